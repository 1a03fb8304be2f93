/* What a contact table must not depend on: where its profiles' axes lie, the grid of the search, the spacing of the points.  S1002 on 60E1
 * 1:40, right side. */
#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/table.h"

static const struct table_grid grid = {.u_max = 8e-3, .u_step = 1e-4, .yaw_max = 0.02, .yaws = 3, .shear_modulus = 82e9, .poisson = 0.28};

/* The touching contact at yaw iy of 3 and displacement u. */
static const float *touching(const struct ctab *t, int64_t iy, double u)
{
    int count;
    const float *row = ctab_node(t, 0, iy, lrint((u - t->u[0]) / (t->u[1] - t->u[0])), &count);
    return count ? row : NULL;
}

static void shape_move(struct shape *s, double dy, double dz)
{
    for (int64_t i = 0; i < s->prof.points; i++) {
        s->y[i] += dy;
        s->z[i] += dz;
    }
}

/* Both moved by 0.0371 mm sideways; both lowered, the wheel's radius with it, so that it is the same wheel. */
static void moved(const struct ctab *t)
{
    struct shape *w = shape_s1002('r'), *r = shape_60e1('r', 1 / 40.0);
    struct ctab m;
    double dy = 3.71e-5, dz = 1e-3, height = 0, place = 0, radius = 0;

    shape_move(w, dy, dz);
    shape_move(r, dy, dz);
    w->prof.radius -= dz;
    if (!ok(!table_fill(&m, &w->prof, &r->prof, TABLE_EXACT, &grid), "both profiles moved"))
        return;
    for (int64_t iy = 0; iy < 3; iy++)
        for (int k = -79; k < 80; k++) {
            const float *a = touching(t, iy, k * 1e-4), *b = touching(&m, iy, k * 1e-4);
            if (fabs((double)a[CTAB_WHEEL_Y] + dy - (double)b[CTAB_WHEEL_Y]) > 1e-3)
                continue;                                        /* two that touch at once */
            height = fmax(height, fabs((double)a[CTAB_HEIGHT] - (double)b[CTAB_HEIGHT]));
            place = fmax(place, fabs((double)a[CTAB_RAIL_Y] + dy - (double)b[CTAB_RAIL_Y]));
            radius = fmax(radius, fabs((double)a[CTAB_RADIUS] - (double)b[CTAB_RADIUS]));
        }
    printf("# both moved: heights within %.2g m, places %.2g m, radii %.2g m\n", height, place, radius);
    ok(height < 0.2e-6 && place < 5e-6 && radius < 10e-6, "moved together they touch as before");
    ctab_free(&m);
    free(w);
    free(r);
}

/* Rms difference of the heights from t, at the displacements that both grids hold, of contacts up to this steep (rad). */
static double off(const struct ctab *t, const struct prof *w, const struct prof *r, double u_step, double steepest)
{
    struct table_grid g = grid;
    struct ctab m;
    double sum = 0;
    int n = 0;

    g.u_step = u_step;
    if (table_fill(&m, w, r, TABLE_EXACT, &g))
        return NAN;
    for (int64_t iy = 0; iy < 3; iy++)
        for (int k = -19; k < 20; k++) {
            const float *a = touching(t, iy, k * 4e-4), *b = touching(&m, iy, k * 4e-4);
            double d = (double)a[CTAB_HEIGHT] - (double)b[CTAB_HEIGHT];
            if (fabs((double)a[CTAB_ANGLE]) > steepest)
                continue;
            sum += d * d;
            n++;
        }
    ctab_free(&m);
    return sqrt(sum / n);
}

/* Every n-th point. */
static void shape_thin(struct shape *s, int64_t every)
{
    int64_t m = 0;

    for (int64_t i = 0; i < s->prof.points; i += every, m++) {
        s->y[m] = s->y[i];
        s->z[m] = s->z[i];
        s->slope[m] = s->slope[i];
        s->curvature[m] = s->curvature[i];
    }
    s->prof.points = m;
    s->poly_first[1] = m;
}

static void thinned(const struct ctab *t)
{
    double d[2];

    for (int k = 0; k < 2; k++) {
        struct shape *w = shape_s1002('r'), *r = shape_60e1('r', 1 / 40.0);
        shape_thin(w, k ? 10 : 20);
        shape_thin(r, k ? 10 : 20);
        d[k] = off(t, &w->prof, &r->prof, grid.u_step, 1.5);
        free(w);
        free(r);
    }
    printf("# every 20th and 10th point: heights off by %.2g and %.2g m rms\n", d[0], d[1]);
    ok(d[1] < 0.2 * d[0], "half the distance of the points, less than a fifth of the error");
}

int main(void)
{
    struct shape *wheel = shape_s1002('r'), *rail = shape_60e1('r', 1 / 40.0);
    struct table_grid fine = grid;
    struct ctab t, f;

    fine.u_step = 2.5e-5;
    if (!ok(!table_fill(&t, &wheel->prof, &rail->prof, TABLE_EXACT, &grid) && !table_fill(&f, &wheel->prof, &rail->prof, TABLE_EXACT, &fine), "tables"))
        return done();
    moved(&t);
    double tread[3], all[3];
    for (int k = 0; k < 3; k++) {
        double step = 4e-4 / (1 << k);
        tread[k] = off(&f, &wheel->prof, &rail->prof, step, 0.1);
        all[k] = off(&f, &wheel->prof, &rail->prof, step, 1.5);
        printf("# grid of %g mm: heights off by %.2g m rms on the tread, %.2g m with the flange\n", 1e3 * step, tread[k], all[k]);
    }
    ok(tread[0] < 1e-11, "on the tread the grid does not count");
    ok(all[1] < 0.5 * all[0] && all[2] < 0.5 * all[1] && all[2] < 20e-9,
       "where arcs of the flange meet within a cell its error falls faster than the step, to 20 nm at 0.1 mm");
    thinned(&t);
    ctab_free(&t);
    ctab_free(&f);
    free(wheel);
    free(rail);
    return done();
}
