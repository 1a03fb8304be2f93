/* Both curves are cubic Hermite polynomials between the same nodes, so their difference is one too: its minimum in a cell where the
 * slope changes from falling to rising is the root of a quadratic, to rounding and without iteration. */
#include "tools/contact/gap.h"

#include <math.h>
#include <string.h>

#define NO_NODE (-HUGE_VAL)   /* z of a node nothing covers */

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

/* Moves the longest run of covered nodes to the front. */
static void keep_run(struct gap_curve *c)
{
    int64_t from = 0, length = 0;

    for (int64_t i = 0, start = 0; i <= c->n; i++) {
        if (i < c->n && c->z[i] != NO_NODE)
            continue;
        if (i - start > length) {
            from = start;
            length = i - start;
        }
        start = i + 1;
    }
    memmove(c->z, c->z + from, (size_t)length * sizeof *c->z);
    memmove(c->slope, c->slope + from, (size_t)length * sizeof *c->slope);
    memmove(c->k, c->k + from, (size_t)length * sizeof *c->k);
    c->first += from;
    c->n = length;
}

void gap_tabulate(const double *y, const double *z, const double *slope, const double *k, int64_t n, double step, struct gap_curve *c)
{
    int64_t last;

    gap_range(y, n, step, &c->first, &last);
    c->n = last >= c->first ? last - c->first + 1 : 0;
    for (int64_t j = 0; j < c->n; j++)
        c->z[j] = NO_NODE;
    for (int64_t i = 0; i + 1 < n; i++) {
        double h = y[i + 1] - y[i];
        if (!(h > 0))
            continue;
        int64_t end = (int64_t)floor(y[i + 1] / step);
        for (int64_t j = (int64_t)ceil(y[i] / step); j <= end; j++) {
            double t = ((double)j * step - y[i]) / h;
            struct hermite p = hermite_at(z[i], slope[i], z[i + 1], slope[i + 1], h, t);
            int64_t at = j - c->first;
            if (p.z > c->z[at]) {
                c->z[at] = p.z;
                c->slope[at] = p.slope;
                c->k[at] = k[i] + t * (k[i + 1] - k[i]);
            }
        }
    }
    keep_run(c);
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

static void minimum_at(const struct gap_curve *r, const struct gap_curve *w, int64_t i, int64_t j, double step, double t,
                       struct gap_minimum *m)
{
    struct hermite rail = {r->z[i], r->slope[i]}, wheel = {w->z[j], w->slope[j]};

    m->rail_k = r->k[i];
    m->wheel_k = w->k[j];
    if (t > 0) {
        rail = hermite_at(r->z[i], r->slope[i], r->z[i + 1], r->slope[i + 1], step, t);
        wheel = hermite_at(w->z[j], w->slope[j], w->z[j + 1], w->slope[j + 1], step, t);
        m->rail_k += t * (r->k[i + 1] - r->k[i]);
        m->wheel_k += t * (w->k[j + 1] - w->k[j]);
    }
    m->y = ((double)(r->first + i) + t) * step;
    m->gap = rail.z - wheel.z;
    m->z = rail.z;
    m->end = 0;
    m->slope = rail.slope;
}

static void minimum_at_end(const struct gap_curve *r, const struct gap_curve *w, int64_t i, int64_t j, double step,
                           struct gap_minimum *m)
{
    minimum_at(r, w, i, j, step, 0, m);
    m->slope = w->slope[j];
    m->end = 1;
}

int gap_minima(const struct gap_curve *rail, const struct gap_curve *wheel, int64_t shift, double step, double apart, int ends,
               struct gap_minimum *m, int most)
{
    int64_t off = rail->first - wheel->first - shift;             /* wheel's index of rail's index 0 */
    int64_t lo = off < 0 ? -off : 0;
    int64_t hi = rail->n - 1 < wheel->n - 1 - off ? rail->n - 1 : wheel->n - 1 - off;
    const double *rs = rail->slope, *ws = wheel->slope;
    struct gap_minimum one;
    int n = 0;

    if (lo >= hi)
        return 0;
    if (ends & GAP_LEFT_END && lo == 0 && rs[lo] > ws[lo + off]) {
        minimum_at_end(rail, wheel, lo, lo + off, step, &one);
        n = keep(m, n, most, apart, &one);
    }
    for (int64_t i = lo, j = lo + off; i < hi; i++, j++)
        if (rs[i] < ws[j] && rs[i + 1] >= ws[j + 1]) {
            const double *rz = rail->z + i, *wz = wheel->z + j;
            double t = least(rz[0] - wz[0], rz[1] - wz[1], step * (rs[i] - ws[j]), step * (rs[i + 1] - ws[j + 1]));
            minimum_at(rail, wheel, i, j, step, t, &one);
            n = keep(m, n, most, apart, &one);
        }
    if (ends & GAP_RIGHT_END && hi == rail->n - 1 && rs[hi] < ws[hi + off]) {
        minimum_at_end(rail, wheel, hi, hi + off, step, &one);
        n = keep(m, n, most, apart, &one);
    }
    return n;
}
