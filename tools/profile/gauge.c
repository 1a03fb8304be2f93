#include "tools/profile/gauge.h"

#include <math.h>
#include <stddef.h>

#include "formats/reason.h"

const char *gauge_face(const struct outline *o, double depth, double *face)
{
    int64_t top = 0;

    for (int64_t i = 1; i < o->n; i++)
        if (o->z[i] < o->z[top])
            top = i;
    double least = o->y[top], limit = o->z[top] + depth;
    for (int64_t i = top; i-- > 0;) {
        if (o->z[i] >= limit) {
            double part = (limit - o->z[i + 1]) / (o->z[i] - o->z[i + 1]);
            *face = fmin(least, o->y[i + 1] + part * (o->y[i] - o->y[i + 1]));
            return NULL;
        }
        least = fmin(least, o->y[i]);
    }
    return reason("the gauge side ends %.2f mm below the top, the gauge is measured %.2f mm below it",
                  1e3 * (o->z[0] - o->z[top]), 1e3 * depth);
}

double gauge_rail_position(double face, double gauge)
{
    return gauge / 2 - face;
}

double gauge_wheel_position(double back_to_back, double flange_back)
{
    return back_to_back / 2 + flange_back;
}
