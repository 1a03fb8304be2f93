/* K u = f by CHOLMOD, K factored once, or the equilibrium on ballast that only pushes; between the nodes by Hermite's polynomials and the
 * element with held ends. */
#include "tools/receptance/stiffness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/receptance/place.h"
#include "tools/track/equilibrium.h"

const char *stiffness_stations(const struct trk *t, double every, int64_t *n, double **x)
{
    *n = (int64_t)floor((t->x[t->nodes - 1] - t->x[0]) / every + 1e-9) + 1;
    *x = calloc((size_t)*n, sizeof **x);
    for (int64_t i = 0; i < *n && *x; i++)
        (*x)[i] = t->x[0] + (double)i * every;
    return *x ? NULL : REASON_MEMORY;
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
        place_load(&rail[i], 1, u);
        const char *why = cholesky_solve(s, u, u);
        if (why)
            return why;
        for (int j = 0; j < TRK_RAILS; j++)
            F[i][j] = place_motion(&rail[j], u) + place_held(&rail[i], &rail[j], s->track);
    }
    k[STIFFNESS_LEFT] = 1 / F[0][0];
    k[STIFFNESS_RIGHT] = 1 / F[1][1];
    k[STIFFNESS_LEFT_OF_BOTH] = 1 / (F[0][0] + F[1][0]);
    k[STIFFNESS_RIGHT_OF_BOTH] = 1 / (F[1][1] + F[0][1]);
    return NULL;
}

static const char *along_tangent(const struct trk *t, int64_t n, const double *x, double *k)
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

/* k [STIFFNESS_N] at x under this load on left, right and both: it is not the sum of the first two. */
static const char *stiffness_under(struct equilibrium *e, double load, double x, double *f, double *u, double *k)
{
    static const int on[] = {PLACE_LEFT, PLACE_RIGHT, PLACE_BOTH};
    static const int told[][TRK_RAILS] = {{STIFFNESS_LEFT, -1}, {-1, STIFFNESS_RIGHT}, {STIFFNESS_LEFT_OF_BOTH, STIFFNESS_RIGHT_OF_BOTH}};

    for (int i = 0; i < 3; i++) {
        struct place force, seen;
        memset(f, 0, (size_t)e->track->dofs * sizeof *f);
        place_find(&force, e->track, on[i], AT_STATION, x);
        place_load(&force, load, f);
        const char *why = equilibrium_add(e, f, u);
        if (why)
            return why;
        for (int rail = 0; rail < TRK_RAILS; rail++)
            if (told[i][rail] >= 0) {
                place_find(&seen, e->track, on[rail], AT_STATION, x);
                k[told[i][rail]] = load / (place_motion(&seen, u) + load * place_held(&force, &seen, e->track));
            }
    }
    return NULL;
}

const char *stiffness_along(const struct trk *t, double load, int64_t n, const double *x, double *k)
{
    struct equilibrium e;
    double *f = calloc((size_t)t->dofs, sizeof *f), *u = calloc((size_t)t->dofs, sizeof *u);
    const char *why = f && u ? NULL : REASON_MEMORY;

    if (!why && !(load > 0))
        why = along_tangent(t, n, x, k);
    else if (!why && !(why = equilibrium_new(&e, t, EQUILIBRIUM_GRAVITY))) {
        for (int64_t i = 0; i < n && !why; i++)
            why = stiffness_under(&e, load, x[i], f, u, &k[i * STIFFNESS_N]);
        equilibrium_free(&e);
    }
    free(f);
    free(u);
    return why;
}

/* m, of one rail at x. */
static double bowl_at(const struct trk *t, const double *u, int rail, double x, double load, int axles, const struct place *axle)
{
    struct place p;
    double w;

    place_find(&p, t, rail == TRK_LEFT ? PLACE_LEFT : PLACE_RIGHT, AT_STATION, x);
    w = place_motion(&p, u);
    for (int k = 0; k < axles; k++)
        w += load * place_held(&axle[k], &p, t);
    return w;
}

const char *stiffness_bowl(const struct trk *t, int excite, double load, int axles, const double *axle, int64_t n, const double *x,
                           double *w)
{
    struct equilibrium e;
    struct place *place = calloc((size_t)axles, sizeof *place);
    double *f = calloc((size_t)t->dofs, sizeof *f), *u = calloc((size_t)t->dofs, sizeof *u);
    const char *why = f && u && place ? equilibrium_new(&e, t, EQUILIBRIUM_GRAVITY) : REASON_MEMORY;

    if (!why) {
        for (int k = 0; k < axles; k++) {
            place_find(&place[k], t, excite, AT_STATION, axle[k]);
            place_load(&place[k], load, f);
        }
        why = equilibrium_add(&e, f, u);
        equilibrium_free(&e);
    }
    for (int64_t i = 0; i < n && !why; i++)
        for (int rail = 0; rail < TRK_RAILS; rail++)
            w[TRK_RAILS * i + rail] = bowl_at(t, u, rail, x[i], load, axles, place);
    free(f);
    free(u);
    free(place);
    return why;
}
