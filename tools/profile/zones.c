#include "tools/profile/zones.h"

#include <math.h>
#include <stddef.h>

double zone_height(const struct prof_zone *z, double y)
{
    double height = 0;

    if (z->polynomial.n == 0) {
        double dy = y - z->centre.x[0], r2 = z->radius * z->radius;
        return z->centre.x[1] - copysign(sqrt(fmax(r2 - dy * dy, 0)), z->radius);
    }
    for (int64_t k = z->polynomial.n; k-- > 0;)
        height = height * y + z->polynomial.x[k];
    return height;
}

double zone_slope(const struct prof_zone *z, double y)
{
    double slope = 0;

    if (z->polynomial.n == 0)
        return (y - z->centre.x[0]) / (z->centre.x[1] - zone_height(z, y));
    for (int64_t k = z->polynomial.n; k-- > 1;)
        slope = slope * y + (double)k * z->polynomial.x[k];
    return slope;
}

static double arc_angle(const struct prof_zone *z, double y)
{
    return asin(fmin(fmax((y - z->centre.x[0]) / fabs(z->radius), -1), 1));
}

/* Even steps of angle. */
static const char *arc_points(const struct prof_zone *z, double spacing, struct points *p, int64_t *room)
{
    double from = arc_angle(z, z->from), to = arc_angle(z, z->to), r = fabs(z->radius);
    int64_t steps = (int64_t)ceil(r * (to - from) / spacing);
    const char *why = NULL;

    for (int64_t i = 0; !why && i <= steps; i++) {
        double angle = from + (to - from) * (double)i / (double)steps;
        why = points_add(p, room, z->centre.x[0] + r * sin(angle), z->centre.x[1] - z->radius * cos(angle), 1);
    }
    return why;
}

/* Steps of y by the slope at the point before. */
static const char *polynomial_points(const struct prof_zone *z, double spacing, struct points *p, int64_t *room)
{
    const char *why = NULL;

    for (double y = z->from; !why && y < z->to;) {
        double step = spacing / hypot(1, zone_slope(z, y));
        why = points_add(p, room, y, zone_height(z, y), 1);
        y += z->to - y < 1.5 * step && z->to - y > step ? (z->to - y) / 2 : step;
    }
    return why ? why : points_add(p, room, z->to, zone_height(z, z->to), 1);
}

/* The right half in front of itself, mirrored; the point on the axis stays single. */
static const char *half_mirror(struct points *p, int64_t *room)
{
    int64_t half = p->n;
    const char *why = NULL;

    for (int64_t i = 1; !why && i < half; i++)
        why = points_add(p, room, p->y[i], p->z[i], 1);
    for (int64_t i = half; !why && i-- > 0;) {
        p->y[half - 1 + i] = p->y[i];
        p->z[half - 1 + i] = p->z[i];
    }
    for (int64_t i = 0; !why && i < half - 1; i++) {
        p->y[i] = -p->y[p->n - 1 - i];
        p->z[i] = p->z[p->n - 1 - i];
    }
    return why;
}

const char *zones_points(int64_t n, const struct prof_zone *zone, int symmetric, double spacing, struct points *p)
{
    const char *why = NULL;
    int64_t room = 0;

    *p = (struct points){0};
    for (int64_t i = 0; !why && i < n; i++)
        why = zone[i].polynomial.n ? polynomial_points(&zone[i], spacing, p, &room) : arc_points(&zone[i], spacing, p, &room);
    if (!why && symmetric)
        why = half_mirror(p, &room);
    if (why)
        points_free(p);
    return why;
}
