/* The gap is taken as a cubic Hermite polynomial between the nodes: its minimum in a cell where the slope changes from falling to rising
 * is the root of a quadratic, to rounding and without iteration. */
#include "tools/contact/gap.h"

#include <math.h>

#include "tools/contact/clones.h"
#include "tools/profile/hermite.h"

#define FACE 5.0              /* |dz/dy| of a face: where a wheel ends in one, the back of its flange, it counts; a rail goes on below one */

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

/* Of the slopes d[n + 1] of n cells, the first cell from `from` on in which they change from falling to rising; n where none.  Cells go by
 * blocks, most of which hold none and are passed in lanes. */
CLONES static int64_t next_rise(const double *d, int64_t from, int64_t n)
{
    enum { BLOCK = 32 };

    for (; from + BLOCK <= n; from += BLOCK) {
        int64_t rises = 0;
        for (int64_t i = from; i < from + BLOCK; i++)
            rises += (d[i] < 0) & (d[i + 1] >= 0);
        if (rises)
            break;
    }
    while (from < n && !(d[from] < 0 && d[from + 1] >= 0))
        from++;
    return from;
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
    const int64_t cells = o.hi - o.lo;
    gap_slopes(&o, d);
    if (ends & GAP_LEFT_END && o.lo == 0 && d[0] > 0 && fabs(rail->slope[0]) < FACE) {
        one = minimum_at_end(&o, d, 0, s->step);
        n = keep(m, n, most, s->apart, &one);
    }
    if (o.lo + o.off == 0 && d[0] > 0 && wheel->slope[0] > FACE) {
        one = minimum_at(&o, d, o.lo, s->step, 0);
        n = keep(m, n, most, s->apart, &one);
    }
    for (int64_t k = next_rise(d, 0, cells); k < cells; k = next_rise(d, k + 1, cells)) {
        int64_t i = o.lo + k;
        double t = least(gap_height(&o, i), gap_height(&o, i + 1), s->step * d[k], s->step * d[k + 1]);
        one = minimum_at(&o, d + k, i, s->step, t);
        n = keep(m, n, most, s->apart, &one);
    }
    if (ends & GAP_RIGHT_END && o.hi == rail->n - 1 && d[cells] < 0 && fabs(rail->slope[o.hi]) < FACE) {
        one = minimum_at_end(&o, d + cells, o.hi, s->step);
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
