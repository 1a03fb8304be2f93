#include "tools/draw/symbols.h"

#include <math.h>

static const unsigned spring = CHART_BLUE, damper = CHART_GREEN, stop = CHART_RED, moment = CHART_PURPLE, other = CHART_WINE;
static const double line = 1.2;      /* pt */

/* n points of a symbol along the page's x (way 0) or y (way 1) about `at`: xy [n][2] in sizes, along and across. */
static void stroke(struct chart *c, struct chart_panel *p, const double at[2], int way, double size, int n, const double *xy, unsigned colour)
{
    double placed[24];

    for (int i = 0; i < n; i++) {
        placed[2 * i + way] = at[way] + size * xy[2 * i];
        placed[2 * i + 1 - way] = at[1 - way] + size * xy[2 * i + 1];
    }
    view_line(c, p, n, placed, colour, line);
}

/* Springs stand on one side of the point, dampers on the other, both beside the middle third, where they would cross those of the other way. */
static void add_spring(struct chart *c, struct chart_panel *p, const double at[2], int way, double size)
{
    static const double zigzag[] = {
        -0.5, -0.65, -0.38, -0.65, -0.32, -0.5, -0.2, -0.8, -0.07, -0.5, 0.07, -0.8, 0.2, -0.5, 0.32, -0.8, 0.38, -0.65, 0.5, -0.65};

    stroke(c, p, at, way, size, 10, zigzag, spring);
}

static void add_damper(struct chart *c, struct chart_panel *p, const double at[2], int way, double size)
{
    static const double cup[] = {0.3, 0.8, -0.2, 0.8, -0.2, 0.5, 0.3, 0.5}, end[] = {-0.5, 0.65, -0.2, 0.65};
    static const double piston[] = {0.1, 0.77, 0.1, 0.53}, rod[] = {0.1, 0.65, 0.5, 0.65};

    stroke(c, p, at, way, size, 4, cup, damper);
    stroke(c, p, at, way, size, 2, end, damper);
    stroke(c, p, at, way, size, 2, piston, damper);
    stroke(c, p, at, way, size, 2, rod, damper);
}

/* Bars at the clearance where that is to be seen, else at least a fifth of the size from the middle. */
static void add_stop(struct chart *c, struct chart_panel *p, const double at[2], int way, double size, double clearance)
{
    const double gap = fmax(clearance / size, 0.2);

    for (int side = -1; side <= 1; side += 2) {
        stroke(c, p, at, way, size, 2, (double[]){side * gap, -0.4, side * gap, 0.4}, stop);
        stroke(c, p, at, way, size, 2, (double[]){side * gap, 0, side * (gap + 0.3), 0}, stop);
    }
}

static void add_mark(struct chart *c, struct chart_panel *p, const double at[2], enum canvas_mark mark, unsigned colour)
{
    struct chart_series *s = view_line(c, p, 1, at, colour, 0);

    s->mark = mark;
    s->size = mark == CANVAS_RING ? 6.5 : mark == CANVAS_DISC ? 3 : 6;
}

static int any(const double *x, int n)
{
    int found = 0;

    for (int k = 0; k < n; k++)
        found |= x[k] != 0;
    return found;
}

void symbols_add(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t k, double size)
{
    const double *stiffness = &v->stiffness[VEH_DOFS * k], *damping = &v->damping[VEH_DOFS * k];
    double at[2];

    view_place(view, &v->point[3 * k], at);
    add_mark(c, p, at, CANVAS_DISC, other);
    for (int way = 0; way < 2; way++) {
        const int axis = view_axes[view].axis[way];
        if (stiffness[axis] > 0)
            add_spring(c, p, at, way, size);
        if (damping[axis] > 0)
            add_damper(c, p, at, way, size);
        if (v->type[k] == VEH_STOP && v->stop_axis[k] == axis)
            add_stop(c, p, at, way, size, v->knot_at[v->knot_first[k]]);
    }
    if (v->type[k] == VEH_STOP && v->stop_axis[k] != view_axes[view].axis[0] && v->stop_axis[k] != view_axes[view].axis[1])
        add_mark(c, p, at, CANVAS_CROSS, stop);
    if (any(stiffness + 3, 3) || any(damping + 3, 3))
        add_mark(c, p, at, CANVAS_RING, moment);
}

void symbols_legend(struct chart *c, struct chart_panel *p)
{
    static const struct { const char *words; const unsigned *colour; enum canvas_mark mark; } entry[] = {
        {"spring", &spring, CANVAS_NO_MARK}, {"damper", &damper, CANVAS_NO_MARK}, {"stop", &stop, CANVAS_NO_MARK},
        {"acts about axes", &moment, CANVAS_RING}};

    for (size_t k = 0; k < sizeof entry / sizeof *entry; k++) {
        struct chart_series *s = chart_add_series(c, p, entry[k].words, 0, NULL, NULL);
        s->colour = *entry[k].colour;
        s->mark = entry[k].mark;
        s->width = s->mark ? 0 : line;
        s->size = 6.5;
    }
}
