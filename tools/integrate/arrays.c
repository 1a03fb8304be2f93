#include "tools/integrate/arrays.h"

double *arrays_take(struct arrays *a, int64_t n)
{
    double *p = a->base ? a->base + a->used : NULL;

    a->used += (size_t)n;
    return p;
}
