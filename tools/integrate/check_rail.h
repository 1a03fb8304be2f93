/* The check rail: it holds the wheelset by the back of one flange, so that the other flange clears the crossing nose.
 *
 * A unilateral spring and damper across the track at rail level, without friction: the rubbing of the flange's back, which lifts and
 * brakes the wheel, is not modelled.  y to the right. */
#ifndef VX_INTEGRATE_CHECK_RAIL_H
#define VX_INTEGRATE_CHECK_RAIL_H

#include "formats/trk.h"
#include "tools/integrate/wheel.h"

/* Adds the check rail beside rail `side` (0 left, 1 right), if any, to the forces of that side's wheel. */
void check_rail_add(const struct trk *t, int side, const struct wheel_input *in, struct wheel_output *out);

#endif
