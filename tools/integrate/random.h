/* Repeatable random numbers: the same seed gives the same sequence everywhere. */
#ifndef VX_INTEGRATE_RANDOM_H
#define VX_INTEGRATE_RANDOM_H

#include <stdint.h>

struct random {
    uint64_t state;
};

/* Any seed. */
void random_begin(struct random *r, uint64_t seed);

/* Two independent normal numbers of mean 0 and deviation 1. */
void random_normal(struct random *r, double x[2]);

#endif
