#include "tools/draw/tables.h"

#include <string.h>

/* A name read from a table, as words: "radius_difference" without its underscores. */
static const char *name_words(struct chart *c, const char *name, const char *unit)
{
    char plain[COLUMNS_NAME];

    for (int k = 0; k < COLUMNS_NAME; k++)
        plain[k] = name[k] == '_' ? ' ' : name[k];
    return *unit ? chart_words(c, "%s (%s)", plain, unit) : chart_words(c, "%s", plain);
}

const char *tables_chart(struct chart *c, const struct columns *t)
{
    int panel[COLUMNS_MOST] = {0}, members[CHART_PANELS] = {0};

    c->x.label = name_words(c, t->name[0], t->unit[0]);
    for (int k = 1; k < t->n; k++) {
        int first = 1;
        while (strcmp(t->unit[first], t->unit[k]) != 0)
            first++;
        panel[k] = first < k ? panel[first] : c->panels;
        if (first == k && c->panels == CHART_PANELS)
            return reason("more than %d units in one table", CHART_PANELS);
        if (first == k)
            chart_add_panel(c, name_words(c, t->name[k], t->unit[k]), 1);
        if (++members[panel[k]] == 2)
            c->panel[panel[k]].y.label = *t->unit[k] ? chart_words(c, "(%s)", t->unit[k]) : NULL;
    }
    for (int k = 1; k < t->n; k++)
        chart_add_series(c, &c->panel[panel[k]], members[panel[k]] > 1 ? name_words(c, t->name[k], "") : NULL, t->rows,
                         t->value[0], t->value[k]);
    return c->why;
}

const char *tables_rolling_radius(struct chart *c, const struct columns *t)
{
    static const char *const name[] = {"y", "radius_difference", "rail_y_left", "rail_y_right"};
    int column[4];

    for (int k = 0; k < 4; k++)
        if ((column[k] = columns_find(t, name[k])) < 0)
            return reason("no column %s: not a table of vxcontact --rolling-radius", name[k]);
    c->x = (struct chart_axis){.label = "lateral displacement of the wheelset y (mm)", .factor = 1e3};
    struct chart_panel *p = chart_add_panel(c, "right − left (mm)", 1e3);
    struct chart_series *s = chart_add_series(c, p, "rolling radius difference", t->rows, t->value[column[0]],
                                              t->value[column[1]]);
    s->colour = CHART_BLACK;
    p = chart_add_panel(c, "y on rail (mm)", 1e3);
    chart_add_series(c, p, "contact on the left rail", t->rows, t->value[column[0]], t->value[column[2]]);
    s = chart_add_series(c, p, "on the right rail", t->rows, t->value[column[0]], t->value[column[3]]);
    s->dash = CANVAS_DASHED;
    return c->why;
}

const char *tables_conicity(struct chart *c, const struct columns *t)
{
    static const char *const name[] = {"conicity", "contact_angle_parameter", "roll_parameter"};
    static const char *const label[] = {"conicity", "contact angle ε", "roll σ"};
    int amplitude = columns_find(t, "amplitude"), column[3];

    for (int k = 0; k < 3; k++)
        if ((column[k] = columns_find(t, name[k])) < 0 || amplitude < 0)
            return reason("no column %s: not a table of vxcontact --conicity", amplitude < 0 ? "amplitude" : name[k]);
    c->x = (struct chart_axis){.label = "amplitude of the wheelset (mm)", .factor = 1e3};
    for (int k = 0; k < 3; k++) {
        struct chart_panel *p = chart_add_panel(c, label[k], 1);
        struct chart_series *s = chart_add_series(c, p, NULL, t->rows, t->value[amplitude], t->value[column[k]]);
        s->colour = CHART_BLACK;
        s->mark = t->rows < 60 ? CANVAS_DISC : CANVAS_NO_MARK;
    }
    c->title = "Equivalent conicity and further parameters over amplitude";
    return c->why;
}

/* A panel with the columns `left` and `right` of a table over its stations. */
static const char *add_rails(struct chart *c, const struct columns *t, const char *left, const char *right, const char *label,
                             double factor, const char *from)
{
    const int station = columns_find(t, "station"), column[2] = {columns_find(t, left), columns_find(t, right)};

    if (station < 0 || column[0] < 0 || column[1] < 0)
        return reason("no column %s: not a table of %s", station < 0 ? "station" : column[0] < 0 ? left : right, from);
    struct chart_panel *p = chart_add_panel(c, label, factor);
    for (int k = 0; k < 2; k++) {
        const char *name = c->panels > 1 ? NULL : k ? "right rail" : "left rail";
        chart_add_series(c, p, name, t->rows, t->value[station], t->value[column[k]]);
    }
    return c->why;
}

const char *tables_stiffness(struct chart *c, const struct columns *t)
{
    static const char from[] = "vxfreq --stiffness";

    c->title = "Static stiffness of the track, load over deflection";
    c->x.label = "station (m)";
    c->alike = 1;
    const char *why = add_rails(c, t, "left", "right", "both loaded (MN/m)", 1e-6, from);
    return why ? why : add_rails(c, t, "left_alone", "right_alone", "one loaded (MN/m)", 1e-6, from);
}

const char *tables_bowl(struct chart *c, const struct columns *t)
{
    c->title = "Static deflection of the track";
    c->x.label = "station (m)";
    const char *why = add_rails(c, t, "left", "right", "deflection (mm)", 1e3, "vxfreq --static --axles");
    if (c->panels > 0)
        c->panel[0].y.down = 1;
    return why;
}
