/* The table against direct search at random points: S1002 on 60E1 1:40, every contact of 10 000 yaws and displacements, and of a nose that
 * rises between two sections. */
#include "tests/kernel/random.h"
#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/lookup.h"
#include "tools/contact/table.h"

enum { YAWS = 500, EACH = 20 };

static const struct table_grid grid = {.u_max = 10e-3, .u_step = 1e-4, .yaw_max = 0.02, .yaws = 21, .shear_modulus = 82e9, .poisson = 0.28};

/* Errors of the contacts of whole weight, on the tread and where the contact is steeper than 0.1 rad. */
struct worst { double height, place, radius, sum; int n; };

static void compare(const struct contact *c, const float *exact, struct worst *w)
{
    double height = fabs(c->height - exact[CTAB_HEIGHT]);

    w->height = fmax(w->height, height);
    w->place = fmax(w->place, fabs(c->row[CTAB_WHEEL_Y] - exact[CTAB_WHEEL_Y]));
    w->radius = fmax(w->radius, fabs(c->row[CTAB_RADIUS] - exact[CTAB_RADIUS]));
    w->sum += height * height;
    w->n++;
}

/* The rail moved to the left by less than a step of the grid, which moves the wheel to the right by as much. */
static void rail_move(struct shape *s, const struct shape *from, double by)
{
    for (int64_t i = 0; i < from->prof.points; i++)
        s->y[i] = from->y[i] - by;
}

int main(void)
{
    struct shape *wheel = shape_s1002('r'), *rail = shape_60e1('r', 1 / 40.0), *moved = shape_60e1('r', 1 / 40.0);
    struct worst tread = {0}, flange = {0};
    struct ctab t;
    int points = 0, met = 0;

    if (!ok(!table_fill(&t, &wheel->prof, &rail->prof, TABLE_EXACT, &grid), "the table"))
        return done();
    for (int i = 0; i < YAWS; i++) {
        struct table_grid one = grid;
        struct ctab exact;
        double by = 1e-4 * random_number(), yaw = 0.02 * random_number();
        one.yaws = 2;
        one.yaw_max = yaw;
        rail_move(moved, rail, by);
        if (table_fill(&exact, &wheel->prof, &moved->prof, TABLE_EXACT, &one))
            return ok(0, "direct search at yaw %g", yaw), done();
        for (int k = 0; k < EACH; k++) {
            int64_t iy = random_number() < 0.5, iu = (int64_t)((double)(exact.us - 2) * random_number());
            struct contact c[CONTACT_MAX];
            int n = contact_lookup(&t, 0, iy ? yaw : -yaw, exact.u[iu] + by, 0, c), m;
            const float *row = ctab_node(&exact, 0, iy, iu, &m);
            points++;
            for (int j = 0; j < m; j++)
                for (int l = 0; l < n; l++)
                    if (c[l].weight > 1 - 1e-9 && fabs(c[l].row[CTAB_WHEEL_Y] - row[j * CTAB_N + CTAB_WHEEL_Y]) < 1e-3) {
                        compare(&c[l], row + j * CTAB_N, fabs(c[l].row[CTAB_ANGLE]) < 0.1 ? &tread : &flange);
                        met += j == 0;
                        break;
                    }
        }
        ctab_free(&exact);
    }
    printf("# %d points, the touching contact met at %d; tread: height %.2g m (rms %.2g), place %.2g m, radius %.2g m\n", points, met, tread.height,
           sqrt(tread.sum / tread.n), tread.place, tread.radius);
    printf("# steeper: height %.2g m (rms %.2g), place %.2g m, radius %.2g m\n", flange.height, sqrt(flange.sum / flange.n), flange.place, flange.radius);
    ok(points == YAWS * EACH && met > 0.97 * points, "a contact of the table where direct search finds the touching one");
    ok(tread.height < 20e-9 && sqrt(tread.sum / tread.n) < 2e-9, "on the tread as high");
    ok(flange.height < 2e-6 && sqrt(flange.sum / flange.n) < 50e-9, "on the flange as high");
    ctab_free(&t);
    free(wheel);
    free(rail);
    free(moved);
    return done();
}
