#include "tools/profile/dimensions.h"

#include <math.h>

#define THICKNESS_DEPTH 10e-3    /* m, EN 15313 */
#define SLOPE_DEPTH 2e-3         /* m */
#define FLANGE_LEAST 15e-3       /* m, less is no flange */
#define TOP_HALF 10e-3           /* m */
#define TURNS 6                  /* each brings the slope closer by the crown's curvature times the gauge depth */

/* The highest point seen along an axis inclined by `slope`: z - slope y is least. */
static int64_t top_of(const struct outline *o, double slope)
{
    int64_t at = 0;
    for (int64_t i = 1; i < o->n; i++)
        if (o->z[i] - slope * o->y[i] < o->z[at] - slope * o->y[at])
            at = i;
    return at;
}

/* y from point i on, in steps, where z - slope y passes `limit`; NAN where it does not. */
static double crossing(const struct outline *o, int64_t i, int64_t step, double slope, double limit)
{
    for (; i + step >= 0 && i + step < o->n; i += step) {
        double a = o->z[i] - slope * o->y[i] - limit, b = o->z[i + step] - slope * o->y[i + step] - limit;
        if (a * b <= 0 && a != b)
            return o->y[i] + a / (a - b) * (o->y[i + step] - o->y[i]);
    }
    return NAN;
}

void dimensions_wheel(const struct outline *o, double flange_back, struct dimensions *c)
{
    int64_t tip = 0;

    for (int64_t i = 1; i < o->n; i++)
        tip = o->z[i] > o->z[tip] ? i : tip;
    *c = (struct dimensions){NAN, NAN, NAN};
    if (o->z[tip] < FLANGE_LEAST || o->y[tip] > 0)
        return;
    double face = crossing(o, tip, 1, 0, THICKNESS_DEPTH);
    c->flange_height = o->z[tip];
    c->flange_thickness = face + flange_back;
    c->flange_slope = face - crossing(o, tip, 1, 0, o->z[tip] - SLOPE_DEPTH);
}

/* Least squares of z over y within TOP_HALF of the middle. */
static double top_slope(const struct outline *o, double middle)
{
    double n = 0, y = 0, z = 0, yy = 0, yz = 0;

    for (int64_t i = 0; i < o->n; i++) {
        double d = o->y[i] - middle;
        if (fabs(d) > TOP_HALF)
            continue;
        n++;
        y += d;
        z += o->z[i];
        yy += d * d;
        yz += d * o->z[i];
    }
    return (n * yz - y * z) / (n * yy - y * y);
}

double dimensions_cant(const struct outline *o, double gauge_depth)
{
    double slope = 0;

    for (int turn = 0; turn < TURNS; turn++) {
        int64_t top = top_of(o, slope);
        double limit = o->z[top] - slope * o->y[top] + gauge_depth;
        double low = crossing(o, top, -1, slope, limit), high = crossing(o, top, 1, slope, limit);
        /* The middle lies gauge_depth below the top, along the inclined axis. */
        double middle = (low + high) / 2 + slope * gauge_depth;
        if (!(high - low > 2 * TOP_HALF))
            return NAN;
        slope = top_slope(o, middle);
    }
    return -slope;
}
