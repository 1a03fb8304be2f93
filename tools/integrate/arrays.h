/* Arrays of one store, which is made in two passes over them: the first counts, the second hands out. */
#ifndef VX_INTEGRATE_ARRAYS_H
#define VX_INTEGRATE_ARRAYS_H

#include <stddef.h>
#include <stdint.h>

struct arrays {
    double *base;       /* NULL while it counts */
    size_t used;
};

/* The next n numbers; NULL while it counts. */
double *arrays_take(struct arrays *a, int64_t n);

#endif
