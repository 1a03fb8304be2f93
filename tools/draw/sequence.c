#include "tools/draw/sequence.h"

#include <math.h>

static const double deep = 0.034, high = 0.014;      /* m, shown below and above the top of the rail */
static const double foot = 0.0285;                   /* m, below it, where the rails are cut off: what profiles reach */
static const double reach = 0.006;                   /* m, shown beside the wheel */
static const double words = 13;                      /* pt, above a cell, for its station */
static const double paper = 440;                     /* pt, width of the grid in print */
static const double touching = 1e-6, open = 4e-3;    /* m, gaps of contacts called touching, of those still shown */

/* A window of the rail's section, and where its upper left corner comes to lie on the sheet. */
struct cell { double left, right, top, bottom, y, z; };   /* m */

int sequence_stations(const struct ctab *t, double from, double to, int n, int64_t *pick)
{
    int64_t first = 0, inside = 0;

    for (int64_t i = t->stations - 1; i >= 0; i--)
        if (t->stations == 1 || (t->station[i] >= from && t->station[i] <= to)) {
            inside++;
            first = i;
        }
    if (n > inside)
        n = (int)inside;
    for (int k = 0; k < n; k++)
        pick[k] = first + (n == 1 ? 0 : (int64_t)llround((double)(inside - 1) * k / (n - 1)));
    return n;
}

static double clamp(double v, double lo, double hi)
{
    return fmin(fmax(v, lo), hi);
}

/* The part of the line y, z [n], moved by (dy, dz), that the cell shows. */
static struct chart_series *cell_line(struct chart *c, struct chart_panel *panel, const struct cell *e, int64_t n, const double *y,
                                      const double *z, double dy, double dz)
{
    double *px = chart_numbers(c, n), *py = chart_numbers(c, n);

    if (!px || !py)
        return &c->spare_series;
    for (int64_t i = 0; i < n; i++) {
        double at = y[i] + dy, depth = z[i] + dz;
        int inside = at >= e->left && at <= e->right && depth >= e->top && depth <= e->bottom;
        px[i] = inside ? at - e->left + e->y : NAN;
        py[i] = depth - e->top + e->z;
    }
    return chart_add_series(c, panel, NULL, n, px, py);
}

/* The material below the line y, z [n], to the bottom of the cell, also where the line ends above. */
static void cell_body(struct chart *c, struct chart_panel *panel, const struct cell *e, int64_t n, const double *y, const double *z,
                      unsigned colour)
{
    double *px = chart_numbers(c, n + 2), *py = chart_numbers(c, n + 2);

    if (!px || !py)
        return;
    for (int64_t i = 0; i < n + 2; i++) {
        double at = i < n ? y[i] : i == n ? y[n - 1] : y[0], depth = i < n ? z[i] : e->bottom;
        px[i] = clamp(at, e->left, e->right) - e->left + e->y;
        py[i] = clamp(depth, e->top, e->bottom) - e->top + e->z;
    }
    struct chart_series *s = chart_add_series(c, panel, NULL, n + 2, px, py);
    s->filled = 1;
    s->colour = chart_tint(colour);
}

/* Bodies of the section nearest to a station. */
static void cell_rails(struct chart *c, struct chart_panel *panel, const struct cell *whole, const struct prof *rail, double station)
{
    struct cell e = *whole;
    int64_t section = contact_nearest(rail->sections, rail->station, station);

    e.bottom = foot;
    for (int64_t k = 0; k < rail->polys; k++) {
        if (rail->poly_section[k] != section)
            continue;
        int64_t first = rail->poly_first[k], n = rail->poly_first[k + 1] - first;
        unsigned colour = chart_colour((int)rail->poly_body[k]);
        cell_body(c, panel, &e, n, rail->y + first, rail->z + first, colour);
        cell_line(c, panel, &e, n, rail->y + first, rail->z + first, 0, 0)->colour = colour;
    }
}

/* Contacts of a node: discs touch, rings are open by the millimetres beside them. */
static void cell_contacts(struct chart *c, struct chart_panel *panel, const struct cell *e, const float *row, int count)
{
    for (int k = 0; k < count; k++) {
        const float *contact = row + k * CTAB_N;
        double gap = (double)contact[CTAB_HEIGHT] - (double)row[CTAB_HEIGHT], *point = chart_numbers(c, 2);
        if (!point || gap > open)
            continue;
        point[0] = contact[CTAB_RAIL_Y] - e->left + e->y;
        point[1] = contact[CTAB_RAIL_Z] - e->top + e->z;
        struct chart_series *s = chart_add_series(c, panel, NULL, 1, point, point + 1);
        s->colour = CHART_WINE;
        s->width = 0;
        s->mark = gap < touching ? CANVAS_DISC : CANVAS_RING;
        if (gap >= touching)
            chart_add_note(c, panel, point[0], point[1], chart_words(c, "%.2f", gap * 1e3))->colour = CHART_WINE;
    }
}

struct sheet { int columns, rows; double w, h, point; };   /* m: of a cell with its words, and of profile in a point on paper */

/* The columns that draw n cells of w by h largest on a picture of this shape. */
static struct sheet best_sheet(int n, double w, double h, double shape)
{
    struct sheet best = {0};

    for (int columns = 1; columns <= n; columns++) {
        int rows = (n + columns - 1) / columns;
        double down = paper / shape - (rows + 3) * words;      /* title and legend take as much as three rows of words */
        double point = down > 0 ? fmax(columns * w / paper, rows * h / down) : INFINITY;
        if (columns == 1 || point < best.point * (1 - 1e-9))
            best = (struct sheet){columns, rows, w, h + words * point, point};
    }
    return best;
}

/* What the cells hold, each once: the bodies at the stations pick [n], the wheel, its contacts. */
static void sheet_legend(struct chart *c, struct chart_panel *panel, const struct prof *rail, const struct ctab *t, int n,
                         const int64_t *pick)
{
    for (int64_t body = 0; body < rail->bodies; body++) {
        int seen = 0;
        for (int k = 0; k < n; k++) {
            int64_t section = contact_nearest(rail->sections, rail->station, t->station[pick[k]]);
            for (int64_t p = 0; p < rail->polys; p++)
                seen |= rail->poly_section[p] == section && rail->poly_body[p] == body;
        }
        if (seen)
            chart_add_series(c, panel, rail->body[body], 0, NULL, NULL)->colour = chart_colour((int)body);
    }
    chart_add_series(c, panel, "wheel", 0, NULL, NULL)->colour = CHART_BLACK;
    struct chart_series *s = chart_add_series(c, panel, "contact; ring: still open, by mm", 0, NULL, NULL);
    s->colour = CHART_WINE;
    s->width = 0;
    s->mark = CANVAS_DISC;
}

/* The wheel over the rails at station i; the wheel stands `shift` aside of the rails' origin. */
static void cell_fill(struct chart *c, struct chart_panel *panel, const struct cell *e, const struct prof *wheel, const struct prof *rail,
                      const struct ctab *t, const int64_t node[3], double shift, double above)
{
    double station = t->station[node[0]];
    int count;
    const float *row = ctab_node(t, node[0], node[1], node[2], &count);
    const char *height = count ? chart_words(c, ", z %.2f mm", row[CTAB_HEIGHT] * 1e3) : ", no contact";

    cell_rails(c, panel, e, rail, station);
    if (count)
        cell_line(c, panel, e, wheel->poly_first[1], wheel->y, wheel->z, shift, row[CTAB_HEIGHT])->colour = CHART_BLACK;
    cell_contacts(c, panel, e, row, count);
    chart_add_note(c, panel, e->y + reach, e->z - above, chart_words(c, "%.2f m%s", station, height))->fixed = 1;
}

const char *sequence_chart(struct chart *c, const struct prof *wheel, const struct prof *rail, const struct ctab *t,
                           const struct contact_place *at, const struct sequence_choice *choice, double shape)
{
    int64_t pick[SEQUENCE_MOST], node[3] = {0, contact_nearest(t->yaws, t->yaw, at->yaw), contact_nearest(t->us, t->u, at->u)};
    double shift = t->u[node[2]] + wheel->position - rail->position;
    struct cell e = {wheel->y[0] + shift - reach, wheel->y[wheel->poly_first[1] - 1] + shift + reach, -high, deep, 0, 0};
    const char *why = contact_fits(wheel, rail, t);
    int n = sequence_stations(t, choice->from, choice->to, choice->stations, pick), frame = choice->frame;

    if (why || n == 0)
        return why ? why : reason("no station of the table between %g and %g m", choice->from, choice->to);
    if (frame >= n)
        return NULL;
    struct sheet g = best_sheet(frame < 0 ? n : 1, e.right - e.left, e.bottom - e.top, shape);
    c->equal = c->bare = 1;
    struct chart_panel *panel = chart_add_panel(c, NULL, 1);
    panel->y.down = 1;
    sheet_legend(c, panel, rail, t, n, pick);
    for (int k = frame < 0 ? 0 : frame; k < (frame < 0 ? n : frame + 1); k++) {
        int place = frame < 0 ? k : 0;
        e.y = place % g.columns * g.w;
        e.z = place / g.columns * g.h;
        node[0] = pick[k];
        cell_fill(c, panel, &e, wheel, rail, t, node, shift, 2 * g.point);
    }
    c->x.lo = 0;
    c->x.hi = g.columns * g.w;
    panel->y.lo = -words * g.point;
    panel->y.hi = g.rows * g.h - words * g.point;
    c->title = chart_words(c, "%s wheel, u = %.2f mm, yaw %.2f mrad", t->side == 'l' ? "Left" : "Right", t->u[node[2]] * 1e3,
                           t->yaw[node[1]] * 1e3);
    return c->why;
}
