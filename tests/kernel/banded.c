/* Banded matrices against LAPACK's dense Cholesky: factor, solution, inverse within a band, product. */
#include "tools/integrate/banded.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"

enum { MOST = 160 };

struct dense {
    int n;
    double x[MOST * MOST]; /* [n][n] */
};

static double at(const struct banded *b, int64_t i, int64_t j)
{
    int64_t d = i > j ? i - j : j - i;

    return d > b->half ? 0 : b->x[d * b->stride + (i < j ? i : j)];
}

/* Random, positive definite by its diagonal. */
static const char *draw(struct banded *b, int n, int half, struct dense *full)
{
    unsigned seed = (unsigned)(7 * n + half);
    const char *why = banded_new(b, n, half);

    if (why)
        return why;
    for (int d = 0; d <= half; d++)
        for (int i = 0; i < n - d; i++)
            b->x[d * b->stride + i] = d ? rig_draw(&seed) : 1.2 * half + 0.5 + rig_draw(&seed) / 4;
    full->n = n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            full->x[i * n + j] = at(b, i, j);
    return NULL;
}

static void matrix(int n, int half)
{
    static struct dense full, inverse;
    struct banded b;
    unsigned seed = 3;
    double x[MOST + BANDED_PAD] = {0}, y[MOST + BANDED_PAD] = {0}, product = 0, solution = 0, worst = 0;
    const char *why = draw(&b, n, half, &full);

    if (why || (why = banded_factor(&b))) {
        ok(0, "%d, half band %d: %s", n, half, why);
        return;
    }
    inverse = full;
    int info = LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'U', n, inverse.x, n) + LAPACKE_dpotri(LAPACK_ROW_MAJOR, 'U', n, inverse.x, n);
    for (int i = 0; i < n; i++)
        x[i] = rig_draw(&seed);
    banded_multiply(&b, x, y);
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j < n; j++)
            sum += full.x[i * n + j] * x[j];
        product = fmax(product, fabs(sum - y[i]));
    }
    memcpy(y, x, sizeof y);
    banded_solve(&b, y);
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j < n; j++)
            sum += inverse.x[i < j ? i * n + j : j * n + i] * x[j];
        solution = fmax(solution, fabs(sum - y[i]));
    }
    const int beyond = half + 2;
    double *Z = calloc((size_t)(n * (beyond + 1)), sizeof *Z);
    banded_inverse(&b, beyond, Z);
    for (int i = 0; i < n; i++)
        for (int d = 0; d <= beyond && i + d < n; d++)
            worst = fmax(worst, fabs(Z[i * (beyond + 1) + d] - inverse.x[i * n + i + d]));
    ok(!info && product < 1e-13 * (half + 1) && solution < 1e-13 && worst < 1e-13,
       "%d, half band %d: product off by %.1e, solution by %.1e, inverse in a band of %d by %.1e", n, half, product, solution, beyond, worst);
    free(Z);
    banded_free(&b);
}

/* The step's matrix of a track, from its sparse one: the residual of a solution against the sparse product. */
static void track(const char *elements, int half)
{
    const char *const set[] = {elements, "rail.mass_model=consistent"};
    struct trk t;
    struct banded b;
    unsigned seed = 5;
    const double h = 1e-4;
    const char *why = rig_track(&t, RIG_STRAIGHT, set, 2);

    if (why) {
        ok(0, "%s", why);
        return;
    }
    const int64_t wide = banded_half(t.dofs, t.Ap, t.Ai, t.Kx);
    double *x = calloc((size_t)(2 * (t.dofs + BANDED_PAD)), sizeof *x), *r = x + t.dofs + BANDED_PAD, off = 0, size = 0;
    ok(wide == half, "%s: half bandwidth %d (%lld)", elements, half, (long long)wide);
    why = banded_new(&b, t.dofs, wide);
    banded_add(&b, 1, t.Ap, t.Ai, t.Kx);
    banded_add(&b, 2 / h, t.Ap, t.Ai, t.Cx);
    banded_add(&b, 4 / (h * h), t.Ap, t.Ai, t.Mx);
    if (!why)
        why = banded_factor(&b);
    for (int64_t i = 0; i < t.dofs; i++)
        x[i] = r[i] = 1e5 * rig_draw(&seed);
    banded_solve(&b, x);
    for (int64_t j = 0; j < t.dofs; j++)
        for (int64_t p = t.Ap[j]; p < t.Ap[j + 1]; p++) {
            const double term = (t.Kx[p] + 2 / h * t.Cx[p] + 4 / (h * h) * t.Mx[p]) * x[j];
            r[t.Ai[p]] -= term;
            size = fmax(size, fabs(term));
        }
    for (int64_t i = 0; i < t.dofs; i++)
        off = fmax(off, fabs(r[i]));
    ok(!why && off < 1e-14 * (double)t.dofs * size, "... its solution leaves %.1e of terms of %.1e%s%s", off, size, why ? ": " : "", why ? why : "");
    free(x);
    banded_free(&b);
    trk_free(&t);
}

static void refusals(void)
{
    struct banded b;
    const char *why = banded_new(&b, 100, BANDED_HALF_MOST + 1);

    ok(why && strstr(why, "half bandwidth"), "too wide a band: %s", why ? why : "is taken");
    ok(!banded_new(&b, 10, 1), "a band");
    for (int i = 0; i < 10; i++)
        b.x[i] = i == 6 ? -1 : 1;
    why = banded_factor(&b);
    ok(why && strstr(why, "row 6"), "that is not positive definite: %s", why ? why : "is factored");
    banded_free(&b);
}

int main(void)
{
    static const int size[][2] = {{1, 0}, {5, 0}, {9, 1}, {40, 3}, {151, 7}, {160, 8}, {155, 9}, {120, 16}, {130, 21}, {160, 32}};

    for (size_t k = 0; k < sizeof size / sizeof *size; k++)
        matrix(size[k][0], size[k][1]);
    track("rail.elements_per_bay=1", 7);
    track("rail.elements_per_bay=8", 7);
    refusals();
    return done();
}
