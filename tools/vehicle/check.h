/* Whether a vehicle is what its author meant: weight, balance, and that nothing is loose. */
#ifndef VX_VEHICLE_CHECK_H
#define VX_VEHICLE_CHECK_H

#include "formats/veh.h"

struct check {
    double mass;            /* kg */
    double cg[3];           /* m, of the whole, x from the first wheelset, z = -height */
    double weight;          /* N */
    double wheels;          /* N, sum of the static wheel loads */
};

void check_balance(const struct veh *v, struct check *k);

/* deflection [couplings] m of each stop along its axis, 0 of others, where all bodies but the wheelsets are pushed to the left by a m/s2, as in a
 * curve to the right: linear, from K, without the stops themselves. */
const char *check_sideways(const struct veh *v, double a, double *deflection);

/* The first motion that no spring holds, wheelsets held, or that falls over. */
const char *check_support(const struct veh *v);

#endif
