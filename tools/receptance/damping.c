/* (K + s C + s^2 M) x = 0 by inverse iteration from the undamped mode: y = Q(s)^-1 (C + 2 s M) x, and s from the Rayleigh
 * functional, the root of y'Q(s)y = 0 nearest to the s before; y' without conjugation, since K, C and M are symmetric
 * (Tisseur and Meerbergen 2001, SIAM Review 43, 235). */
#include "tools/receptance/damping.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/receptance/direct.h"

static const double CONVERGED = 1e-9;      /* change of s over |s| */
static const double BESIDE = 1e-9;         /* of s: so far from an exact eigenvalue, where Q has no factors, it is factored */
enum {
    STEPS = 50,                            /* of one iteration, at most */
    PARTS = 4                              /* the damping comes in so many parts, so that each mode keeps to its own path */
};

/* x'Ax without conjugation; x [dofs][2] */
static double complex product(const struct trk *t, const double *A, const double *x)
{
    double complex sum = 0;

    for (int64_t j = 0; j < t->dofs; j++) {
        double re = 0, im = 0;
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            re += A[p] * x[2 * t->Ai[p]];
            im += A[p] * x[2 * t->Ai[p] + 1];
        }
        sum += (re + im * I) * (x[2 * j] + x[2 * j + 1] * I);
    }
    return sum;
}

/* Root of m s^2 + c s + k nearest to s. */
static double complex nearest_root(double complex m, double complex c, double complex k, double complex s)
{
    const double complex root = csqrt(c * c - 4 * m * k), a = (-c + root) / (2 * m), b = (-c - root) / (2 * m);

    return cabs(a - s) <= cabs(b - s) ? a : b;
}

static double complex rayleigh(const struct direct *d, const double *x, double complex s)
{
    const struct trk *t = d->track;
    return nearest_root(product(t, t->Mx, x), d->part * product(t, t->Cx, x), product(t, t->Kx, x), s);
}

/* y = (C + 2 s M) x; x, y [dofs][2] apart */
static void right_hand_side(const struct direct *d, double complex s, const double *x, double *y)
{
    const struct trk *t = d->track;

    for (int64_t i = 0; i < 2 * t->dofs; i++)
        y[i] = 0;
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            const double complex v = (d->part * t->Cx[p] + 2 * s * t->Mx[p]) * (x[2 * j] + x[2 * j + 1] * I);
            y[2 * t->Ai[p]] += creal(v);
            y[2 * t->Ai[p] + 1] += cimag(v);
        }
}

/* x = y, its largest entry 1; x, y [n] */
static void scale(int64_t n, const double *y, double *x)
{
    double most = 0;

    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(y[i]));
    for (int64_t i = 0; i < n; i++)
        x[i] = y[i] / most;
}

/* x [dofs][2] and *s: the mode before and after; y [dofs][2] is work space. */
static const char *iterate(struct direct *d, double *x, double *y, double complex *s)
{
    for (int step = 0; step < STEPS; step++) {
        const char *why = direct_factor(d, *s);
        if (why)
            why = direct_factor(d, *s * (1 + BESIDE));
        right_hand_side(d, *s, x, y);
        if (why || (why = direct_solve(d, y)))
            return why;
        scale(2 * d->track->dofs, y, x);
        const double complex next = rayleigh(d, x, *s);
        const double change = cabs(next - *s);
        *s = next;
        if (change <= CONVERGED * cabs(next))
            return NULL;
    }
    return reason("the complex eigenvalue does not settle in %d steps", STEPS);
}

const char *damping_track(const struct trk *t, int64_t n, const double *frequency, const double *shape, double *ratio)
{
    struct direct d;
    double *x = calloc(4 * (size_t)t->dofs, sizeof *x);
    const char *why = x ? direct_new(&d, t) : REASON_MEMORY;

    if (why) {
        free(x);
        return why;
    }
    for (int64_t i = 0; i < n && !why; i++) {
        for (int64_t k = 0; k < t->dofs; k++) {
            x[2 * k] = shape[i * t->dofs + k];
            x[2 * k + 1] = 0;
        }
        double complex s = 2 * M_PI * frequency[i] * I;
        for (int part = 1; part <= PARTS && !why; part++) {
            d.part = (double)part / PARTS;
            s = rayleigh(&d, x, s);
            why = iterate(&d, x, x + 2 * t->dofs, &s);
        }
        ratio[i] = -creal(s) / cabs(s);
        if (why)
            why = reason("mode at %g Hz: %s", frequency[i], why);
    }
    free(x);
    direct_free(&d);
    return why;
}
