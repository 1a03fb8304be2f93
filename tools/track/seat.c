/* The load spread to the nodes of its element; the deflection under it adds the element's own. */
#include "tools/track/seat.h"

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

static void take(struct seat *s, const struct trk *t, const struct point *p, int rail, double load, const double *u)
{
    int64_t dof[4];

    point_dofs(p, t, rail, dof);
    *s = (struct seat){.deflection = load * p->compliance[rail]};
    for (int k = 0; k < 4; k++)
        s->deflection += p->shape[rail][k] * u[dof[k]];
    for (int64_t i = 0; i < t->sleepers; i++) {
        double arm = trk_pad_arm(t, rail, i);
        double compression = u[trk_rail_dof(t, rail, t->sleeper_node[i])] - (u[t->sleeper_dof[i]] + arm * u[t->sleeper_dof[i] + 1]);
        double force = t->pad_k[rail * t->sleepers + i] * compression;
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
    if (!why)
        take(s, t, p, point_rail(excite), load, u);
    free(f);
    free(u);
    return why;
}
