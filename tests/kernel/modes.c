/* Modes of the track of Table 1 against closed forms, an independent program and LAPACK's dense solution; modes of a vehicle of one
 * body against the oscillator's formulas. */
#include "tools/receptance/modes.h"

#include <string.h>

#include <lapacke.h>

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/dense.h"

enum { SMALL = 36, MODES = 18 };       /* degrees of freedom and modes of a track of six sleepers */

/* Distance from f to the nearest mode, of those named `name` where it is given. */
static double distance(const struct mod *m, double f, const char *name)
{
    double least = INFINITY;

    for (int64_t i = 0; i < m->n; i++)
        if (!name || strcmp(m->name[i], name) == 0)
            least = fmin(least, fabs(m->frequency[i] - f));
    return least;
}

static void published(const struct trk *t)
{
    static const struct { double f, tolerance; const char *what; } row[] = {
        {129.0, 0.1, "129.0 Hz: rails and sleepers on the ballast"},
        {505.1, 0.1, "505.1 Hz: rails on their pads"},
        {826.0, 1.0, "826 Hz: the rail between the sleepers"},
        {504.23, 0.05, "504.23 Hz: rail of 36 kg and half a sleeper, by hand"}};
    struct mod m;

    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        ok(modes_track(&m, t, 12, row[k].f) == NULL, "twelve modes near %g Hz", row[k].f);
        near(distance(&m, row[k].f, "in phase"), 0, row[k].tolerance, row[k].what);
        mod_free(&m);
    }
    ok(modes_track(&m, t, 12, 0) == NULL, "the twelve lowest modes");
    near(m.frequency[0] / 124.48, 1, 0.001, "the lowest is that of 36 kg and half a sleeper by hand, 124.48 Hz");
    mod_free(&m);
}

/* y = A x; x, y [dofs] */
static void multiply(const struct trk *t, const double *A, const double *x, double *y)
{
    memset(y, 0, (size_t)t->dofs * sizeof *y);
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            y[t->Ai[p]] += A[p] * x[j];
}

static void properties(const struct trk *t)
{
    static double Kx[400], Mx[400];
    struct mod m;
    double residual = 0, norm = 0, mixed = 0;
    int falls = 0;

    if (!ok(modes_track(&m, t, 60, 300) == NULL, "sixty modes near 300 Hz"))
        return;
    for (int64_t i = 0; i < m.n; i++) {
        const double *x = m.shape + i * m.dofs, lambda = pow(2 * M_PI * m.frequency[i], 2);
        multiply(t, t->Kx, x, Kx);
        multiply(t, t->Mx, x, Mx);
        for (int64_t k = 0; k < t->dofs; k++)
            residual = fmax(residual, fabs(Kx[k] - lambda * Mx[k]) / lambda);
        for (int64_t j = 0; j <= i; j++) {
            double xMx = 0;
            for (int64_t k = 0; k < t->dofs; k++)
                xMx += m.shape[j * m.dofs + k] * Mx[k];
            if (j == i)
                norm = fmax(norm, fabs(xMx - 1));
            else
                mixed = fmax(mixed, fabs(xMx));
        }
        falls += i && m.frequency[i] < m.frequency[i - 1];
    }
    near(residual, 0, 1e-6, "K x = omega^2 M x");
    near(norm, 0, 1e-9, "unit modal mass");
    near(mixed, 0, 1e-9, "modes are orthogonal in M");
    ok(falls == 0, "frequencies increase");
    mod_free(&m);
}

/* Each mode keeps to an eigenvalue of its own: among 150 modes in dense bands no two have one damping ratio. */
static void own_eigenvalues(const struct trk *t)
{
    struct mod m;
    int shared = 0;

    if (!ok(modes_track(&m, t, 150, 0) == NULL, "half of all modes"))
        return;
    for (int64_t i = 0; i < m.n; i++)
        for (int64_t j = 0; j < i; j++)
            shared += fabs(m.damping[i] - m.damping[j]) < 1e-9;
    near(shared, 0, 0, "no two follow one complex eigenvalue");
    mod_free(&m);
}

/* Dense copy, row and column alike. */
static void dense(const struct trk *t, const double *X, double *A)
{
    memset(A, 0, SMALL * SMALL * sizeof *A);
    for (int64_t j = 0; j < SMALL; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            A[t->Ai[p] * SMALL + j] = X[p];
}

/* All damping ratios: eigenvalues of [0 I; -K/M -C/M], M being diagonal. */
static void all_ratios(const struct trk *t, double ratio[2 * SMALL])
{
    static double K[SMALL * SMALL], C[SMALL * SMALL], M[SMALL * SMALL], A[4 * SMALL * SMALL], re[2 * SMALL], im[2 * SMALL];

    dense(t, t->Kx, K);
    dense(t, t->Cx, C);
    dense(t, t->Mx, M);
    for (int i = 0; i < SMALL; i++) {
        A[i * 2 * SMALL + SMALL + i] = 1;
        for (int j = 0; j < SMALL; j++) {
            A[(SMALL + i) * 2 * SMALL + j] = -K[i * SMALL + j] / M[i * SMALL + i];
            A[(SMALL + i) * 2 * SMALL + SMALL + j] = -C[i * SMALL + j] / M[i * SMALL + i];
        }
    }
    ok(LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', 2 * SMALL, A, 2 * SMALL, re, im, NULL, 1, NULL, 1) == 0, "LAPACK dgeev");
    for (int i = 0; i < 2 * SMALL; i++)
        ratio[i] = -re[i] / hypot(re[i], im[i]);
}

static void against_dense(void)
{
    static double K[SMALL * SMALL], M[SMALL * SMALL], lambda[SMALL], ratio[2 * SMALL];
    const char *set[] = {"from=-1.8", "length=3.6"};
    struct trk t;
    struct mod m;
    double worst_f = 0, worst_ratio = 0;

    if (!ok(table1(&t, set, 2) == NULL && t.dofs == SMALL && modes_track(&m, &t, MODES, 0) == NULL, "half the modes of six sleepers"))
        return;
    dense(&t, t.Kx, K);
    dense(&t, t.Mx, M);
    ok(LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'U', SMALL, K, SMALL, M, SMALL, lambda) == 0, "LAPACK dsygv");
    all_ratios(&t, ratio);
    int used[2 * SMALL] = {0};
    for (int i = 0; i < MODES; i++) {
        int best = 0;
        for (int k = 1; k < 2 * SMALL; k++)
            if (!used[k] && (used[best] || fabs(ratio[k] - m.damping[i]) < fabs(ratio[best] - m.damping[i])))
                best = k;
        used[best] = 1;
        worst_ratio = fmax(worst_ratio, fabs(ratio[best] - m.damping[i]));
        worst_f = fmax(worst_f, fabs(m.frequency[i] / (sqrt(lambda[i]) / (2 * M_PI)) - 1));
    }
    near(worst_f, 0, 1e-9, "frequencies are LAPACK's, none left out");
    near(worst_ratio, 0, 1e-7, "damping ratios are those of different complex eigenvalues of the dense matrix");
    mod_free(&m);
    trk_free(&t);
}

/* One body of mass m on springs above one held wheelset: six oscillators, f = sqrt(k/m)/2 pi, ratio c / 2 sqrt(k m), or 1. */
static void oscillator(void)
{
    static const char name[2][32] = {"carbody", "wheelset1"};
    static const double mass = 1000, inertia = 500, k[6] = {1e5, 4e5, 9e5, 1e5, 4e5, 9e5}, c[6] = {0, 2e3, 3e3, 1e3, 1e6, 2e3};
    static double K[144], C[144], M[144];
    static const int64_t wheelset[1] = {1};
    struct veh v = {.bodies = 2, .wheelsets = 1, .body_name = name, .wheelset = wheelset, .K = K, .C = C, .M = M};
    struct mod m;

    for (int d = 0; d < 6; d++) {
        M[d * 13] = d < 3 ? mass : inertia;
        M[(d + 6) * 13] = 100;
        K[d * 13] = K[(d + 6) * 13] = k[d];
        K[d * 12 + d + 6] = K[(d + 6) * 12 + d] = -k[d];
        C[d * 13] = c[d];
    }
    if (!ok(dense_vehicle(&m, &v, 6, 0) == NULL, "six modes of one body"))
        return;
    static const char *const order[6] = {"longitudinal", "roll", "lateral", "pitch", "bounce", "yaw"};
    static const int dof[6] = {0, 3, 1, 4, 2, 5};
    for (int i = 0; i < 6; i++) {
        double mi = dof[i] < 3 ? mass : inertia, ki = k[dof[i]], want = c[dof[i]] / (2 * sqrt(ki * mi));
        ok(strstr(m.name[i], order[i]) != NULL, "mode %d is %s: %s", i + 1, order[i], m.name[i]);
        near(m.frequency[i] * 2 * M_PI / sqrt(ki / mi), 1, 1e-12, "its frequency sqrt(k/m)");
        near(m.damping[i], want < 1 ? want : 1, 1e-12, "its damping c/2 sqrt(k m), 1 where it creeps back");
        near(fabs(m.shape[i * 12 + dof[i]]) * sqrt(mi), 1, 1e-12, "its shape has unit modal mass");
    }
    mod_free(&m);
    ok(dense_vehicle(&m, &v, 1, 4.0) == NULL && strstr(m.name[0], "pitch"), "nearest to 4 Hz is the pitch at 4.50 Hz");
    mod_free(&m);
    ok(dense_vehicle(&m, &v, 7, 0) != NULL, "a seventh mode is refused");
    mod_free(&m);
}

int main(void)
{
    struct trk t;
    struct mod m;
    const char *why = table1(&t, NULL, 0);

    if (!ok(why == NULL, "the track of Table 1 builds%s%s", why ? ": " : "", why ? why : ""))
        return done();
    published(&t);
    properties(&t);
    own_eigenvalues(&t);
    ok(modes_track(&m, &t, 151, 0) != NULL, "more than half the modes are refused");
    mod_free(&m);
    trk_free(&t);
    against_dense();
    oscillator();
    return done();
}
