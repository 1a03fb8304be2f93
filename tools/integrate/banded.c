/* Recurrences along the band keep the last `width` numbers in registers: what a row waits for is one product and one difference. */
#include "tools/integrate/banded.h"
#include "formats/reason.h"
#include "tools/contact/clones.h"

#include <math.h>
#include <stdlib.h>

enum { LANES = 8, BLOCK = 256 };

int64_t banded_half(int64_t n, const int64_t *Ap, const int64_t *Ai, const double *x)
{
    int64_t half = 0;

    for (int64_t j = 0; j < n; j++)
        for (int64_t p = Ap[j]; p < Ap[j + 1]; p++)
            if (fabs(x[p]) > 0 && llabs(Ai[p] - j) > half)
                half = llabs(Ai[p] - j);
    return half;
}

const char *banded_new(struct banded *b, int64_t n, int64_t half)
{
    *b = (struct banded){.n = n, .stride = (n + LANES - 1) / LANES * LANES, .half = (int)half};
    if (half > BANDED_HALF_MOST)
        return reason("the half bandwidth of the track, %lld, is beyond %d", (long long)half, BANDED_HALF_MOST);
    b->width = (b->half + LANES - 1) / LANES * LANES;
    b->width = b->width ? b->width : LANES;
    b->x = calloc((size_t)((half + 1) * b->stride), sizeof *b->x);
    b->L = calloc((size_t)(n * b->width), sizeof *b->L);
    b->inverse = calloc((size_t)n, sizeof *b->inverse);
    if (b->x && b->L && b->inverse)
        return NULL;
    banded_free(b);
    return REASON_MEMORY;
}

void banded_free(struct banded *b)
{
    free(b->x);
    free(b->L);
    free(b->inverse);
    *b = (struct banded){0};
}

void banded_add(struct banded *b, double c, const int64_t *Ap, const int64_t *Ai, const double *x)
{
    for (int64_t j = 0; j < b->n; j++)
        for (int64_t p = Ap[j]; p < Ap[j + 1]; p++)
            if (Ai[p] >= j && fabs(x[p]) > 0)
                b->x[(Ai[p] - j) * b->stride + j] += c * x[p];
}

/* ---- product ---- */

/* y[i] += d[i] x[i] */
static inline void add_product(int64_t from, int64_t to, const double *restrict d, const double *restrict x, double *restrict y)
{
    for (int64_t i = from; i < to; i++)
        y[i] += d[i] * x[i];
}

/* Block by block of y, so that it stays at hand for all diagonals. */
CLONES static void multiply_band(int64_t n, int64_t half, int64_t stride, const double *a, const double *x, double *y)
{
    for (int64_t from = 0; from < n; from += BLOCK) {
        int64_t to = from + BLOCK < n ? from + BLOCK : n;
        add_product(from, to, a, x, y);
        for (int64_t d = 1; d <= half; d++) {
            add_product(from > d ? from : d, to, a + d * stride - d, x - d, y);
            add_product(from, to < n - d ? to : n - d, a + d * stride, x + d, y);
        }
    }
}

void banded_multiply(const struct banded *b, const double *x, double *y)
{
    multiply_band(b->n, b->half, b->stride, b->x, x, y);
}

/* ---- factor ---- */

/* Column by column: D(i) = A(i, i), L(k, i) = A(k, i)/D(i), A(j, k) -= L(j, i) D(i) L(k, i). */
const char *banded_factor(struct banded *b)
{
    const int h = b->half, w = b->width;
    double *work = calloc((size_t)(b->n + h) * (size_t)(h + 1), sizeof *work); /* [n + h][h + 1] by column */
    const char *why = NULL;

    if (!work)
        return REASON_MEMORY;
    for (int64_t i = 0; i < b->n; i++)
        for (int d = 0; d <= h; d++)
            work[i * (h + 1) + d] = b->x[d * b->stride + i];
    for (int64_t i = 0; i < b->n && !why; i++) {
        double *c = work + i * (h + 1);
        if (!(c[0] > 0 && isfinite(c[0])))
            why = reason("the matrix of the step is not positive definite at row %lld", (long long)i);
        b->inverse[i] = 1 / c[0];
        for (int k = 1; k <= h; k++) {
            double l = b->L[i * w + k - 1] = c[k] * b->inverse[i];
            for (int j = k; j <= h; j++)
                c[k * (h + 1) + j - k] -= l * c[j];
        }
    }
    free(work);
    return why;
}

/* ---- solution ---- */

/* L y = f, then y/D.  r holds f[i..i + w - 1] less what rows before i take from them. */
static inline void solve_forward(int64_t n, int w, const double *restrict L, const double *restrict inverse, double *restrict x)
{
    double r[BANDED_PAD];

    for (int k = 0; k < w; k++)
        r[k] = x[k];
    for (int64_t i = 0; i < n; i++, L += w) {
        double y = r[0];
        x[i] = y * inverse[i];
        for (int k = 0; k < w - 1; k++)
            r[k] = r[k + 1] - L[k] * y;
        r[w - 1] = x[i + w] - L[w - 1] * y;
    }
}

/* L' x = y.  r holds x[i + 1..i + w]; the nearest, the last to be known, is taken off last. */
static inline void solve_backward(int64_t n, int w, const double *restrict L, double *restrict x)
{
    double r[BANDED_PAD] = {0};

    L += n * w;
    for (int64_t i = n - 1; i >= 0; i--) {
        double y = x[i];
        L -= w;
        for (int k = w - 1; k >= 0; k--)
            y -= L[k] * r[k];
        for (int k = w - 1; k > 0; k--)
            r[k] = r[k - 1];
        x[i] = r[0] = y;
    }
}

/* The width as a constant, so that r lives in registers. */
static void solve_8(const struct banded *b, double *x)
{
    solve_forward(b->n, 8, b->L, b->inverse, x);
    solve_backward(b->n, 8, b->L, x);
}

static void solve_16(const struct banded *b, double *x)
{
    solve_forward(b->n, 16, b->L, b->inverse, x);
    solve_backward(b->n, 16, b->L, x);
}

void banded_solve(const struct banded *b, double *x)
{
    if (b->width == 8)
        solve_8(b, x);
    else if (b->width == 16)
        solve_16(b, x);
    else {
        solve_forward(b->n, b->width, b->L, b->inverse, x);
        solve_backward(b->n, b->width, b->L, x);
    }
}

/* ---- inverse ---- */

/* (b^-1)(i, j) from what of it is known, |i - j| <= beyond. */
static double known(const double *Z, int beyond, int64_t i, int64_t j)
{
    return i <= j ? Z[i * (beyond + 1) + j - i] : Z[j * (beyond + 1) + i - j];
}

void banded_inverse(const struct banded *b, int beyond, double *Z)
{
    for (int64_t i = b->n - 1; i >= 0; i--) {
        const double *L = b->L + i * b->width;
        const int below = b->n - 1 - i < b->half ? (int)(b->n - 1 - i) : b->half;
        for (int d = beyond; d >= 0; d--) {
            double z = d ? 0 : b->inverse[i];
            for (int k = 1; k <= below && i + d < b->n; k++)
                z -= L[k - 1] * known(Z, beyond, i + k, i + d);
            Z[i * (beyond + 1) + d] = z;
        }
    }
}
