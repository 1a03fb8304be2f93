/* KLU: one symbolic analysis for all s, then refactoring without pivoting, guarded by the reciprocal pivot growth (Davis and
 * Palamadai Natarajan 2010, ACM Trans. Math. Software 37, 36); each solution is checked by its residual. */
#include "tools/receptance/direct.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <klu.h>

#include "formats/reason.h"

static const double GROWTH = 1e-6;      /* below it the pivots are chosen anew */
static const double RESIDUAL = 1e-10;   /* of |A| |u| + |f| */

static const char *why_not(const klu_l_common *c, double complex s)
{
    if (c->status == KLU_OUT_OF_MEMORY)
        return REASON_MEMORY;
    return reason("no factors at s = %g%+gi 1/s (KLU status %d)", creal(s), cimag(s), (int)c->status);
}

const char *direct_new(struct direct *d, const struct trk *t)
{
    memset(d, 0, sizeof *d);
    d->track = t;
    d->part = 1;
    d->A = calloc(2 * (size_t)t->Ap[t->dofs], sizeof *d->A);
    d->f = calloc(2 * (size_t)t->dofs, sizeof *d->f);
    d->common = calloc(1, sizeof(klu_l_common));
    if (d->A && d->f && d->common) {
        klu_l_defaults(d->common);
        ((klu_l_common *)d->common)->scale = -1;         /* no row scaling, nor a check of the pattern at each s */
        d->symbolic = klu_l_analyze(t->dofs, (SuiteSparse_long *)t->Ap, (SuiteSparse_long *)t->Ai, d->common);
    }
    if (d->symbolic)
        return NULL;
    direct_free(d);
    return REASON_MEMORY;
}

static void fill(struct direct *d, double complex s)
{
    const struct trk *t = d->track;
    const double sr = creal(s), si = cimag(s), s2r = sr * sr - si * si, s2i = 2 * sr * si;
    double most = 0;

    for (int64_t p = 0; p < t->Ap[t->dofs]; p++) {
        const double re = t->Kx[p] + sr * (d->part * t->Cx[p]) + s2r * t->Mx[p];
        const double im = si * (d->part * t->Cx[p]) + s2i * t->Mx[p];
        d->A[2 * p] = re;
        d->A[2 * p + 1] = im;
        const double size = fabs(re) + fabs(im);
        most = size > most ? size : most;
    }
    d->scale = most;
}

/* Pivots chosen anew, the largest of each column where tol is 1. */
static const char *factor(struct direct *d, double complex s, double tol)
{
    klu_l_common *c = d->common;
    SuiteSparse_long *Ap = (SuiteSparse_long *)d->track->Ap, *Ai = (SuiteSparse_long *)d->track->Ai;
    const double usual = c->tol;

    klu_zl_free_numeric((klu_l_numeric **)&d->numeric, c);
    c->tol = tol;
    d->numeric = klu_zl_factor(Ap, Ai, d->A, d->symbolic, c);
    c->tol = usual;
    return d->numeric && c->status == KLU_OK ? NULL : why_not(c, s);
}

const char *direct_factor(struct direct *d, double complex s)
{
    klu_l_common *c = d->common;
    SuiteSparse_long *Ap = (SuiteSparse_long *)d->track->Ap, *Ai = (SuiteSparse_long *)d->track->Ai;

    fill(d, s);
    if (!d->numeric)
        return factor(d, s, c->tol);
    if (klu_zl_refactor(Ap, Ai, d->A, d->symbolic, d->numeric, c) && c->status == KLU_OK &&
        klu_zl_rgrowth(Ap, Ai, d->A, d->symbolic, d->numeric, c) && c->rgrowth >= GROWTH)
        return NULL;
    d->repivots++;
    return factor(d, s, 1);
}

/* |A u - f| against |A| |u| + |f|, in sums, which a NaN spoils; size_f is |f|. */
static const char *check_residual(const struct direct *d, const double *u, double size_f)
{
    const struct trk *t = d->track;
    double size_u = 0, residual = 0;

    for (int64_t j = 0; j < t->dofs; j++) {
        const double ur = u[2 * j], ui = u[2 * j + 1];
        size_u += fabs(ur) + fabs(ui);
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            d->f[2 * t->Ai[p]] -= d->A[2 * p] * ur - d->A[2 * p + 1] * ui;
            d->f[2 * t->Ai[p] + 1] -= d->A[2 * p] * ui + d->A[2 * p + 1] * ur;
        }
    }
    for (int64_t i = 0; i < 2 * t->dofs; i++)
        residual += fabs(d->f[i]);
    if (!(residual <= RESIDUAL * (d->scale * size_u + size_f)))
        return reason("the solution leaves a residual of %g for a load of %g", residual, size_f);
    return NULL;
}

const char *direct_solve(struct direct *d, double *u)
{
    const int64_t n = d->track->dofs;
    double size_f = 0;

    memcpy(d->f, u, 2 * (size_t)n * sizeof *u);
    for (int64_t i = 0; i < 2 * n; i++)
        size_f += fabs(u[i]);
    if (!klu_zl_solve(d->symbolic, d->numeric, n, 1, u, d->common))
        return reason("no solution (KLU status %d)", (int)((klu_l_common *)d->common)->status);
    return check_residual(d, u, size_f);
}

void direct_free(struct direct *d)
{
    if (d->common) {
        klu_zl_free_numeric((klu_l_numeric **)&d->numeric, d->common);
        klu_l_free_symbolic((klu_l_symbolic **)&d->symbolic, d->common);
    }
    free(d->common);
    free(d->A);
    free(d->f);
    memset(d, 0, sizeof *d);
}
