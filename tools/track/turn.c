#include "tools/track/turn.h"
#include "formats/reason.h"

#include <math.h>
#include <stdlib.h>

#define EVERYWHERE 1e9    /* m, before all that is run over */

/* Signs of degrees of freedom, in their order. */
static const double rail_sign[TRK_SPATIAL_RAIL] = {[TRK_W] = 1, [TRK_PITCH] = -1, [TRK_Y] = -1, [TRK_YAW] = 1, [TRK_TWIST] = -1};
static const double sleeper_sign[TRK_SPATIAL_SLEEPER] = {[TRK_Z] = 1, [TRK_ROLL] = -1, [TRK_SLEEPER_Y] = -1, [TRK_SLEEPER_YAW] = 1};

/* [rows][n]: rows and columns in the opposite order, times sign; NULL stays NULL. */
static int reverse(struct trk *t, const double **x, int64_t rows, int64_t n, double sign)
{
    const double *from = *x;
    double *to = trk_room(t, rows * n, sizeof *to);

    if (!from || !to)
        return !from;
    for (int64_t i = 0; i < rows * n; i++)
        to[i] = sign * from[rows * n - 1 - i];
    *x = to;
    return 1;
}

/* The same of whole numbers; of places counted from the last one, where last is not negative. */
static int reverse_whole(struct trk *t, const int64_t **x, int64_t rows, int64_t n, int64_t last)
{
    const int64_t *from = *x;
    int64_t *to = trk_room(t, rows * n, sizeof *to);

    if (!from || !to)
        return !from;
    for (int64_t i = 0; i < rows * n; i++)
        to[i] = last < 0 ? from[rows * n - 1 - i] : last - from[rows * n - 1 - i];
    *x = to;
    return 1;
}

static int turn_rails(struct trk *t)
{
    const int64_t n = t->nodes;

    return reverse(t, &t->x, 1, n, -1) && reverse(t, &t->bending_x, 1, t->knots, -1) && reverse(t, &t->bending, 2, t->knots, 1) &&
           reverse(t, &t->rail_shear, 2, n - 1, 1) && reverse(t, &t->rail_mass, 2, n, 1) && reverse(t, &t->rail_inertia, 2, n, 1) &&
           reverse(t, &t->rail_density, 2, n - 1, 1) && reverse(t, &t->rail_rotary, 2, n - 1, 1) &&
           reverse(t, &t->rail_yaw, 2, n, 1) && reverse(t, &t->rail_twist, 2, n, 1) && reverse(t, &t->rail_lateral_shear, 2, n - 1, 1) &&
           reverse(t, &t->rail_lateral_rotary, 2, n - 1, 1) && reverse(t, &t->rail_torsion, 2, n - 1, 1) &&
           reverse(t, &t->rail_polar, 2, n - 1, 1) && reverse(t, &t->lateral_bending_x, 1, t->lateral_knots, -1) &&
           reverse(t, &t->lateral_bending, 2, t->lateral_knots, 1);
}

static int turn_sleepers(struct trk *t)
{
    const int64_t n = t->sleepers;

    return reverse(t, &t->sleeper_x, 1, n, -1) && reverse_whole(t, &t->sleeper_node, 1, n, t->nodes - 1) &&
           reverse_whole(t, &t->sleeper_number, 1, n, -1) && reverse(t, &t->sleeper_mass, 1, n, 1) &&
           reverse(t, &t->sleeper_inertia, 1, n, 1) && reverse(t, &t->sleeper_y, 1, n, -1) && reverse(t, &t->pad_k, 2, n, 1) &&
           reverse(t, &t->pad_c, 2, n, 1) && reverse(t, &t->ballast_k, TRK_BALLAST, n, 1) && reverse(t, &t->ballast_c, TRK_BALLAST, n, 1) &&
           reverse(t, &t->ballast_y, TRK_BALLAST, n, -1) && reverse(t, &t->ballast_gap, TRK_BALLAST, n, 1) &&
           reverse_whole(t, &t->ballast_state, TRK_BALLAST, n, -1) && reverse_whole(t, &t->pad_zone, 2, n, -1) &&
           reverse(t, &t->sleeper_yaw, 1, n, 1) && reverse(t, &t->pad_lateral_k, 2, n, 1) && reverse(t, &t->pad_lateral_c, 2, n, 1) &&
           reverse(t, &t->ballast_lateral_k, 1, n, 1) && reverse(t, &t->ballast_lateral_c, 1, n, 1) &&
           reverse(t, &t->ballast_yaw_k, 1, n, 1) && reverse(t, &t->ballast_yaw_c, 1, n, 1);
}

static int turn_check_rail(struct trk *t)
{
    int64_t *side = trk_room(t, 1, sizeof *side);

    if (!side)
        return 0;
    *side = *t->check_rail == TRK_LEFT ? TRK_RIGHT : TRK_LEFT;
    t->check_rail = side;
    return reverse(t, &t->check_x, 1, t->checks, -1) && reverse(t, &t->check_play, 1, t->checks, 1) &&
           reverse_whole(t, &t->check_node, 1, t->check_nodes, t->nodes - 1) && reverse(t, &t->check_y, 1, 1, -1);
}

/* Pieces of curvature, the last one without end: [x0 k0] [x1 k1] ... becomes [-far -k_last] ... [-x1 -k0] [-x0 0]. */
static int turn_curves(struct trk *t, const struct trk *from)
{
    const int64_t n = from->curves;
    double *x = trk_room(t, n + 1, sizeof *x), *k = trk_room(t, n + 1, sizeof *k);

    if (!x || !k)
        return 0;
    for (int64_t i = 0; i < n; i++) {
        x[n - i] = -from->curve_x[i];
        k[n - 1 - i] = -from->curvature[i];
    }
    x[0] = -EVERYWHERE;
    t->curves = n ? n + 1 : 0;
    t->curve_x = x;
    t->curvature = k;
    return reverse(t, &t->cant_x, 1, t->cants, -1) && reverse(t, &t->cant, 1, t->cants, -1);
}

/* ---- degrees of freedom ---- */

struct order {
    int64_t n;          /* numbered so far */
    int64_t *old;       /* [dofs] by new number */
    int64_t *new;       /* [dofs] by old number */
    double *sign;       /* [dofs] by new number */
};

static int64_t number(struct order *o, int64_t first, int64_t count, const double *sign)
{
    const int64_t begun = o->n;

    for (int64_t k = 0; k < count; k++) {
        o->old[o->n] = first + k;
        o->new[first + k] = o->n;
        o->sign[o->n++] = sign[k];
    }
    return begun;
}

/* By node the left rail, the right rail, the check rail and the sleeper. */
static int renumber(struct trk *t, const struct trk *from, struct order *o)
{
    int64_t *node = trk_room(t, t->nodes, sizeof *node), *sleeper = trk_room(t, t->sleepers, sizeof *sleeper);
    int64_t *check = trk_room(t, t->check_nodes, sizeof *check), s = t->sleepers - 1, c = t->check_nodes - 1;

    if (!node || !sleeper || !check)
        return 0;
    for (int64_t i = t->nodes - 1; i >= 0; i--) {
        node[t->nodes - 1 - i] = number(o, trk_rail_dof(from, TRK_RIGHT, i), t->rail_dofs, rail_sign);
        number(o, trk_rail_dof(from, TRK_LEFT, i), t->rail_dofs, rail_sign);
        for (; c >= 0 && from->check_node[c] == i; c--)
            check[t->check_nodes - 1 - c] = number(o, from->check_dof[c], t->rail_dofs, rail_sign);
        for (; s >= 0 && from->sleeper_node[s] == i; s--)
            sleeper[t->sleepers - 1 - s] = number(o, from->sleeper_dof[s], t->sleeper_dofs, sleeper_sign);
    }
    t->node_dof = node;
    t->sleeper_dof = sleeper;
    t->check_dof = from->check_dof ? check : NULL;
    return o->n == t->dofs;
}

struct matrices { int64_t *p, *i; double *K, *C, *M; };

/* Row r of column j comes after those before it, in order of rows. */
static void insert(struct matrices *to, int64_t begun, int64_t end, int64_t r, const double v[3])
{
    for (; end > begun && to->i[end - 1] > r; end--) {
        to->i[end] = to->i[end - 1];
        to->K[end] = to->K[end - 1];
        to->C[end] = to->C[end - 1];
        to->M[end] = to->M[end - 1];
    }
    to->i[end] = r;
    to->K[end] = v[0];
    to->C[end] = v[1];
    to->M[end] = v[2];
}

static int turn_matrices(struct trk *t, const struct trk *from, const struct order *o)
{
    const int64_t n = from->Ap[from->dofs];
    struct matrices to = {trk_room(t, t->dofs + 1, sizeof *to.p), trk_room(t, n, sizeof *to.i), trk_room(t, n, sizeof *to.K),
                          trk_room(t, n, sizeof *to.C), trk_room(t, n, sizeof *to.M)};

    if (!to.p || !to.i || !to.K || !to.C || !to.M)
        return 0;
    for (int64_t j = 0; j < t->dofs; j++) {
        int64_t end = to.p[j];
        for (int64_t q = from->Ap[o->old[j]]; q < from->Ap[o->old[j] + 1]; q++) {
            const int64_t r = o->new[from->Ai[q]];
            const double s = o->sign[j] * o->sign[r], v[3] = {s * from->Kx[q], s * from->Cx[q], s * from->Mx[q]};
            insert(&to, to.p[j], end++, r, v);
        }
        to.p[j + 1] = end;
    }
    t->Ap = to.p;
    t->Ai = to.i;
    t->Kx = to.K;
    t->Cx = to.C;
    t->Mx = to.M;
    return 1;
}

const char *turn_track(struct trk *t, const struct trk *from)
{
    const size_t n = (size_t)from->dofs;
    struct order o = {0, calloc(n, sizeof *o.old), calloc(n, sizeof *o.new), calloc(n, sizeof *o.sign)};

    *t = *from;
    t->store = NULL;
    const int done = o.old && o.new && o.sign && renumber(t, from, &o) && turn_matrices(t, from, &o) && turn_rails(t) && turn_sleepers(t) &&
                     turn_check_rail(t) && turn_curves(t, from);
    free(o.old);
    free(o.new);
    free(o.sign);
    if (done)
        return NULL;
    trk_free(t);
    return REASON_MEMORY;
}
