#include "tools/profile/loft.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/profile/hermite.h"

#define MOTION_STEP 1e-3     /* m, along the curve */
#define OVERSHOOT 1e-5       /* m, of a line beyond its sections */

const char *loft_add(struct loft *l, double station, const struct curve *c, const struct piece *p)
{
    struct loft_section *sections = realloc(l->section, (size_t)(l->n + 1) * sizeof *sections);
    if (sections)
        l->section = sections;
    struct link *links = realloc(l->link, (size_t)(l->n + 1) * sizeof *links);
    if (links)
        l->link = links;
    if (!sections || !links)
        return REASON_MEMORY;
    l->section[l->n] = (struct loft_section){station, c, *p};
    if (l->n)
        link_make(&l->section[l->n - 1].piece, p, &l->link[l->n - 1]);
    l->n++;
    return NULL;
}

void loft_free(struct loft *l)
{
    free(l->section);
    free(l->link);
    *l = (struct loft){0};
}

/* One chord of a line: from section i through `at` to section i + way, where it is at `to`. */
struct chord { double to, length, slope[2]; };

/* 0 where the line ends. */
static int chord_find(const struct loft *l, int64_t i, int way, double at, struct chord *c)
{
    double p[2], q[2];

    if (i + way < 0 || i + way >= l->n)
        return 0;
    const struct link *k = &l->link[way < 0 ? i - 1 : i];
    c->to = way < 0 ? link_map(k->n, k->b, k->a, at) : link_map(k->n, k->a, k->b, at);
    if (isnan(c->to))
        return 0;
    curve_point(l->section[i].curve, at, p);
    curve_point(l->section[i + way].curve, c->to, q);
    double x = l->section[i + way].station - l->section[i].station;
    c->length = fabs(x);
    for (int d = 0; d < 2; d++)
        c->slope[d] = (q[d] - p[d]) / x;
    return 1;
}

/* m, not turned against the chord nor steeper than three times it, but for what takes the cubic OVERSHOOT beyond its ends: opposite
 * slopes m and -m where the chord is level do so by m length/4. */
static double slope_limit(double m, double chord, double length)
{
    double free = 4 * OVERSHOOT / length, most = m * chord > 0 ? fmax(3 * fabs(chord), free) : free;

    return copysign(fmin(fabs(m), most), m);
}

/* Unit vector along section i at `at`. */
static void tangent_find(const struct loft *l, int64_t i, double at, double e[2])
{
    double y[3], z[3];

    spline_at(&l->section[i].curve->y, at, y);
    spline_at(&l->section[i].curve->z, at, z);
    double length = hypot(y[1], z[1]);
    e[0] = y[1] / length;
    e[1] = z[1] / length;
}

/* v := its components along the section and normal to it, the way e (1), or back (-1). */
static void vector_turn(double v[2], const double e[2], int way)
{
    double first = v[0] * e[0] + way * v[1] * e[1];

    v[1] = v[1] * e[0] - way * v[0] * e[1];
    v[0] = first;
}

/* Slope of the line through `at` of section i: that of the parabola through three sections, limited along the section and normal to it,
 * so that lines may turn on a smooth surface without a crease. */
static void line_slope(const struct loft *l, int64_t i, double at, double slope[2])
{
    struct chord b, a, next;
    double e[2];
    int before = chord_find(l, i, -1, at, &b), after = chord_find(l, i, 1, at, &a), way = after ? 1 : -1;

    tangent_find(l, i, at, e);
    slope[0] = slope[1] = 0;
    if (before)
        vector_turn(b.slope, e, 1);
    if (after)
        vector_turn(a.slope, e, 1);
    const struct chord *only = after ? &a : &b;
    int more = before != after && chord_find(l, i + way, way, only->to, &next);
    if (more)
        vector_turn(next.slope, e, 1);
    for (int d = 0; d < 2 && (before || after); d++)
        if (before && after) {
            double m = (a.length * b.slope[d] + b.length * a.slope[d]) / (a.length + b.length);
            slope[d] = slope_limit(slope_limit(m, a.slope[d], a.length), b.slope[d], b.length);
        } else {
            double turn = more ? (only->slope[d] - next.slope[d]) * only->length / (only->length + next.length) : 0;
            slope[d] = slope_limit(only->slope[d] + turn, only->slope[d], only->length);
        }
    vector_turn(slope, e, -1);
}

/* Point of the line from `a` of section i to `b` of section i + 1 at station s, and its slope. */
static void line_point(const struct loft *l, int64_t i, double a, double b, double s, double p[2], double slope[2])
{
    const struct loft_section *one = &l->section[i], *two = one + 1;
    double h = two->station - one->station, t = (s - one->station) / h, pa[2], pb[2], sa[2], sb[2];

    curve_point(one->curve, a, pa);
    curve_point(two->curve, b, pb);
    line_slope(l, i, a, sa);
    line_slope(l, i + 1, b, sb);
    for (int d = 0; d < 2; d++) {
        struct hermite at = hermite_at(pa[d], sa[d], pb[d], sb[d], h, t);
        p[d] = at.z;
        slope[d] = at.slope;
    }
}

double loft_motion(const struct loft *l, int64_t i)
{
    const struct link *k = &l->link[i];
    double most = 0, length = k->a[k->n - 1] - k->a[0], p[2], q[2];
    int64_t steps = (int64_t)ceil(length / MOTION_STEP);

    for (int64_t j = 0; j <= steps; j++) {
        double at = k->a[0] + length * (double)j / (double)steps;
        curve_point(l->section[i].curve, at, p);
        curve_point(l->section[i + 1].curve, link_map(k->n, k->a, k->b, at), q);
        most = fmax(most, hypot(q[0] - p[0], q[1] - p[1]));
    }
    return most;
}

/* Points and slopes of the lines at station s of section i, the whole piece; y z dy/ds dz/ds [n] each. */
static void section_points(const struct loft *l, int64_t i, int64_t n, double *const out[4])
{
    const struct loft_section *x = &l->section[i];
    double p[2], slope[2];

    for (int64_t j = 0; j < n; j++) {
        double at = x->piece.from + (x->piece.to - x->piece.from) * (double)j / (double)(n - 1);
        curve_point(x->curve, at, p);
        line_slope(l, i, at, slope);
        out[0][j] = p[0], out[1][j] = p[1], out[2][j] = slope[0], out[3][j] = slope[1];
    }
}

/* The same at s between section i and the next, evenly over the mean of both lengths. */
static void link_points(const struct loft *l, int64_t i, double s, int64_t n, double *const out[4])
{
    const struct link *k = &l->link[i];
    double t = (s - l->section[i].station) / (l->section[i + 1].station - l->section[i].station);
    double both[LINK_MOST], p[2], slope[2];

    for (int j = 0; j < k->n; j++)
        both[j] = (1 - t) * k->a[j] + t * k->b[j];
    for (int64_t j = 0; j < n; j++) {
        double at = both[0] + (both[k->n - 1] - both[0]) * (double)j / (double)(n - 1);
        line_point(l, i, link_map(k->n, both, k->a, at), link_map(k->n, both, k->b, at), s, p, slope);
        out[0][j] = p[0], out[1][j] = p[1], out[2][j] = slope[0], out[3][j] = slope[1];
    }
}

/* y, z and their slopes along the track become splines over the length along the points. */
static const char *outline_fit(int64_t n, double *const raw[4], double smoothing, struct outline *o)
{
    struct spline fit[4] = {{0}};
    double *length = calloc((size_t)n, sizeof *length), at[4][3];
    const char *why = length ? outline_new(o, n) : REASON_MEMORY;

    for (int64_t j = 1; !why && j < n; j++)
        length[j] = length[j - 1] + hypot(raw[0][j] - raw[0][j - 1], raw[1][j] - raw[1][j - 1]);
    for (int d = 0; d < 4 && !why; d++)
        why = spline_fit(&fit[d], n, length, raw[d], NULL, spline_lambda(smoothing));
    for (int64_t j = 0; !why && j < n; j++) {
        for (int d = 0; d < 4; d++)
            spline_at(&fit[d], length[j], at[d]);
        o->y[j] = at[0][0];
        o->z[j] = at[1][0];
        o->slope[j] = at[1][1] / at[0][1];
        o->curvature[j] = (at[0][1] * at[1][2] - at[1][1] * at[0][2]) / pow(hypot(at[0][1], at[1][1]), 3);
        o->fall[j] = at[3][0] - o->slope[j] * at[2][0];
    }
    for (int d = 0; d < 4; d++)
        spline_free(&fit[d]);
    free(length);
    return why;
}

const char *loft_outline(const struct loft *l, double s, double spacing, double smoothing, struct outline *o)
{
    int64_t i = 0;

    *o = (struct outline){0};
    if (l->n == 0 || s < l->section[0].station || s > l->section[l->n - 1].station)
        return NULL;
    while (i < l->n - 1 && l->section[i + 1].station <= s)
        i++;
    int on = l->section[i].station == s;
    const struct link *k = &l->link[i];
    double length = on ? l->section[i].piece.to - l->section[i].piece.from : fmax(k->a[k->n - 1] - k->a[0], k->b[k->n - 1] - k->b[0]);
    int64_t n = (int64_t)ceil(length / spacing) + 1;
    double *store = calloc((size_t)n * 4, sizeof *store), *const raw[4] = {store, store + n, store + 2 * n, store + 3 * n};
    if (!store)
        return REASON_MEMORY;
    on ? section_points(l, i, n, raw) : link_points(l, i, s, n, raw);
    const char *why = outline_fit(n, raw, smoothing, o);
    free(store);
    if (why)
        outline_free(o);
    return why;
}
