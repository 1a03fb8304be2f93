/* Couplings at one place and its mirror image share a number.  Notes stand aside of symbols by themselves. */
#include "tools/draw/vehicle.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/draw/symbols.h"

static const struct chart_area area[VIEWS] = {
    [VIEW_SIDE] = {0, 0, 1, 0.37}, [VIEW_TOP] = {0, 0.37, 1, 0.29}, [VIEW_END] = {0, 0.66, 0.4, 0.34}};
static const struct chart_area key_area = {0.42, 0.67, 0.58, 0.33};
static const double type = 0.62;                            /* of a chart's, for all these words */
static const double symbol = 0.025, least = 0.2, most = 0.3;  /* of the width of the drawing, within these m */
static const double below = 0.15, beside = 0.2;             /* m, shown below the rails and around the boxes */
static const double close_by = 1e-3;                        /* m, couplings with one note */
enum { KEY_ROWS = 11, KEY_COLUMNS = 2, NARROW = 34 };      /* NARROW: bytes of names where there are two columns */

struct drawing {
    const struct veh *v;
    double from, to;          /* m, shown along x */
    int *number;              /* [couplings] of their place, from 1; 0 outside the window */
    int numbers;
};

static int inside(const struct drawing *d, double x)
{
    return x >= d->from && x <= d->to;
}

/* Length of a name without the -r or -l of a twin. */
static size_t stem(const char *name)
{
    const size_t n = strlen(name);
    return n > 2 && (!strcmp(name + n - 2, "-r") || !strcmp(name + n - 2, "-l")) ? n - 2 : n;
}

/* The same place but for its side. */
static int share_place(const struct veh *v, int64_t a, int64_t b)
{
    const double *p = &v->point[3 * a], *q = &v->point[3 * b];
    return fabs(p[0] - q[0]) + fabs(fabs(p[1]) - fabs(q[1])) + fabs(p[2] - q[2]) < close_by;
}

static void number_places(struct drawing *d)
{
    for (int64_t k = 0; k < d->v->couplings; k++) {
        if (!inside(d, d->v->point[3 * k]))
            continue;
        for (int64_t j = 0; j < k && !d->number[k]; j++)
            if (d->number[j] && share_place(d->v, j, k))
                d->number[k] = d->number[j];
        if (!d->number[k])
            d->number[k] = ++d->numbers;
    }
}

/* The boxes of bodies in the window, in each axis. */
static void extent(const struct drawing *d, double lo[3], double hi[3])
{
    for (int k = 0; k < 3; k++) {
        lo[k] = INFINITY;
        hi[k] = -INFINITY;
    }
    for (int64_t i = 0; i < d->v->bodies; i++) {
        const double *cg = &d->v->cg[3 * i];
        double half[3];
        view_box(d->v, i, half);
        for (int k = 0; k < 3 && inside(d, cg[0]); k++) {
            lo[k] = fmin(lo[k], cg[k] - half[k] - beside);
            hi[k] = fmax(hi[k], cg[k] + half[k] + beside);
        }
    }
    hi[2] = fmax(hi[2], below);
}

static void set_limits(struct chart *c, struct chart_panel *p, enum view view, const struct drawing *d)
{
    double lo[3], hi[3], least_xy[2], most_xy[2];

    extent(d, lo, hi);
    if (view != VIEW_END) {
        lo[0] = d->from;
        hi[0] = d->to;
    }
    view_place(view, lo, least_xy);
    view_place(view, hi, most_xy);
    c->x.lo = least_xy[0];
    c->x.hi = most_xy[0];
    p->y.lo = fmin(least_xy[1], most_xy[1]);
    p->y.hi = fmax(least_xy[1], most_xy[1]);
}

/* "1 2 5": the numbers of the places here in this view, each once; written at the first of them. */
static void note_numbers(struct chart *c, struct chart_panel *p, enum view view, const struct drawing *d, int64_t k)
{
    const struct veh *v = d->v;
    double here[2], there[2];
    char words[96] = "";
    int last = 0;

    view_place(view, &v->point[3 * k], here);
    for (int64_t j = 0; j < v->couplings; j++) {
        view_place(view, &v->point[3 * j], there);
        if (!d->number[j] || hypot(there[0] - here[0], there[1] - here[1]) > close_by)
            continue;
        if (j < k)
            return;
        if (d->number[j] > last && strlen(words) < sizeof words - 16) {
            snprintf(words + strlen(words), 16, "%s%d", *words ? " " : "", d->number[j]);
            last = d->number[j];
        }
    }
    chart_add_note(c, p, here[0], here[1], chart_words(c, "%s", words))->colour = CHART_WINE;
}

static void add_bodies(struct chart *c, struct chart_panel *p, enum view view, const struct drawing *d)
{
    const struct veh *v = d->v;

    for (int64_t i = 0, k = 0; i < v->bodies; i++) {
        double centre[2];
        if (view == VIEW_END && !inside(d, v->cg[3 * i]))
            continue;
        if (veh_is_wheelset(v, i)) {
            while (v->wheelset[k] != i)
                k++;
            view_wheels(c, p, view, v, k, CHART_BLACK);
            continue;
        }
        view_body(c, p, view, v, i, NULL, CHART_GREY, i % 2 ? 0xe2e6ea : 0xf0f2f4);
        view_place(view, &v->cg[3 * i], centre);
        view_line(c, p, 1, centre, CHART_BLACK, 0)->mark = CANVAS_CROSS;
        if (view == VIEW_SIDE && inside(d, centre[0]))
            chart_add_note(c, p, centre[0], centre[1], v->body_name[i])->colour = CHART_GREY;
    }
}

static void add_view(struct chart *c, enum view view, const struct drawing *d)
{
    struct chart_panel *p = view_begin(c, view);
    const double size = fmax(least, fmin(most, symbol * (d->to - d->from)));

    c->area = area[view];
    c->type = type;
    set_limits(c, p, view, d);
    if (view == VIEW_SIDE)
        symbols_legend(c, p, d->v);
    if (view != VIEW_TOP)
        view_line(c, p, 2, (double[]){view == VIEW_SIDE ? d->from : -1.5, 0, view == VIEW_SIDE ? d->to : 1.5, 0}, CHART_BLACK, 0.8);
    add_bodies(c, p, view, d);
    for (int64_t k = 0; k < d->v->couplings; k++)
        if (d->number[k]) {
            symbols_add(c, p, view, d->v, k, size);
            note_numbers(c, p, view, d, k);
        }
}

/* Names of the couplings at the place of k, each once, and whether they lie on both sides. */
static void list_names(const struct drawing *d, int64_t k, char *words, size_t size, int *both)
{
    const struct veh *v = d->v;
    size_t n = 0;

    *both = 0;
    for (int64_t j = k; j < v->couplings; j++) {
        const char *name = v->coupling_name[j];
        if (d->number[j] != d->number[k])
            continue;
        const int twin = j > 0 && d->number[j - 1] == d->number[j] && stem(name) < strlen(name) && stem(v->coupling_name[j - 1]) == stem(name) &&
                         !strncmp(v->coupling_name[j - 1], name, stem(name));
        *both |= v->point[3 * j + 1] * v->point[3 * k + 1] < 0;
        if (!twin && n < size)
            n += (size_t)snprintf(words + n, size - n, "%s%.*s", n ? ", " : "", (int)stem(name), name);
    }
}

/* Number of a place, the couplings there, their x, y and height. */
static const char *describe(struct chart *c, const struct drawing *d, int64_t k)
{
    const double *at = &d->v->point[3 * k];
    const int one_column = d->numbers <= KEY_ROWS;
    char names[72];
    int both;

    list_names(d, k, names, one_column ? sizeof names : NARROW, &both);
    return chart_words(c, "%d  %s at %.5g, %s%.5g, %s%.5g%s", d->number[k], names, at[0], both ? "±" : "", both ? fabs(at[1]) : at[1],
                       one_column ? "height " : "", -at[2], one_column ? " m" : "");
}

static void add_key(struct chart *c, const struct drawing *d)
{
    struct chart_panel *p = chart_add_panel(c, NULL, 1);
    int last = 0;

    c->bare = 1;
    c->type = type;
    c->x.hi = p->y.hi = 1;
    p->y.down = 1;
    for (int64_t k = 0; k < d->v->couplings; k++) {
        const int n = d->number[k] - 1;
        if (d->number[k] <= last || n >= KEY_ROWS * KEY_COLUMNS)
            continue;
        last = d->number[k];
        struct chart_note *note = chart_add_note(c, p, n < KEY_ROWS ? 0 : 0.5, (n % KEY_ROWS + 0.5) / (KEY_ROWS + 1), describe(c, d, k));
        note->fixed = 1;
        note->colour = CHART_BLACK;
    }
    if (d->numbers > KEY_ROWS * KEY_COLUMNS)
        chart_add_note(c, p, 0.5, 1, chart_words(c, "and %d more: narrow the window", d->numbers - KEY_ROWS * KEY_COLUMNS))->fixed = 1;
}

const char *vehicle_chart(struct chart *c, const struct veh *v, double from, double to)
{
    struct drawing d = {.v = v, .from = from, .to = to, .number = calloc((size_t)v->couplings + 1, sizeof(int))};

    if (!d.number)
        return REASON_MEMORY;
    double lo[3], hi[3];
    extent(&d, lo, hi);
    d.from = isfinite(from) ? from : lo[0];
    d.to = isfinite(to) ? to : hi[0];
    extent(&d, lo, hi);
    if (!(lo[0] < hi[0])) {
        free(d.number);
        return reason("no body between %g and %g m", d.from, d.to);
    }
    number_places(&d);
    c->title = chart_words(c, "%s, from the right, from above and from behind; boxes have the mass and the inertias of the bodies", v->name);
    add_view(c, VIEW_SIDE, &d);
    for (enum view view = VIEW_TOP; view < VIEWS; view++)
        add_view(chart_add_beside(c, &area[view]), view, &d);
    add_key(chart_add_beside(c, &key_area), &d);
    free(d.number);
    return c->why;
}
