/* How far a table of creep forces lies from a theory, on random contacts. */
#ifndef VX_CREEP_COMPARE_H
#define VX_CREEP_COMPARE_H

#include "tools/creep/tabulate.h"

struct creep_difference {
    double rms, most;           /* 1, of the force, over mu N */
    double ratio, creep[3];     /* 1, where it is largest: a/b, creepages xi, eta and phi sqrt(a b) over mu N/(G a b) */
};

/* Over n contacts: a/b from 1/10 to 10, creepages of exp(-5) to exp(2) times mu N/(G a b), both evenly in their logarithm, in any
 * direction, and spin evenly up to mu N/(G (a b)^1.5) either way.  The theory has the grid given and Poisson's ratio of the table. */
const char *creep_compare(const struct creep *t, enum creep_theory theory, int grid, int64_t n, uint64_t seed, struct creep_difference *d);

#endif
