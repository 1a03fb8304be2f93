#include "tools/draw/radius.h"

#include "tools/draw/contact.h"

/* Rolling radius of the contact that touches, over u, into r [us]; points without contact are left out of u [us] too. */
static int64_t radii(const struct ctab *t, double station, double yaw, double *u, double *r)
{
    int64_t i = contact_nearest(t->stations, t->station, station), j = contact_nearest(t->yaws, t->yaw, yaw), n = 0;

    for (int64_t k = 0; k < t->us; k++) {
        int count;
        const float *row = ctab_node(t, i, j, k, &count);
        if (count == 0)
            continue;
        u[n] = t->u[k];
        r[n++] = row[CTAB_RADIUS];
    }
    return n;
}

/* a at v, straight between the knots x [n] increasing. */
static double between(int64_t n, const double *x, const double *a, double v)
{
    int64_t i = 1;

    while (i < n - 1 && x[i] < v)
        i++;
    return a[i - 1] + (v - x[i - 1]) / (x[i] - x[i - 1]) * (a[i] - a[i - 1]);
}

const char *radius_chart(struct chart *c, const struct ctab *left, const struct ctab *right, double station, double yaw)
{
    double *ul = chart_numbers(c, left->us), *rl = chart_numbers(c, left->us);
    double *ur = chart_numbers(c, right->us), *rr = chart_numbers(c, right->us);
    double *y = chart_numbers(c, left->us), *difference = chart_numbers(c, left->us);

    if (left->side != 'l' || right->side != 'r')
        return "the left table comes first, then the right one";
    if (!ul || !rl || !ur || !rr || !y || !difference)
        return c->why;
    int64_t nl = radii(left, station, yaw, ul, rl), nr = radii(right, station, yaw, ur, rr), n = 0;
    if (nl < 2 || nr < 2)
        return "no contacts there";
    for (int64_t k = 0; k < nl; k++)
        if (ul[k] >= ur[0] && ul[k] <= ur[nr - 1]) {
            y[n] = ul[k];
            difference[n++] = between(nr, ur, rr, ul[k]) - rl[k];
        }
    c->x = (struct chart_axis){.label = "lateral displacement of the wheelset y (mm)", .factor = 1e3};
    struct chart_panel *panel = chart_add_panel(c, "right − left (mm)", 1e3);
    chart_add_series(c, panel, "rolling radius difference, right − left", n, y, difference)->colour = CHART_BLACK;
    panel = chart_add_panel(c, "radius (mm)", 1e3);
    chart_add_series(c, panel, "left wheel", nl, ul, rl);
    chart_add_series(c, panel, "right wheel", nr, ur, rr)->dash = CANVAS_DASHED;
    return c->why;
}
