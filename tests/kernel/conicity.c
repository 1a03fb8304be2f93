/* Equivalent conicity: cones in closed form, reference wheels B and C on rail A of EN 15302, S1002 on 60E1 1:40. */
#include "tools/contact/conicity.h"

#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/table.h"
#include "tools/contact/wheelset.h"

#define STEP 1e-5             /* m: wheel B leaps a few hundredths before 3 mm */
enum { POINTS = 2001 };

static const struct table_grid grid = {.u_max = 12e-3, .u_step = 1e-4, .shear_modulus = 82e9, .poisson = 0.28};
static struct wheelset_point sweep[POINTS];
static double y[POINTS], dr[POINTS];

static void closed_forms(void)
{
    double c, l, worst = 0;
    for (int i = 0; i < 201; i++)
        y[i] = (i - 100) * 1e-4;
    for (double gamma = 0.01; gamma < 1; gamma *= 2) {
        for (int i = 0; i < 201; i++)
            dr[i] = 2 * gamma * y[i];
        ok(!conicity_klingel(y, dr, 201, 3.3e-3, 1.5, 0.46, &c, &l), "cone of %g", gamma);
        worst = fmax(worst, fmax(fabs(c / gamma - 1), fabs(l / (2 * M_PI * sqrt(1.5 * 0.46 / (2 * gamma))) - 1)));
    }
    ok(worst < 1e-9, "a cone has its own conicity and Klingel's wavelength (%.1e)", worst);
    for (int i = 0; i < 201; i++)
        dr[i] = 0.4 * (y[i] - 1.7e-3);
    conicity_klingel(y, dr, 201, 2e-3, 1.5, 0.46, &c, &l);
    near(c, 0.2, 1e-9, "a shifted cone: about the displacement without radius difference");
    for (int i = 0; i < POINTS; i++) {
        y[i] = (i - 1000) * 3e-6;
        dr[i] = 1e6 * y[i] * y[i] * y[i];
    }
    conicity_klingel(y, dr, POINTS, 2e-3, 1.5, 0.46, &c, &l);
    /* y'' = -k y^3: period 4 K(1/2)/(a sqrt k), K(m = 1/2) = 1.854074677 */
    near(l / (4 * 1.854074677301372 / (2e-3 * sqrt(1e6 / 0.69))), 1, 5e-6, "a cubic law has the period of the elliptic function");
    for (int i = 0; i < 201; i++) {
        y[i] = (i - 100) * 1e-4;
        dr[i] = 0;
    }
    ok(!conicity_klingel(y, dr, 201, 2e-3, 1.5, 0.46, &c, &l) && c == 0 && l == 0, "cylinders: conicity 0, no wavelength");
    ok(conicity_klingel(y, dr, 201, 11e-3, 1.5, 0.46, &c, &l) != NULL, "amplitude beyond the range is refused");
}

/* Zones of EN 15302 (mm): z = c - sqrt(R^2 - (y - m)^2), or c + m y where R = 0; up to `to`. */
struct zone { double to, c, m, R; };

static struct shape *zones(char part, const struct zone *zone, double from, char side)
{
    struct shape *s = shape_new(part, 0.75, part == 'w' ? 0.46 : 0);
    for (double at = from; ; at += 0.05) {
        while (zone->to && at > zone->to)
            zone++;
        if (!zone->to)
            break;
        if (zone->R > 0)
            shape_arc_point(s, at * 1e-3, zone->m * 1e-3, zone->c * 1e-3, zone->R * 1e-3, -1);
        else
            shape_point(s, at * 1e-3, (zone->c + zone->m * at) * 1e-3, zone->m, 0);
    }
    return shape_end(s, side);
}

static const struct zone rail_a[] = {
    {-23.2401, 15.899044, -19.63949, 13}, {-7.8749, 80.277908, -1.0825, 80}, {13.0989, 299.48349, 17.5966, 300},
    {28.6709, 79.508225, 14.29829, 80}, {39.2, 13.598369, 26.33535, 13}, {0, 0, 0, 0},
};
static const struct zone wheel_b[] = {
    {-38.7879, -93.5767, -2.7475, 0}, {-29.3505, 17.7814, -25.6322, 14}, {-0.4787, 119.9745, 2.5204, 120}, {30, 0, -0.025, 0},
    {60, 0.75, -0.05, 0}, {0, 0, 0, 0},
};
static const struct zone wheel_c[] = {
    {-41.0534, 11.96051 - 2.47508685 * 41.05339, -2.47508685, 0}, {-32.3621, 16.830365, -29, 13}, {-17.587, 100.870534, -6.5, 100},
    {19, 329.45258, 19, 330}, {29, -0.54742374, 0, 0}, {59, -0.54742374 + 2.9, -0.1, 0}, {0, 0, 0, 0},
};

/* Sweeps a pair of profiles; y and dr filled, how many. */
static int64_t pair(const struct prof *wl, const struct prof *rl, const struct prof *wr, const struct prof *rr, int roll_free)
{
    struct ctab left, right;
    int64_t n = 0;
    if (!ok(!table_fill(&left, wl, rl, TABLE_NONE, &grid) && !table_fill(&right, wr, rr, TABLE_NONE, &grid), "tables"))
        return 0;
    ok(!wheelset_sweep(&left, &right, 0, 0, STEP, roll_free, sweep, POINTS, &n), "sweep");
    for (int64_t i = 0; i < n; i++) {
        y[i] = sweep[i].y;
        dr[i] = sweep[i].radius_difference;
    }
    ctab_free(&left);
    ctab_free(&right);
    return n;
}

static double dr_at(int64_t n, double at)
{
    int64_t i = (int64_t)floor((at - y[0]) / STEP + 0.5);
    return i >= 0 && i < n ? dr[i] : (double)NAN;
}

/* Radius differences (mm) at 1..6 mm and conicities at 1..6 mm of the standard's tables; its roll is 0. */
static void reference_wheel(const char *name, const struct zone *wheel, double from, const double *want_dr, const double *want)
{
    struct shape *wl = zones('w', wheel, from, 'l'), *wr = zones('w', wheel, from, 'r');
    struct shape *rl = zones('r', rail_a, -32.6, 'l'), *rr = zones('r', rail_a, -32.6, 'r');
    int64_t n = pair(&wl->prof, &rl->prof, &wr->prof, &rr->prof, 0);
    double worst = 0, c, l;
    int within = 1;
    for (int k = 1; k <= 6; k++) {
        worst = fmax(worst, fabs(dr_at(n, k * 1e-3) * 1e3 - want_dr[k - 1]));
        const char *why = conicity_klingel(y, dr, n, k * 1e-3, 1.5, 0.46, &c, &l);
        if (why || fabs(c - want[k - 1]) > fmin(0.05, 0.5 * want[k - 1])) {
            within = 0;
            printf("# %s at %d mm: %.4f, should be %.3f\n", name, k, c, want[k - 1]);
        }
    }
    ok(worst < 3e-3, "wheel %s: radius differences within 3 um (%.2g mm)", name, worst);
    ok(within, "wheel %s: conicities within the standard's limits", name);
    free(wl);
    free(wr);
    free(rl);
    free(rr);
}

static void s1002(int roll_free, int most)
{
    static const double want[6] = {0.354, 0.219, 0.175, 0.156, 0.150, 0.270};
    struct shape *wr = shape_s1002('r'), *wl = shape_s1002('l'), *rr = shape_60e1('r', 1 / 40.0), *rl = shape_60e1('l', 1 / 40.0);
    int64_t n = pair(&wl->prof, &rl->prof, &wr->prof, &rr->prof, roll_free);
    double c, l, worst = 0;
    for (int k = 1; k <= most; k++) {
        conicity_klingel(y, dr, n, k * 1e-3, 1.5, 0.46, &c, &l);
        worst = fmax(worst, fabs(c - want[k - 1]));
        if (k == 3)
            near(c, 0.175, 0.005, "S1002 on 60E1 1:40: 0.175 at 3 mm");
    }
    ok(worst < 0.005, "S1002 on 60E1 1:40, 1 to %d mm, %s roll: within 0.005 (%.2g)", most, roll_free ? "with" : "without", worst);
    free(wr);
    free(wl);
    free(rr);
    free(rl);
}

int main(void)
{
    static const double b_dr[6] = {0.05, 0.1, 1.948, 2.515, 3.16, 3.886}, b[6] = {0.025, 0.025, 0.030, 0.236, 0.280, 0.300};
    static const double c_dr[6] = {1.024, 1.271, 1.402, 1.533, 1.665, 1.801}, c[6] = {0.515, 0.365, 0.271, 0.221, 0.191, 0.170};

    closed_forms();
    reference_wheel("B", wheel_b, -38.9, b_dr, b);
    reference_wheel("C", wheel_c, -43.8, c_dr, c);
    s1002(0, 6);
    s1002(1, 4);                                                 /* roll brings the flange root to bear at 4.95 mm, not 5.1 */
    return done();
}
