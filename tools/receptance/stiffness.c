/* K u = f by CHOLMOD, K factored once; between the nodes by Hermite's polynomials and the element with held ends. */
#include "tools/receptance/stiffness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/receptance/place.h"
#include "tools/track/cholesky.h"

const char *stiffness_stations(const struct trk *t, double every, int64_t *n, double **x)
{
    *n = (int64_t)floor((t->x[t->nodes - 1] - t->x[0]) / every + 1e-9) + 1;
    *x = calloc((size_t)*n, sizeof **x);
    for (int64_t i = 0; i < *n && *x; i++)
        (*x)[i] = t->x[0] + (double)i * every;
    return *x ? NULL : REASON_MEMORY;
}

static void load_place(const struct place *p, double load, double *f)
{
    for (int k = 0; k < p->dofs; k++)
        f[p->dof[k]] += load * p->share[k];
}

static double deflection(const struct place *p, const double *u)
{
    double w = 0;

    for (int k = 0; k < p->dofs; k++)
        w += p->share[k] * u[p->dof[k]];
    return w;
}

/* k [STIFFNESS_N] at x from the flexibilities of left and right: 1/F_ll, 1/F_rr, 1/(F_ll + F_lr), 1/(F_rr + F_lr). */
static const char *stiffness_at(struct cholesky *s, double x, double *u, double *k)
{
    struct place rail[TRK_RAILS];
    double F[TRK_RAILS][TRK_RAILS];

    for (int i = 0; i < TRK_RAILS; i++)
        place_find(&rail[i], s->track, i == TRK_LEFT ? PLACE_LEFT : PLACE_RIGHT, AT_STATION, x);
    for (int i = 0; i < TRK_RAILS; i++) {
        memset(u, 0, (size_t)s->track->dofs * sizeof *u);
        load_place(&rail[i], 1, u);
        const char *why = cholesky_solve(s, u, u);
        if (why)
            return why;
        for (int j = 0; j < TRK_RAILS; j++)
            F[i][j] = deflection(&rail[j], u) + place_held(&rail[i], &rail[j], s->track);
    }
    k[STIFFNESS_LEFT] = 1 / F[0][0];
    k[STIFFNESS_RIGHT] = 1 / F[1][1];
    k[STIFFNESS_LEFT_OF_BOTH] = 1 / (F[0][0] + F[1][0]);
    k[STIFFNESS_RIGHT_OF_BOTH] = 1 / (F[1][1] + F[0][1]);
    return NULL;
}

const char *stiffness_along(const struct trk *t, int64_t n, const double *x, double *k)
{
    struct cholesky s;
    double *u = calloc((size_t)t->dofs, sizeof *u);
    const char *why = u ? cholesky_new(&s, t) : REASON_MEMORY;

    if (!why) {
        for (int64_t i = 0; i < n && !why; i++)
            why = stiffness_at(&s, x[i], u, &k[i * STIFFNESS_N]);
        cholesky_free(&s);
    }
    free(u);
    return why;
}

/* m, of one rail at x. */
static double bowl_at(const struct trk *t, const double *u, int rail, double x, double load, int axles, const struct place *axle)
{
    struct place p;
    double w;

    place_find(&p, t, rail == TRK_LEFT ? PLACE_LEFT : PLACE_RIGHT, AT_STATION, x);
    w = deflection(&p, u);
    for (int k = 0; k < axles; k++)
        w += load * place_held(&axle[k], &p, t);
    return w;
}

const char *stiffness_bowl(const struct trk *t, int excite, double load, int axles, const double *axle, int64_t n, const double *x,
                           double *w)
{
    struct cholesky s;
    struct place *place = calloc((size_t)axles, sizeof *place);
    double *u = calloc((size_t)t->dofs, sizeof *u);
    const char *why = u && place ? cholesky_new(&s, t) : REASON_MEMORY;

    if (!why) {
        for (int k = 0; k < axles; k++) {
            place_find(&place[k], t, excite, AT_STATION, axle[k]);
            load_place(&place[k], load, u);
        }
        why = cholesky_solve(&s, u, u);
        cholesky_free(&s);
    }
    for (int64_t i = 0; i < n && !why; i++)
        for (int rail = 0; rail < TRK_RAILS; rail++)
            w[TRK_RAILS * i + rail] = bowl_at(t, u, rail, x[i], load, axles, place);
    free(u);
    free(place);
    return why;
}
