#include "tools/profile/outline.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

const char *outline_new(struct outline *o, int64_t n)
{
    *o = (struct outline){0};
    double *store = calloc((size_t)n * 5, sizeof *store);
    if (!store)
        return REASON_MEMORY;
    *o = (struct outline){.n = n, .y = store, .z = store + n, .slope = store + 2 * n, .curvature = store + 3 * n, .fall = store + 4 * n};
    return NULL;
}

void outline_free(struct outline *o)
{
    free(o->y);
    *o = (struct outline){0};
}

void outline_shift(struct outline *o, double dy, double dz)
{
    for (int64_t i = 0; i < o->n; i++) {
        o->y[i] += dy;
        o->z[i] += dz;
    }
}

static void array_reverse(double *a, int64_t n, double sign)
{
    for (int64_t i = 0, j = n - 1; i <= j; i++, j--) {
        double first = a[i];
        a[i] = sign * a[j];
        a[j] = sign * first;
    }
}

void outline_mirror(struct outline *o)
{
    array_reverse(o->y, o->n, -1);
    array_reverse(o->z, o->n, 1);
    array_reverse(o->slope, o->n, -1);
    array_reverse(o->curvature, o->n, 1);
    array_reverse(o->fall, o->n, 1);
}

void outline_keep(struct outline *o, int64_t first, int64_t end)
{
    double *array[] = {o->y, o->z, o->slope, o->curvature, o->fall};

    o->n = end - first;
    for (int k = 0; k < 5; k++)
        memmove(array[k], array[k] + first, (size_t)o->n * sizeof *array[k]);
}
