/* The gap is taken as a cubic Hermite polynomial between the nodes: its minimum in a cell where the slope changes from falling to rising
 * is the root of a quadratic, to rounding and without iteration. */
#include "tools/contact/gap.h"

#include <math.h>

#include "tools/contact/clones.h"

#define FACE 5.0              /* |dz/dy| of a face: where a wheel ends in one, the back of its flange, it counts; a rail goes on below one */

struct hermite { double z, slope; };

/* Cubic with values z0, z1 and slopes d0, d1 (per unit of y) at the ends of a cell of width h, at t of 0..1. */
static struct hermite hermite_at(double z0, double d0, double z1, double d1, double h, double t)
{
    double s = 1 - t, dz = (z1 - z0) / h;

    return (struct hermite){
        .z = z0 * s * s * (1 + 2 * t) + z1 * t * t * (1 + 2 * s) + h * t * s * (d0 * s - d1 * t),
        .slope = 6 * t * s * dz + d0 * s * (1 - 3 * t) + d1 * t * (1 - 3 * s),
    };
}

static void gap_range(const double *y, int64_t n, double step, int64_t *first, int64_t *last)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (int64_t i = 0; i < n; i++) {                             /* comparisons with NaN are false */
        lo = y[i] < lo ? y[i] : lo;
        hi = y[i] > hi ? y[i] : hi;
    }
    *first = lo <= hi ? (int64_t)ceil(lo / step) : 0;
    *last = lo <= hi ? (int64_t)floor(hi / step) : -1;
}

int64_t gap_nodes(const double *y, int64_t n, double step)
{
    int64_t first, last;

    gap_range(y, n, step, &first, &last);
    return last >= first ? last - first + 1 : 0;
}

/* The piece from point i to i + 1 onto the nodes it covers and lies lowest on. */
static void tabulate_piece(const struct gap_line *l, int64_t i, double step, struct gap_curve *c)
{
    double h = l->y[i + 1] - l->y[i], along_y = (l->along[i + 1] - l->along[i]) / h;
    double bend_y = (l->bend[i + 1] - l->bend[i]) / h;
    int64_t end = (int64_t)floor(l->y[i + 1] / step);

    for (int64_t j = (int64_t)ceil(l->y[i] / step); j <= end; j++) {
        double d = (double)j * step - l->y[i], t = d / h;
        struct hermite p = hermite_at(l->z[i], l->slope[i], l->z[i + 1], l->slope[i + 1], h, t);
        int64_t at = j - c->first;
        if (!isnan(c->slope[at]) && p.z <= c->z[at])
            continue;
        c->z[at] = p.z;
        c->slope[at] = p.slope;
        c->k[at] = l->k[i] + t * (l->k[i + 1] - l->k[i]);
        c->along[at] = l->along[i] + d * along_y;
        c->along_y[at] = along_y;
        c->bend[at] = l->bend[i] + d * bend_y;
        c->bend_y[at] = bend_y;
        c->at[at] = 0;
    }
}

void gap_tabulate(const struct gap_line *line, double step, struct gap_curve *c)
{
    int64_t last;

    gap_range(line->y, line->n, step, &c->first, &last);
    c->n = last >= c->first ? last - c->first + 1 : 0;
    for (int64_t j = 0; j < c->n; j++)
        c->slope[j] = (double)NAN;
    for (int64_t i = 0; i + 1 < line->n; i++)
        if (line->y[i + 1] > line->y[i])
            tabulate_piece(line, i, step, c);
    c->level = 1;
    for (int64_t i = 0; i < line->n; i++)
        c->level &= line->along[i] == 0 && line->bend[i] == 0;
}

void gap_join(struct gap_curve *c, const struct gap_curve *from, double x, double b)
{
    for (int64_t i = 0, j = c->first - from->first; i < c->n; i++, j++) {
        if (j < 0 || j >= from->n || isnan(from->slope[j]))
            continue;
        if (!isnan(c->slope[i]) && from->z[j] + 0.5 * b * x * x >= c->z[i] + 0.5 * b * c->at[i] * c->at[i])
            continue;
        c->z[i] = from->z[j];
        c->slope[i] = from->slope[j];
        c->k[i] = from->k[j];
        c->along[i] = from->along[j];
        c->along_y[i] = from->along_y[j];
        c->bend[i] = from->bend[j];
        c->bend_y[i] = from->bend_y[j];
        c->at[i] = x;
        c->level = 0;
    }
}

/* Where a cubic with end values g0, g1 and end slopes d0 < 0 <= d1 (all per cell) is least, in (0, 1]. */
static double least(double g0, double g1, double d0, double d1)
{
    double a = 6 * (g0 - g1) + 3 * (d0 + d1), b = -6 * (g0 - g1) - 4 * d0 - 2 * d1;    /* a t^2 + b t + d0 = 0 */
    double root = sqrt(fmax(b * b - 4 * a * d0, 0));
    double t = b >= 0 ? -2 * d0 / (b + root) : (root - b) / (2 * a);

    return t >= 0 && t <= 1 ? t : d0 / (d0 - d1);
}

/* Adds a minimum to the n held, which are in order of y. */
static int keep(struct gap_minimum *m, int n, int most, double apart, const struct gap_minimum *new)
{
    if (n > 0 && new->y - m[n - 1].y < apart) {
        if (new->gap < m[n - 1].gap)
            m[n - 1] = *new;
        return n;
    }
    if (n < most) {
        m[n] = *new;
        return n + 1;
    }
    int high = 0;
    for (int i = 1; i < n; i++)
        high = m[i].gap > m[high].gap ? i : high;
    if (new->gap < m[high].gap) {
        for (; high < n - 1; high++)
            m[high] = m[high + 1];
        m[high] = *new;
    }
    return n;
}

/* Rail from its node lo on, wheel from its node lo + off on. */
struct overlap {
    const struct gap_curve *r, *w;
    int64_t lo, hi, off;
};

static inline double within(double x, double lo, double hi)
{
    x = x > lo ? x : lo;
    return x < hi ? x : hi;
}

/* Where rail and wheel are nearest in the plane of node i: q, and the gap there beyond z_r - z_w. */
static double nearest(const struct overlap *o, int64_t i, double *q)
{
    const struct gap_curve *r = o->r, *w = o->w;
    int64_t j = i + o->off;
    double e = r->along[i], k = r->bend[i], X = w->along[j], b = w->bend[j];

    *q = within((b * (X - r->at[i]) - e) / (b + k), X - r->reach[i], X + r->reach[i]);
    double behind = r->at[i] + *q - X;
    return *q * (e + 0.5 * k * *q) + 0.5 * b * behind * behind;
}

/* d(gap)/dy at the nodes lo .. hi into d[hi - lo + 1], of a rail that falls, at the x where the gap is least:
 * z_r' - z_w' + e' q + k' q^2/2 + b' (x - X)^2/2 + (e + k q) X'. */
CLONES static void gap_slopes_fall(const struct overlap *o, double *restrict d)
{
    const struct gap_curve *r = o->r, *w = o->w;
    int64_t i0 = o->lo, j0 = o->lo + o->off;
    const double *restrict rs = r->slope + i0, *restrict e = r->along + i0, *restrict e1 = r->along_y + i0, *restrict k = r->bend + i0;
    const double *restrict k1 = r->bend_y + i0, *restrict at = r->at + i0, *restrict reach = r->reach + i0;
    const double *restrict ws = w->slope + j0, *restrict X = w->along + j0, *restrict X1 = w->along_y + j0;
    const double *restrict b = w->bend + j0, *restrict b1 = w->bend_y + j0;

    for (int64_t i = 0; i <= o->hi - o->lo; i++) {
        double q = within((b[i] * (X[i] - at[i]) - e[i]) / (b[i] + k[i]), X[i] - reach[i], X[i] + reach[i]), behind = at[i] + q - X[i];
        d[i] = rs[i] - ws[i] + q * (e1[i] + 0.5 * k1[i] * q) + 0.5 * b1[i] * behind * behind + (e[i] + k[i] * q) * X1[i];
    }
}

static void gap_slopes(const struct overlap *o, double *restrict d)
{
    const double *rs = o->r->slope + o->lo, *ws = o->w->slope + o->lo + o->off;

    if (!o->r->level)
        gap_slopes_fall(o, d);
    for (int64_t i = 0; i <= o->hi - o->lo && o->r->level; i++)
        d[i] = rs[i] - ws[i];
}

static double gap_height(const struct overlap *o, int64_t i)
{
    double q;

    return o->r->z[i] - o->w->z[i + o->off] + (o->r->level ? 0 : nearest(o, i, &q));
}

double gap_node(const struct gap_curve *rail, const struct gap_curve *wheel, int64_t i, int64_t j)
{
    return gap_height(&(struct overlap){.r = rail, .w = wheel, .off = j - i}, i);
}

/* The rail where the wheel is nearest to it in the plane of node i. */
struct touch { double x, z, slope, fall; };

static struct touch touch_at(const struct overlap *o, int64_t i)
{
    const struct gap_curve *r = o->r;
    double q = 0;

    if (r->level)
        return (struct touch){o->w->along[i + o->off], r->z[i], r->slope[i], r->along[i]};
    nearest(o, i, &q);
    return (struct touch){r->at[i] + q, r->z[i] + q * (r->along[i] + 0.5 * r->bend[i] * q),
                          r->slope[i] + q * (r->along_y[i] + 0.5 * r->bend_y[i] * q), r->along[i] + r->bend[i] * q};
}

static double between(const double *a, double t)
{
    return t > 0 ? a[0] + t * (a[1] - a[0]) : a[0];
}

/* The minimum at t of the cell from node i on, or at the node itself; d are the gap's slopes at both nodes. */
static struct gap_minimum minimum_at(const struct overlap *o, const double *d, int64_t i, double step, double t)
{
    struct touch a = touch_at(o, i), b = t > 0 ? touch_at(o, i + 1) : a;
    struct hermite rail = {a.z + t * (b.z - a.z), a.slope + t * (b.slope - a.slope)}, gap = {gap_height(o, i), d[0]};
    int64_t j = i + o->off;

    if (t > 0) {
        /* Both at a's x, from which b's differs. */
        rail.slope = hermite_at(a.z, a.slope, b.z - 0.5 * (a.fall + b.fall) * (b.x - a.x), b.slope, step, t).slope;
        if (o->r->level)
            rail = hermite_at(a.z, a.slope, b.z, b.slope, step, t);
        gap = hermite_at(gap.z, d[0], gap_height(o, i + 1), d[1], step, t);
    }
    return (struct gap_minimum){
        .y = ((double)(o->r->first + i) + t) * step, .gap = gap.z, .x = a.x + t * (b.x - a.x), .z = rail.z, .slope = rail.slope,
        .fall = a.fall + t * (b.fall - a.fall), .rail_k = between(o->r->k + i, t), .wheel_k = between(o->w->k + j, t),
    };
}

static struct gap_minimum minimum_at_end(const struct overlap *o, const double *d, int64_t i, double step)
{
    struct gap_minimum m = minimum_at(o, d, i, step, 0);

    m.slope -= d[0];
    m.end = 1;
    return m;
}

int gap_minima(const struct gap_search *s, const struct gap_curve *rail, const struct gap_curve *wheel, int64_t shift, int ends,
               struct gap_minimum *m, int most)
{
    struct overlap o = {.r = rail, .w = wheel, .off = rail->first - wheel->first - shift};    /* wheel's index of rail's 0 */
    struct gap_minimum one;
    double *d = s->work;
    int n = 0;

    o.lo = o.off < 0 ? -o.off : 0;
    o.hi = rail->n - 1 < wheel->n - 1 - o.off ? rail->n - 1 : wheel->n - 1 - o.off;
    if (o.lo >= o.hi)
        return 0;
    gap_slopes(&o, d);
    if (ends & GAP_LEFT_END && o.lo == 0 && d[0] > 0 && fabs(rail->slope[0]) < FACE) {
        one = minimum_at_end(&o, d, 0, s->step);
        n = keep(m, n, most, s->apart, &one);
    }
    if (o.lo + o.off == 0 && d[0] > 0 && wheel->slope[0] > FACE) {
        one = minimum_at(&o, d, o.lo, s->step, 0);
        n = keep(m, n, most, s->apart, &one);
    }
    for (int64_t i = o.lo; i < o.hi; i++, d++)
        if (d[0] < 0 && d[1] >= 0) {
            double t = least(gap_height(&o, i), gap_height(&o, i + 1), s->step * d[0], s->step * d[1]);
            one = minimum_at(&o, d, i, s->step, t);
            n = keep(m, n, most, s->apart, &one);
        }
    if (ends & GAP_RIGHT_END && o.hi == rail->n - 1 && d[0] < 0 && fabs(rail->slope[o.hi]) < FACE) {
        one = minimum_at_end(&o, d, o.hi, s->step);
        n = keep(m, n, most, s->apart, &one);
    }
    return n;
}

int gap_at(const struct gap_pair *pair, double y, struct gap_place *p)
{
    const struct gap_curve *rail = pair->rail, *wheel = pair->wheel;
    struct overlap o = {.r = rail, .w = wheel, .off = rail->first - wheel->first - pair->shift};
    double step = pair->step, at = y / step - (double)rail->first;
    int64_t i = (int64_t)at, j = i + o.off;

    if (!(at >= 0) || i > rail->n - 2 || j < 0 || j > wheel->n - 2)
        return 0;
    double t = at - (double)i, d[2];
    o.lo = i, o.hi = i + 1;
    gap_slopes(&o, d);
    struct hermite gap = hermite_at(gap_height(&o, i), d[0], gap_height(&o, i + 1), d[1], step, t);
    struct hermite z = hermite_at(rail->z[i], rail->slope[i], rail->z[i + 1], rail->slope[i + 1], step, t);
    *p = (struct gap_place){.gap = gap.z, .z = z.z, .slope = gap.slope, .rail = z.slope,
                             .bend = (rail->level ? 0 : between(rail->bend + i, t)) + between(wheel->bend + j, t)};
    return !isnan(gap.slope);
}
