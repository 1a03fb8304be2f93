/* Complex modes of the track of Table 1 against LAPACK's dense solution, by their residual, and against the undamped modes where damping
 * is weak or mixes nothing. */
#include "tools/receptance/damped.h"

#include <complex.h>
#include <string.h>

#include <lapacke.h>

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/modes.h"

enum { SMALL = 36, FEW = 12 };

static double complex eigenvalue(const struct mod *m, int64_t i)
{
    const double omega = 2 * M_PI * m->frequency[i], z = m->damping[i];

    return omega * (-z + sqrt(fmax(1 - z * z, 0)) * I);
}

/* Row-major dense copy. */
static void dense(const struct trk *t, const double *X, double *A)
{
    memset(A, 0, SMALL * SMALL * sizeof *A);
    for (int64_t j = 0; j < SMALL; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            A[t->Ai[p] * SMALL + j] = X[p];
}

/* All eigenvalues s [2 SMALL] of [0 I; -K -C] z = s [I 0; 0 M] z, with milliseconds and entries about 1. */
static int all_eigenvalues(const struct trk *t, double complex *s)
{
    enum { N = 2 * SMALL };
    static double K[SMALL * SMALL], C[SMALL * SMALL], M[SMALL * SMALL], A[N * N], B[N * N], re[N], im[N], by[N];

    dense(t, t->Kx, K);
    dense(t, t->Cx, C);
    dense(t, t->Mx, M);
    memset(A, 0, sizeof A);
    memset(B, 0, sizeof B);
    for (int i = 0; i < SMALL; i++) {
        A[i * N + SMALL + i] = 1;
        B[i * N + i] = 1;
        for (int j = 0; j < SMALL; j++) {
            A[(SMALL + i) * N + j] = -1e-9 * K[i * SMALL + j];
            A[(SMALL + i) * N + SMALL + j] = -1e-6 * C[i * SMALL + j];
            B[(SMALL + i) * N + SMALL + j] = 1e-3 * M[i * SMALL + j];
        }
    }
    if (LAPACKE_dggev(LAPACK_ROW_MAJOR, 'N', 'N', N, A, N, B, N, re, im, by, NULL, 1, NULL, 1) != 0)
        return 0;
    for (int k = 0; k < N; k++)
        s[k] = 1e3 * (re[k] + im[k] * I) / by[k];
    return 1;
}

static void against_dense(double near_to)
{
    const char *set[] = {"from=-1.8", "length=3.6"};
    static double complex s[2 * SMALL];
    double complex sigma = 2 * M_PI * near_to * I;
    struct trk t;
    struct mod m;
    double worst = 0;
    int missed = 0;

    if (!ok(table1(&t, set, 2) == NULL && t.dofs == SMALL && all_eigenvalues(&t, s) && damped_track(&m, &t, FEW, near_to) == NULL,
            "twelve damped modes of six sleepers near %g Hz", near_to))
        return;
    double farthest = 0;
    for (int64_t i = 0; i < m.n; i++) {
        double least = INFINITY;
        for (int k = 0; k < 2 * SMALL; k++)
            least = fmin(least, cabs(s[k] - eigenvalue(&m, i)) / cabs(s[k]));
        worst = fmax(worst, least);
        farthest = fmax(farthest, cabs(eigenvalue(&m, i) - sigma));
    }
    near(worst, 0, 1e-9, "each is an eigenvalue by LAPACK");
    for (int k = 0; k < 2 * SMALL; k++)
        missed += cimag(s[k]) > 0 && cabs(s[k] - sigma) < farthest * (1 - 1e-9);
    near(missed, FEW - 1, 0, "of those nearer than the farthest none is missed");
    mod_free(&m);
    trk_free(&t);
}

/* Largest |Q(s) x| over the largest |M s^2 x|, and of |x'(2 s M + C)x - 2i Im s| / |2 s|. */
static void residuals(const struct trk *t, const struct mod *m, double *residual, double *norm)
{
    static double complex f[3000];

    *residual = *norm = 0;
    for (int64_t i = 0; i < m->n; i++) {
        const double complex s = eigenvalue(m, i);
        const double *re = m->shape + i * m->dofs, *im = m->imaginary + i * m->dofs;
        double complex unit = -2 * cimag(s) * I;
        double most = 0, scale = 0;
        memset(f, 0, sizeof f);
        for (int64_t j = 0; j < t->dofs; j++)
            for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
                const double complex x = re[j] + im[j] * I, y = re[t->Ai[p]] + im[t->Ai[p]] * I;
                f[t->Ai[p]] += (t->Kx[p] + s * t->Cx[p] + s * s * t->Mx[p]) * x;
                unit += y * (2 * s * t->Mx[p] + t->Cx[p]) * x;
                scale = fmax(scale, cabs(t->Kx[p] * x));
            }
        for (int64_t j = 0; j < t->dofs; j++)
            most = fmax(most, cabs(f[j]));
        *residual = fmax(*residual, most / scale);
        *norm = fmax(*norm, cabs(unit) / cabs(2 * s));
    }
}

static void properties(void)
{
    static const double where[] = {0, 124, 505, 907, 1300};
    double residual, norm;
    struct trk t;
    struct mod m;

    if (!ok(table1(&t, NULL, 0) == NULL, "the track of Table 1"))
        return;
    for (size_t k = 0; k < sizeof where / sizeof where[0]; k++) {
        const char *why = damped_track(&m, &t, 40, where[k]);
        if (ok(why == NULL && m.n == 40, "forty modes near %g Hz%s%s", where[k], why ? ": " : "", why ? why : "")) {
            residuals(&t, &m, &residual, &norm);
            near(residual, 0, 1e-10, "Q(s) x = 0");
            near(norm, 0, 1e-9, "x'(2 s M + C)x = 2i Im s");
        }
        mod_free(&m);
    }
    ok(damped_track(&m, &t, 101, 0) != NULL, "more than a third of the degrees of freedom are refused");
    mod_free(&m);
    trk_free(&t);
}

/* Springs with a millionth of the damping: nothing changes but the ratios, which are tiny. */
static void proportional(void)
{
    const char *set[] = {"railpad.damping=300e-3", "ballast.damping=280e-3"};
    struct trk t;
    struct mod bare, m;
    double worst = 0, real = 0;

    if (!ok(table1(&t, set, 2) == NULL && modes_track(&bare, &t, 20, 0) == NULL && damped_track(&m, &t, 20, 0) == NULL,
            "twenty modes of a track with next to no damping"))
        return;
    for (int64_t i = 0; i < m.n; i++) {
        worst = fmax(worst, fabs(m.frequency[i] / bare.frequency[i] - 1) + fabs(m.damping[i] - bare.damping[i]));
        double size = 0, imaginary = 0;
        for (int64_t k = 0; k < m.dofs; k++) {
            size = fmax(size, fabs(m.shape[i * m.dofs + k]));
            imaginary = fmax(imaginary, fabs(m.imaginary[i * m.dofs + k]));
        }
        real = fmax(real, imaginary / size);
    }
    near(worst, 0, 1e-9, "frequencies and ratios are those of the undamped modes");
    near(real, 0, 1e-3, "shapes are real");
    mod_free(&bare);
    mod_free(&m);
    trk_free(&t);
}

int main(void)
{
    against_dense(0);
    against_dense(300);
    against_dense(900);
    properties();
    proportional();
    return done();
}
