/* The assembled track with consistent mass: an infinite beam on discrete and on continuous supports, pinned-pinned frequencies, rigid motion,
 * bending stiffness that varies.  Run from the root. */
#include "tools/receptance/sweep.h"

#include <complex.h>
#include <time.h>

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/peaks.h"
#include "tools/track/seat.h"

enum { FREQUENCIES = 15, MOST = 4000 };

#define LONG "from=-60", "length=120", "rail.mass_model=consistent"

/* H of both rails loaded at the middle of the track, at frequencies from by step to. */
static const char *receptance(struct frf *r, const struct trk *t, int at, double from, double to, double step)
{
    struct place p;

    place_find(&p, t, PLACE_BOTH, at, 0);
    return sweep_places(r, t, &p, &p, 0, &(struct sweep){from, to, step});
}

static double complex value(const struct trk *t, int at, double frequency)
{
    struct frf r = {0};
    double complex H = NAN;

    if (receptance(&r, t, at, frequency, frequency, 1) == NULL)
        H = r.H[0] + r.H[1] * I;
    frf_free(&r);
    return H;
}

/* (diag(1/k) + G)^-1 g with the Green's function of the free beam (Heckl 1995, Acustica 81, 559), Table 1, both rails loaded alike, by an
 * independent program: Hz, m/N, degrees over a sleeper, the same halfway. */
static const double EXACT[FREQUENCIES][5] = {
    {0, 4.97705e-9, 0, 5.09835e-9, 0},                 {10, 4.99545e-9, -0.95, 5.11669e-9, -0.92},
    {50, 5.49911e-9, -5.65, 5.61864e-9, -5.48},        {100, 8.30401e-9, -24.58, 8.40962e-9, -24.19},
    {119, 9.93529e-9, -51.63, 1.00037e-8, -51.12},     {150, 5.71361e-9, -95.89, 5.66957e-9, -95.11},
    {200, 2.13561e-9, -99.36, 1.99973e-9, -96.29},     {256, 1.25591e-9, -65.54, 1.30937e-9, -54.35},
    {300, 1.47006e-9, -46.38, 1.63322e-9, -39.05},     {400, 2.22527e-9, -48.91, 2.44187e-9, -44.32},
    {483, 2.57345e-9, -70.31, 2.78636e-9, -65.68},     {600, 2.02936e-9, -100.70, 2.16826e-9, -94.92},
    {800, 1.13753e-9, -121.21, 1.20357e-9, -111.79},   {1000, 7.46557e-10, -130.31, 7.94059e-10, -114.18},
    {1200, 5.30619e-10, -139.60, 6.07557e-10, -107.71}};

static void infinite_beam(void)
{
    static const char *const set[] = {LONG, "rail.elements_per_bay=8"};
    const double half_digit = 0.005 * M_PI / 180;
    struct trk t;
    double size = 0, turn = 0;

    if (!ok(table1(&t, set, 4) == NULL, "120 m with consistent mass, eight elements a bay"))
        return;
    for (int k = 0; k < FREQUENCIES; k++)
        for (int at = AT_SLEEPER; at <= AT_MIDSPAN; at++) {
            const double complex H = value(&t, at, EXACT[k][0]);
            const double want = EXACT[k][1 + 2 * at], phase = EXACT[k][2 + 2 * at] * M_PI / 180;
            const double off = cabs(H) / want - 1, ahead = carg(H * cexp(-phase * I));
            ok(fabs(off) < 1e-3, "%g Hz %s: |H| off by %.1e", EXACT[k][0], at == AT_SLEEPER ? "over a sleeper" : "halfway", off);
            ok(fabs(ahead) < 1e-3, "and its phase by %.1e rad", ahead);
            size = fmax(size, fabs(off));
            turn = fmax(turn, fabs(ahead) - half_digit);
        }
    printf("# at most %.1e, and %.1e rad beyond the last digit of the phases\n", size, turn);
    trk_free(&t);
}

/* Two-layer support made continuous: H = 1/(8 EI b^3), b^4 = (s - m w^2)/4EI (Knothe and Grassie 1993, Vehicle System Dynamics 22, 209). */
static double complex continuous(double f)
{
    const double EI = 6.11e6, m = 60, L = 0.6, w = 2 * M_PI * f;
    const double complex pad = 300e6 + 50e3 * w * I, below = 140e6 - 190 * w * w + 60e3 * w * I;

    return 1 / (8 * EI * cpow((pad * below / (pad + below) / L - m * w * w) / (4 * EI), 0.75));
}

/* Table 1 cut into sleepers a sixth as heavy and stiff, 0.1 m apart. */
static void winkler(void)
{
    static const char *const set[] = {"from=-40", "length=80", "rail.mass_model=consistent", "sleeper.spacing=0.1", "sleeper.mass=63.333333333333333",
                                      "sleeper.roll_inertia=25.848333333333333", "railpad.stiffness=50e6", "railpad.damping=8333.3333333333333",
                                      "ballast.stiffness=46.666666666666667e6", "ballast.damping=20e3"};
    static const double f[] = {0, 20, 119, 256, 483, 800, 1200, 2000};
    struct trk t;
    struct seat s[TRK_RAILS];
    struct point p;

    if (!ok(table1(&t, set, 10) == NULL, "80 m with 800 small sleepers"))
        return;
    for (size_t k = 0; k < sizeof f / sizeof f[0]; k++) {
        const double complex H = value(&t, AT_SLEEPER, f[k]), want = continuous(f[k]);
        ok(cabs(H - want) < 1e-3 * cabs(want), "Winkler's beam, %g Hz: within %.1e", f[k], cabs(H / want - 1));
    }
    point_at(&p, &t, point_station(&t, AT_SLEEPER, 0));
    ok(seat_load(s, &t, &p, EXCITE_BOTH, 93.195e3) == NULL, "static");
    near(s[0].deflection / 0.4679e-3, 1, 1e-3, "0.468 mm under 93.195 kN");
    trk_free(&t);
}

/* The highest peak of |H| halfway between two sleepers from 900 to 1500 Hz. */
static double pinned(const char *beam, int elements)
{
    static struct peak p[MOST];
    char number[32];
    const char *set[] = {LONG, beam, number};
    struct trk t;
    struct frf r = {0};
    double best = NAN, most = 0;

    snprintf(number, sizeof number, "rail.elements_per_bay=%d", elements);
    if (table1(&t, set, 5) == NULL && receptance(&r, &t, AT_MIDSPAN, 900, 1500, 1) == NULL) {
        const int64_t n = peaks_find(r.n, r.frequency, r.H, p);
        for (int64_t i = 0; i < n; i++)
            if (!p[i].is_dip && p[i].amplitude > most) {
                most = p[i].amplitude;
                best = p[i].frequency;
            }
    }
    frf_free(&r);
    trk_free(&t);
    return best;
}

static void pinned_pinned(void)
{
    near(pinned("rail.beam=euler", 4), 1392.4, 1, "Euler-Bernoulli on 200 sleepers: the receptance peaks at 1392 Hz");
    near(pinned("rail.beam=euler", 8), 1392.4, 0.5, "with eight elements too");
    near(pinned("rail.beam=timoshenko", 4), 1056, 1.5, "Timoshenko: at 1056 Hz");
    near(pinned("rail.beam=timoshenko", 8), 1056, 1.5, "with eight elements too");
}

/* Largest |K u| over the largest entry of K; u and f [dofs]. */
static double force(const struct trk *t, const double *u, double *f)
{
    double most = 0, scale = 0;

    for (int64_t i = 0; i < t->dofs; i++)
        f[i] = 0;
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            f[t->Ai[p]] += t->Kx[p] * u[j];
            scale = fmax(scale, fabs(t->Kx[p]));
        }
    for (int64_t i = 0; i < t->dofs; i++)
        most = fmax(most, fabs(f[i]));
    return most / scale;
}

/* The whole track as one body, on no ballast: lift, pitch and roll. */
static void rigid_motion(void)
{
    static const char *const set[] = {"rail.mass_model=consistent", "rail.beam=timoshenko", "rail.elements_per_bay=3", "ballast.stiffness=1e-20",
                                      "rail.left.bending_stiffness={station: [-9, -2.2, 3], value: [5e6, 9e6, 6e6]}"};
    static const char *const name[] = {"lifting", "pitching", "rolling"};
    static double u[3][2000], f[2000];
    struct trk t;

    if (!ok(table1(&t, set, 5) == NULL && t.dofs <= 2000, "Timoshenko rails of varying stiffness on no ballast"))
        return;
    for (int64_t i = 0; i < t.nodes; i++)
        for (int rail = 0; rail < TRK_RAILS; rail++) {
            const int64_t w = t.node_dof[i] + 2 * rail;
            u[0][w] = 1;
            u[1][w] = -t.x[i];
            u[1][w + 1] = 1;
            u[2][w] = (rail == TRK_LEFT ? -0.5 : 0.5) * t.rail_spacing;
        }
    for (int64_t k = 0; k < t.sleepers; k++) {
        u[0][t.sleeper_dof[k]] = 1;
        u[1][t.sleeper_dof[k]] = -t.sleeper_x[k];
        u[2][t.sleeper_dof[k] + 1] = 1;
    }
    for (int k = 0; k < 3; k++) {
        const double left = force(&t, u[k], f);
        ok(left < 15e-12, "%s it needs no force: %.1e", name[k], left);
    }
    double weight = 0;
    for (int64_t j = 0; j < t.dofs; j++)
        for (int64_t p = t.Ap[j]; p < t.Ap[j + 1]; p++)
            weight += u[0][j] * u[0][t.Ai[p]] * t.Mx[p];
    near(weight, 2 * 60.0 * 30 + 50 * 380.0, 1e-8, "and it weighs what its parts weigh");
    trk_free(&t);
}

static double static_deflection(const char *const *set, int sets, int excite, double x)
{
    struct trk t;
    struct point p;
    struct seat s[TRK_RAILS] = {{.deflection = NAN}, {.deflection = NAN}};

    if (table1(&t, set, sets) == NULL) {
        point_at(&p, &t, x);
        seat_load(s, &t, &p, excite, 1e5);
    }
    trk_free(&t);
    return s[point_rail(excite)].deflection;
}

/* Knots within bays: one element a bay is as exact as twelve, anywhere in the bay; the other rail keeps its own. */
static void varying(void)
{
    static const char *const left[] = {"rail.left.bending_stiffness={station: [0.45, 1.03, 1.2], value: [6.11e6, 11e6, 8e6]}"},
                      *const fine[] = {left[0], "rail.elements_per_bay=12"}, *const shear[] = {left[0], "rail.beam=timoshenko"},
                      *const shear_fine[] = {left[0], "rail.beam=timoshenko", "rail.elements_per_bay=12"},
                      *const number[] = {"rail.bending_stiffness={number: [1.25, 2.75], value: [6.11e6, 9e6]}"},
                      *const station[] = {"rail.bending_stiffness={station: [0.45, 1.35], value: [6.11e6, 9e6]}"};

    for (double x = 0.37; x < 1.6; x += 0.29) {
        near(static_deflection(left, 1, EXCITE_LEFT, x) / static_deflection(fine, 2, EXCITE_LEFT, x), 1, 1e-9, "one element a bay is as twelve");
        near(static_deflection(shear, 2, EXCITE_LEFT, x) / static_deflection(shear_fine, 3, EXCITE_LEFT, x), 1, 1e-9, "with shear too");
    }
    ok(static_deflection(left, 1, EXCITE_LEFT, 0.9) < 0.999 * static_deflection(NULL, 0, EXCITE_LEFT, 0.9), "a stiffer left rail gives less");
    ok(static_deflection(left, 1, EXCITE_RIGHT, 0.9) > 0.9999 * static_deflection(NULL, 0, EXCITE_RIGHT, 0.9), "the right rail as before");
    near(static_deflection(number, 1, EXCITE_LEFT, 0.9) / static_deflection(station, 1, EXCITE_LEFT, 0.9), 1, 1e-12,
         "places by number are those by station");
}

/* Processor seconds of layout and assembly, the least of five. */
static double seconds(const char *from, const char *length)
{
    const char *set[] = {from, length, "rail.mass_model=consistent", "rail.beam=timoshenko", "rail.elements_per_bay=8"};
    double least = INFINITY;

    for (int i = 0; i < 5; i++) {
        struct trk t;
        const clock_t before = clock();
        ok(table1(&t, set, 5) == NULL, "%s builds", length);
        least = fmin(least, (double)(clock() - before) / CLOCKS_PER_SEC);
        trk_free(&t);
    }
    return least;
}

static void cost(void)
{
    const double one = seconds("from=-60", "length=120"), ten = seconds("from=-600", "length=1200");

    printf("# %.4f s for 120 m, %.4f s for 1200 m\n", one, ten);
    ok(one < 0.05, "120 m are assembled in %.1f ms, below 50", 1e3 * one);
    ok(ten < 30 * one, "ten times the length takes %.1f times as long", ten / one);
}

int main(void)
{
    infinite_beam();
    winkler();
    pinned_pinned();
    rigid_motion();
    varying();
    cost();
    return done();
}
