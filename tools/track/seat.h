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

/* load (N, down) on each rail that excite names; the answer is that of one loaded rail, left where both are. */
const char *seat_load(struct seat *s, const struct trk *t, const struct point *p, int excite, double load);

#endif
