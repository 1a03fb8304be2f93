/* The load spread to the nodes of its element; the deflection under it adds the element's own.  On ballast that only pushes the ballast's
 * force is what it carries more than at rest. */
#include "tools/track/seat.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/track/equilibrium.h"

static void spread(const struct trk *t, const struct point *p, int excite, double load, double *f)
{
    for (int rail = 0; rail < TRK_RAILS; rail++) {
        int64_t dof[4];
        point_dofs(p, t, rail, dof);
        for (int k = 0; k < 4 && point_loads(excite, rail); k++)
            f[dof[k]] += load * p->shape[rail][k];
    }
}

/* m, of a railpad */
static double compress(const struct trk *t, int rail, int64_t sleeper, const double *u)
{
    const double *of = &u[t->sleeper_dof[sleeper]];

    return u[trk_rail_dof(t, rail, t->sleeper_node[sleeper])] - (of[TRK_Z] + trk_pad_arm(t, rail, sleeper) * of[TRK_ROLL]);
}

static void take(struct seat *s, const struct trk *t, const struct point *p, int excite, int rail, double load, const double *u)
{
    int64_t dof[4];

    point_dofs(p, t, rail, dof);
    *s = (struct seat){.deflection = (point_loads(excite, rail) ? load : 0) * p->compliance[rail]};
    for (int k = 0; k < 4; k++)
        s->deflection += p->shape[rail][k] * u[dof[k]];
    for (int64_t i = 0; i < t->sleepers; i++) {
        const double compression = compress(t, rail, i, u);
        const double force = t->pad_k[rail * t->sleepers + i] * compression;
        if (i == 0 || force > s->force) {
            s->force = force;
            s->compression = compression;
            s->number = t->sleeper_number[i];
        }
    }
}

const char *seat_load(struct seat *s, const struct trk *t, const struct point *p, int excite, double load)
{
    struct equilibrium rest;
    double *f = calloc((size_t)t->dofs, sizeof *f), *u = calloc((size_t)t->dofs, sizeof *u);
    const char *why = f && u ? equilibrium_new(&rest, t, EQUILIBRIUM_GRAVITY) : REASON_MEMORY;

    if (!why) {
        spread(t, p, excite, load, f);
        why = equilibrium_add(&rest, f, u);
        equilibrium_free(&rest);
    }
    for (int rail = 0; rail < TRK_RAILS && !why; rail++)
        take(&s[rail], t, p, excite, rail, load, u);
    free(f);
    free(u);
    return why;
}

/* N, of the ballast under a sleeper at e = z + y roll: k e, or beyond a gap k (e - gap) where it only pushes. */
static double push(const struct trk *t, int64_t sleeper, const double *u)
{
    double force = 0;

    for (int k = 0; k < TRK_BALLAST; k++) {
        const int64_t i = k * t->sleepers + sleeper;
        const double e = u[t->sleeper_dof[sleeper] + TRK_Z] + t->ballast_y[i] * u[t->sleeper_dof[sleeper] + TRK_ROLL];
        force += t->ballast_k[i] * (t->ballast_state[i] == TRK_BONDED ? e : fmax(e - t->ballast_gap[i], 0));
    }
    return force;
}

static int is_same(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fabs(a);
}

int seat_alike(const struct seat *a, const struct seat *b)
{
    return is_same(a->deflection, b->deflection) && is_same(a->force, b->force) && is_same(a->compression, b->compression);
}

const char *seat_bearers(const struct trk *t, int excite, double load, int axles, const double *axle, double *force)
{
    struct equilibrium e;
    double *f = calloc((size_t)t->dofs, sizeof *f), *u = calloc((size_t)t->dofs, sizeof *u);
    const char *why = f && u ? equilibrium_new(&e, t, EQUILIBRIUM_GRAVITY) : REASON_MEMORY;

    if (!why) {
        for (int k = 0; k < axles; k++) {
            struct point p;
            point_at(&p, t, axle[k]);
            spread(t, &p, excite, load, f);
        }
        why = equilibrium_add(&e, f, u);
        for (int64_t i = 0; i < t->sleepers && !why; i++) {
            double *to = &force[i * SEAT_BEARS];
            to[SEAT_NUMBER] = (double)t->sleeper_number[i];
            for (int rail = 0; rail < TRK_RAILS; rail++)
                to[SEAT_LEFT + rail] = t->pad_k[rail * t->sleepers + i] * compress(t, rail, i, u);
            to[SEAT_BALLAST] = -push(t, i, e.rest);
            for (int64_t d = t->sleeper_dof[i]; d <= t->sleeper_dof[i] + TRK_ROLL; d++)
                u[d] += e.rest[d];
            to[SEAT_BALLAST] += push(t, i, u);
        }
        equilibrium_free(&e);
    }
    free(f);
    free(u);
    return why;
}
