/* Static deflection of a track: K u = f, K factored once.
 *
 * z down: a force down is positive and so is its deflection. */
#ifndef VX_STATIC_H
#define VX_STATIC_H

#include "formats/trk.h"

struct statics {
    const struct trk *track;   /* must outlive this */
    void *common, *factor;     /* CHOLMOD's */
};

/* Factors K; fails where K is not positive definite (with the degree of freedom) or badly conditioned. */
const char *static_new(struct statics *s, const struct trk *t);

/* u, f: [dofs] m and rad, N and N m; u may be f. */
const char *static_solve(struct statics *s, const double *f, double *u);

void static_free(struct statics *s);

#endif
