/* Inclination of a right rail towards the track's centre.
 *
 * The section turns about x through atan(cant) round the point y = 0, z = 0, the top of its centre line, which keeps its place:
 * the top leans to -y, the gauge side goes down.  Heights are then counted from the highest point again (section.c), so that
 * the top is z = 0 and y = 0 is still the turned centre line's upper end. */
#ifndef VX_PROFILE_CANT_H
#define VX_PROFILE_CANT_H

#include <stdint.h>

/* y[n], z[n] in m, in place; cant 0.025 is 1:40. */
void cant_rotate(int64_t n, double *y, double *z, double cant);

#endif
