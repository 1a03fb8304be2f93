/* The limit of stiffness lies two orders below the softest railpads and ballast that are built; kN/mm taken for N/m are caught, and so is
 * MN/m.  A rail's radius of gyration in pitch is 0.06 m (60E1, EN 13674-1: I = 3038 cm4, A = 76.7 cm2).  With one node a bay its pitch
 * inertia is all that makes pinned-pinned modes, and may be larger; with several it is the rail's own. */
#include "tools/track/doubt.h"

#include <math.h>
#include <stdio.h>

static const double stiffness_least = 1e5;       /* N/m */
static const double gyration_most = 0.1;         /* m */

/* The first sleeper where value [parts][sleepers], summed, is not 0 but below the least stiffness; -1 where none is. */
static int64_t soft(const struct trk *t, const double *value, int parts, double *least)
{
    for (int64_t s = 0; s < t->sleepers; s++) {
        double sum = 0;
        for (int k = 0; k < parts; k++)
            sum += value[k * t->sleepers + s];
        *least = sum;
        if (sum > 0 && sum < stiffness_least)
            return s;
    }
    return -1;
}

int doubt_track(const struct trk *t, char words[DOUBT_TRACK_MOST][DOUBT_TRACK_WORDS])
{
    double least = 0;
    int n = 0;
    int64_t s = soft(t, t->pad_k, 1, &least);

    if (s < 0)
        s = soft(t, t->pad_k + t->sleepers, 1, &least);
    if (s >= 0)
        snprintf(words[n++], DOUBT_TRACK_WORDS, "a railpad of sleeper %lld has %g N/m", (long long)t->sleeper_number[s], least);
    if ((s = soft(t, t->ballast_k, TRK_BALLAST, &least)) >= 0)
        snprintf(words[n++], DOUBT_TRACK_WORDS, "the ballast under sleeper %lld has %g N/m", (long long)t->sleeper_number[s], least);
    for (int64_t i = 0; i < t->nodes && t->nodes > t->sleepers; i++) {
        const double radius = t->rail_mass[i] > 0 ? sqrt(t->rail_inertia[i] / t->rail_mass[i]) : 0;
        if (radius > gyration_most) {
            snprintf(words[n++], DOUBT_TRACK_WORDS, "rail.pitch_inertia: %g kg.m2 at each of several nodes a bay is a radius of gyration of %.2g m, "
                     "a rail has 0.06: pinned-pinned frequencies fall", t->rail_inertia[i], radius);
            break;
        }
    }
    return n;
}
