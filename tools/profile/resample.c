#include "tools/profile/resample.h"

#include <math.h>
#include <stddef.h>

const char *resample_curve(const struct curve *c, double spacing, struct outline *o)
{
    int64_t steps = (int64_t)ceil(c->length / spacing);
    const char *why = outline_new(o, steps + 1);

    for (int64_t i = 0; !why && i <= steps; i++)
        curve_at(c, c->length * (double)i / (double)steps, &o->y[i], &o->z[i], &o->slope[i], &o->curvature[i]);
    return why;
}
