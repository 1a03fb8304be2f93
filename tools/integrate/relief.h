/* Ballast that only pushes, in a linear scheme: what its springs have in K and C beyond their force is given back to the sleeper as a load,
 *   P = (k e + c e')[in K and C] - max(k (e - gap) + c e', 0)[e > gap],   e = z + y roll,
 * sought by putting it in, solving, and looking again: a step's solution turns 1 N of it into a hundredth of that. */
#ifndef VX_INTEGRATE_RELIEF_H
#define VX_INTEGRATE_RELIEF_H

#include "formats/trk.h"

struct relief {
    int any;                    /* whether some ballast only pushes */
    double *P[TRK_BALLAST];     /* N [sleepers] down on the sleeper */
    double change;              /* N, the largest when last sought */
};

const char *relief_new(struct relief *r, const struct trk *t);
void relief_free(struct relief *r);

/* Adds P to f [dofs]. */
void relief_load(const struct relief *r, const struct trk *t, double *f);

/* P from u [dofs] and the rates 2/h (u - u0) - v0 of average acceleration, and its change to f. */
void relief_seek(struct relief *r, const struct trk *t, double h, const double *u, const double *u0, const double *v0, double *f);

#endif
