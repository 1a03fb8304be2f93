/* A passage that runs trailing, as the track's description has it.
 *
 * Inside, x is forward: track, tables and excitation of a trailing passage are turned half way round about z, stations are those of the
 * track times -1, and its left rail is the track's right one.  What people read has the track's stations, sides and axes: x with
 * increasing station, y to the right of that, z down. */
#ifndef VX_INTEGRATE_FACING_H
#define VX_INTEGRATE_FACING_H

#include "formats/run.h"
#include "tools/integrate/passage.h"

static inline double facing_station(const struct passage *p, double s)
{
    return p->o.trailing ? -s : s;
}

/* left or right */
static inline const char *facing_side(const struct passage *p, int side)
{
    return (side != 0) != (p->o.trailing != 0) ? "right" : "left";
}

/* One record x of a channel, double or float as it says: sides and, where the track does not follow the train, sleepers and nodes into
 * the track's order, all in its axes. */
void facing_channel(const struct run *r, enum run_channel c, int follows, void *x);
/* The same of extremes. */
void facing_extreme(const struct run *r, enum run_extreme c, int follows, double *x);

/* v [n][width] as x and y of places or vectors: both change their sign. */
void facing_turn(int64_t n, int64_t width, double *v);

#endif
