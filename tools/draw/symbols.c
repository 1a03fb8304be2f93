#include "tools/draw/symbols.h"

#include <math.h>

static const unsigned spring = CHART_BLUE, damper = CHART_GREEN, stop = CHART_RED, moment = CHART_PURPLE, rod = CHART_BLACK, slide = CHART_ORANGE,
                      place = CHART_WINE;
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
    static const double piston[] = {0.1, 0.77, 0.1, 0.53}, shaft[] = {0.1, 0.65, 0.5, 0.65};

    stroke(c, p, at, way, size, 4, cup, damper);
    stroke(c, p, at, way, size, 2, end, damper);
    stroke(c, p, at, way, size, 2, piston, damper);
    stroke(c, p, at, way, size, 2, shaft, damper);
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

/* Two faces that slide on each other along the way. */
static void add_friction(struct chart *c, struct chart_panel *p, const double at[2], int way, double size)
{
    stroke(c, p, at, way, size, 2, (double[]){-0.45, 1.0, 0.25, 1.0}, slide);
    stroke(c, p, at, way, size, 2, (double[]){-0.25, 1.12, 0.45, 1.12}, slide);
}

/* What acts along the line between two ends. */
static void add_line(struct chart *c, struct chart_panel *p, const double at[2], const double to[2], unsigned colour)
{
    view_line(c, p, 2, (double[]){at[0], at[1], to[0], to[1]}, colour, 2 * line);
    add_mark(c, p, to, CANVAS_DISC, place);
}

/* What coupling k does along one of the page's axes. */
static void add_way(struct chart *c, struct chart_panel *p, const double at[2], int way, int axis, const struct veh *v, int64_t k, double size)
{
    const int64_t type = v->type[k];
    const int here = v->axis[k] == axis;

    if ((type == VEH_BUSHING && v->stiffness[VEH_DOFS * k + axis] > 0) || (type == VEH_SPRING && here))
        add_spring(c, p, at, way, size);
    if ((type == VEH_BUSHING && v->damping[VEH_DOFS * k + axis] > 0) || (type == VEH_DAMPER && here))
        add_damper(c, p, at, way, size);
    if (type == VEH_STOP && here)
        add_stop(c, p, at, way, size, v->knot_at[v->knot_first[k]]);
    if (type == VEH_FRICTION && v->stiffness[VEH_DOFS * k + axis] > 0)
        add_friction(c, p, at, way, size);
}

void symbols_add(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t k, double size)
{
    const int64_t type = v->type[k];
    const int *axis = view_axes[view].axis;
    double at[2], to[2];

    view_place(view, &v->point[3 * k], at);
    view_place(view, &v->end[3 * k], to);
    add_mark(c, p, at, CANVAS_DISC, place);
    if (type == VEH_ROD || (type == VEH_DAMPER && v->axis[k] == VEH_LINE)) {
        add_line(c, p, at, to, type == VEH_ROD ? rod : damper);
        return;
    }
    for (int way = 0; way < 2; way++)
        add_way(c, p, at, way, axis[way], v, k, size);
    if (type == VEH_STOP && v->axis[k] != axis[0] && v->axis[k] != axis[1])
        add_mark(c, p, at, CANVAS_CROSS, stop);
    if (any(&v->stiffness[VEH_DOFS * k + VEH_ROLL], 3) || any(&v->damping[VEH_DOFS * k + VEH_ROLL], 3))
        add_mark(c, p, at, CANVAS_RING, moment);
}

void symbols_legend(struct chart *c, struct chart_panel *p, const struct veh *v)
{
    static const struct { const char *words; const unsigned *colour; enum canvas_mark mark; int type; } entry[] = {
        {"spring", &spring, CANVAS_NO_MARK, -1}, {"damper", &damper, CANVAS_NO_MARK, -1}, {"stop", &stop, CANVAS_NO_MARK, VEH_STOP},
        {"rod", &rod, CANVAS_NO_MARK, VEH_ROD}, {"friction", &slide, CANVAS_NO_MARK, VEH_FRICTION}, {"acts about axes", &moment, CANVAS_RING, -1}};

    for (size_t k = 0; k < sizeof entry / sizeof *entry; k++) {
        int used = entry[k].type < 0;
        for (int64_t i = 0; i < v->couplings; i++)
            used |= v->type[i] == entry[k].type;
        if (!used)
            continue;
        struct chart_series *s = chart_add_series(c, p, entry[k].words, 0, NULL, NULL);
        s->colour = *entry[k].colour;
        s->mark = entry[k].mark;
        s->width = s->mark ? 0 : line;
        s->size = 6.5;
    }
}
