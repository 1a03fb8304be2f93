#include "tools/integrate/energy.h"
#include "formats/reason.h"
#include "tools/contact/clones.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *energy_new(struct energy *e, const struct way *w)
{
    *e = (struct energy){.counted = 1, .n = w->scheme == WAY_EXPLICIT ? w->lumped.stride : w->track->sleepers};
    for (int64_t i = 0; i < TRK_BALLAST * w->track->sleepers; i++)
        e->counted &= w->track->ballast_state[i] == TRK_BONDED;
    e->lost = calloc((size_t)e->n, sizeof *e->lost);
    return e->lost ? NULL : REASON_MEMORY;
}

void energy_free(struct energy *e)
{
    free(e->lost);
    *e = (struct energy){0};
}

/* ---- stored ---- */

/* x' A x/2 */
/* Less than that is no loss to be measured by. */
#define NOTHING 1e-6 /* J */

static double half_square(const struct trk *t, const double *Ax, const double *x)
{
    double sum = 0;

    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            sum += 0.5 * x[t->Ai[p]] * Ax[p] * x[j];
    return sum;
}

/* e' M u g, e going down with all of the track. */
static double descended(const struct trk *t, const double *u, double g)
{
    double sum = 0;

    for (int64_t i = 0; i < t->nodes; i++)
        for (int s = 0; s < 2; s++) {
            const int64_t j = trk_rail_dof(t, s, i);
            for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
                sum += t->Mx[p] * u[t->Ai[p]] * g;
        }
    for (int64_t i = 0; i < t->check_nodes; i++)
        for (int64_t p = t->Ap[t->check_dof[i]]; p < t->Ap[t->check_dof[i] + 1]; p++)
            sum += t->Mx[p] * u[t->Ai[p]] * g;
    for (int64_t i = 0; i < t->sleepers; i++)
        sum += t->sleeper_mass[i] * u[t->sleeper_dof[i]] * g;
    return sum;
}

static double stored(const struct way *w)
{
    double *u = calloc((size_t)(2 * w->track->dofs), sizeof *u), *v = u ? u + w->track->dofs : NULL, sum = 0;

    if (!u)
        return 0;
    way_state(w, u, v);
    sum = half_square(w->track, w->track->Kx, u) + half_square(w->track, w->track->Mx, v) - descended(w->track, u, w->gravity);
    free(u);
    return sum;
}

void energy_begin(struct energy *e, const struct way *w)
{
    memset(e->lost, 0, (size_t)e->n * sizeof *e->lost);
    e->work = e->step = 0;
    e->at = e->of = 0;
    e->begun = e->counted ? stored(w) : 0;
}

/* ---- work and loss ---- */

void energy_work(struct energy *e, const struct way *w, int rail, const struct wheel_place *before, double F_before,
                 const struct wheel_place *now, double F_now)
{
    const struct newmark *m = &w->newmark;

    if (w->scheme == WAY_EXPLICIT) {
        const double done = w->step * F_now * lumped_sample(&w->lumped, rail, now, now->shape, w->lumped.v);
        e->step = done + (e->of == e->at ? e->step : 0);
        e->of = e->at;
        e->work += done;
    } else
        e->work += 0.5 * (F_before * newmark_moved(m, rail, before, before->shape) + F_now * newmark_moved(m, rail, now, now->shape));
}

/* c e'^2 h of springs between w and z + y roll. */
CLONES static void lose_in_pads(int64_t n, double h, const double *restrict vw, const double *restrict vz, const double *restrict vr,
                                const double *restrict y, const double *restrict c, double *restrict lost)
{
    for (int64_t i = 0; i < n; i++) {
        double e = vw[i] - vz[i] - y[i] * vr[i];
        lost[i] += c[i] * e * e * h;
    }
}

CLONES static void lose_in_ballast(int64_t n, double h, const double *restrict vz, const double *restrict vr, const double *restrict y,
                                   const double *restrict c, double *restrict lost)
{
    for (int64_t i = 0; i < n; i++) {
        double e = vz[i] + y[i] * vr[i];
        lost[i] += c[i] * e * e * h;
    }
}

/* F.(u - u0) */
static double work_of(const struct newmark *m, const struct head_place *p, const struct head_force *F)
{
    return F->Y * (direction_sample(&p->y, m->u) - direction_sample(&p->y, m->u0)) +
           F->M * (direction_sample(&p->twist, m->u) - direction_sample(&p->twist, m->u0));
}

void energy_work_head(struct energy *e, const struct way *w, const struct head_place *before, const struct head_force *F_before,
                      const struct head_place *now, const struct head_force *F_now)
{
    e->work += 0.5 * (work_of(&w->newmark, before, F_before) + work_of(&w->newmark, now, F_now));
}

static void lose_lumped(const struct way *w, double *lost)
{
    const struct lumped *l = &w->lumped;
    const int64_t k = l->stride, n = w->track->sleepers;
    const double *vz = l->v + LUMPED_Z * k, *vr = l->v + LUMPED_ROLL * k;

    for (int s = 0; s < 2; s++)
        lose_in_pads(n, w->step, l->v + (s ? LUMPED_WR : LUMPED_WL) * k, vz, vr, l->arm[s], l->pad_c[s], lost);
    for (int s = 0; s < 3; s++)
        lose_in_ballast(n, w->step, vz, vr, l->ballast_y[s], l->ballast_c[s], lost);
}

void energy_lose(struct energy *e, struct way *w)
{
    if (w->scheme == WAY_IMPLICIT)
        newmark_lose(&w->newmark, e->lost);
    else
        lose_lumped(w, e->lost);
    e->at++;
}

/* ---- the account ---- */

static double sum_of(int64_t n, const double *x)
{
    double sum = 0;

    for (int64_t i = 0; i < n; i++)
        sum += x[i];
    return sum;
}

/* Sums over the steps of a run from rest count its last instant in full, where integrals, by trapezia, have half of it. */
double energy_end(const struct energy *e, const struct way *w, double *work, double *left, double *lost)
{
    *work = e->work;
    *lost = sum_of(e->n, e->lost);
    *left = stored(w) - e->begun;
    if (w->scheme == WAY_EXPLICIT) {
        double *last = calloc((size_t)e->n, sizeof *last);
        if (last)
            lose_lumped(w, last);
        *work -= 0.5 * e->step;
        *lost -= last ? 0.5 * sum_of(e->n, last) : 0;
        free(last);
    }
    return fabs(*work - *left - *lost) / fmax(*lost, NOTHING);
}
