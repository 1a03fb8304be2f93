/* A track seen by who runs it the other way: turned half way round about z.
 *
 * x' = -x, y' = -y, z' = z: left and right change, what came first comes last, pitch, roll and twist change their sign, yaw does not.  A curve to the
 * right is one to the left.  Numbers and names stay with what they name. */
#ifndef VX_TRACK_TURN_H
#define VX_TRACK_TURN_H

#include "formats/trk.h"

/* from must outlive t; trk_free takes t. */
const char *turn_track(struct trk *t, const struct trk *from);

#endif
