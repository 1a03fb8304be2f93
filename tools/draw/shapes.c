#include "tools/draw/shapes.h"

#include <math.h>
#include <string.h>

static const double type = 0.55;               /* of a chart's, for these words */
static const double heading = 0.045;           /* of the height, for the title */
static const double swing = 0.6;               /* m, largest displacement of a corner */
static const double margin = 0.7;              /* m, around the vehicle */

/* x, z and pitch from the right; x, y and yaw from above; y, z and roll from behind. */
enum view shapes_view(const struct veh *v, const double *shape)
{
    enum view best = VIEW_SIDE;
    double most = -1;

    for (enum view view = 0; view < VIEWS; view++) {
        const struct view_axes *a = &view_axes[view];
        double sum = 0;
        for (int64_t i = 0; i < v->bodies; i++) {
            const double *q = &shape[VEH_DOFS * i];
            for (int k = 0; k < 2; k++)
                sum += v->mass[i] * q[a->axis[k]] * q[a->axis[k]];
            sum += v->inertia[3 * i + a->turn - VEH_ROLL] * q[a->turn] * q[a->turn];
        }
        if (sum > most * (1 + 1e-9)) {
            most = sum;
            best = view;
        }
    }
    return best;
}

/* The page's limits of the vehicle in a view. */
static void limits(const struct veh *v, enum view view, double lo[2], double hi[2])
{
    for (int k = 0; k < 2; k++) {
        const int axis = view_axes[view].axis[k];
        double least = INFINITY, most = -INFINITY;
        for (int64_t i = 0; i < v->bodies; i++) {
            double half[3];
            view_box(v, i, half);
            const double at = view_axes[view].sign[k] * v->cg[3 * i + axis];
            least = fmin(least, at - half[axis]);
            most = fmax(most, at + half[axis]);
        }
        lo[k] = least - margin;
        hi[k] = most + margin;
    }
}

/* How far the corner of a box moves most in the view. */
static double largest(const struct veh *v, enum view view, const double *shape)
{
    const struct view_axes *a = &view_axes[view];
    double most = 0;

    for (int64_t i = 0; i < v->bodies; i++) {
        const double *q = &shape[VEH_DOFS * i], turn = fabs(q[a->turn]);
        double half[3];
        view_box(v, i, half);
        most = fmax(most, hypot(fabs(q[a->axis[0]]) + turn * half[a->axis[1]], fabs(q[a->axis[1]]) + turn * half[a->axis[0]]));
    }
    return most > 0 ? most : 1;
}

static void add_shape(struct chart *c, const struct mod *m, const struct veh *v, int64_t mode)
{
    const double *shape = m->shape + mode * m->dofs;
    const enum view view = shapes_view(v, shape);
    struct chart_panel *p = view_begin(c, view);
    double lo[2], hi[2], q[VEH_DOFS];

    c->bare = 1;
    c->type = type;
    limits(v, view, lo, hi);
    c->x.lo = lo[0];
    c->x.hi = hi[0];
    p->y.lo = lo[1];
    p->y.hi = hi[1];
    const double scale = swing / largest(v, view, shape);
    if (view != VIEW_TOP)
        view_line(c, p, 2, (double[]){lo[0], 0, hi[0], 0}, CHART_BLACK, 0.8);
    for (int64_t i = 0, k = 0; i < v->bodies; i++) {
        if (veh_is_wheelset(v, i)) {
            while (v->wheelset[k] != i)
                k++;
            view_wheels(c, p, view, v, k, CHART_BLACK);
            continue;
        }
        for (int d = 0; d < VEH_DOFS; d++)
            q[d] = scale * shape[VEH_DOFS * i + d];
        view_body(c, p, view, v, i, NULL, 0xb8b8b8, 0xf4f4f4);
        view_body(c, p, view, v, i, q, chart_colour((int)(i % CHART_COLOURS)), 0);
    }
    c->title = chart_words(c, "%lld  %s, %.3f Hz, damping %.1f %%, %s", (long long)mode + 1, m->name[mode], m->frequency[mode],
                           100 * m->damping[mode], view_axes[view].words);
}

const char *shapes_chart(struct chart *c, const struct mod *m, const struct veh *v)
{
    const int n = (int)(m->n < SHAPES_MOST ? m->n : SHAPES_MOST), columns = n > 4 ? 2 : 1, rows = (n + columns - 1) / columns;

    if (strcmp(m->of, "veh") != 0 || m->dofs != VEH_DOFS * v->bodies)
        return "the modes are not those of this vehicle";
    c->title = chart_words(c, "Natural modes of %s, wheelsets held", v->name);
    c->area = (struct chart_area){0, 0, 1, heading};
    c->bare = 1;
    c->type = type;
    chart_add_panel(c, NULL, 1);
    for (int k = 0; k < n; k++) {
        const struct chart_area area = {(double)(k % columns) / columns, heading + (1 - heading) * (k / columns) / rows, 1.0 / columns,
                                        (1 - heading) / rows};
        add_shape(chart_add_beside(c, &area), m, v, k);
    }
    return c->why;
}
