/* Places of a rail's surface that can be found again in the next section, by its inclination.
 *
 * Profile axes: y to the right, z down, so the surface inclines from -90 degrees on the left flank to +90 on the right one. */
#ifndef VX_PROFILE_FEATURES_H
#define VX_PROFILE_FEATURES_H

#include "tools/profile/curve.h"

/* From the highest point to either side, where the surface first inclines by 20 and by 45 degrees; the highest point itself where it
 * is a ridge. */
enum { FEATURE_LEFT_45, FEATURE_LEFT_20, FEATURE_RIDGE, FEATURE_RIGHT_20, FEATURE_RIGHT_45, FEATURES };

/* Lengths s[FEATURES] (m) along the curve between `from` and `to`, increasing; NAN where there is no such place. */
void features_find(const struct curve *c, double from, double to, double *s);

#endif
