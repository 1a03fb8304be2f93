/* With second differences Q^T x, the tridiagonal R of the natural spline and W = diag(w_i), the inner second derivatives
 * solve (R + lambda Q^T W^-1 Q) m = Q^T x, five diagonals, positive definite; then f = x - lambda W^-1 Q m. */
#include "tools/profile/spline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

double spline_lambda(double wavelength)
{
    return pow(wavelength / (2 * M_PI), 4);
}

/* 1/w_i times the length that knot i stands for. */
static double knot_inverse(const struct spline *p, const double *weight, int64_t i)
{
    double before = i > 0 ? p->s[i] - p->s[i - 1] : 0, after = i < p->n - 1 ? p->s[i + 1] - p->s[i] : 0;
    return 2 / ((before + after) * (weight ? weight[i] : 1));
}

/* Column j of Q: its entries in rows j, j + 1, j + 2. */
static void column_of_q(const struct spline *p, int64_t j, double q[3])
{
    q[0] = 1 / (p->s[j + 1] - p->s[j]);
    q[2] = 1 / (p->s[j + 2] - p->s[j + 1]);
    q[1] = -q[0] - q[2];
}

/* Lower diagonals a0 a1 a2 of R + lambda Q^T W^-1 Q, and the right-hand side Q^T x; n - 2 rows each. */
static void system_build(const struct spline *p, const double *x, const double *weight, double lambda,
                         double *a0, double *a1, double *a2, double *b)
{
    int64_t rows = p->n - 2;
    double q[3], next[3], v[3];

    for (int64_t j = 0; j < rows; j++) {
        column_of_q(p, j, q);
        for (int k = 0; k < 3; k++)
            v[k] = lambda * q[k] * knot_inverse(p, weight, j + k);
        b[j] = q[0] * x[j] + q[1] * x[j + 1] + q[2] * x[j + 2];
        a0[j] = (p->s[j + 2] - p->s[j]) / 3 + v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
        if (j + 1 < rows) {
            column_of_q(p, j + 1, next);
            a1[j] = (p->s[j + 2] - p->s[j + 1]) / 6 + v[1] * next[0] + v[2] * next[1];
        }
        if (j + 2 < rows) {
            column_of_q(p, j + 2, next);
            a2[j] = v[2] * next[0];
        }
    }
}

/* b := A^-1 b by L D L^T; the diagonals are overwritten. */
static void system_solve(int64_t rows, double *a0, double *a1, double *a2, double *b)
{
    for (int64_t j = 0; j < rows; j++) {
        if (j + 1 < rows) {
            double l1 = a1[j] / a0[j];
            a0[j + 1] -= l1 * a1[j];
            if (j + 2 < rows) {
                a1[j + 1] -= l1 * a2[j];
                a0[j + 2] -= a2[j] * a2[j] / a0[j];
                a2[j] /= a0[j];
                b[j + 2] -= a2[j] * b[j];
            }
            a1[j] = l1;
            b[j + 1] -= l1 * b[j];
        }
    }
    for (int64_t j = rows - 1; j >= 0; j--) {
        b[j] /= a0[j];
        if (j + 1 < rows)
            b[j] -= a1[j] * b[j + 1];
        if (j + 2 < rows)
            b[j] -= a2[j] * b[j + 2];
    }
}

/* f = x - lambda W^-1 Q m */
static void values_smooth(struct spline *p, const double *weight, double lambda)
{
    double q[3];

    for (int64_t j = 0; j < p->n - 2; j++) {
        column_of_q(p, j, q);
        for (int k = 0; k < 3; k++)
            p->f[j + k] -= lambda * knot_inverse(p, weight, j + k) * q[k] * p->m[j + 1];
    }
}

const char *spline_fit(struct spline *p, int64_t n, const double *s, const double *x, const double *weight, double lambda)
{
    double *store = calloc((size_t)n * 3, sizeof *store), *work = calloc((size_t)n * 3, sizeof *work);

    *p = (struct spline){0};
    if (!store || !work) {
        free(store);
        free(work);
        return REASON_MEMORY;
    }
    *p = (struct spline){.n = n, .s = store, .f = store + n, .m = store + 2 * n};
    memcpy(p->s, s, (size_t)n * sizeof *s);
    memcpy(p->f, x, (size_t)n * sizeof *x);
    system_build(p, x, weight, lambda, work, work + n, work + 2 * n, p->m + 1);
    system_solve(n - 2, work, work + n, work + 2 * n, p->m + 1);
    p->m[n - 1] = 0;
    values_smooth(p, weight, lambda);
    free(work);
    return NULL;
}

void spline_free(struct spline *p)
{
    free(p->s);
    *p = (struct spline){0};
}

/* The interval of s, by bisection. */
static int64_t interval_find(const struct spline *p, double s)
{
    int64_t lo = 0, hi = p->n - 1;
    while (hi - lo > 1) {
        int64_t middle = (lo + hi) / 2;
        if (p->s[middle] <= s)
            lo = middle;
        else
            hi = middle;
    }
    return lo;
}

void spline_at(const struct spline *p, double s, double out[3])
{
    double inside = fmin(fmax(s, p->s[0]), p->s[p->n - 1]);
    int64_t i = interval_find(p, inside);
    double h = p->s[i + 1] - p->s[i], a = (p->s[i + 1] - inside) / h, b = 1 - a;

    out[0] = a * p->f[i] + b * p->f[i + 1] + ((a * a * a - a) * p->m[i] + (b * b * b - b) * p->m[i + 1]) * h * h / 6;
    out[1] = (p->f[i + 1] - p->f[i]) / h + ((1 - 3 * a * a) * p->m[i] + (3 * b * b - 1) * p->m[i + 1]) * h / 6;
    out[2] = a * p->m[i] + b * p->m[i + 1];
    if (s != inside) {
        out[0] += out[1] * (s - inside);
        out[2] = 0;
    }
}
