#include "tools/draw/sections.h"

#include <math.h>
#include <string.h>

static const double space = 0.012;     /* m, between the cells */
static const double rim = 0.005;       /* m, of a wheel drawn above the highest point of its outline */
static const double words = 11;        /* pt, above a section, for the names of its rails */
static const double room = 42;         /* pt, left of a section, for its station */
static const double astray = 0.002;    /* m, from the running edge: no closure rail any more */
static const double paper = 440;       /* pt, width of the grid in print */

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
    body->colour = chart_tint(colour);
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

/* The grid that draws n cells with profiles of w by h largest on a picture of this shape, words above each, room to its left. */
static struct grid best_grid(int n, double w, double h, double shape)
{
    struct grid best = {0};

    for (int columns = 1; columns <= n; columns++) {
        int rows = (n + columns - 1) / columns;
        /* width and height of the paper hold columns and rows, whichever is tighter */
        double across = columns * w / (paper - columns * room), down = rows * h / (paper / shape - rows * words);
        double point = across < 0 || down < 0 ? INFINITY : fmax(across, down);
        if (columns == 1 || point < best.point * (1 - 1e-9))
            best = (struct grid){columns, rows, w + room * point, h + words * point, point};
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

/* y of a polyline's gauge side: the right end of a left rail. */
static double gauge_side(const struct prof *p, int64_t k)
{
    return p->side == 'l' ? p->y[p->poly_first[k + 1] - 1] : p->y[p->poly_first[k]];
}

/* What an engineer calls polyline k: a turnout's switch and wing rail is a switch rail beside the stock rail, a wing rail once its gauge side
 * has left `edge` (m), a closure rail between. */
static const char *rail_name(const struct prof *p, int64_t k, double edge)
{
    const char *name = p->body[p->poly_body[k]];

    if (strcmp(name, "switch and wing rail") != 0)
        return name;
    if (fabs(gauge_side(p, k) - edge) > astray)
        return "wing rail";
    for (int64_t j = 0; j < p->polys; j++)
        if (p->poly_section[j] == p->poly_section[k] && strcmp(p->body[p->poly_body[j]], "stock rail") == 0)
            return "switch rail";
    return "closure rail";
}

struct stack {
    const struct prof *p;
    const struct grid *g;
    struct cell e;
    double edge;                       /* m, y of the running edge */
    uint64_t legend;                   /* bodies named there */
    const char *last[64];              /* name each body was last called */
};

/* The bodies of one section with its station and, where it is new, the name of each rail above it. */
static void draw_section(struct chart *c, struct chart_panel *panel, struct stack *s, int64_t section, double y, double z)
{
    const struct prof *p = s->p;
    struct chart_note *note;

    for (int64_t j = 0; j < p->polys; j++) {
        if (p->poly_section[j] != section)
            continue;
        int64_t body = p->poly_body[j] % 64;
        uint64_t bit = (uint64_t)1 << body;
        const char *name = rail_name(p, j, s->edge);
        sections_polyline(c, panel, p, j, y, z, s->legend & bit ? NULL : p->body[p->poly_body[j]]);
        s->legend |= bit;
        if (p->bodies > 1 && (!s->last[body] || strcmp(s->last[body], name) != 0)) {
            note = chart_add_note(c, panel, y + gauge_side(p, j), z + s->e.top - 3 * s->g->point, name);
            note->fixed = 1;
            note->across = p->side == 'l';
            note->colour = chart_colour((int)p->poly_body[j]);
        }
        s->last[body] = name;
    }
    note = chart_add_note(c, panel, y + s->e.left - room * s->g->point, z + s->e.bottom, chart_words(c, "%.2f m", p->station[section]));
    note->fixed = 1;
}

/* Down a column, so that rails are seen to move: its running edge, a thin line. */
static void draw_edge(struct chart *c, struct chart_panel *panel, double y, double top, double bottom)
{
    double *line = chart_numbers(c, 4);

    if (!line)
        return;
    line[0] = line[1] = y;
    line[2] = top;
    line[3] = bottom;
    struct chart_series *s = chart_add_series(c, panel, NULL, 2, line, line + 2);
    s->colour = CHART_GREY;
    s->width = 0.4;
}

const char *sections_chart(struct chart *c, const struct prof *p, double from, double to, double shape)
{
    int64_t pick[SECTIONS_MOST];
    int n = choose(p, from, to, pick);

    c->equal = 1;
    if (n == 0)
        return reason("no section between %g and %g m", from, to);
    if (n == 1)
        return one_section(c, p, pick[0]);
    struct cell e = extent(p, pick, n);
    struct grid g = best_grid(n, e.right - e.left + space, e.bottom - e.top + space, shape * 1.2);
    struct stack s = {.p = p, .g = &g, .e = e, .edge = gauge_side(p, 0)};
    c->bare = 1;
    struct chart_panel *panel = chart_add_panel(c, NULL, 1);
    panel->y.down = 1;
    for (int k = 0; k < n; k++) {
        double y = k / g.rows * g.w + room * g.point - e.left, z = k % g.rows * g.h - e.top;
        int left = n - k < g.rows ? n - k : g.rows;
        if (k % g.rows == 0)
            draw_edge(c, panel, y + s.edge, 0, left * g.h - words * g.point);
        draw_section(c, panel, &s, pick[k], y, z);
    }
    c->x.lo = -space / 2;
    c->x.hi = g.columns * g.w - space / 2;
    panel->y.lo = -words * g.point;
    panel->y.hi = g.rows * g.h + words * g.point / 2;
    scale_bar(c, panel, g.columns * g.w - space, g.rows * g.h, g.point);
    return c->why;
}
