/* Twins of a mirrored coupling, NAME-r and NAME-l, share a number.  Notes stand aside of symbols by themselves. */
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
enum { KEY_ROWS = 11, KEY_COLUMNS = 2 };

struct drawing {
    const struct veh *v;
    double from, to;          /* m, shown along x */
    int *number;              /* [couplings] from 1, shared by twins */
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

static int is_twin(const struct veh *v, int64_t a, int64_t b)
{
    const char *one = v->coupling_name[a], *other = v->coupling_name[b];
    return stem(one) < strlen(one) && stem(one) == stem(other) && !strncmp(one, other, stem(one));
}

static void number_couplings(struct drawing *d)
{
    for (int64_t k = 0; k < d->v->couplings; k++)
        if (inside(d, d->v->point[3 * k]))
            d->number[k] = k > 0 && d->number[k - 1] && is_twin(d->v, k - 1, k) ? d->numbers : ++d->numbers;
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

/* "1 2 5": the numbers of the couplings here in this view, each once; written at the first of them. */
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
        if (d->number[j] != last && strlen(words) < sizeof words - 16)
            snprintf(words + strlen(words), 16, "%s%d", *words ? " " : "", d->number[j]);
        last = d->number[j];
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

/* Number, name, bodies and place of a coupling, its y with both signs where it has a twin. */
static const char *describe(struct chart *c, const struct drawing *d, int64_t k)
{
    const struct veh *v = d->v;
    const double *at = &v->point[3 * k];
    const int twin = k + 1 < v->couplings && d->number[k + 1] == d->number[k];

    if (d->numbers > KEY_ROWS)
        return chart_words(c, "%d %.*s at %.4g, %s%.4g, %.4g", d->number[k], (int)stem(v->coupling_name[k]), v->coupling_name[k], at[0],
                           twin ? "±" : "", twin ? fabs(at[1]) : at[1], -at[2]);
    return chart_words(c, "%d  %.*s, %s to %s, at %.5g, %s%.5g, height %.5g m", d->number[k],
                       (int)(twin ? stem(v->coupling_name[k]) : strlen(v->coupling_name[k])), v->coupling_name[k],
                       v->body_name[v->ends[2 * k]], v->body_name[v->ends[2 * k + 1]], at[0], twin ? "±" : "", twin ? fabs(at[1]) : at[1], -at[2]);
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
        if (d->number[k] == last || n < 0 || n >= KEY_ROWS * KEY_COLUMNS)
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
    number_couplings(&d);
    c->title = chart_words(c, "%s, from the right, from above and from behind; boxes have the mass and the inertias of the bodies", v->name);
    add_view(c, VIEW_SIDE, &d);
    for (enum view view = VIEW_TOP; view < VIEWS; view++)
        add_view(chart_add_beside(c, &area[view]), view, &d);
    add_key(chart_add_beside(c, &key_area), &d);
    free(d.number);
    return c->why;
}
