/* The arrays of the track with lumped masses, from those of a .trk, and states to and fro. */
#include "tools/integrate/lumped.h"
#include "formats/reason.h"
#include "tools/integrate/arrays.h"
#include "tools/track/rails.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void place_arrays(struct lumped *l, struct arrays *a)
{
    const int64_t n = l->stride, all = LUMPED_PARTS * n;

    l->u = arrays_take(a, all);
    l->v = arrays_take(a, all);
    l->a = arrays_take(a, all);
    l->before = arrays_take(a, all);
    l->inverse = arrays_take(a, all);
    for (int s = 0; s < 2; s++) {
        l->pad[s] = arrays_take(a, n);
        l->k12[s] = arrays_take(a, n);
        l->k6[s] = arrays_take(a, n);
        l->k4[s] = arrays_take(a, n);
        l->taper_6[s] = arrays_take(a, n);
        l->taper_near[s] = arrays_take(a, n);
        l->taper_far[s] = arrays_take(a, n);
        l->shear[s] = arrays_take(a, n + LUMPED_LANES);
        l->near[s] = arrays_take(a, n + LUMPED_LANES);
        l->far[s] = arrays_take(a, n + LUMPED_LANES);
        l->pad_k[s] = arrays_take(a, n);
        l->pad_c[s] = arrays_take(a, n);
        l->arm[s] = arrays_take(a, n);
    }
    for (int s = 0; s < 3; s++) {
        l->ballast[s] = arrays_take(a, n);
        l->ballast_k[s] = arrays_take(a, n);
        l->ballast_c[s] = arrays_take(a, n);
        l->ballast_y[s] = arrays_take(a, n);
        l->gap[s] = arrays_take(a, n);
        l->floor[s] = arrays_take(a, n);
    }
}

/* K = [w -c1 -w -c2; . n c1 f; . . w c2; . . . m]: what is alike at both ends into k12, k6, k4, the rest into the taper. */
static void set_tapered(struct lumped *l, int s, int64_t i)
{
    double K[4][4];

    beam_stiffness(&l->beam[s][i], K);
    l->k12[s][i] = K[0][0];
    l->k6[s][i] = -0.5 * (K[0][1] + K[0][3]);
    l->k4[s][i] = 2 * K[1][3];
    l->taper_6[s][i] = -0.5 * (K[0][1] - K[0][3]);
    l->taper_near[s][i] = K[1][1] - 2 * K[1][3];
    l->taper_far[s][i] = K[3][3] - 2 * K[1][3];
    l->tapered[s] = 1;
}

static void set_rail(struct lumped *l, int s)
{
    const struct trk *t = l->track;
    double *w = l->inverse + (s ? LUMPED_WR : LUMPED_WL) * l->stride;
    double *p = l->inverse + (s ? LUMPED_TR : LUMPED_TL) * l->stride;

    for (int64_t i = 0; i < l->n; i++) {
        w[i] = 1 / t->rail_mass[s * l->n + i];
        p[i] = 1 / t->rail_inertia[s * l->n + i];
    }
    for (int64_t i = 0; i + 1 < l->n; i++) {
        const struct beam b = l->beam[s][i] = rails_beam(t, s, i);
        const double EI = b.bending, L = b.length;
        if (!(EI > 0))
            set_tapered(l, s, i);
        else {
            l->k12[s][i] = 12 * EI / (L * L * L);
            l->k6[s][i] = 6 * EI / (L * L);
            l->k4[s][i] = 4 * EI / L;
        }
    }
}

/* The explicit scheme's rails: mass at the nodes alone, Euler-Bernoulli, a node above every sleeper. */
static int is_lumped(const struct trk *t)
{
    int same = t->nodes == t->sleepers && t->nodes >= 2;

    for (int64_t k = 0; k < TRK_RAILS * (t->nodes - 1); k++)
        same &= t->rail_density[k] <= 0 && t->rail_rotary[k] <= 0 && t->rail_shear[k] <= 0;
    for (int64_t k = 0; k < TRK_RAILS * t->nodes; k++)
        same &= t->rail_mass[k] > 0 && t->rail_inertia[k] > 0;
    return same;
}

static void set_sleepers(struct lumped *l)
{
    const struct trk *t = l->track;

    for (int64_t i = 0; i < l->n; i++) {
        l->inverse[LUMPED_Z * l->stride + i] = 1 / t->sleeper_mass[i];
        l->inverse[LUMPED_ROLL * l->stride + i] = 1 / t->sleeper_inertia[i];
        for (int s = 0; s < 2; s++) {
            l->pad_k[s][i] = t->pad_k[s * l->n + i];
            l->pad_c[s][i] = t->pad_c[s * l->n + i];
            l->arm[s][i] = trk_pad_arm(t, s, i);
        }
        for (int s = 0; s < 3; s++) {
            l->ballast_k[s][i] = t->ballast_k[s * l->n + i];
            l->ballast_c[s][i] = t->ballast_c[s * l->n + i];
            l->ballast_y[s][i] = t->ballast_y[s * l->n + i];
            l->gap[s][i] = t->ballast_gap[s * l->n + i];
            const int bonded = t->ballast_state[s * l->n + i] == TRK_BONDED;
            l->floor[s][i] = bonded ? -HUGE_VAL : 0;
            l->pushes[s] |= !bonded;
        }
    }
}

const char *lumped_new(struct lumped *l, const struct trk *t, double gravity)
{
    struct arrays a = {0};

    *l = (struct lumped){.track = t, .n = t->sleepers, .gravity = gravity};
    l->stride = (t->sleepers + LUMPED_LANES - 1) / LUMPED_LANES * LUMPED_LANES;
    if (trk_is_spatial(t))
        return "the explicit scheme does not move rails sideways: dofs: vertical, or the implicit one";
    if (!is_lumped(t))
        return "the explicit scheme wants lumped Euler-Bernoulli rails with one rail node above every sleeper: mass_model: lumped, beam: euler, "
               "elements_per_bay: 1";
    place_arrays(l, &a);
    if (!(l->store = calloc(a.used + LUMPED_LANES, sizeof *l->store)))
        return REASON_MEMORY;
    a.base = l->store + (LUMPED_LANES - (uintptr_t)l->store / sizeof *l->store % LUMPED_LANES) % LUMPED_LANES; /* a vector lies in one line of the cache */
    a.used = 0;
    place_arrays(l, &a);
    l->beam[0] = calloc(2 * (size_t)l->n, sizeof *l->beam[0]);
    if (!l->beam[0]) {
        lumped_free(l);
        return REASON_MEMORY;
    }
    l->beam[1] = l->beam[0] + l->n;
    for (int s = 0; s < 2; s++)
        set_rail(l, s);
    set_sleepers(l);
    return NULL;
}

void lumped_free(struct lumped *l)
{
    free(l->store);
    free(l->beam[0]);
    *l = (struct lumped){0};
}

void lumped_set(struct lumped *l, const double *u)
{
    const struct trk *t = l->track;

    memset(l->v, 0, (size_t)(LUMPED_PARTS * l->stride) * sizeof *l->v);
    for (int64_t i = 0; i < t->nodes; i++)
        for (int part = LUMPED_WL; part <= LUMPED_TR; part++)
            l->u[part * l->stride + i] = u[t->node_dof[i] + part];
    for (int64_t i = 0; i < t->sleepers; i++)
        for (int part = LUMPED_Z; part <= LUMPED_ROLL; part++)
            l->u[part * l->stride + i] = u[t->sleeper_dof[i] + part - LUMPED_Z];
}

void lumped_state(const struct lumped *l, const double *state, double *x)
{
    const struct trk *t = l->track;

    for (int64_t i = 0; i < t->nodes; i++)
        for (int part = LUMPED_WL; part <= LUMPED_TR; part++)
            x[t->node_dof[i] + part] = state[part * l->stride + i];
    for (int64_t i = 0; i < t->sleepers; i++)
        for (int part = LUMPED_Z; part <= LUMPED_ROLL; part++)
            x[t->sleeper_dof[i] + part - LUMPED_Z] = state[part * l->stride + i];
}
