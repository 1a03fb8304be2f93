/* Figure of a vehicle: from the right, from above and from behind, with bodies, wheels and numbered couplings, and the key to the numbers. */
#ifndef VX_DRAW_VEHICLE_H
#define VX_DRAW_VEHICLE_H

#include "tools/draw/views.h"

/* from, to: window along x, m; infinite for all of it. */
const char *vehicle_chart(struct chart *c, const struct veh *v, double from, double to);

#endif
