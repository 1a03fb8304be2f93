/* Static equilibrium of a track on ballast that may only push, across a gap.
 *
 * z down; forces and deflections are positive down, from the unloaded track.  The force of a ballast spring under the point y of its sleeper
 * is k (e - gap) where e = z + y roll is beyond the gap, 0 where not; where it is bonded k e, both ways. */
#ifndef VX_TRACK_EQUILIBRIUM_H
#define VX_TRACK_EQUILIBRIUM_H

#include "formats/trk.h"
#include "tools/track/cholesky.h"

#define EQUILIBRIUM_GRAVITY 9.81   /* m/s2, where no vehicle says another */

struct equilibrium_push;           /* a spring that only pushes */

struct equilibrium {
    const struct trk *track;       /* must outlive this */
    struct trk tangent;            /* the track with the matrices of the ballast that touched last */
    struct cholesky factor;        /* of its K */
    double *weight;                /* N [dofs] dead weight of rails and sleepers */
    double *rest;                  /* m, rad [dofs] under it */
    int64_t pushes;                /* springs that only push; without any all is linear */
    struct equilibrium_push *push; /* [pushes] */
    double *bare;                  /* [entries] K without them */
    double *next, *load;           /* [dofs] */
};

/* Factors the track and finds its rest under its own weight. */
const char *equilibrium_new(struct equilibrium *e, const struct trk *t, double gravity);

/* u [dofs] under f [dofs], N and N m, weight and all; u may not be f. */
const char *equilibrium_find(struct equilibrium *e, const double *f, double *u);

/* u [dofs]: what f [dofs] adds to the rest under own weight; u may not be f. */
const char *equilibrium_add(struct equilibrium *e, const double *f, double *u);

/* state [3][sleepers]: TRK_BONDED, and TRK_CLOSED or TRK_OPEN as in what was found last. */
void equilibrium_states(const struct equilibrium *e, int64_t *state);

void equilibrium_free(struct equilibrium *e);

/* Finds which ballast of a new track touches under its own weight, and assembles K and C with that. */
const char *equilibrium_settle(struct trk *t, double gravity);

#endif
