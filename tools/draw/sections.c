#include "tools/draw/sections.h"

#include <math.h>

static const double space = 0.012;     /* m, between the cells */
static const double rim = 0.005;       /* m, of a wheel drawn above the highest point of its outline */
static const double words = 11;        /* pt, above a section, for its station */
static const double paper = 440;       /* pt, width of the grid in print */

/* colour over white. */
static unsigned tint(unsigned colour)
{
    unsigned pale = 0;

    for (int shift = 0; shift <= 16; shift += 8)
        pale |= (255 - (255 - (colour >> shift & 255)) / 5) << shift;
    return pale;
}

void sections_polyline(struct chart *c, struct chart_panel *panel, const struct prof *p, int64_t k, double y, double z,
                       const char *label)
{
    int64_t first = p->poly_first[k], n = p->poly_first[k + 1] - first;
    double *px = chart_numbers(c, n + 2), *py = chart_numbers(c, n + 2), deepest = -INFINITY, highest = INFINITY;
    unsigned colour = chart_colour((int)p->poly_body[k]);

    if (!px || !py)
        return;
    for (int64_t i = 0; i < n; i++) {
        px[i] = p->y[first + i] + y;
        py[i] = p->z[first + i] + z;
        deepest = fmax(deepest, py[i]);
        highest = fmin(highest, py[i]);
    }
    /* the material of a rail lies below its outline, that of a wheel above */
    px[n] = px[n - 1];
    px[n + 1] = px[0];
    py[n] = py[n + 1] = p->part == 'w' ? highest - rim : deepest;
    struct chart_series *body = chart_add_series(c, panel, NULL, n + 2, px, py);
    body->filled = 1;
    body->colour = tint(colour);
    chart_add_series(c, panel, label, n, px, py)->colour = colour;
}

struct cell { double left, right, top, bottom; };   /* m, y and z of what is drawn in a cell */

static int within(const struct prof *p, int64_t section, double from, double to)
{
    return p->sections == 1 || (p->station[section] >= from && p->station[section] <= to);
}

/* Numbers of the sections to draw, into pick [SECTIONS_MOST]. */
static int choose(const struct prof *p, double from, double to, int64_t *pick)
{
    int64_t inside = 0, first = 0;

    for (int64_t i = p->sections - 1; i >= 0; i--)
        if (within(p, i, from, to)) {
            inside++;
            first = i;
        }
    int n = inside < SECTIONS_MOST ? (int)inside : SECTIONS_MOST;
    for (int k = 0; k < n; k++)
        pick[k] = first + (n == 1 ? 0 : (int64_t)llround((double)(inside - 1) * k / (n - 1)));
    return n;
}

static struct cell extent(const struct prof *p, const int64_t *pick, int n)
{
    struct cell e = {INFINITY, -INFINITY, INFINITY, -INFINITY};

    for (int64_t k = 0; k < p->polys; k++) {
        int drawn = 0;
        for (int i = 0; i < n; i++)
            drawn |= pick[i] == p->poly_section[k];
        for (int64_t j = p->poly_first[k]; j < p->poly_first[k + 1] && drawn; j++) {
            e.left = fmin(e.left, p->y[j]);
            e.right = fmax(e.right, p->y[j]);
            e.top = fmin(e.top, p->z[j]);
            e.bottom = fmax(e.bottom, p->z[j]);
        }
    }
    return e;
}

struct grid {
    int columns, rows;
    double w, h;            /* m, of a cell */
    double point;           /* m of profile in a point on paper */
};

/* The grid that draws n cells with profiles of w by h largest on a picture of this shape, words above each. */
static struct grid best_grid(int n, double w, double h, double shape)
{
    struct grid best = {0};

    for (int columns = 1; columns <= n; columns++) {
        int rows = (n + columns - 1) / columns;
        /* width and height of the paper hold columns and rows, whichever is tighter */
        double across = columns * w / paper, down = rows * h / (paper / shape - rows * words);
        double point = down < 0 ? INFINITY : fmax(across, down);
        if (columns == 1 || point < best.point * (1 - 1e-9))
            best = (struct grid){columns, rows, w, h + words * point, point};
    }
    return best;
}

/* 50 mm long, its right end at (y, z). */
static void scale_bar(struct chart *c, struct chart_panel *panel, double y, double z, double point)
{
    double *bar = chart_numbers(c, 4);

    if (!bar)
        return;
    bar[0] = y - 0.05;
    bar[1] = y;
    bar[2] = bar[3] = z;
    struct chart_series *s = chart_add_series(c, panel, NULL, 2, bar, bar + 2);
    s->colour = CHART_BLACK;
    s->width = 2;
    struct chart_note *note = chart_add_note(c, panel, y, z - 3 * point, "50 mm");
    note->fixed = 1;
    note->across = 1;
}

/* A single section: on axes. */
static const char *one_section(struct chart *c, const struct prof *p, int64_t section)
{
    const struct cell e = extent(p, &section, 1);
    c->x = (struct chart_axis){.label = "lateral position y (mm)", .factor = 1e3, .lo = e.left - space, .hi = e.right + space};
    struct chart_panel *panel = chart_add_panel(c, "z down (mm)", 1e3);
    panel->y.down = 1;
    for (int64_t k = 0; k < p->polys; k++)
        if (p->poly_section[k] == section)
            sections_polyline(c, panel, p, k, 0, 0, p->body[p->poly_body[k]]);
    return c->why;
}

const char *sections_chart(struct chart *c, const struct prof *p, double from, double to, double shape)
{
    int64_t pick[SECTIONS_MOST];
    int n = choose(p, from, to, pick);
    uint64_t named = 0;                /* bodies in the legend */

    c->equal = 1;
    if (n == 0)
        return reason("no section between %g and %g m", from, to);
    if (n == 1)
        return one_section(c, p, pick[0]);
    struct cell e = extent(p, pick, n);
    struct grid g = best_grid(n, e.right - e.left + space, e.bottom - e.top + space, shape * 1.2);
    c->bare = 1;
    struct chart_panel *panel = chart_add_panel(c, NULL, 1);
    panel->y.down = 1;
    for (int k = 0; k < n; k++) {
        double y = k % g.columns * g.w - e.left, z = k / g.columns * g.h - e.top;
        for (int64_t j = 0; j < p->polys; j++) {
            if (p->poly_section[j] != pick[k])
                continue;
            uint64_t bit = (uint64_t)1 << p->poly_body[j] % 64;
            sections_polyline(c, panel, p, j, y, z, named & bit ? NULL : p->body[p->poly_body[j]]);
            named |= bit;
        }
        struct chart_note *note = chart_add_note(c, panel, y + e.left, z + e.top - 3 * g.point,
                                                 chart_words(c, "%.2f m", p->station[pick[k]]));
        note->fixed = 1;
    }
    c->x.lo = -space / 2;
    c->x.hi = g.columns * g.w - space / 2;
    panel->y.lo = -words * g.point;
    panel->y.hi = g.rows * g.h + words * g.point / 2;
    scale_bar(c, panel, g.columns * g.w - space, g.rows * g.h, g.point);
    return c->why;
}
