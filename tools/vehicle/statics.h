/* The vehicle at rest on straight level track: what the couplings carry and how the weight reaches the wheels.
 *
 * x forward, y to the right, z down. */
#ifndef VX_VEHICLE_STATICS_H
#define VX_VEHICLE_STATICS_H

#include "formats/veh.h"

/* Lateral distance of a wheel's contact from the middle of the track, half of the nominal 1500 mm between running circles. */
#define STATICS_CONTACT_LEVER 0.75

/* preload[couplings][3] N on the first body, vertical only, rest[couplings] m of springs in their tables, and
 * wheel_load[wheelsets][2] N, left and right, of v, whose own arrays of these are not read.  given[couplings] N > 0 fixes the force of a
 * spring.  Fails where vertical springs cannot carry a body, or a wheel would lift. */
const char *statics_rest(const struct veh *v, const double *given, double *preload, double *rest, double *wheel_load);

#endif
