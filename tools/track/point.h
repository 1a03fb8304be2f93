/* A point on the rails between two nodes: where a force enters and a deflection is read.
 *
 * x forward, z down; deflection and force are positive down. */
#ifndef VX_TRACK_POINT_H
#define VX_TRACK_POINT_H

#include "formats/trk.h"

enum { EXCITE_LEFT, EXCITE_RIGHT, EXCITE_BOTH };   /* the rails loaded */
enum { AT_SLEEPER, AT_MIDSPAN };

struct point {
    double x;                        /* m */
    int64_t node;                    /* near end of its element; a moving mass has none, and the far end is the near one */
    double shape[TRK_RAILS][4];      /* of [w t] near and far: deflection from them, and load upon them */
    double compliance[TRK_RAILS];    /* m/N, of the element with held ends */
};

/* The sleeper, or the middle of two neighbours, nearest to x; of two as near the one behind. */
double point_station(const struct trk *t, int at, double x);

/* The point at x, which is moved onto the rail where it lies beyond an end. */
void point_at(struct point *p, const struct trk *t, double x);

/* dof [4]: the degrees of freedom that shape belongs to. */
void point_dofs(const struct point *p, const struct trk *t, int rail, int64_t dof[4]);

/* Whether this rail is loaded. */
static inline int point_loads(int excite, int rail)
{
    return excite == EXCITE_BOTH || excite == (rail == TRK_LEFT ? EXCITE_LEFT : EXCITE_RIGHT);
}

/* The rail whose response is told: the one loaded, left where both are. */
static inline int point_rail(int excite)
{
    return excite == EXCITE_RIGHT ? TRK_RIGHT : TRK_LEFT;
}

#endif
