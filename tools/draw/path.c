#include "tools/draw/path.h"

#include <math.h>
#include <stddef.h>

enum { HEIGHT, RAIL_Y, X, VALUES };

static const struct { const char *column, *label; } panels[VALUES] = {
    [HEIGHT] = {"height", "wheel z (mm)"},
    [RAIL_Y] = {"rail_y", "contact y (mm)"},
    [X] = {"x", "ahead x (mm)"},
};
static const double leap = 3e-3;               /* m, of the contact from one row to the next, between which no line is drawn */
static const double fitted = 0.05;             /* m, of the path on either side of a transfer */

static void path_begin(struct chart *c)
{
    c->x = (struct chart_axis){.label = "station of the wheelset's centre, from which x counts (m)"};
    for (int v = 0; v < VALUES; v++)
        chart_add_panel(c, panels[v].label, 1e3);
    c->panel[HEIGHT].y.down = 1;
    c->panel[HEIGHT].share = 1.4;
    c->title = "Path of a wheel, and its kink from one rail body to the next";
}

/* Slope of the line of least squares through z over s, both [n]. */
static double slope_fit(const double *s, const double *z, int64_t n)
{
    double middle = 0, level = 0, sz = 0, ss = 0;

    for (int64_t i = 0; i < n; i++) {
        middle += s[i] / (double)n;
        level += z[i] / (double)n;
    }
    for (int64_t i = 0; i < n; i++) {
        sz += (s[i] - middle) * (z[i] - level);
        ss += (s[i] - middle) * (s[i] - middle);
    }
    return sz / ss;
}

/* The angle (rad) by which the path z turns upwards at row i, the first on another body: lines over a length on either side, on which the
 * body must stay the same; NAN where it does not, or the rows end. */
static double kink_at(const double *s, const double *z, const double *body, int64_t rows, int64_t i)
{
    int64_t first = i - 1, end = i + 1;

    while (first > 0 && body[first - 1] == body[i - 1] && s[i] - s[first] < fitted)
        first--;
    while (end < rows && body[end] == body[i] && s[end - 1] - s[i] < fitted)
        end++;
    if (s[i] - s[first] < fitted || s[end - 1] - s[i] < fitted)
        return NAN;
    return slope_fit(s + first, z + first, i - first) - slope_fit(s + i, z + i, end - i);
}

/* The row at which the path turns upwards most from body to body, its angle (rad) into *kink; 0 where there is none. */
static int64_t sharpest(const double *s, const double *z, const double *body, int64_t rows, double *kink)
{
    int64_t at = 0;

    *kink = 0;
    for (int64_t i = 1; i < rows; i++) {
        double turn = body[i] == body[i - 1] ? 0 : kink_at(s, z, body, rows, i);
        if (turn > *kink) {
            *kink = turn;
            at = i;
        }
    }
    return at;
}

/* value [rows] without the rows at which the contact has leapt. */
static const double *parted(struct chart *c, const double *value, const double *y, int64_t rows)
{
    double *part = chart_numbers(c, rows);

    for (int64_t i = 0; part && i < rows; i++)
        part[i] = i > 0 && fabs(y[i] - y[i - 1]) > leap ? (double)NAN : value[i];
    return part;
}

const char *path_add(struct chart *c, const struct columns *t, int k, const char *name)
{
    int station = columns_find(t, "station"), body = columns_find(t, "body");
    const double *value[VALUES], *s = t->value[station < 0 ? 0 : station];
    double kink;

    for (int v = 0; v < VALUES; v++) {
        int column = columns_find(t, panels[v].column);
        if (station < 0 || body < 0 || column < 0)
            return reason("no column %s: not a table of vxcontact --path", station < 0 ? "station" : body < 0 ? "body" : panels[v].column);
        value[v] = t->value[column];
    }
    if (k == 0)
        path_begin(c);
    int64_t at = sharpest(s, value[HEIGHT], t->value[body], t->rows, &kink);
    const char *label = at > 0 ? chart_words(c, "%s: %.1f mrad", name, kink * 1e3) : chart_words(c, "%s", name);
    for (int v = 0; v < VALUES; v++) {
        const double *drawn = v == HEIGHT ? value[v] : parted(c, value[v], value[RAIL_Y], t->rows);
        if (drawn)
            chart_add_series(c, &c->panel[v], v == HEIGHT ? label : NULL, t->rows, s, drawn)->colour = chart_colour(k);
    }
    if (at > 0) {
        struct chart_series *transfer = chart_add_series(c, &c->panel[HEIGHT], NULL, 1, s + at, value[HEIGHT] + at);
        transfer->colour = chart_colour(k);
        transfer->width = 0;
        transfer->mark = CANVAS_DISC;
    }
    return c->why;
}
