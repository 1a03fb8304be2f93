/* Static deflection of a track: K u = f, K factored once.
 *
 * z down: a force down is positive and so is its deflection. */
#ifndef VX_TRACK_CHOLESKY_H
#define VX_TRACK_CHOLESKY_H

#include "formats/trk.h"

struct cholesky {
    const struct trk *track;   /* must outlive this */
    void *common, *factor;     /* CHOLMOD's */
};

/* Factors K; fails where K is not positive definite (with the degree of freedom) or badly conditioned. */
const char *cholesky_new(struct cholesky *s, const struct trk *t);

/* The same after K has changed in place, on its old pattern. */
const char *cholesky_again(struct cholesky *s);

/* u, f: [dofs] m and rad, N and N m; u may be f. */
const char *cholesky_solve(struct cholesky *s, const double *f, double *u);

void cholesky_free(struct cholesky *s);

#endif
