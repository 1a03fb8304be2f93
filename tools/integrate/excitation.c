#include "tools/integrate/excitation.h"
#include "formats/reason.h"
#include "tools/profile/spline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { KNOTS_A_WAVE = 40, KNOTS_A_SPACING = 4, KNOT = 8, KNOTS_MOST = 4000000 };

/* ---- irregularity ---- */

/* 1 - cos from 0 at `from` to 1 at from + fade. */
static double faded(const struct excitation_options *o, double x, double *slope)
{
    const double t = (o->trailing ? o->to - x : x - o->from) / o->fade;

    *slope = t > 0 && t < 1 ? (o->trailing ? -0.5 : 0.5) * M_PI / o->fade * sin(M_PI * t) : 0;
    return t <= 0 ? 0 : t >= 1 ? 1 : 0.5 * (1 - cos(M_PI * t));
}

/* A quantity goes to the rails as EN 13848-1 has them: level and alignment their means, cross level and gauge their differences. */
static void spread(struct excitation *e, enum irregularity_quantity quantity, const double *value, const double *slope)
{
    static const double share[IRREGULARITY_QUANTITIES][4] = {
        [IRREGULARITY_LEVEL] = {1, 0, 1, 0},
        [IRREGULARITY_ALIGNMENT] = {0, 1, 0, 1},
        [IRREGULARITY_CROSS_LEVEL] = {-0.5, 0, 0.5, 0},
        [IRREGULARITY_GAUGE] = {0, -0.5, 0, 0.5},
    };

    for (int64_t i = 0; i < e->n; i++) {
        double turn, up = faded(&e->o, e->x0 + (double)i * e->h, &turn), *knot = e->knot + KNOT * i;
        for (int k = 0; k < 4; k++) {
            const double w = share[quantity][k] * e->o.scale;
            knot[k] += w * up * value[i];
            knot[4 + k] += w * (up * slope[i] + turn * value[i]) * e->h;
        }
    }
}

/* Of one quantity at the knots into value and slope; 0 in *there where the input has none. */
static const char *sample(const struct excitation *e, enum irregularity_quantity quantity, double *value, double *slope, int *there)
{
    const struct irregularity *m = e->o.measured;
    struct spline line;
    const char *why;

    *there = !m || m->value[quantity];
    if (!m)
        spectrum_series(&e->o.waves, quantity, e->x0, e->h, e->n, value, slope);
    if (!m || !*there)
        return NULL;
    if ((why = spline_fit(&line, m->n, m->x, m->value[quantity], NULL, 0)))
        return why;
    for (int64_t i = 0; i < e->n; i++) {
        double f[3];
        spline_at(&line, e->x0 + (double)i * e->h, f);
        value[i] = f[0];
        slope[i] = f[1];
    }
    spline_free(&line);
    return NULL;
}

static double knot_spacing(const struct excitation_options *o)
{
    double least = HUGE_VAL;

    if (!o->measured)
        return o->waves.shortest / KNOTS_A_WAVE;
    for (int64_t i = 1; i < o->measured->n; i++)
        least = fmin(least, o->measured->x[i] - o->measured->x[i - 1]);
    return least / KNOTS_A_SPACING;
}

static const char *lay_irregularity(struct excitation *e)
{
    const struct excitation_options *o = &e->o;
    const struct irregularity *m = o->measured;
    const double h = knot_spacing(o), count = ceil((o->to - o->from) / h) + 2;
    double *room;
    const char *why = NULL;

    if (m && (m->x[0] > o->from || m->x[m->n - 1] < o->to))
        return reason("irregularity: reaches from %g to %g m, but %g to %g m are run over", m->x[0], m->x[m->n - 1], o->from, o->to);
    if (count > KNOTS_MOST)
        return reason("irregularity: %.3g points, most are %d", count, KNOTS_MOST);
    e->n = (int64_t)count;
    e->h = h;
    e->x0 = o->from;
    e->knot = calloc((size_t)(KNOT * e->n), sizeof *e->knot);
    room = calloc((size_t)(2 * e->n), sizeof *room);
    if (!e->knot || !room)
        why = REASON_MEMORY;
    for (int quantity = 0; quantity < IRREGULARITY_QUANTITIES && !why; quantity++) {
        int there;
        why = sample(e, quantity, room, room + e->n, &there);
        if (!why && there)
            spread(e, quantity, room, room + e->n);
    }
    free(room);
    return why;
}

const char *excitation_new(struct excitation *e, const struct excitation_options *o)
{
    const char *why = NULL;

    *e = (struct excitation){.o = *o};
    if (o->measured || o->waves.shortest > 0)
        why = lay_irregularity(e);
    if (why)
        excitation_free(e);
    return why;
}

void excitation_free(struct excitation *e)
{
    free(e->knot);
    *e = (struct excitation){0};
}

/* Cubic Hermite over t = 0..1: value and slope by t. */
static void between(double t, double p, double dp, double q, double dq, double *f, double *df)
{
    const double u = 1 - t;

    *f = u * u * (1 + 2 * t) * p + t * u * u * dp + t * t * (3 - 2 * t) * q - t * t * u * dq;
    *df = 6 * t * u * (q - p) + u * (1 - 3 * t) * dp + t * (3 * t - 2) * dq;
}

static void add_irregularity(const struct excitation *e, double s, int side, struct excitation_at *at)
{
    const double place = (s - e->x0) / e->h;
    const int64_t i = (int64_t)floor(place);
    const double *p = e->knot + KNOT * i + 2 * side, *q = p + KNOT;
    double slope;

    if (place < 0 || i > e->n - 2)
        return;
    between(place - (double)i, p[0], p[4], q[0], q[4], &at->z, &slope);
    at->z_slope = slope / e->h;
    between(place - (double)i, p[1], p[5], q[1], q[5], &at->y, &slope);
    at->y_slope = slope / e->h;
}

/* ---- single defects ---- */

static int is_on(int of, int side)
{
    return of == CASE_BOTH || of == (side ? CASE_RIGHT : CASE_LEFT);
}

/* depth/2 (1 - cos 2 pi (s - from)/length). */
static void add_dip(const struct case_dip *d, double s, struct excitation_at *at)
{
    const double k = 2 * M_PI / d->length, x = s - d->from;

    if (x <= 0 || x >= d->length)
        return;
    at->z += 0.5 * d->depth * (1 - cos(k * x));
    at->z_slope += 0.5 * d->depth * k * sin(k * x);
}

/* Two rail ends bent down: depth (1 - |x|/l)^2, l half the length.  They meet at an angle of 4 depth/l. */
static void add_joint(const struct case_joint *j, double s, struct excitation_at *at)
{
    const double l = 0.5 * j->length, x = s - j->at, left = 1 - fabs(x) / l;

    if (left <= 0)
        return;
    at->z += j->depth * left * left;
    at->z_slope += (x < 0 ? 2 : -2) * j->depth / l * left;
}

/* The flat comes to the rail at f->at and once a turn from there.  Fresh, a chord of the wheel: the wheel tips over its first edge and then
 * about its last, so its centre falls by (l/2 - |x|)^2/(2 r).  Worn: depth/2 (1 + cos 2 pi x/l), the depth half of the chord's, l^2/(16 r), of
 * which the edges have been rolled away. */
static void add_flat(const struct case_flat *f, double s, double r, struct excitation_at *at)
{
    const double x = remainder(s - f->at, 2 * M_PI * r), edge = 0.5 * f->length - fabs(x), k = 2 * M_PI / f->length;
    const double depth = f->length * f->length / (16 * r);

    if (edge <= 0)
        return;
    if (f->shape == CASE_FRESH) {
        at->z += edge * edge / (2 * r);
        at->z_slope += (x < 0 ? 1 : -1) * edge / r;
    } else {
        at->z += 0.5 * depth * (1 + cos(k * x));
        at->z_slope -= 0.5 * depth * k * sin(k * x);
    }
}

static void find(const struct excitation *e, double s, int64_t i, int side, double r, struct excitation_at *at)
{
    const struct excitation_options *o = &e->o;

    *at = (struct excitation_at){0};
    if (e->n)
        add_irregularity(e, s, side, at);
    for (int64_t k = 0; k < o->dips; k++)
        if (is_on(o->dip[k].rail, side))
            add_dip(&o->dip[k], s, at);
    for (int64_t k = 0; k < o->joints; k++)
        if (is_on(o->joint[k].rail, side))
            add_joint(&o->joint[k], s, at);
    for (int64_t k = 0; k < o->flats; k++)
        if (o->flat[k].wheelset == i + 1 && is_on(o->flat[k].side, side))
            add_flat(&o->flat[k], s, r, at);
}

/* Turned half way round about z, heights stay, lines and slopes of heights change their sign, slopes of lines change it twice. */
void excitation_find(const struct excitation *e, double s, int64_t i, int side, double r, struct excitation_at *at)
{
    if (!e->o.trailing) {
        find(e, s, i, side, r, at);
        return;
    }
    find(e, -s, i, !side, r, at);
    at->z_slope = -at->z_slope;
    at->y = -at->y;
}
