/* Between two stations a contact goes on along its link: its height is the parabola through both ends with half the slope of each, the
 * rest a straight line.  One that ends or begins goes on by its slope for half the way.  The wheel rests on the lowest. */
#include "tools/draw/path.h"

#include <math.h>

enum { LINES = 5, PARTS = 8 };                 /* displacements; samples between two stations */
static const double apart = 2e-3;              /* m, between the displacements */
static const double leap = 3e-3;               /* m, of the contact from one sample to the next, between which no line is drawn */
static const double tangent = 0.05;            /* m, a contact that ends goes on no further */

static const enum ctab_column column[PATH_VALUES] = {CTAB_HEIGHT, CTAB_RAIL_Y, CTAB_X};

/* Keeps the values of a contact of this height where none before is lower. */
static void rest(double value[PATH_VALUES], double height, const float *a, const float *b, double part)
{
    if (value[0] <= height)
        return;
    value[0] = height;
    for (int v = 1; v < PATH_VALUES; v++)
        value[v] = (1 - part) * a[column[v]] + part * b[column[v]];
}

void path_between(const struct ctab *t, int64_t i, int64_t j, int64_t k, double part, double value[PATH_VALUES])
{
    int before, behind;
    const float *a = ctab_node(t, i, j, k, &before), *b = ctab_node(t, i + 1, j, k, &behind);
    double length = t->station[i + 1] - t->station[i];
    unsigned begun = 0;                        /* bits of the rows behind that go on from one before */

    value[0] = INFINITY;
    value[1] = value[2] = NAN;
    for (int r = 0; r < before; r++, a += CTAB_N) {
        int link = t->link[(a - t->row) / CTAB_N * CTAB_LINKS + CTAB_LINK_STATION];
        if (link) {
            const float *on = b + (link - 1) * CTAB_N;
            double bend = 0.5 * part * (1 - part) * length * ((double)a[CTAB_HEIGHT_S] - (double)on[CTAB_HEIGHT_S]);
            begun |= 1u << (link - 1);
            rest(value, (1 - part) * a[CTAB_HEIGHT] + part * on[CTAB_HEIGHT] + bend, a, on, part);
        } else if (part <= 0.5) {
            rest(value, a[CTAB_HEIGHT] + a[CTAB_HEIGHT_S] * fmin(part * length, tangent), a, a, 0);
        }
    }
    for (int r = 0; r < behind && part > 0.5; r++, b += CTAB_N)
        if (!(begun >> r & 1))
            rest(value, b[CTAB_HEIGHT] - b[CTAB_HEIGHT_S] * fmin((1 - part) * length, tangent), b, b, 0);
    if (isinf(value[0]))
        value[0] = NAN;
}

/* Samples at displacement k into x and y[PATH_VALUES], of [n] each. */
static void path_samples(const struct ctab *t, int64_t j, int64_t k, int64_t n, double *x, double *const *y)
{
    double last = NAN;

    for (int64_t s = 0; s < n; s++) {
        int64_t i = s / PARTS < t->stations - 1 ? s / PARTS : t->stations - 2;
        double part = (double)(s - i * PARTS) / PARTS, value[PATH_VALUES];
        path_between(t, i, j, k, part, value);
        x[s] = t->station[i] + part * (t->station[i + 1] - t->station[i]);
        for (int v = 0; v < PATH_VALUES; v++)
            y[v][s] = v > 0 && fabs(value[1] - last) > leap ? (double)NAN : value[v];
        last = value[1];
    }
}

/* The largest angle by which the wheel's path turns upwards where its contact leaps, in the window; 0 where it does not. */
static double largest_kink(const struct chart *c, int64_t n, const double *x, double *const *y)
{
    double most = 0;

    for (int64_t s = 2; s + 1 < n; s++) {
        double turn = (y[0][s - 1] - y[0][s - 2]) / (x[s - 1] - x[s - 2]) - (y[0][s + 1] - y[0][s]) / (x[s + 1] - x[s]);
        if (isnan(y[1][s]) && x[s] > c->x.lo && x[s] < c->x.hi)
            most = fmax(most, turn);
    }
    return most;
}

const char *path_chart(struct chart *c, const struct ctab *t, const struct contact_place *at, double from, double to)
{
    static const char *const label[PATH_VALUES] = {"wheel z (mm)", "contact y (mm)", "ahead x (mm)"};
    int64_t j = contact_nearest(t->yaws, t->yaw, at->yaw), n = (t->stations - 1) * PARTS + 1;
    struct chart_panel *panel[PATH_VALUES];

    if (t->stations < 2)
        return "a table of one station has no path";
    c->x = (struct chart_axis){.label = "station of the wheel (m)", .lo = fmax(from, t->station[0]),
                               .hi = fmin(to, t->station[t->stations - 1])};
    for (int v = 0; v < PATH_VALUES; v++)
        panel[v] = chart_add_panel(c, label[v], 1e3);
    panel[0]->y.down = 1;
    panel[0]->share = 1.4;
    for (int line = 0; line < LINES; line++) {
        int64_t k = contact_nearest(t->us, t->u, at->u + (line - LINES / 2) * apart);
        double *x = chart_numbers(c, n), *y[PATH_VALUES];
        for (int v = 0; v < PATH_VALUES; v++)
            y[v] = chart_numbers(c, n);
        if (c->why)
            return c->why;
        path_samples(t, j, k, n, x, y);
        double kink = largest_kink(c, n, x, y);
        const char *name = chart_words(c, kink > 0 ? "%.3g mm: %.1f mrad" : "%.3g mm", t->u[k] * 1e3, kink * 1e3);
        for (int v = 0; v < PATH_VALUES; v++)
            chart_add_series(c, panel[v], v ? NULL : name, n, x, y[v]);
    }
    c->title = chart_words(c, "Path of the %s wheel at five u, and its kink; yaw %.2f mrad", t->side == 'l' ? "left" : "right", t->yaw[j] * 1e3);
    return c->why;
}
