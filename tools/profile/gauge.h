/* Where a wheel and a rail stand across the track.
 *
 * Right side: y to the right, z down, the gauge face on the side of -y.  The gauge is measured between the innermost points of the two
 * heads from their tops down to gauge_depth, 14 mm (EN 13848-1). */
#ifndef VX_PROFILE_GAUGE_H
#define VX_PROFILE_GAUGE_H

#include "tools/profile/outline.h"

/* y (m) of the gauge face of a right rail: the least y from its top down to `depth`.  Refuses a rail that does not reach that deep. */
const char *gauge_face(const struct outline *o, double depth, double *face);

/* y of the profile's origin in track axes. */
double gauge_rail_position(double face, double gauge);
double gauge_wheel_position(double back_to_back, double flange_back);

#endif
