/* Is a run in balance?  Wheel forces against weight and the recorded accelerations of the bodies, sample by sample.
 *
 * Track axes: x forward, y to the right, z down.  The moments are about the tangent, at rail level, to the track centre line at the heaviest
 * body.  With y' positions from that tangent, z = -height, a accelerations in space, H = Jy spin of a wheelset and r' its yaw rate in space:
 *   sum Q            = sum m (g - az)
 *   sum Y            = - sum m ay
 *   sum (y' Q - z Y) = sum [ y' m (g - az) + z m ay - Jx roll'' ] + sum H r'                        */
#ifndef VX_POST_BALANCE_H
#define VX_POST_BALANCE_H

#include "formats/run.h"

struct balance {
    double weight;            /* N */
    double vertical, lateral; /* N largest residual of the first two over the samples */
    double roll;              /* N m of the third */
    double mean_q[2];         /* N sum of Q of a side, mean over the samples */
    double mean_y;            /* N sum of Y, mean */
    double transfer;          /* N load moved to the left side, half the mean difference of the sides */
    double expected;          /* N the same from the right of the third equation and the mean lever of Q */
    int64_t samples;
};

/* Over the samples with the front wheelset from `from` to `to` (m).  Needs the channel groups wheels and bodies. */
const char *balance_find(const struct run *r, double from, double to, struct balance *b);

#endif
