#include "tools/draw/yaw.h"

#include <math.h>
#include <string.h>

static const struct { const char *column, *label; double factor; } panels[] = {
    {"wheel_y_", "y on wheel (mm)", 1e3},
    {"rail_y_", "y on rail (mm)", 1e3},
    {"x_", "x ahead (mm)", 1e3},
    {"angle_", "angle (°)", 180 / M_PI},
    {"radius_", "radius (mm)", 1e3},
};
enum { PANELS = sizeof panels / sizeof *panels, DASHES = CANVAS_DOTTED + 1 };

static void yaw_begin(struct chart *c)
{
    c->x = (struct chart_axis){.label = "lateral displacement of the wheel u (mm)", .factor = 1e3};
    for (int p = 0; p < PANELS; p++)
        chart_add_panel(c, panels[p].label, panels[p].factor);
}

/* The lines of one panel, a method each; how many. */
static int add_methods(struct chart *c, int p, const struct columns *t, int k, int n, const char *name)
{
    size_t length = strlen(panels[p].column);
    int methods = 0;

    for (int i = 1; i < t->n; i++) {
        if (strncmp(t->name[i], panels[p].column, length) != 0)
            continue;
        const char *method = t->name[i] + length, *label = n == 1 ? method : methods == 0 ? name : NULL;
        struct chart_series *s = chart_add_series(c, &c->panel[p], label, t->rows, t->value[0], t->value[i]);
        s->colour = chart_colour(n == 1 ? methods : k);
        s->dash = (enum canvas_dash)(methods++ % DASHES);
        if (n > 1 && k == n - 1) {                                    /* the dash alone, in the legend */
            struct chart_series *dash = chart_add_series(c, &c->panel[p], method, 0, NULL, NULL);
            dash->colour = CHART_GREY;
            dash->dash = s->dash;
        }
    }
    return methods;
}

const char *yaw_add(struct chart *c, const struct columns *t, int k, int n, const char *name)
{
    if (k == 0)
        yaw_begin(c);
    if (strcmp(t->name[0], "u") != 0)
        return "the first column is not u: not a table of vxcontact --sweep";
    for (int p = 0; p < PANELS; p++)
        if (add_methods(c, p, t, k, n, name) == 0)
            return reason("no column %s...: not a table of vxcontact --sweep", panels[p].column);
    return c->why;
}
