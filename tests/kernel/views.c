/* Drawings of a vehicle: boxes against the inertias of a uniform block, places on the page, the view of a mode, charts beside one another. */
#include "tools/draw/views.h"

#include <math.h>
#include <string.h>

#include "tests/kernel/tap.h"
#include "tools/draw/layout.h"
#include "tools/draw/shapes.h"

/* One block of 12 x 3 x 2 m. */
static const double side[3] = {12, 3, 2}, mass[1] = {36000}, cg[3] = {-5, 0.2, -1.8};

static struct veh block(double inertia[3])
{
    for (int k = 0; k < 3; k++)
        inertia[k] = mass[0] / 12 * (pow(side[(k + 1) % 3], 2) + pow(side[(k + 2) % 3], 2));
    return (struct veh){.bodies = 1, .mass = mass, .inertia = inertia, .cg = cg};
}

static void boxes(void)
{
    double inertia[3], half[3];
    struct veh v = block(inertia);

    view_box(&v, 0, half);
    near(half[0], 6, 1e-12, "a block of 12 m is half of it long");
    near(half[1], 1.5, 1e-12, "half of 3 m wide");
    near(half[2], 1, 1e-12, "half of 2 m high");
    inertia[0] = inertia[1] + inertia[2] + 1;
    view_box(&v, 0, half);
    near(half[0], 0, 0, "inertias of no body make no length");
}

static void places(void)
{
    static const double p[3] = {1, 2, -3};
    double xy[2];

    view_place(VIEW_SIDE, p, xy);
    ok(xy[0] == 1 && xy[1] == 3, "from the right: x and height");
    view_place(VIEW_TOP, p, xy);
    ok(xy[0] == 1 && xy[1] == 2, "from above: x and y");
    view_place(VIEW_END, p, xy);
    ok(xy[0] == 2 && xy[1] == 3, "from behind: y and height");
}

/* The corners that a displaced box adds to a panel, and where they must be: d + turn x d of a small turn. */
static void turned(enum view view, int turn)
{
    double inertia[3], q[VEH_DOFS] = {0.1, 0.2, 0.3}, t = 0.01, omega[3] = {0}, worst = 0;
    struct veh v = block(inertia);
    struct chart c;
    const int *axis = view_axes[view].axis;

    q[turn] = t;
    omega[turn - VEH_ROLL] = t;
    chart_begin(&c);
    struct chart_panel *p = chart_add_panel(&c, NULL, 1);
    view_body(&c, p, view, &v, 0, q, 0, 0);
    double d[3] = {0}, at[3], xy[2];
    d[axis[0]] = -side[axis[0]] / 2;
    d[axis[1]] = -side[axis[1]] / 2;
    for (int k = 0; k < 3; k++)
        at[k] = cg[k] + q[k] + d[k] + omega[(k + 1) % 3] * d[(k + 2) % 3] - omega[(k + 2) % 3] * d[(k + 1) % 3];
    view_place(view, at, xy);
    worst = fmax(fabs(p->series->x[0] - xy[0]), fabs(p->series->y[0] - xy[1]));
    ok(worst < 1e-12, "a corner of a body turned as seen %s", view_axes[view].words);
    chart_free(&c);
}

static void best_view(void)
{
    double inertia[3], shape[VEH_DOFS];
    struct veh v = block(inertia);
    static const enum view want[VEH_DOFS] = {VIEW_SIDE, VIEW_TOP, VIEW_SIDE, VIEW_END, VIEW_SIDE, VIEW_TOP};
    int right = 0;

    for (int d = 0; d < VEH_DOFS; d++) {
        memset(shape, 0, sizeof shape);
        shape[d] = 1;
        right += shapes_view(&v, shape) == want[d];
    }
    ok(right == VEH_DOFS, "bounce and pitch from the right, yaw from above, roll from behind");
    memset(shape, 0, sizeof shape);
    shape[VEH_Y] = 1;
    shape[VEH_ROLL] = 0.5;
    ok(shapes_view(&v, shape) == VIEW_END, "a sway from behind");
}

/* Two charts share a picture without meeting. */
static void sheet(void)
{
    static const double x[2] = {0, 1};
    struct chart c;
    struct layout l, other;
    struct text t = {0};

    chart_begin(&c);
    ok(text_open(&t) == NULL, "fonts");
    chart_add_series(&c, chart_add_panel(&c, "one", 1), NULL, 2, x, x);
    c.area = (struct chart_area){0, 0, 0.5, 1};
    struct chart *b = chart_add_beside(&c, &(struct chart_area){0.5, 0.25, 0.5, 0.75});
    chart_add_series(b, chart_add_panel(b, "other", 1), NULL, 2, x, x);
    layout_make(&l, &c, &t, 800, 400);
    layout_make(&other, b, &t, 800, 400);
    ok(l.box[0].x > 0 && l.box[0].x + l.box[0].w < 400, "the first keeps to the left half");
    ok(other.box[0].x > 400 && other.box[0].x + other.box[0].w < 800 && other.box[0].y >= 100, "the one beside it to its part");
    text_free(&t);
    chart_free(&c);
}

int main(void)
{
    boxes();
    places();
    turned(VIEW_SIDE, VEH_PITCH);
    turned(VIEW_TOP, VEH_YAW);
    turned(VIEW_END, VEH_ROLL);
    best_view();
    sheet();
    return done();
}
