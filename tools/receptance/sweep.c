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
static const double ROUNDING = 1e-12;

/* m/N, of the places moved by the nodes alone; u [dofs][2] is work space. */
static const char *response(struct direct *d, const struct place *force, const struct place *motion, double frequency, double *u,
                            double complex *H)
{
    const char *why = direct_factor(d, 2 * M_PI * frequency * I);

    memset(u, 0, 2 * (size_t)d->track->dofs * sizeof *u);
    for (int k = 0; k < force->dofs; k++)
        u[2 * force->dof[k]] += force->share[k];
    if (why || (why = direct_solve(d, u)))
        return reason("at %g Hz: %s", frequency, why);
    for (int k = 0; k < motion->dofs; k++)
        *H += motion->share[k] * (u[2 * motion->dof[k]] + u[2 * motion->dof[k] + 1] * I);
    return NULL;
}

static void keep(double complex H, double complex factor, double *to)
{
    to[0] = creal(factor * H);
    to[1] = cimag(factor * H);
}

/* hermite, exact: [n][2], the second with what the element gives with held ends; frequency [n]. */
static const char *solve_all(const struct trk *t, const struct place *force, const struct place *motion, int quantity, int64_t n,
                             const double *frequency, double *hermite, double *exact)
{
    const double held = place_held(force, motion, t);
    struct direct d;
    const char *why = direct_new(&d, t);
    if (why)
        return why;
    double *u = calloc(2 * (size_t)t->dofs, sizeof *u);
    if (!u)
        why = REASON_MEMORY;
    for (int64_t i = 0; i < n && !why; i++) {
        double complex H = 0, factor = 1;
        for (int power = 0; power < quantity; power++)
            factor *= 2 * M_PI * frequency[i] * I;
        if ((why = response(&d, force, motion, frequency[i], u, &H)) == NULL) {
            keep(H, factor, &hermite[2 * i]);
            keep(H + held, factor, &exact[2 * i]);
        }
    }
    free(u);
    direct_free(&d);
    return why;
}

/* Whether the element's own deflection tells anywhere in hermite, exact [n][2]: not a rounding beside a node. */
static int differ(int64_t n, const double *hermite, const double *exact)
{
    for (int64_t i = 0; i < n; i++)
        if (hypot(exact[2 * i] - hermite[2 * i], exact[2 * i + 1] - hermite[2 * i + 1]) > ROUNDING * hypot(exact[2 * i], exact[2 * i + 1]))
            return 1;
    return 0;
}

static void name(const struct place *p, struct frf_place *to)
{
    snprintf(to->on, sizeof to->on, "%s", place_on[p->on]);
    snprintf(to->at, sizeof to->at, "%s", place_at[p->at]);
    to->x = p->x;
    to->lateral = p->lateral;
}

const char *sweep_places(struct frf *r, const struct trk *t, const struct place *force, const struct place *motion, int quantity,
                         const struct sweep *s)
{
    const double steps = floor((s->to - s->from) / s->step + 1e-9);
    struct place seen = *motion;

    memset(r, 0, sizeof *r);
    if (!(steps >= 0) || steps >= FREQUENCIES_MOST)
        return reason("from %g to %g Hz in steps of %g Hz is not a range of frequencies", s->from, s->to, s->step);
    if (motion->on == PLACE_BOTH)
        (motion->lateral ? place_find_lateral : place_find)(&seen, t, PLACE_LEFT, motion->at, motion->x);
    const int64_t n = (int64_t)steps + 1;
    double *frequency = calloc((size_t)n, 5 * sizeof *frequency);
    if (!frequency)
        return REASON_MEMORY;
    double *exact = frequency + n, *hermite = frequency + 3 * n;
    name(force, &r->force);
    name(&seen, &r->motion);
    r->quantity = quantity;
    r->store = frequency;
    r->n = n;
    r->frequency = frequency;
    r->H = exact;
    r->hermite = hermite;
    for (int64_t i = 0; i < n; i++)
        frequency[i] = s->from + (double)i * s->step;
    const char *why = solve_all(t, force, &seen, quantity, n, frequency, hermite, exact);
    r->hermites = !why && differ(n, hermite, exact) ? n : 0;
    return why;
}
