#include "tools/integrate/follow.h"
#include "formats/reason.h"

#include <string.h>

/* [rows][1] to [rows][n] */
static const double *repeat(struct trk *t, const double *x, int64_t rows, int64_t n)
{
    double *y = trk_room(t, rows * n, sizeof *y);

    for (int64_t i = 0; i < rows * n && y; i++)
        y[i] = x[i / n];
    return y;
}

static const int64_t *repeat_whole(struct trk *t, const int64_t *x, int64_t rows, int64_t n)
{
    int64_t *y = trk_room(t, rows * n, sizeof *y);

    for (int64_t i = 0; i < rows * n && y; i++)
        y[i] = x[i / n];
    return y;
}

/* from, from + step, ... [n] */
static const int64_t *count(struct trk *t, int64_t n, int64_t from, int64_t step)
{
    int64_t *y = trk_room(t, n, sizeof *y);

    for (int64_t i = 0; i < n && y; i++)
        y[i] = from + i * step;
    return y;
}

/* Wheelsets from the front one; an idle copy behind them. */
static const double *stations(struct trk *t, const struct veh *v)
{
    double *x = trk_room(t, t->sleepers, sizeof *x);

    for (int64_t i = 0; i < t->sleepers && x; i++)
        x[i] = i < v->wheelsets ? v->cg[3 * v->wheelset[i]] : (i ? x[i - 1] : 0) - 1;
    return x;
}

static int repeat_parts(struct trk *t, const struct trk *one, const struct veh *v)
{
    const int64_t n = t->sleepers;
    const double *none = trk_room(t, TRK_RAILS * n, sizeof *none);

    t->x = t->sleeper_x = stations(t, v);
    t->rail_shear = t->rail_density = t->rail_rotary = none;
    t->rail_mass = repeat(t, (double[]){*one->running_m, *one->running_m}, TRK_RAILS, n);
    t->rail_inertia = repeat(t, one->rail_inertia, TRK_RAILS, n);
    t->sleeper_node = count(t, n, 0, 1);
    t->sleeper_number = count(t, n, 1, 1);
    t->sleeper_mass = repeat(t, one->sleeper_mass, 1, n);
    t->sleeper_inertia = repeat(t, one->sleeper_inertia, 1, n);
    t->sleeper_y = repeat(t, one->sleeper_y, 1, n);
    t->pad_k = repeat(t, one->pad_k, TRK_RAILS, n);
    t->pad_c = repeat(t, one->pad_c, TRK_RAILS, n);
    t->ballast_k = repeat(t, one->ballast_k, TRK_BALLAST, n);
    t->ballast_c = repeat(t, one->ballast_c, TRK_BALLAST, n);
    t->ballast_y = repeat(t, one->ballast_y, TRK_BALLAST, n);
    t->ballast_gap = repeat(t, one->ballast_gap, TRK_BALLAST, n);
    t->ballast_state = repeat_whole(t, one->ballast_state, TRK_BALLAST, n);
    t->pad_zone = repeat_whole(t, one->pad_zone, TRK_RAILS, n);
    t->node_dof = count(t, n, *one->node_dof, one->dofs);
    t->sleeper_dof = count(t, n, *one->sleeper_dof, one->dofs);
    return none && t->x && t->rail_mass && t->rail_inertia && t->sleeper_node && t->sleeper_number && t->sleeper_mass && t->sleeper_inertia &&
           t->sleeper_y && t->pad_k && t->pad_c && t->ballast_k && t->ballast_c && t->ballast_y && t->ballast_gap && t->ballast_state &&
           t->pad_zone && t->node_dof && t->sleeper_dof;
}

/* A block for each copy. */
static int repeat_matrices(struct trk *t, const struct trk *one)
{
    const int64_t n = t->sleepers, entries = one->Ap[one->dofs];
    int64_t *Ap = trk_room(t, t->dofs + 1, sizeof *Ap), *Ai = trk_room(t, n * entries, sizeof *Ai);
    double *K = trk_room(t, n * entries, sizeof *K), *C = trk_room(t, n * entries, sizeof *C), *M = trk_room(t, n * entries, sizeof *M);

    if (!Ap || !Ai || !K || !C || !M)
        return 0;
    for (int64_t i = 0; i < n; i++) {
        for (int64_t j = 0; j < one->dofs; j++)
            Ap[i * one->dofs + j] = i * entries + one->Ap[j];
        for (int64_t p = 0; p < entries; p++)
            Ai[i * entries + p] = i * one->dofs + one->Ai[p];
        memcpy(K + i * entries, one->Kx, (size_t)entries * sizeof *K);
        memcpy(C + i * entries, one->Cx, (size_t)entries * sizeof *C);
        memcpy(M + i * entries, one->Mx, (size_t)entries * sizeof *M);
    }
    Ap[t->dofs] = n * entries;
    for (int64_t k = 0; k < TRK_RAILS * n; k++) {
        const int64_t w = t->node_dof[k / TRK_RAILS] + k % TRK_RAILS * t->rail_dofs;
        for (int64_t p = Ap[w]; p < Ap[w + 1]; p++)
            M[p] = Ai[p] == w ? *one->running_m : 0;
    }
    t->Ap = Ap;
    t->Ai = Ai;
    t->Kx = K;
    t->Cx = C;
    t->Mx = M;
    return 1;
}

const char *follow_train(struct trk *t, const struct trk *one, const struct veh *v)
{
    *t = *one;
    t->store = NULL;
    t->nodes = t->sleepers = v->wheelsets < 2 ? 2 : v->wheelsets;
    t->dofs = t->sleepers * one->dofs;
    if (repeat_parts(t, one, v) && repeat_matrices(t, one))
        return NULL;
    trk_free(t);
    return REASON_MEMORY;
}

/* An element has two ends: the last copy is the far one. */
struct wheel_place follow_find(int64_t n, int64_t i)
{
    const int far = i == n - 1;
    struct wheel_place p = {.node = far ? i - 1 : i};

    p.shape[far ? 2 : 0] = 1;
    return p;
}
