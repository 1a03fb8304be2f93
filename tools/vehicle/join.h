/* Several vehicles, one behind the other, as one. */
#ifndef VX_VEHICLE_JOIN_H
#define VX_VEHICLE_JOIN_H

#include "formats/veh.h"

struct join {
    double gap;                     /* m from the last wheelset of a vehicle to the first of the next */
    double stiffness, damping;      /* N/m, N s/m of a coupler between neighbours, a rod; 0: none */
    double length, height;          /* m of the rod, lengthwise midway between those wheelsets, and of it above the rails */
};

/* Of part[n], n >= 2, from the front.  Names get the vehicle's number, from 1, behind a point.  A coupler joins the heaviest bodies on springs. */
const char *join_vehicles(struct veh *v, const struct veh *part, int64_t n, const struct join *j);

#endif
