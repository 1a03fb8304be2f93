/* What a static load does to the track under it, beside its own weight. */
#ifndef VX_TRACK_SEAT_H
#define VX_TRACK_SEAT_H

#include "formats/trk.h"
#include "tools/track/point.h"

struct seat {
    double deflection;    /* m, of the rail under the load, down */
    double force;         /* N, of the most loaded railpad of that rail */
    double compression;   /* m, of that railpad */
    int64_t number;       /* of its sleeper */
};

/* s [TRK_RAILS]: load (N, down) on each rail that excite names; of a rail that it does not name, what it does all the same. */
const char *seat_load(struct seat *s, const struct trk *t, const struct point *p, int excite, double load);

/* Whether both rails do the same, but for rounding. */
int seat_alike(const struct seat *a, const struct seat *b);

enum { SEAT_NUMBER, SEAT_LEFT, SEAT_RIGHT, SEAT_BALLAST, SEAT_BEARS };

/* force [sleepers][SEAT_BEARS]: number of each sleeper, and what load (N, down) on each rail that excite names adds at every axle [axles] (m)
 * to the force of its left and its right railpad and of the ballast under it (N, down). */
const char *seat_bearers(const struct trk *t, int excite, double load, int axles, const double *axle, double *force);

#endif
