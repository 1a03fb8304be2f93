/* A point (y, z) of a surface z(y, s) keeps its depth where y moves by dy/ds, so that dz/ds = -(dz/dy) dy/ds.  On flat parts
 * the difference is taken in height at the same y, on steep ones in y at the same height: each where its Taylor series is the short one. */
#include "tools/profile/fall.h"

#include <math.h>

#include "tools/profile/hermite.h"

#define STEEP 0.5            /* |dz/dy| */
#define AROUND 100           /* points searched to either side for the same height */

/* Cubic through values f and derivatives d at both ends of an interval x0 .. x1. */
static double cubic_at(double x0, double x1, const double *f, const double d[2], double x)
{
    return hermite_at(f[0], d[0], f[1], d[1], x1 - x0, (x - x0) / (x1 - x0)).z;
}

/* The interval of y, from *at on; 0 beside the outline. */
static int interval_find(const struct outline *o, double y, int64_t *at)
{
    if (o->n < 2)
        return 0;
    while (*at < o->n - 2 && o->y[*at + 1] < y)
        ++*at;
    return y >= o->y[0] && y <= o->y[o->n - 1];
}

/* y at height z on the side that has the sign of `slope`, in the interval nearest to `at`; NAN where it is not near. */
static double place_at(const struct outline *o, double z, double slope, int64_t at)
{
    for (int64_t k = 0; k <= 2 * AROUND; k++) {
        int64_t i = at + (k % 2 ? (k + 1) / 2 : -k / 2);
        if (i < 0 || i > o->n - 2 || o->slope[i] * slope <= 0 || o->slope[i + 1] * slope <= 0)
            continue;
        if ((o->z[i] - z) * (o->z[i + 1] - z) <= 0)
            return cubic_at(o->z[i], o->z[i + 1], o->y + i, (double[]){1 / o->slope[i], 1 / o->slope[i + 1]}, z);
    }
    return NAN;
}

/* (b - a)/2h, or what one of them gives with the middle; NAN without either. */
static double difference(double a, double middle, double b, double h)
{
    if (isnan(a) || isnan(b))
        return isnan(a) ? (b - middle) / h : (middle - a) / h;
    return (b - a) / (2 * h);
}

/* Points without a fall take that of the nearest one with it. */
static void gaps_fill(struct outline *o)
{
    for (int64_t i = 1; i < o->n; i++)
        if (isnan(o->fall[i]))
            o->fall[i] = o->fall[i - 1];
    for (int64_t i = o->n - 1; i-- > 0;)
        if (isnan(o->fall[i]))
            o->fall[i] = o->fall[i + 1];
    for (int64_t i = 0; i < o->n; i++)
        if (isnan(o->fall[i]))
            o->fall[i] = 0;
}

void fall_between(const struct outline *behind, const struct outline *ahead, double h, struct outline *o)
{
    const struct outline *near[2] = {behind, ahead};
    int64_t at[2] = {0, 0};

    for (int64_t i = 0; i < o->n; i++) {
        double y = o->y[i], z = o->z[i], slope = o->slope[i], high[2], place[2];
        for (int k = 0; k < 2; k++) {
            const struct outline *p = near[k];
            int inside = interval_find(p, y, &at[k]);
            high[k] = inside ? cubic_at(p->y[at[k]], p->y[at[k] + 1], p->z + at[k], p->slope + at[k], y) : NAN;
            place[k] = fabs(slope) > STEEP ? place_at(p, z, slope, at[k]) : NAN;
        }
        double moved = difference(place[0], y, place[1], h);
        o->fall[i] = isnan(moved) ? difference(high[0], z, high[1], h) : -slope * moved;
    }
    gaps_fill(o);
}
