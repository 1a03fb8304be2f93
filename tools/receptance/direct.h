/* Solutions of (K + s C + s^2 M) u = f at complex s; s = i omega gives the response to f exp(i omega t). */
#ifndef VX_RECEPTANCE_DIRECT_H
#define VX_RECEPTANCE_DIRECT_H

#include <complex.h>

#include "formats/trk.h"

struct direct {
    const struct trk *track;            /* must outlive this */
    double part;                        /* of the damping C that counts, 1 unless set */
    double *A;                          /* [entries][2] K + s C + s^2 M, real and imaginary part */
    double *f;                          /* [dofs][2] the load, kept for the residual */
    double scale;                       /* largest entry of A */
    void *common, *symbolic, *numeric;  /* KLU's */
    int64_t repivots;                   /* factored anew, because the old pivots had become small */
};

/* Orders the matrix once. */
const char *direct_new(struct direct *d, const struct trk *t);

/* Factors at s, with the pivots of the last time while they are good. */
const char *direct_factor(struct direct *d, double complex s);

/* u [dofs][2]: the load before, the response after. */
const char *direct_solve(struct direct *d, double *u);

void direct_free(struct direct *d);

#endif
