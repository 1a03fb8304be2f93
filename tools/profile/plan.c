/* Ground axes: x along the straight centre line, y towards the side of divergence.  The diverging centre line is
 * (R sin phi, R (1 - cos phi)) with the normal (-sin phi, cos phi); a line beside it is its centre plus offset times normal. */
#include "tools/profile/plan.h"

#include <math.h>

/* Diverging route at arc length s: y of its centre line, and heading. */
static double centre_y(const struct plan *p, double s, double *heading)
{
    double arc = p->radius * p->angle;

    *heading = fmin(fmax(s / p->radius, 0), p->angle);
    return p->radius * (1 - cos(*heading)) + fmax(s - arc, 0) * sin(p->angle);
}

/* Through route at x: y of the line beside the diverging centre line at this offset. */
static double beside_y(const struct plan *p, double offset, double x)
{
    double r = p->radius - offset, x_end = r * sin(p->angle);

    if (x <= 0)
        return offset;
    if (x <= x_end)
        return p->radius - sqrt(r * r - x * x);
    return p->radius - r * cos(p->angle) + (x - x_end) * tan(p->angle);
}

double plan_stock(const struct plan *p, double s)
{
    double half = p->gauge / 2, heading, y;

    if (!p->diverging)
        return beside_y(p, half, s) - half;
    y = centre_y(p, s, &heading);
    return (half + y) / cos(heading) - half;      /* the line y = -half along the normal */
}

double plan_separation(const struct plan *p, double s)
{
    double half = p->gauge / 2, heading, y;

    if (!p->diverging)
        return beside_y(p, -half, s) - half;
    y = centre_y(p, s, &heading);
    return (y - half) / cos(heading) - half;      /* the line y = half along the normal */
}

/* The separation grows with s: bisection to the last bit. */
double plan_separation_station(const struct plan *p, double separation)
{
    double lo = 0, hi = 4 * p->radius;

    for (int i = 0; i < 100; i++) {
        double middle = (lo + hi) / 2;
        if (plan_separation(p, middle) < separation)
            lo = middle;
        else
            hi = middle;
    }
    return (lo + hi) / 2;
}
