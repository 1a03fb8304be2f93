/* ARPACK in its mode 3: Lanczos on (K - sigma M)^-1 M, whose largest eigenvalues belong to the omega^2 nearest to sigma (Lehoucq,
 * Sorensen and Yang 1998, ARPACK Users' Guide).  KLU factors K - sigma M, which is indefinite; the start vector is our own, so
 * that two runs give the same bits. */
#include "tools/receptance/modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <arpack/arpack.h>
#include <klu.h>

#include "formats/reason.h"
#include "tools/receptance/damping.h"
#include "tools/receptance/kind.h"

static const double TOLERANCE = 1e-13;     /* of the Ritz values */
enum { RESTARTS = 3000, BASIS_LEAST = 20 };

struct shifted {
    const struct trk *track;
    double sigma;
    double *A;                             /* [entries] K - sigma M */
    klu_l_common common;
    klu_l_symbolic *symbolic;
    klu_l_numeric *numeric;
};

static const char *shifted_new(struct shifted *s, const struct trk *t, double sigma)
{
    SuiteSparse_long *Ap = (SuiteSparse_long *)t->Ap, *Ai = (SuiteSparse_long *)t->Ai;

    *s = (struct shifted){.track = t, .sigma = sigma};
    klu_l_defaults(&s->common);
    s->A = calloc((size_t)t->Ap[t->dofs], sizeof *s->A);
    if (!s->A)
        return REASON_MEMORY;
    for (int64_t p = 0; p < t->Ap[t->dofs]; p++)
        s->A[p] = t->Kx[p] - sigma * t->Mx[p];
    s->symbolic = klu_l_analyze(t->dofs, Ap, Ai, &s->common);
    if (s->symbolic)
        s->numeric = klu_l_factor(Ap, Ai, s->A, s->symbolic, &s->common);
    if (!s->numeric || s->common.status != KLU_OK)
        return reason("K - sigma M has no factors at %g Hz (KLU status %d)", sqrt(sigma) / (2 * M_PI), (int)s->common.status);
    return NULL;
}

static void shifted_free(struct shifted *s)
{
    klu_l_free_numeric(&s->numeric, &s->common);
    klu_l_free_symbolic(&s->symbolic, &s->common);
    free(s->A);
}

/* y = M x; x, y: [dofs], apart */
static void multiply_mass(const struct trk *t, const double *x, double *y)
{
    memset(y, 0, (size_t)t->dofs * sizeof *y);
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            y[t->Ai[p]] += t->Mx[p] * x[j];
}

static const char *solve(struct shifted *s, double *x)
{
    return klu_l_solve(s->symbolic, s->numeric, s->track->dofs, 1, x, &s->common) ? NULL : reason("KLU could not solve");
}

/* Work space of ARPACK, in one piece. */
struct lanczos {
    a_int n, nev, ncv, lworkl;
    a_int iparam[11], ipntr[14];
    double *resid, *v, *workd, *workl;     /* [n] [n ncv] [3 n] [lworkl] */
};

static const char *lanczos_new(struct lanczos *a, int64_t dofs, int64_t modes)
{
    const size_t n = (size_t)dofs;

    *a = (struct lanczos){.n = (a_int)dofs, .nev = (a_int)modes};
    a->ncv = 2 * a->nev + 1 > BASIS_LEAST ? 2 * a->nev + 1 : BASIS_LEAST;
    if (a->ncv > a->n)
        a->ncv = a->n;
    a->lworkl = a->ncv * (a->ncv + 8);
    a->iparam[0] = 1;                      /* exact shifts */
    a->iparam[2] = RESTARTS;
    a->iparam[6] = 3;                      /* shift and invert */
    a->resid = calloc(n * (size_t)(4 + a->ncv) + (size_t)a->lworkl, sizeof *a->resid);
    if (!a->resid)
        return REASON_MEMORY;
    a->v = a->resid + n;
    a->workd = a->v + n * (size_t)a->ncv;
    a->workl = a->workd + 3 * n;
    uint64_t state = 1;
    for (size_t i = 0; i < n; i++) {       /* Knuth's MMIX congruences, in (0, 1): some of every mode */
        state = state * 6364136223846793005u + 1442695040888963407u;
        a->resid[i] = (double)(state >> 11) * 0x1p-53;
    }
    return NULL;
}

static const char *iterate(struct lanczos *a, struct shifted *s)
{
    const size_t n = (size_t)a->n;
    a_int ido = 0, info = 1;               /* info 1: resid is the start vector */

    for (;;) {
        const char *why = NULL;
        dsaupd_c(&ido, "G", a->n, "LM", a->nev, TOLERANCE, a->resid, a->ncv, a->v, a->n, a->iparam, a->ipntr, a->workd, a->workl,
                 a->lworkl, &info);
        double *x = a->workd + a->ipntr[0] - 1, *y = a->workd + a->ipntr[1] - 1, *Bx = a->workd + a->ipntr[2] - 1;
        if (ido == -1) {                   /* y = (K - sigma M)^-1 M x */
            multiply_mass(s->track, x, y);
            why = solve(s, y);
        } else if (ido == 1) {             /* the same, M x known */
            memcpy(y, Bx, n * sizeof *y);
            why = solve(s, y);
        } else if (ido == 2)
            multiply_mass(s->track, x, y);
        else
            return info == 0 ? NULL : reason("ARPACK stopped with info %d after %d of %d modes", (int)info, (int)a->iparam[4], (int)a->nev);
        if (why)
            return why;
    }
}

/* lambda [nev] = omega^2, shape [nev][dofs] with unit modal mass. */
static const char *extract(struct lanczos *a, double sigma, double *lambda, double *shape)
{
    a_int info = 0, *select = calloc((size_t)a->ncv, sizeof *select);
    if (!select)
        return REASON_MEMORY;
    dseupd_c(1, "A", select, lambda, shape, a->n, sigma, "G", a->n, "LM", a->nev, TOLERANCE, a->resid, a->ncv, a->v, a->n, a->iparam,
             a->ipntr, a->workd, a->workl, a->lworkl, &info);
    free(select);
    return info == 0 ? NULL : reason("ARPACK gave no modes (info %d)", (int)info);
}

/* The k-th mode into place `to` of the arrays of *m: largest motion positive. */
static void take(const struct trk *t, const double *x, double lambda, double *frequency, double *shape, char name[32])
{
    double most = 0;

    for (int64_t i = 0; i < t->dofs; i++)
        if (fabs(x[i]) > fabs(most))
            most = x[i];
    for (int64_t i = 0; i < t->dofs; i++)
        shape[i] = most < 0 ? -x[i] : x[i];
    *frequency = sqrt(fmax(lambda, 0)) / (2 * M_PI);
    kind_name(t, shape, name);
}

static const char *find(struct mod *m, const struct trk *t, double sigma, double *lambda, double *shape)
{
    struct shifted s;
    struct lanczos a = {0};
    const char *why = shifted_new(&s, t, sigma);

    if (!why)
        why = lanczos_new(&a, t->dofs, m->n);
    if (!why)
        why = iterate(&a, &s);
    if (!why)
        why = extract(&a, sigma, lambda, shape);
    free(a.resid);
    shifted_free(&s);
    return why;
}

const char *modes_track(struct mod *m, const struct trk *t, int64_t n, double near)
{
    const size_t count = (size_t)n, dofs = (size_t)t->dofs;

    *m = (struct mod){.of = "trk", .n = n, .dofs = t->dofs};
    if (n < 1 || n > t->dofs / 2)
        return reason("%lld modes are not between 1 and %lld, half the degrees of freedom", (long long)n, (long long)t->dofs / 2);
    double *frequency = calloc(count * (2 + dofs) * sizeof *frequency + count * sizeof *m->name, 1);
    double *lambda = calloc(count * (1 + dofs), sizeof *lambda);
    const char *why = frequency && lambda ? find(m, t, pow(2 * M_PI * near, 2), lambda, lambda + n) : REASON_MEMORY;
    double *damping = frequency + count, *shape = damping + count;
    char (*name)[32] = (char (*)[32])(shape + count * dofs);

    m->store = frequency;
    for (size_t i = 0; i < count && !why; i++) {
        size_t to = 0;                     /* rank, whatever the order ARPACK gives */
        for (size_t j = 0; j < count; j++)
            to += lambda[j] < lambda[i] || (j < i && lambda[j] <= lambda[i]);
        take(t, lambda + count + i * dofs, lambda[i], &frequency[to], &shape[to * dofs], name[to]);
    }
    m->frequency = frequency;
    m->damping = damping;
    m->name = (const char (*)[32])name;
    m->shape = shape;
    if (!why)
        why = damping_track(t, n, frequency, shape, damping);
    free(lambda);
    return why;
}
