/* ARPACK on the linear problem of twice the size, z = [x; s x], shifted and inverted: theta = 1/(s - sigma), and
 *
 *     Q(sigma) p = -(C x + sigma M x + M v),   q = x + sigma p,   Q(sigma) = K + sigma C + sigma^2 M,
 *
 * gives [p; q] from [x; v] with factors of the size of the track alone (Tisseur and Meerbergen 2001, SIAM Review 43, 235; Lehoucq, Sorensen
 * and Yang 1998, ARPACK Users' Guide).  v is kept over the size of sigma, so that both halves count alike. */
#include "tools/receptance/damped.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <arpack/arpack.h>

#include "formats/reason.h"
#include "tools/receptance/direct.h"
#include "tools/receptance/kind.h"

static const double TOLERANCE = 1e-12;         /* of the Ritz values */
static const double SLOW = 2 * 3.14159265358979323846;   /* 1/s, least size of sigma */
enum { RESTARTS = 3000, BASIS_LEAST = 20 };

struct arnoldi {
    const struct trk *track;
    struct direct direct;                      /* Q(sigma) */
    double complex sigma;
    double scale;                              /* 1/s, of v */
    a_int n, nev, ncv, lworkl;                 /* n is twice the degrees of freedom */
    a_int iparam[11], ipntr[14];
    double complex *resid, *v, *workd, *workl; /* [n] [n ncv] [3 n] [lworkl] */
    double complex *d, *workev;                /* [nev + 1] [2 ncv] */
    double *rwork;                             /* [ncv] */
};

static void arnoldi_free(struct arnoldi *a)
{
    direct_free(&a->direct);
    free(a->resid);
    free(a->rwork);
}

static const char *arnoldi_new(struct arnoldi *a, const struct trk *t, int64_t modes, double near)
{
    const size_t n = 2 * (size_t)t->dofs;

    memset(a, 0, sizeof *a);
    a->track = t;
    a->sigma = 2 * M_PI * near * I;
    a->scale = fmax(cabs(a->sigma), SLOW);
    a->n = (a_int)n;
    a->nev = (a_int)(2 * modes);               /* a pair may lie on both sides of sigma */
    a->ncv = 2 * a->nev + 1 > BASIS_LEAST ? 2 * a->nev + 1 : BASIS_LEAST;
    if (a->ncv > a->n)
        a->ncv = a->n;
    const size_t ncv = (size_t)a->ncv;
    a->lworkl = 3 * a->ncv * a->ncv + 5 * a->ncv;
    a->iparam[0] = 1;                          /* exact shifts */
    a->iparam[2] = RESTARTS;
    a->iparam[6] = 1;                          /* the operator is ours */
    a->resid = calloc(n * (4 + ncv) + (size_t)a->lworkl + (size_t)a->nev + 1 + 2 * ncv, sizeof *a->resid);
    a->rwork = calloc(ncv, sizeof *a->rwork);
    const char *why = a->resid && a->rwork ? direct_new(&a->direct, t) : REASON_MEMORY;
    if (why)
        return why;
    a->v = a->resid + n;
    a->workd = a->v + n * ncv;
    a->workl = a->workd + 3 * n;
    a->d = a->workl + a->lworkl;
    a->workev = a->d + a->nev + 1;
    uint64_t state = 1;
    for (size_t i = 0; i < n; i++) {           /* Knuth's MMIX congruences, in (0, 1): some of every mode */
        state = state * 6364136223846793005u + 1442695040888963407u;
        a->resid[i] = (double)(state >> 11) * 0x1p-53;
    }
    return direct_factor(&a->direct, a->sigma);
}

/* to = (A - sigma B)^-1 B from; from, to [n] = [x; v/scale] */
static const char *operate(struct arnoldi *a, const double complex *from, double complex *to)
{
    const struct trk *t = a->track;
    const int64_t dofs = t->dofs;

    for (int64_t i = 0; i < dofs; i++)
        to[i] = 0;
    for (int64_t j = 0; j < dofs; j++) {
        const double complex x = from[j], Mv = a->sigma * x + a->scale * from[dofs + j];
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            to[t->Ai[p]] -= t->Cx[p] * x + t->Mx[p] * Mv;
    }
    const char *why = direct_solve(&a->direct, (double *)to);
    for (int64_t i = 0; i < dofs; i++)
        to[dofs + i] = (from[i] + a->sigma * to[i]) / a->scale;
    return why;
}

static const char *iterate(struct arnoldi *a)
{
    a_int ido = 0, info = 1;                   /* info 1: resid is the start vector */

    for (;;) {
        znaupd_c(&ido, "I", a->n, "LM", a->nev, TOLERANCE, a->resid, a->ncv, a->v, a->n, a->iparam, a->ipntr, a->workd, a->workl, a->lworkl,
                 a->rwork, &info);
        if (ido == 99)
            return info == 0 ? NULL : reason("ARPACK stopped with info %d after %d of %d eigenvalues", (int)info, (int)a->iparam[4], (int)a->nev);
        const char *why = operate(a, a->workd + a->ipntr[0] - 1, a->workd + a->ipntr[1] - 1);
        if (why)
            return why;
    }
}

/* Eigenvalues s into d [nev], vectors into v [nev][n]. */
static const char *extract(struct arnoldi *a)
{
    a_int info = 0, *select = calloc((size_t)a->ncv, sizeof *select);

    if (!select)
        return REASON_MEMORY;
    zneupd_c(1, "A", select, a->d, a->v, a->n, 0, a->workev, "I", a->n, "LM", a->nev, TOLERANCE, a->resid, a->ncv, a->v, a->n, a->iparam,
             a->ipntr, a->workd, a->workl, a->lworkl, a->rwork, &info);
    free(select);
    if (info != 0)
        return reason("ARPACK gave no eigenvalues (info %d)", (int)info);
    for (a_int k = 0; k < a->nev; k++)
        a->d[k] = a->sigma + 1 / a->d[k];
    return NULL;
}

/* order [n]: the n eigenvalues with Im s >= 0 nearest to sigma, with increasing size; how many there are. */
static int64_t choose(const struct arnoldi *a, int64_t n, int64_t *order)
{
    int64_t found = 0;

    for (a_int k = 0; k < a->nev; k++) {
        int64_t nearer = 0;
        if (cimag(a->d[k]) < -TOLERANCE * cabs(a->d[k]))
            continue;
        for (a_int j = 0; j < a->nev; j++)
            if (cimag(a->d[j]) >= -TOLERANCE * cabs(a->d[j])) {
                const double here = cabs(a->d[k] - a->sigma), there = cabs(a->d[j] - a->sigma);
                nearer += there < here || (there <= here && j < k);
            }
        if (nearer >= n)
            continue;
        int64_t to = found++;
        for (; to > 0 && cabs(a->d[order[to - 1]]) > cabs(a->d[k]); to--)
            order[to] = order[to - 1];
        order[to] = k;
    }
    return found;
}

/* x over the root of x'(2 s M + C)x / 2i Im s, its largest real part positive; re, im [dofs] */
static void scale_shape(const struct trk *t, double complex s, const double complex *x, double *re, double *im)
{
    double complex norm = 0;
    double most = 0;

    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            norm += x[t->Ai[p]] * (2 * s * t->Mx[p] + t->Cx[p]) * x[j];
    const double complex by = cimag(s) > 0 ? csqrt(2 * cimag(s) * I / norm) : csqrt(1 / norm);
    for (int64_t i = 0; i < t->dofs; i++) {
        re[i] = creal(by * x[i]);
        im[i] = cimag(by * x[i]);
        most = fabs(re[i]) > fabs(most) ? re[i] : most;
    }
    for (int64_t i = 0; i < t->dofs && most < 0; i++) {
        re[i] = -re[i];
        im[i] = -im[i];
    }
}

/* The modes of order [m->n] into *m. */
static const char *keep(struct mod *m, const struct arnoldi *a, const int64_t *order)
{
    const size_t count = (size_t)m->n, dofs = (size_t)m->dofs;
    double *frequency = calloc(count * (2 + 2 * dofs) * sizeof *frequency + count * sizeof *m->name, 1);

    if (!frequency)
        return REASON_MEMORY;
    double *damping = frequency + count, *shape = damping + count, *imaginary = shape + count * dofs;
    char (*name)[32] = (char (*)[32])(imaginary + count * dofs);
    for (size_t i = 0; i < count; i++) {
        const double complex s = a->d[order[i]];
        frequency[i] = cabs(s) / (2 * M_PI);
        damping[i] = -creal(s) / cabs(s);
        scale_shape(a->track, s, a->v + order[i] * a->n, &shape[i * dofs], &imaginary[i * dofs]);
        kind_name(a->track, &shape[i * dofs], name[i]);
    }
    m->store = frequency;
    m->frequency = frequency;
    m->damping = damping;
    m->shape = shape;
    m->imaginary = imaginary;
    m->imaginaries = m->n;
    m->name = (const char (*)[32])name;
    return NULL;
}

const char *damped_track(struct mod *m, const struct trk *t, int64_t n, double near)
{
    struct arnoldi a;
    int64_t *order = calloc((size_t)n, sizeof *order);

    *m = (struct mod){.of = "trk", .dofs = t->dofs};
    if (n < 1 || n > t->dofs / 3) {
        free(order);
        return reason("%lld damped modes are not between 1 and %lld, a third of the degrees of freedom", (long long)n, (long long)t->dofs / 3);
    }
    const char *why = arnoldi_new(&a, t, n, near);
    if (!why && order)
        why = iterate(&a);
    if (!why)
        why = order ? extract(&a) : REASON_MEMORY;
    if (!why) {
        m->n = choose(&a, n, order);
        why = keep(m, &a, order);
    }
    arnoldi_free(&a);
    free(order);
    return why;
}
