#include "tools/draw/contact.h"

#include <math.h>

#include "tools/draw/scale.h"
#include "tools/draw/sections.h"

static const double head = 0.040;          /* m, half width of what is shown of a rail: a head is 72 mm wide */
static const double normal = 0.008;        /* m, drawn length of a normal to either side */
static const double apart = 0.035;         /* m, wheel above rail in the picture of pairs */
static const double gauge_side = 0.075;    /* m, half width shown there: flange and tread */
static const double name_room = 0.006, clear = 0.0015;   /* m, between the names of pairs, above the wheel */
static const double lowest = 0.016;        /* m, shown below the rail's top there */
enum { leaps_most = 6 };                   /* named in the title */
static const double touching = 1e-6;       /* m, gap of a contact called touching */

int64_t contact_nearest(int64_t n, const double *x, double v)
{
    int64_t best = 0;

    for (int64_t i = 1; i < n; i++)
        if (fabs(x[i] - v) < fabs(x[best] - v))
            best = i;
    return best;
}

const char *contact_fits(const struct prof *wheel, const struct prof *rail, const struct ctab *t)
{
    if (wheel->part != 'w')
        return "the first profile is not a wheel";
    if (rail->part != 'r')
        return "the second profile is not a rail";
    if (wheel->side != t->side || rail->side != t->side)
        return reason("sides differ: wheel %c, rail %c, table %c", wheel->side, rail->side, t->side);
    return NULL;
}

static void rail_bodies(struct chart *c, struct chart_panel *panel, const struct prof *rail, double station)
{
    int64_t section = contact_nearest(rail->sections, rail->station, station);

    for (int64_t k = 0; k < rail->polys; k++)
        if (rail->poly_section[k] == section)
            sections_polyline(c, panel, rail, k, 0, 0, rail->body[rail->poly_body[k]]);
}

/* The wheel with its running circle's lowest point at (y, z). */
static void wheel_outline(struct chart *c, struct chart_panel *panel, const struct prof *wheel, double y, double z, const char *label)
{
    int64_t n = wheel->poly_first[1];
    double *px = chart_numbers(c, n), *py = chart_numbers(c, n);

    if (!px || !py)
        return;
    for (int64_t i = 0; i < n; i++) {
        px[i] = wheel->y[i] + y;
        py[i] = wheel->z[i] + z;
    }
    struct chart_series *s = chart_add_series(c, panel, label, n, px, py);
    s->colour = CHART_BLACK;
    s->width = 1.6;
}

/* The point of contact k, its normal and its name. */
static void contact_point(struct chart *c, struct chart_panel *panel, const float *row, int k, double gap)
{
    double *x = chart_numbers(c, 2), *y = chart_numbers(c, 2);
    double angle = row[CTAB_ANGLE];

    if (!x || !y)
        return;
    for (int end = 0; end < 2; end++) {
        x[end] = row[CTAB_RAIL_Y] + (end ? 1 : -1) * normal * sin(angle);
        y[end] = row[CTAB_RAIL_Z] - (end ? 1 : -1) * normal * cos(angle);
    }
    const char *open = gap < touching ? "" : chart_words(c, ", gap %.2f mm", gap * 1e3);
    const char *label = chart_words(c, "%d: y %.1f mm, angle %.2f°, r %.2f mm%s", k + 1, row[CTAB_RAIL_Y] * 1e3,
                                    angle * 180 / M_PI, row[CTAB_RADIUS] * 1e3, open);
    chart_add_series(c, panel, NULL, 2, x, y)->colour = CHART_WINE;
    double *point = chart_numbers(c, 2);
    if (!point)
        return;
    point[0] = row[CTAB_RAIL_Y];
    point[1] = row[CTAB_RAIL_Z];
    struct chart_series *s = chart_add_series(c, panel, label, 1, point, point + 1);
    s->colour = CHART_WINE;
    s->width = 0;
    s->mark = gap < touching ? CANVAS_DISC : CANVAS_RING;
    s->size = 7;
    chart_add_note(c, panel, x[1], y[1], chart_words(c, "%d", k + 1))->colour = CHART_WINE;
}

static struct chart_panel *begin(struct chart *c)
{
    c->equal = 1;
    c->x = (struct chart_axis){.label = "lateral position on the rail y (mm)", .factor = 1e3, .lo = -head, .hi = head};
    struct chart_panel *panel = chart_add_panel(c, "z down (mm)", 1e3);
    panel->y.down = 1;
    return panel;
}

const char *contact_chart(struct chart *c, const struct prof *wheel, const struct prof *rail, const struct ctab *t,
                          const struct contact_place *at)
{
    const char *why = contact_fits(wheel, rail, t);
    int count;

    if (why)
        return why;
    int64_t i = contact_nearest(t->stations, t->station, at->station), j = contact_nearest(t->yaws, t->yaw, at->yaw);
    int64_t k = contact_nearest(t->us, t->u, at->u);
    const float *row = ctab_node(t, i, j, k, &count);
    if (count == 0)
        return reason("no contact at station %g m, yaw %g rad, u %g m", t->station[i], t->yaw[j], t->u[k]);
    struct chart_panel *panel = begin(c);
    rail_bodies(c, panel, rail, t->station[i]);
    wheel_outline(c, panel, wheel, t->u[k] + wheel->position - rail->position, row[CTAB_HEIGHT], "wheel");
    for (int s = 0; s < count; s++) {
        const float *contact = row + s * CTAB_N;
        contact_point(c, panel, contact, s, contact[CTAB_HEIGHT] - row[CTAB_HEIGHT]);
        c->x.lo = fmin(c->x.lo, contact[CTAB_RAIL_Y] - normal);
        c->x.hi = fmax(c->x.hi, contact[CTAB_RAIL_Y] + normal);
    }
    panel->y.lo = -0.012;
    panel->y.hi = 0.030;
    c->title = chart_words(c, "Contact at u = %.2f mm, yaw %.2f mrad%s", t->u[k] * 1e3, t->yaw[j] * 1e3,
                           t->stations > 1 ? chart_words(c, ", station %.3f m", t->station[i]) : "");
    return c->why;
}

/* a [points of the wheel], z or slope, at y, straight between the points. */
static double outline_at(const struct prof *wheel, const double *a, double y)
{
    int64_t n = wheel->poly_first[1], i = 1;

    while (i < n - 1 && wheel->y[i] < y)
        i++;
    return a[i - 1] + (y - wheel->y[i - 1]) / (wheel->y[i] - wheel->y[i - 1]) * (a[i] - a[i - 1]);
}

/* Words at a point of the wheel's outline raised to (y, z), on the side of its material. */
static void name_pair(struct chart *c, struct chart_panel *panel, double y, double z, double slope, const char *words)
{
    double ny = slope / hypot(1, slope), nz = -1 / hypot(1, slope);
    struct chart_note *note = chart_add_note(c, panel, y + clear * ny, z + clear * nz, words);

    note->fixed = 1;
    note->across = (1 - ny) / 2;
    note->up = (1 + nz) / 2;
}

/* Lines x, y [3 us] from wheel to rail for the contact that touches at every `every`-th u, NaN between them; u is named at
 * the wheel where there is room.  The number of points. */
static int64_t join_pairs(struct chart *c, struct chart_panel *panel, const struct prof *wheel, const struct ctab *t, int64_t i,
                          int64_t j, int64_t every, double shift, double *x, double *y)
{
    int64_t n = 0;
    double at[2] = {INFINITY, INFINITY};

    for (int64_t k = (t->us - 1) / 2 % every; k < t->us; k += every) {
        int count;
        const float *row = ctab_node(t, i, j, k, &count);
        if (count == 0)
            continue;
        double wz = outline_at(wheel, wheel->z, row[CTAB_WHEEL_Y]);
        x[n] = row[CTAB_RAIL_Y];
        y[n] = row[CTAB_RAIL_Z];
        x[n + 1] = row[CTAB_WHEEL_Y] + shift;
        y[n + 1] = wz - apart;
        x[n + 2] = y[n + 2] = NAN;
        if (hypot(x[n + 1] - at[0], y[n + 1] - at[1]) > name_room) {
            at[0] = x[n + 1];
            at[1] = y[n + 1];
            name_pair(c, panel, at[0], at[1], outline_at(wheel, wheel->slope, row[CTAB_WHEEL_Y]),
                      chart_words(c, "%.3g", t->u[k] * 1e3));
        }
        n += 3;
    }
    return n;
}

/* "Leaps at u = 0.25, 5.15 mm": half-way between the displacements at which another contact touches first that is not the same going on. */
static const char *leaps_words(struct chart *c, const struct ctab *t, int64_t i, int64_t j)
{
    const char *words = "";
    int leaps = 0;

    for (int64_t k = 0; k + 1 < t->us; k++) {
        int before, behind;
        const float *row = ctab_node(t, i, j, k, &before);
        ctab_node(t, i, j, k + 1, &behind);
        if (before == 0 || behind == 0 || t->link[(row - t->row) / CTAB_N * CTAB_LINKS + CTAB_LINK_U] == 1)
            continue;
        double u = 0.5 * (t->u[k] + t->u[k + 1]);
        words = leaps < leaps_most ? chart_words(c, "%s%s %.2f", words, leaps ? "," : "", u * 1e3) : words;
        leaps++;
    }
    if (leaps == 0)
        return "Contact pairs without a leap";
    return chart_words(c, "Leaps at u =%s%s mm", words, leaps > leaps_most ? " ..." : "");
}

/* Which side of the rail is which, at the lower corners. */
static void name_sides(struct chart *c, struct chart_panel *panel, char side)
{
    for (int right = 0; right < 2; right++) {
        const char *words = right == (side == 'l') ? "gauge side" : "field side";
        struct chart_note *note = chart_add_note(c, panel, right ? gauge_side - clear : clear - gauge_side, lowest - clear, words);
        note->fixed = 1;
        note->across = right;
    }
}

const char *contact_pairs_chart(struct chart *c, const struct prof *wheel, const struct prof *rail, const struct ctab *t,
                                const struct contact_place *at, int pairs)
{
    const char *why = contact_fits(wheel, rail, t);

    if (why)
        return why;
    int64_t i = contact_nearest(t->stations, t->station, at->station), j = contact_nearest(t->yaws, t->yaw, at->yaw);
    double du = t->us > 1 ? t->u[1] - t->u[0] : 1, distance = scale_step((double)t->us * du, pairs);
    int64_t every = distance > du ? llround(distance / du) : 1;
    double shift = wheel->position - rail->position;
    double *x = chart_numbers(c, 3 * t->us), *y = chart_numbers(c, 3 * t->us);
    if (!x || !y)
        return c->why;
    struct chart_panel *panel = begin(c);
    rail_bodies(c, panel, rail, t->station[i]);
    wheel_outline(c, panel, wheel, shift, -apart, chart_words(c, "wheel, raised by %.0f mm", apart * 1e3));
    int64_t n = join_pairs(c, panel, wheel, t, i, j, every, shift, x, y);
    struct chart_series *s = chart_add_series(
        c, panel, chart_words(c, "contact pairs, u every %.3g mm, named at the wheel", (double)every * du * 1e3), n, x, y);
    s->colour = CHART_WINE;
    s->width = 0.7;
    c->x.lo = -gauge_side;
    c->x.hi = gauge_side;
    panel->y.lo = -apart - 0.012;
    panel->y.hi = lowest;
    name_sides(c, panel, t->side);
    c->title = chart_words(c, "%s; yaw %.2f mrad%s", leaps_words(c, t, i, j), t->yaw[j] * 1e3,
                           t->stations > 1 ? chart_words(c, ", station %.3f m", t->station[i]) : "");
    return c->why;
}
