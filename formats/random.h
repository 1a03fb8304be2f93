/* Repeatable random numbers: the same seed gives the same sequence everywhere. */
#ifndef VX_FORMATS_RANDOM_H
#define VX_FORMATS_RANDOM_H

#include <stdint.h>

struct random {
    uint64_t state;
};

/* Any seed. */
void random_begin(struct random *r, uint64_t seed);

/* Within 0..1, 0 included. */
double random_uniform(struct random *r);

/* Two independent normal numbers of mean 0 and deviation 1. */
void random_normal(struct random *r, double x[2]);

#endif
