/* LAPACK: dsygv for K x = omega^2 M x, dgeev for the complex eigenvalues of the first-order form
 *   d/dt [x; v] = [0 I; -M^-1 K  -M^-1 C] [x; v],
 * whose vectors are matched with the undamped modes by their overlap in M. */
#include "tools/receptance/dense.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "formats/reason.h"
#include "tools/receptance/name.h"

/* The vehicle without its wheelsets. */
struct held {
    int n;                     /* degrees of freedom */
    int64_t *dof;              /* [n] in the vehicle */
    double *K, *C, *M;         /* [n][n] */
    double *lambda;            /* [n] omega^2, increasing */
    double *shape;             /* [n][n] a row each, unit modal mass */
    double *ratio;             /* [n] damping */
};

static const char *held_new(struct held *h, const struct veh *v)
{
    const int64_t all = VEH_DOFS * v->bodies, n = VEH_DOFS * (v->bodies - v->wheelsets);

    *h = (struct held){.n = (int)n};
    if (n < 1)
        return reason("with its wheelsets held, nothing of this vehicle can move");
    const size_t square = (size_t)n * (size_t)n;
    h->dof = calloc((size_t)n, sizeof *h->dof);
    h->K = calloc(4 * square + 2 * (size_t)n, sizeof *h->K);
    if (!h->dof || !h->K)
        return REASON_MEMORY;
    h->C = h->K + square;
    h->M = h->C + square;
    h->shape = h->M + square;
    h->lambda = h->shape + square;
    h->ratio = h->lambda + n;
    for (int64_t d = 0, k = 0; d < all; d++)
        if (!veh_is_wheelset(v, d / VEH_DOFS))
            h->dof[k++] = d;
    for (int64_t i = 0; i < n; i++)
        for (int64_t j = 0; j < n; j++) {
            h->K[i * n + j] = v->K[h->dof[i] * all + h->dof[j]];
            h->C[i * n + j] = v->C[h->dof[i] * all + h->dof[j]];
            h->M[i * n + j] = v->M[h->dof[i] * all + h->dof[j]];
        }
    return NULL;
}

static void held_free(struct held *h)
{
    free(h->dof);
    free(h->K);
}

static const char *solve_undamped(struct held *h)
{
    const size_t square = (size_t)h->n * (size_t)h->n;
    double *M = calloc(square, sizeof *M);
    if (!M)
        return REASON_MEMORY;
    memcpy(h->shape, h->K, square * sizeof *M);
    memcpy(M, h->M, square * sizeof *M);
    /* symmetric, so row and column order are one; the vectors come as columns, rows for us */
    int info = LAPACKE_dsygv(LAPACK_COL_MAJOR, 1, 'V', 'L', h->n, h->shape, h->n, M, h->n, h->lambda);
    free(M);
    if (info > h->n)
        return reason("the mass matrix is not positive definite");
    return info ? reason("LAPACK dsygv stopped with info %d", info) : NULL;
}

/* A [2n][2n] by rows: the first-order form. */
static const char *fill_state(const struct held *h, double *A)
{
    const int n = h->n, N = 2 * n;
    const size_t square = (size_t)n * (size_t)n;
    double *L = calloc(3 * square, sizeof *L);
    if (!L)
        return REASON_MEMORY;
    double *K = L + square, *C = K + square;

    memcpy(L, h->M, square * sizeof *L);
    memcpy(K, h->K, square * sizeof *K);
    memcpy(C, h->C, square * sizeof *C);
    int info = LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'L', n, L, n);
    if (!info)
        info = LAPACKE_dpotrs(LAPACK_ROW_MAJOR, 'L', n, n, L, n, K, n);
    if (!info)
        info = LAPACKE_dpotrs(LAPACK_ROW_MAJOR, 'L', n, n, L, n, C, n);
    for (int i = 0; i < n; i++) {
        A[i * N + n + i] = 1;
        for (int j = 0; j < n; j++) {
            A[(n + i) * N + j] = -K[i * n + j];
            A[(n + i) * N + n + j] = -C[i * n + j];
        }
    }
    free(L);
    return info ? reason("the mass matrix is not positive definite") : NULL;
}

/* |x'M u|^2 / u*'M u of mode i with unit modal mass and u = re + i im, the upper half of columns of V [2n][2n]; im is -1 for none. */
static double overlap(const struct held *h, int i, const double *V, int re, int im)
{
    const int n = h->n, N = 2 * n;
    double xr = 0, xi = 0, norm = 0;

    for (int a = 0; a < n; a++) {
        double Mr = 0, Mi = 0;
        for (int b = 0; b < n; b++) {
            Mr += h->M[a * n + b] * V[b * N + re];
            Mi += im < 0 ? 0 : h->M[a * n + b] * V[b * N + im];
        }
        xr += h->shape[i * n + a] * Mr;
        xi += h->shape[i * n + a] * Mi;
        norm += V[a * N + re] * Mr + (im < 0 ? 0 : V[a * N + im] * Mi);
    }
    return norm > 0 ? (xr * xr + xi * xi) / norm : 0;
}

/* Largest overlap first, each mode and each eigenvalue once: rest [n][2n] the overlaps, used up here. */
static void match(struct held *h, double *rest, const double *wr, const double *wi)
{
    const int n = h->n, N = 2 * n;

    for (int done = 0; done < n; done++) {
        int best = 0;
        for (int k = 1; k < n * N; k++)
            if (rest[k] > rest[best])
                best = k;
        const int i = best / N, j = best % N;
        const double size = hypot(wr[j], wi[j]);
        h->ratio[i] = size > 0 ? -wr[j] / size : 0;
        for (int k = 0; k < N; k++)
            rest[i * N + k] = -1;
        for (int k = 0; k < n; k++)
            rest[k * N + j] = -1;
    }
}

static const char *solve_damped(struct held *h)
{
    const int n = h->n, N = 2 * n;
    const size_t square = (size_t)N * (size_t)N;
    double *A = calloc(2 * square + (size_t)n * (size_t)N + 2 * (size_t)N, sizeof *A);
    if (!A)
        return REASON_MEMORY;
    double *V = A + square, *rest = V + square, *wr = rest + n * N, *wi = wr + N;
    const char *why = fill_state(h, A);

    if (!why) {
        int info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', N, A, N, wr, wi, NULL, N, V, N);
        if (info)
            why = reason("LAPACK dgeev stopped with info %d", info);
    }
    for (int i = 0; i < n && !why; i++)        /* of a pair the first counts, of which columns j, j + 1 are re, im */
        for (int j = 0; j < N; j++)
            rest[i * N + j] = wi[j] < 0 ? -1 : overlap(h, i, V, j, wi[j] > 0 ? j + 1 : -1);
    if (!why)
        match(h, rest, wr, wi);
    free(A);
    return why;
}

/* First of the n consecutive modes nearest to sigma. */
static int first_of(const struct held *h, int64_t n, double sigma)
{
    int first = 0;

    while (first + n < h->n && fabs(h->lambda[first + n] - sigma) < fabs(h->lambda[first] - sigma))
        first++;
    return first;
}

static const char *take(struct mod *m, const struct held *h, const struct veh *v, int first)
{
    const size_t n = (size_t)m->n, all = (size_t)m->dofs;
    double *frequency = calloc(n * ((2 + all) * sizeof *frequency + sizeof *m->name), 1);
    if (!frequency)
        return REASON_MEMORY;
    double *damping = frequency + n, *shape = damping + n;
    char (*name)[32] = (char (*)[32])(shape + n * all);

    m->store = frequency;
    m->frequency = frequency;
    m->damping = damping;
    m->shape = shape;
    m->name = (const char (*)[32])name;
    for (size_t i = 0; i < n; i++) {
        const double *x = h->shape + (size_t)(first + (int)i) * (size_t)h->n;
        frequency[i] = sqrt(fmax(h->lambda[first + (int)i], 0)) / (2 * M_PI);
        damping[i] = h->ratio[first + (int)i];
        for (int k = 0; k < h->n; k++)
            shape[i * all + (size_t)h->dof[k]] = x[k];
        name_mode(v, &shape[i * all], name[i]);
    }
    return NULL;
}

const char *dense_vehicle(struct mod *m, const struct veh *v, int64_t n, double near)
{
    struct held h;
    const char *why = held_new(&h, v);

    *m = (struct mod){.of = "veh", .n = n, .dofs = VEH_DOFS * v->bodies};
    if (!why && (n < 1 || n > h.n))
        why = reason("%lld modes are not between 1 and %d, what the bodies beside the wheelsets have", (long long)n, h.n);
    if (!why)
        why = solve_undamped(&h);
    if (!why)
        why = solve_damped(&h);
    if (!why)
        why = take(m, &h, v, first_of(&h, n, pow(2 * M_PI * near, 2)));
    held_free(&h);
    return why;
}
