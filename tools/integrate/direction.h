/* A motion of the track at one place, as a sum over degrees of freedom; a force along it loads these by the same shares. */
#ifndef VX_INTEGRATE_DIRECTION_H
#define VX_INTEGRATE_DIRECTION_H

#include <stdint.h>

enum { DIRECTION_MOST = 6 };

struct direction {
    int n;
    int64_t dof[DIRECTION_MOST];
    double share[DIRECTION_MOST];
};

/* f += F d */
void direction_load(const struct direction *d, double F, double *f);

/* d.state */
double direction_sample(const struct direction *d, const double *state);

/* m/N: a' S^-1 b, what a force along b gives along a; Z [][beyond + 1] as of banded_inverse, which must reach from one to the other. */
double direction_give(const struct direction *a, const struct direction *b, const double *Z, int beyond);

#endif
