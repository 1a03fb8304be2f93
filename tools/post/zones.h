/* Extremes of a run gathered by zone of the railpads. */
#ifndef VX_POST_ZONES_H
#define VX_POST_ZONES_H

#include "formats/run.h"

/* A largest value and the sleeper number where it stands. */
struct zone_extreme {
    double value;
    int64_t sleeper;
};

struct zone {
    char name[32];
    int64_t sleepers;               /* rail seats in it */
    struct zone_extreme Q, Y;       /* N, of wheels nearest to a seat of the zone */
    struct zone_extreme pad;        /* N */
    struct zone_extreme compression;/* m, of the pad */
    struct zone_extreme ballast;    /* N, largest of left, middle and right under the zone's sleepers */
};

/* Fills zone[0 .. r->zones]; 0 is what lies in no zone.  The run must be complete. */
const char *zones_find(const struct run *r, struct zone *zone);

#endif
