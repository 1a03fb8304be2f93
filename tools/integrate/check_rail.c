#include "tools/integrate/check_rail.h"

#include <math.h>

/* Play and its slope at station s; 0 where the check rail does not reach. */
static int find_play(const struct trk *t, double s, double *play, double *slope)
{
    const double *x = t->check_x;
    int64_t i = 0;

    if (t->checks < 2 || s < x[0] || s > x[t->checks - 1])
        return 0;
    while (i + 2 < t->checks && s >= x[i + 1])
        i++;
    *slope = (t->check_play[i + 1] - t->check_play[i]) / (x[i + 1] - x[i]);
    *play = t->check_play[i] + *slope * (s - x[i]);
    return 1;
}

/* On the right the back of the flange meets the check rail when the wheelset moves left, by e = -y - play at rail level.  A beam yields to
 * the force, by g F, at the rate of q F: F = k (e - g F) + c (e' - q F). */
void check_rail_add(const struct trk *t, int side, const struct wheel_input *in, struct wheel_output *out)
{
    double play, slope, sign = side == TRK_RIGHT ? 1 : -1, e, rate, F;

    if (side != *t->check_rail || !find_play(t, in->s, &play, &slope))
        return;
    e = -sign * (in->y - in->roll * in->radius - in->check_y) - play;
    rate = -sign * (in->vy - in->vroll * in->radius - in->check_vy) - slope * in->v;
    if (e <= 0)
        return;
    F = fmax(0, *t->check_k * e + *t->check_c * rate) / (1 + *t->check_k * in->check_give + *t->check_c * in->check_quick);
    out->check = -sign * F;
    out->Y -= sign * F;
    out->force[1] += sign * F;
    out->moment[0] -= (in->radius - in->z) * sign * F; /* at rail level, r0 - z below the axle */
}
