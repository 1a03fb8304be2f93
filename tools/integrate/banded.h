/* Symmetric banded matrices: product, L D L' without pivoting, solution, and the inverse within a band.
 *
 * A(i + d, i) stands at x[d stride + i], d = 0..half; L(i + k, i) at L[i width + k - 1], k = 1..half.  Vectors have room for n + BANDED_PAD
 * numbers, zero beyond n. */
#ifndef VX_INTEGRATE_BANDED_H
#define VX_INTEGRATE_BANDED_H

#include <stdint.h>

enum { BANDED_PAD = 32, BANDED_HALF_MOST = BANDED_PAD };

struct banded {
    int64_t n, stride;
    int half, width;        /* half bandwidth; that of the factor's columns, whole vectors */
    double *x;              /* [half + 1][stride] the matrix */
    double *L, *inverse;    /* [n][width], [n] 1/D: after banded_factor */
};

/* Half bandwidth of a symmetric pattern with values x, zeros not counted. */
int64_t banded_half(int64_t n, const int64_t *Ap, const int64_t *Ai, const double *x);

/* Zeros.  Fails where half > BANDED_HALF_MOST. */
const char *banded_new(struct banded *b, int64_t n, int64_t half);
void banded_free(struct banded *b);

/* b += c X, X of that pattern by column. */
void banded_add(struct banded *b, double c, const int64_t *Ap, const int64_t *Ai, const double *x);

/* y [n] += b x [n] */
void banded_multiply(const struct banded *b, const double *x, double *y);

/* Fails where the matrix is not positive definite, with the row. */
const char *banded_factor(struct banded *b);

/* x <- b^-1 x, of a factored matrix. */
void banded_solve(const struct banded *b, double *x);

/* Z[i (beyond + 1) + k] = (b^-1)(i, i + k), k = 0..beyond, beyond >= half: Takahashi, Fagan and Chin 1973,
 *   Z(i, j) = -sum_k L(k, i) Z(k, j),  j > i,   Z(i, i) = 1/D(i) - sum_k L(k, i) Z(k, i). */
void banded_inverse(const struct banded *b, int beyond, double *Z);

#endif
