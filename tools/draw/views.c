#include "tools/draw/views.h"

#include <math.h>

enum { ROUND = 48 };                                    /* corners of a wheel */
static const double running = 0.75, tread = 0.135;      /* m, circle from the middle of the track, width of a wheel; drawn only */

const struct view_axes view_axes[VIEWS] = {
    [VIEW_SIDE] = {{VEH_X, VEH_Z}, VEH_PITCH, {1, -1}, "from the right", {"x (m)", "height (m)"}},
    [VIEW_TOP] = {{VEH_X, VEH_Y}, VEH_YAW, {1, 1}, "from above", {"x (m)", "y (m)"}},
    [VIEW_END] = {{VEH_Y, VEH_Z}, VEH_ROLL, {1, -1}, "from behind", {"y (m)", "height (m)"}},
};

void view_place(enum view view, const double p[3], double xy[2])
{
    for (int k = 0; k < 2; k++)
        xy[k] = view_axes[view].sign[k] * p[view_axes[view].axis[k]];
}

void view_box(const struct veh *v, int64_t body, double half[3])
{
    const double *J = &v->inertia[3 * body];

    for (int k = 0; k < 3; k++)
        half[k] = 0.5 * sqrt(fmax(6 * (J[(k + 1) % 3] + J[(k + 2) % 3] - J[k]) / v->mass[body], 0));
}

struct chart_panel *view_begin(struct chart *c, enum view view)
{
    struct chart_panel *p = chart_add_panel(c, view_axes[view].label[1], 1);

    c->equal = 1;
    c->x.label = view_axes[view].label[0];
    p->y.down = view == VIEW_TOP;
    return p;
}

struct chart_series *view_line(struct chart *c, struct chart_panel *p, int n, const double *xy, unsigned colour, double width)
{
    double *x = chart_numbers(c, n), *y = chart_numbers(c, n);

    if (!x || !y)
        return &c->spare_series;
    for (int i = 0; i < n; i++) {
        x[i] = xy[2 * i];
        y[i] = xy[2 * i + 1];
    }
    struct chart_series *s = chart_add_series(c, p, NULL, n, x, y);
    s->colour = colour;
    s->width = width;
    return s;
}

void view_body(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t body, const double *q, unsigned colour,
               unsigned tint)
{
    static const double corner[7][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {0, 0}, {1, 0}};
    const struct view_axes *a = &view_axes[view];
    const int one = a->axis[0], other = a->axis[1];
    const double about = (other - one == 2 ? -1 : 1) * (q ? q[a->turn] : 0);      /* pitch turns x towards -z */
    double half[3], xy[14];

    view_box(v, body, half);
    for (int i = 0; i < 7; i++) {
        const double d = corner[i][0] * half[one], e = corner[i][1] * half[other];
        double at[3] = {v->cg[3 * body], v->cg[3 * body + 1], v->cg[3 * body + 2]};
        at[one] += d - about * e + (q ? q[one] : 0);
        at[other] += e + about * d + (q ? q[other] : 0);
        view_place(view, at, &xy[2 * i]);
    }
    if (tint)
        view_line(c, p, 5, xy, tint, 0)->filled = 1;
    view_line(c, p, 5, xy, colour, 1);
    if (q)
        view_line(c, p, 2, &xy[10], colour, 1);
}

static void rectangle(struct chart *c, struct chart_panel *p, const double centre[2], double w, double h, unsigned colour)
{
    const double l = centre[0] - w / 2, r = centre[0] + w / 2, b = centre[1] - h / 2, t = centre[1] + h / 2;

    view_line(c, p, 5, (double[]){l, b, r, b, r, t, l, t, l, b}, colour, 1);
}

void view_wheels(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t i, unsigned colour)
{
    const int64_t body = v->wheelset[i];
    const double r = v->radius[i];
    double circle[2 * (ROUND + 1)], axle[4], at[3], centre[2];

    if (view == VIEW_SIDE) {
        for (int k = 0; k <= ROUND; k++) {
            circle[2 * k] = v->cg[3 * body] + r * cos(2 * M_PI * k / ROUND);
            circle[2 * k + 1] = -v->cg[3 * body + 2] + r * sin(2 * M_PI * k / ROUND);
        }
        view_line(c, p, ROUND + 1, circle, colour, 1.2);
        return;
    }
    for (int side = 0; side < 2; side++) {
        at[0] = v->cg[3 * body];
        at[1] = v->cg[3 * body + 1] + (side ? running : -running);
        at[2] = v->cg[3 * body + 2];
        view_place(view, at, centre);
        rectangle(c, p, centre, view == VIEW_TOP ? 2 * r : tread, view == VIEW_TOP ? tread : 2 * r, colour);
        axle[2 * side] = centre[0];
        axle[2 * side + 1] = centre[1];
    }
    view_line(c, p, 2, axle, colour, 1.2);
}
