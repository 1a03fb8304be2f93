/* Parameters of linear wheelset models: wheels and rails of arcs in closed form, a leap by its Fourier term, cones. */
#include "tools/contact/parameters.h"

#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/table.h"

#define STEP 1e-5                      /* m */
static const double e = 1.5, r0 = 0.46, Rw = 0.45, Rr = 0.30;
enum { POINTS = 2001 };

static const struct table_grid grid = {.u_max = 8e-3, .u_step = 1e-4, .shear_modulus = 82e9, .poisson = 0.28};
static struct wheelset_point sweep[POINTS];
static double value[4][POINTS];
static const struct parameters_curves curves = {value[0], value[1], value[2], value[3]};

/* An arc through y = 0, z = 0 with the slope -tan(d0) there, its centre below. */
static struct shape *arc(char part, double R, double d0, double half, char side)
{
    struct shape *s = shape_new(part, 0.5 * e, part == 'w' ? r0 : 0);
    for (int i = -1500; i <= 1500; i++)
        shape_arc_point(s, i * half / 1500, R * sin(d0), R * cos(d0), R, -1);
    return shape_end(s, side);
}

/* Rest positions of a wheelset of arcs, how many. */
static int64_t arcs(double d0, int roll_free)
{
    struct ctab t[2];
    int64_t n = 0;
    for (int i = 0; i < 2; i++) {
        struct shape *wheel = arc('w', Rw, d0, 0.035, "lr"[i]), *rail = arc('r', Rr, d0, 0.030, "lr"[i]);
        ok(!table_fill(&t[i], &wheel->prof, &rail->prof, TABLE_NONE, &grid), "table of arcs at %g rad, side %c", d0, "lr"[i]);
        free(wheel);
        free(rail);
    }
    ok(!wheelset_sweep(&t[0], &t[1], 0, 0, STEP, roll_free, sweep, POINTS, &n), "rest positions");
    parameters_gather(sweep, n, &curves);
    ctab_free(&t[0]);
    ctab_free(&t[1]);
    return n;
}

static void closed_forms(double d0)
{
    const double l = 0.5 * e, t = tan(d0), turn = t / (l - r0 * t);
    const double angle = turn * (l / sin(d0) + Rw) / (Rw - Rr);          /* rad/m, of the contact plane */
    struct parameters p = {0};
    int64_t n = arcs(d0, 1);

    ok(!parameters_at(&curves, n, 2e-4, e, r0, &p), "parameters at 0.2 mm");
    near(p.klingel.conicity / (Rw * (angle - turn) * sin(d0)), 1, 2e-3, "conicity of arcs, over Rw (angle - roll) sin d0");
    near(p.contact_angle / (l * angle / (cos(d0) * cos(d0))), 1, 2e-3, "contact angle parameter of arcs, over its closed form");
    near(p.roll / (l * turn), 1, 2e-3, "roll parameter of arcs, over its closed form");
    n = arcs(d0, 0);
    parameters_at(&curves, n, 2e-4, e, r0, &p);
    near(p.roll, 0, 0, "without roll its parameter is 0");
    near(p.contact_angle / (l / (Rw - Rr) / pow(cos(d0), 3)), 1, 2e-3, "and the contact moves by the curvatures alone");
}

static void harmonics(void)
{
    double y[201], f[201];

    for (int i = 0; i < 201; i++) {
        y[i] = (i - 100) * 1e-4;
        f[i] = 3 * y[i] + 0.7;
    }
    near(parameters_slope(y, f, 201, 1e-3, 4e-3), 3, 1e-9, "a line acts by its slope, whatever its height");
    for (int i = 0; i < 201; i++)
        f[i] = y[i] * y[i] * y[i];
    near(parameters_slope(y, f, 201, 0, 4e-3) / (0.75 * 16e-6), 1, 1e-3, "a cube by 3/4 of the amplitude squared");
    for (int i = 0; i < 201; i++)
        f[i] = (y[i] > 1e-9) - (y[i] < -1e-9);
    near(parameters_slope(y, f, 201, 0, 4e-3) / (4 / (M_PI * 4e-3)), 1, 1e-3, "a step of one to either side by 4/(pi a)");
    near(parameters_slope(y, f, 201, 6e-3, 4e-3), 0, 1e-9, "and not at all beyond it");
}

int main(void)
{
    harmonics();
    closed_forms(0.025);
    closed_forms(0.1);
    return done();
}
