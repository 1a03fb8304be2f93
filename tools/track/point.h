/* A point on the rails between two nodes: where a force enters and a deflection is read.
 *
 * x forward, y to the right, z down; deflection and force are positive down, or sideways to the right. */
#ifndef VX_TRACK_POINT_H
#define VX_TRACK_POINT_H

#include "formats/trk.h"

enum { EXCITE_LEFT, EXCITE_RIGHT, EXCITE_BOTH };   /* the rails loaded */
enum { AT_SLEEPER, AT_MIDSPAN };
enum { POINT_LATERAL = 6 };                        /* degrees of freedom that a lateral force loads: y, yaw and twist near and far */

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

/* dof, share [POINT_LATERAL]: of the motion sideways at this height (m) above the rail's centroid, and of the load of a force there; *held
 * (m/N) is what the element gives with held ends.  A spatial track alone has it. */
void point_lateral(const struct point *p, const struct trk *t, int rail, double height, int64_t *dof, double *share, double *held);

/* The same of the check rail, as a beam, at station x.  Returns 0 where it does not run. */
int point_check(const struct trk *t, double x, double height, int64_t *dof, double *share, double *held);

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
