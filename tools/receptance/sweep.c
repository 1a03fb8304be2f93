/* (K + i omega C - omega^2 M) u = f at each frequency.  Between the nodes f and the response follow Hermite's polynomials, which
 * is equation 7 of Lau and Hoff 2018; the massless element adds its deflection with held ends, L^3/192EI in the middle. */
#include "tools/receptance/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/receptance/direct.h"

static const double FREQUENCIES_MOST = 1e7;

/* u [dofs][2]: a unit force on each loaded rail. */
static void load(const struct trk *t, const struct point *p, int excite, double *u)
{
    memset(u, 0, 2 * (size_t)t->dofs * sizeof *u);
    for (int rail = 0; rail < TRK_RAILS; rail++) {
        int64_t dof[4];
        point_dofs(p, t, rail, dof);
        for (int k = 0; k < 4 && point_loads(excite, rail); k++)
            u[2 * dof[k]] += p->shape[k];
    }
}

/* H [2], m/N: real and imaginary part; u [dofs][2] is work space. */
static const char *response(struct direct *d, const struct point *p, int excite, double frequency, double *u, double *H)
{
    int64_t dof[4];
    const char *why = direct_factor(d, 2 * M_PI * frequency * I);

    load(d->track, p, excite, u);
    if (why || (why = direct_solve(d, u)))
        return reason("at %g Hz: %s", frequency, why);
    point_dofs(p, d->track, point_rail(excite), dof);
    for (int c = 0; c < 2; c++) {
        H[c] = 0;
        for (int k = 0; k < 4; k++)
            H[c] += p->shape[k] * u[2 * dof[k] + c];
    }
    return NULL;
}

/* hermite, exact: [n][2], the second with the compliance of the element; frequency [n]. */
static const char *solve_all(const struct trk *t, const struct point *p, int excite, int64_t n, const double *frequency,
                             double *hermite, double *exact)
{
    struct direct d;
    const char *why = direct_new(&d, t);
    if (why)
        return why;
    double *u = calloc(2 * (size_t)t->dofs, sizeof *u);
    if (!u)
        why = REASON_MEMORY;
    for (int64_t i = 0; i < n && !why; i++) {
        why = response(&d, p, excite, frequency[i], u, &hermite[2 * i]);
        exact[2 * i] = hermite[2 * i] + p->compliance[point_rail(excite)];
        exact[2 * i + 1] = hermite[2 * i + 1];
    }
    free(u);
    direct_free(&d);
    return why;
}

const char *sweep_point(struct frf *r, const struct trk *t, const struct point *p, int at, int excite, const struct sweep *s)
{
    static const char *const excites[] = {"left", "right", "both"}, *const ats[] = {"sleeper", "midspan"};
    const double steps = floor((s->to - s->from) / s->step + 1e-9);

    memset(r, 0, sizeof *r);
    if (!(steps >= 0) || steps >= FREQUENCIES_MOST)
        return reason("from %g to %g Hz in steps of %g Hz is not a range of frequencies", s->from, s->to, s->step);
    const int64_t n = (int64_t)steps + 1;
    double *frequency = calloc((size_t)n, 5 * sizeof *frequency);
    if (!frequency)
        return REASON_MEMORY;
    double *exact = frequency + n, *hermite = frequency + 3 * n;
    snprintf(r->excite, sizeof r->excite, "%s", excites[excite]);
    snprintf(r->at, sizeof r->at, "%s", ats[at]);
    r->store = frequency;
    r->x = p->x;
    r->n = n;
    r->frequency = frequency;
    r->receptance = exact;
    r->hermite = hermite;
    r->hermites = p->compliance[point_rail(excite)] > 0 ? n : 0;
    for (int64_t i = 0; i < n; i++)
        frequency[i] = s->from + (double)i * s->step;
    return solve_all(t, p, excite, n, frequency, hermite, exact);
}
