/* Receptance of the track of Table 1: properties, a closed form, and the published resonances as an independent program
 * (Octave, dense complex solution of the same equations) finds them. */
#include "tools/receptance/sweep.h"

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/direct.h"
#include "tools/receptance/peaks.h"
#include "tools/track/cholesky.h"

enum { DOFS = 300, MOST = 4000 };

/* The highest peak between two frequencies. */
static struct peak highest(const struct peak *p, int64_t n, double from, double to)
{
    struct peak best = {0, NAN, 0};

    for (int64_t i = 0; i < n; i++)
        if (!p[i].is_dip && p[i].frequency > from && p[i].frequency < to && p[i].amplitude > best.amplitude)
            best = p[i];
    return best;
}

/* Receptance over the sleeper or bay next to the middle, 10 to 1500 Hz in steps of 1 Hz. */
static void sweep(struct frf *r, const struct trk *t, int at, int excite)
{
    struct place p;

    place_find(&p, t, excite, at, 0);
    const char *why = sweep_places(r, t, &p, &p, FRF_RECEPTANCE, &(struct sweep){10, 1500, 1});
    ok(why == NULL, "sweep%s%s", why ? ": " : "", why ? why : "");
}

/* The k-th peak, or dip. */
static struct peak extremum(const struct peak *p, int64_t n, int is_dip, int k)
{
    for (int64_t i = 0; i < n; i++)
        if (p[i].is_dip == is_dip && k-- == 0)
            return p[i];
    return (struct peak){0, NAN, NAN};
}

static void resonances(const struct trk *t)
{
    static struct peak p[MOST];
    struct frf r;

    sweep(&r, t, AT_SLEEPER, PLACE_BOTH);
    int64_t n = peaks_find(r.n, r.frequency, r.H, p);
    near(extremum(p, n, 0, 0).frequency, 119, 2, "both rails, over a sleeper: rail and sleeper on the ballast at 119 Hz");
    near(extremum(p, n, 0, 0).amplitude / 1.006e-8, 1, 0.02, "with 1.006e-8 m/N");
    near(extremum(p, n, 0, 1).frequency, 486, 5, "rail on the pads at 486 Hz");
    near(extremum(p, n, 0, 1).amplitude / 2.79e-9, 1, 0.02, "with 2.79e-9 m/N");
    near(extremum(p, n, 0, 2).frequency, 901, 5, "pinned-pinned, seen from a sleeper, at 901 Hz");
    near(extremum(p, n, 1, 0).frequency, 256, 2, "dip at 256 Hz");
    near(extremum(p, n, 1, 1).frequency, 895, 5, "dip at 895 Hz");
    near(hypot(r.H[2 * 990], r.H[2 * 990 + 1]) / 3.8e-10, 1, 0.02, "3.8e-10 m/N at 1000 Hz");
    near(hypot(r.H[2 * 10], r.H[2 * 10 + 1]) / 5.05e-9, 1, 0.01, "5.05e-9 m/N at 20 Hz");
    frf_free(&r);

    sweep(&r, t, AT_SLEEPER, PLACE_LEFT);
    n = peaks_find(r.n, r.frequency, r.H, p);
    near(extremum(p, n, 0, 0).frequency, 121, 2, "one rail: 121 Hz");
    near(extremum(p, n, 0, 0).amplitude / 8.87e-9, 1, 0.02, "with 8.87e-9 m/N");
    near(extremum(p, n, 0, 1).frequency, 494, 5, "and 494 Hz");
    near(extremum(p, n, 0, 1).amplitude / 2.61e-9, 1, 0.02, "with 2.61e-9 m/N");
    frf_free(&r);

    sweep(&r, t, AT_MIDSPAN, PLACE_BOTH);
    n = peaks_find(r.n, r.frequency, r.hermite, p);
    near(highest(p, n, 800, 1000).frequency, 907, 2, "halfway by Hermite's polynomials: pinned-pinned at 907 Hz");
    near(r.H[0] - r.hermite[0], 1.841e-10, 1e-13, "exact minus Hermite is L^3/192EI");
    ok(r.hermites == r.n, "both are kept");
    frf_free(&r);
}

/* Two-layer support made continuous: H = 1/(8 EI b^3), b^4 = (s - m w^2)/4EI, s the pad in series with half a sleeper on half the
 * ballast, over the spacing (Knothe and Grassie 1993, Vehicle System Dynamics 22, 209). */
static double complex continuous(double f)
{
    const double EI = 6.11e6, m = 60, L = 0.6, w = 2 * M_PI * f;
    const double complex pad = 300e6 + 50e3 * w * I, below = 140e6 - 190 * w * w + 60e3 * w * I;

    return 1 / (8 * EI * cpow((pad * below / (pad + below) / L - m * w * w) / (4 * EI), 0.75));
}

static void closed_form(void)
{
    const char *set[] = {"from=-60", "length=120"};
    struct trk t;
    struct frf r;

    ok(table1(&t, set, 2) == NULL, "a track of 120 m, as good as infinite, builds");
    sweep(&r, &t, AT_SLEEPER, PLACE_BOTH);
    for (int f = 20; f <= 120; f += 20) {
        const double complex H = r.H[2 * (f - 10)] + r.H[2 * (f - 10) + 1] * I, want = continuous(f);
        ok(cabs(H - want) <= 0.02 * cabs(want), "%d Hz: the infinite beam on a continuous support, within 2 %%", f);
    }
    int bad = 0;
    for (int64_t i = 0; i < r.n; i++)
        bad += r.H[2 * i + 1] > 0;
    ok(bad == 0, "the track takes energy up at every frequency: Im H <= 0");
    frf_free(&r);
    trk_free(&t);
}

/* |H|, one frequency, n elements a bay with the inertia of a piece of rail as long as an element. */
static double refined(int n, int at, double frequency)
{
    char elements[64], inertia[64];
    const double h = 0.6 / n;
    const char *set[] = {"from=-60", "length=120", elements, inertia};
    struct trk t;
    struct place p;
    struct frf r = {0};
    double H = NAN;

    snprintf(elements, sizeof elements, "rail.elements_per_bay=%d", n);
    snprintf(inertia, sizeof inertia, "rail.pitch_inertia=%.17g", 60 * h * h * h / 12);
    if (table1(&t, set, 4) == NULL) {
        place_find(&p, &t, PLACE_BOTH, at, 0);
        if (sweep_places(&r, &t, &p, &p, FRF_RECEPTANCE, &(struct sweep){frequency, frequency, 1}) == NULL)
            H = hypot(r.H[0], r.H[1]);
    }
    frf_free(&r);
    trk_free(&t);
    return H;
}

/* Against the exact infinite beam on 201 discrete supports, (diag(1/k) + G)^-1 g with the Green's function of the free beam (Heckl
 * 1995, Acustica 81, 559), computed by an independent program; lumped masses converge to it with the second order. */
static void convergence(void)
{
    static const struct { double frequency, sleeper, midspan; } exact[] = {
        {10, 4.99545e-9, 5.11669e-9},  {100, 8.30401e-9, 8.40962e-9}, {256, 1.25591e-9, 1.30937e-9},
        {483, 2.57345e-9, 2.78636e-9}, {800, 1.13753e-9, 1.20357e-9}, {1000, 7.46557e-10, 7.94059e-10}};

    for (size_t k = 0; k < sizeof exact / sizeof exact[0]; k++) {
        const double f = exact[k].frequency;
        double at = refined(8, AT_SLEEPER, f) / exact[k].sleeper - 1, between = refined(8, AT_MIDSPAN, f) / exact[k].midspan - 1;
        ok(fabs(at) < 1.1e-3, "%g Hz, eight elements a bay: %.1e from the exact beam over a sleeper", f, at);
        ok(fabs(between) < 1.1e-3, "%g Hz: %.1e halfway", f, between);
    }
    double coarse = refined(4, AT_SLEEPER, 483) / exact[3].sleeper - 1, fine = refined(8, AT_SLEEPER, 483) / exact[3].sleeper - 1;
    near(log2(coarse / fine), 2, 0.1, "the order of convergence is 2");
}

static const char *column(struct direct *d, int64_t j, double *u)
{
    for (int64_t i = 0; i < 2 * DOFS; i++)
        u[i] = i == 2 * j;
    return direct_solve(d, u);
}

static void reciprocity(const struct trk *t)
{
    static const int64_t dof[4] = {0, 131, 148, 299};
    static double u[4][2 * DOFS];
    struct direct d;
    double worst = 0, scale = 0;

    if (!ok(direct_new(&d, t) == NULL && direct_factor(&d, 2 * M_PI * 321 * I) == NULL, "factors at 321 Hz"))
        return;
    for (int k = 0; k < 4; k++)
        ok(column(&d, dof[k], u[k]) == NULL, "unit load on degree of freedom %d", (int)dof[k]);
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++) {
            worst = fmax(worst, hypot(u[a][2 * dof[b]] - u[b][2 * dof[a]], u[a][2 * dof[b] + 1] - u[b][2 * dof[a] + 1]));
            scale = fmax(scale, hypot(u[a][2 * dof[b]], u[a][2 * dof[b] + 1]));
        }
    near(worst / scale, 0, 1e-13, "reciprocity: H_ij = H_ji");
    ok(column(&d, 131, u[0]) == NULL, "a second solution");
    direct_free(&d);
}

static void static_limit(const struct trk *t)
{
    static double u[DOFS], f[DOFS], H[2 * DOFS];
    struct cholesky s;
    struct direct d;
    double worst = 0, scale = 0;

    f[148] = 1;
    H[2 * 148] = 1;
    ok(cholesky_new(&s, t) == NULL && cholesky_solve(&s, f, u) == NULL, "static solution");
    ok(direct_new(&d, t) == NULL && direct_factor(&d, 0) == NULL && direct_solve(&d, H) == NULL, "receptance at 0 Hz");
    for (int i = 0; i < DOFS; i++) {
        worst = fmax(worst, fabs(H[2 * i] - u[i]) + fabs(H[2 * i + 1]));
        scale = fmax(scale, fabs(u[i]));
    }
    near(worst / scale, 0, 1e-12, "at 0 Hz it is K\\f");
    cholesky_free(&s);
    direct_free(&d);
}

/* y = x^2 sampled unevenly: the parabola finds its foot. */
static void refinement(void)
{
    const double f[4] = {1, 1.5, 2.5, 3}, foot = 1.9, H[8] = {1.81, 0, 1.16, 0, 1.36, 0, 2.21, 0};
    struct peak p[4];

    near((double)peaks_find(4, f, H, p), 1, 0, "one dip in a parabola");
    near(p[0].frequency, foot, 1e-12, "at its foot");
    near(p[0].amplitude, 1, 1e-12, "with its value");
    ok(p[0].is_dip, "and it is a dip");
}

int main(void)
{
    struct trk t;
    const char *why = table1(&t, NULL, 0);

    if (!ok(why == NULL, "the track of Table 1 builds%s%s", why ? ": " : "", why ? why : ""))
        return done();
    resonances(&t);
    closed_form();
    convergence();
    reciprocity(&t);
    static_limit(&t);
    refinement();
    trk_free(&t);
    return done();
}
