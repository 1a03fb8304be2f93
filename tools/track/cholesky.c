/* K = L D L' by CHOLMOD's simplicial method, which gives the same bits with every BLAS.  It accepts negative pivots, so these
 * are looked for here; one solve is checked by its residual. */
#include "tools/track/cholesky.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cholmod.h>

#include "formats/reason.h"

static const double RESIDUAL = 100;    /* times n eps (|K| |u| + |f|), of the first solve */

static cholmod_sparse matrix(const struct trk *t)
{
    return (cholmod_sparse){.nrow = (size_t)t->dofs, .ncol = (size_t)t->dofs, .nzmax = (size_t)t->Ap[t->dofs],
                            .p = (void *)t->Ap, .i = (void *)t->Ai, .x = (void *)t->Kx, .stype = 1, .itype = CHOLMOD_LONG,
                            .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE, .sorted = 1, .packed = 1};
}

static const char *not_positive(int64_t column)
{
    return reason("the track's stiffness matrix is not positive definite at its degree of freedom %lld: does anything carry it?",
                  (long long)column);
}

/* Column j of the factor begins with D_jj; perm gives its degree of freedom. */
static const char *check_pivots(const cholmod_factor *L)
{
    const SuiteSparse_long *p = L->p, *perm = L->Perm;
    const double *x = L->x;

    if (L->minor < L->n)
        return not_positive(perm[L->minor]);
    for (size_t j = 0; j < L->n; j++)
        if (!(x[p[j]] > 0))
            return not_positive(perm[j]);
    return NULL;
}

/* f = 1 everywhere: |K u - f| <= c n eps (|K| |u| + |f|), in sums, which a NaN spoils. */
static const char *check_residual(struct cholesky *s)
{
    const struct trk *t = s->track;
    const size_t n = (size_t)t->dofs;
    double *u = calloc(3 * n, sizeof *u);
    if (!u)
        return REASON_MEMORY;
    double *r = u + n, *row = r + n, size_u = 0, residual = 0, most_row = 0;

    for (size_t i = 0; i < n; i++)
        r[i] = 1;
    const char *why = cholesky_solve(s, r, u);
    for (size_t j = 0; j < n && !why; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            r[t->Ai[p]] -= t->Kx[p] * u[j];
            row[t->Ai[p]] += fabs(t->Kx[p]);
        }
    for (size_t i = 0; i < n; i++) {
        size_u += fabs(u[i]);
        residual += fabs(r[i]);
        most_row = fmax(most_row, row[i]);
    }
    if (!why && !(residual <= RESIDUAL * (double)n * DBL_EPSILON * (most_row * size_u + (double)n)))
        why = reason("static solution leaves a residual of %g of the load", residual / (double)n);
    free(u);
    return why;
}

const char *cholesky_again(struct cholesky *s)
{
    cholmod_sparse K = matrix(s->track);

    cholmod_l_factorize(&K, s->factor, s->common);
    if (((cholmod_common *)s->common)->status < CHOLMOD_OK)
        return reason("factoring the track's stiffness matrix failed (CHOLMOD status %d)", ((cholmod_common *)s->common)->status);
    const char *why = check_pivots(s->factor);
    return why ? why : check_residual(s);
}

static const char *factor(struct cholesky *s)
{
    cholmod_sparse K = matrix(s->track);

    s->factor = cholmod_l_analyze(&K, s->common);
    return s->factor ? cholesky_again(s) : REASON_MEMORY;
}

const char *cholesky_new(struct cholesky *s, const struct trk *t)
{
    memset(s, 0, sizeof *s);
    cholmod_common *c = calloc(1, sizeof *c);
    if (!c)
        return REASON_MEMORY;
    cholmod_l_start(c);
    c->supernodal = CHOLMOD_SIMPLICIAL;
    c->print = 0;
    s->track = t;
    s->common = c;
    const char *why = factor(s);
    if (why)
        cholesky_free(s);
    return why;
}

const char *cholesky_solve(struct cholesky *s, const double *f, double *u)
{
    const size_t n = (size_t)s->track->dofs;
    cholmod_dense F = {.nrow = n, .ncol = 1, .nzmax = n, .d = n, .x = (void *)f, .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE};
    cholmod_dense *U = cholmod_l_solve(CHOLMOD_A, s->factor, &F, s->common);

    if (!U)
        return REASON_MEMORY;
    memcpy(u, U->x, n * sizeof *u);
    cholmod_l_free_dense(&U, s->common);
    return NULL;
}

void cholesky_free(struct cholesky *s)
{
    if (s->common) {
        cholmod_l_free_factor((cholmod_factor **)&s->factor, s->common);
        cholmod_l_finish(s->common);
        free(s->common);
    }
    memset(s, 0, sizeof *s);
}
