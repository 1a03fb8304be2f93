/* Where a force enters a track, or where its motion is read: a rail, both rails alike, or a sleeper.
 *
 * x forward, y to the right, z down; deflection and force are positive down, or sideways to the right, then of the running surface. */
#ifndef VX_RECEPTANCE_PLACE_H
#define VX_RECEPTANCE_PLACE_H

#include "formats/trk.h"
#include "tools/track/point.h"

enum { PLACE_LEFT = EXCITE_LEFT, PLACE_RIGHT = EXCITE_RIGHT, PLACE_BOTH = EXCITE_BOTH, PLACE_SLEEPER };
enum { AT_STATION = AT_MIDSPAN + 1 };    /* beside AT_SLEEPER and AT_MIDSPAN: there and nowhere else */

struct place {
    int on, at;
    int lateral;                         /* sideways, else vertical */
    double x;                            /* m */
    struct point point;                  /* of the rails at x */
    int dofs;
    int64_t dof[2 * POINT_LATERAL];      /* [dofs] that a force here loads, and whose motion is the motion here */
    double share[2 * POINT_LATERAL];     /* [dofs] */
};

/* The sleeper or the middle between two that is nearest to x, or x itself; a sleeper is loaded at its centre and, whatever `at`
 * says, is the nearest one.  x beyond an end of the rails is moved onto it. */
void place_find(struct place *p, const struct trk *t, int on, int at, double x);

/* The same sideways, on a spatial track: of a rail at its head, so that twist counts, of a sleeper at its centre. */
void place_find_lateral(struct place *p, const struct trk *t, int on, int at, double x);

#define PLACE_MIDDLE -1e9                /* m, as near: the middle of the track */

/* Whether `near` is on the rails. */
const char *place_near(const struct trk *t, double near);

/* The place that `where` names: sleeper or midspan, the one nearest to `near` (m), or a station in m on the rails; lateral, of a spatial track, or not. */
const char *place_named(struct place *p, const struct trk *t, int on, const char *where, double near, int lateral);

/* f [dofs] += a force at p; and the motion there of u [dofs]. */
void place_load(const struct place *p, double force, double *f);
double place_motion(const struct place *p, const double *u);

/* m/N: what the element gives with held ends at `seen` under a unit force at `force`; 0 where they share no element. */
double place_held(const struct place *force, const struct place *seen, const struct trk *t);

/* PLACE_LEFT and so on, and AT_SLEEPER and so on, as words. */
extern const char *const place_on[], *const place_at[];

#endif
