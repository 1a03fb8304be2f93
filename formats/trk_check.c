/* The checks at the door, so that kernels need none. */
#include "formats/trk_check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

static const double SAME_STATION = 1e-6;   /* m, sleeper and rail node above it */
static const double SYMMETRY = 1e-9;       /* of a matrix, relative to its largest entry */

static const char *increasing(const char *name, const double *x, int64_t n)
{
    for (int64_t i = 1; i < n; i++)
        if (!(x[i] > x[i - 1]))
            return reason("array %s: not increasing at %lld", name, (long long)i);
    return NULL;
}

static const char *at_least(const char *name, const double *x, int64_t n, double least, int may_equal)
{
    for (int64_t i = 0; i < n; i++)
        if (x[i] < least || (!may_equal && x[i] <= least))
            return reason("array %s: %g at %lld must be %s %g", name, x[i], (long long)i, may_equal ? "at least" : "above", least);
    return NULL;
}

static const char *check_numbers(const struct trk *t)
{
    const int64_t n = t->nodes, s = t->sleepers;
    const char *why;

    (void)((why = increasing("x", t->x, n)) ||
           (why = increasing("sleeper.x", t->sleeper_x, s)) ||
           (why = increasing("check.x", t->check_x, t->checks)) ||
           (why = increasing("curve.x", t->curve_x, t->curves)) ||
           (why = increasing("cant.x", t->cant_x, t->cants)) ||
           (why = at_least("lateral.m", t->lateral_m, 1, 0, !(*t->lateral_k > 0))) ||
           (why = at_least("lateral.k", t->lateral_k, 1, 0, 1)) ||
           (why = at_least("lateral.c", t->lateral_c, 1, 0, 1)) ||
           (why = at_least("sleeper.lateral.k", t->sleeper_lateral_k, 1, 0, 1)) ||
           (why = at_least("sleeper.lateral.c", t->sleeper_lateral_c, 1, 0, 1)) ||
           (why = at_least("running.m", t->running_m, 1, 0, 1)) ||
           (why = at_least("check.k", t->check_k, 1, 0, 1)) ||
           (why = at_least("check.c", t->check_c, 1, 0, 1)) ||
           (why = increasing("bending.x", t->bending_x, t->knots)) ||
           (why = at_least("bending", t->bending, TRK_RAILS * t->knots, 0, 0)) ||
           (why = at_least("rail.shear", t->rail_shear, TRK_RAILS * (n - 1), 0, 1)) ||
           (why = at_least("rail.mass", t->rail_mass, TRK_RAILS * n, 0, 1)) ||
           (why = at_least("rail.inertia", t->rail_inertia, TRK_RAILS * n, 0, 1)) ||
           (why = at_least("rail.density", t->rail_density, TRK_RAILS * (n - 1), 0, 1)) ||
           (why = at_least("rail.rotary", t->rail_rotary, TRK_RAILS * (n - 1), 0, 1)) ||
           (why = at_least("sleeper.mass", t->sleeper_mass, s, 0, 0)) ||
           (why = at_least("sleeper.inertia", t->sleeper_inertia, s, 0, n == 1)) ||
           (why = at_least("pad.k", t->pad_k, TRK_RAILS * s, 0, 1)) ||
           (why = at_least("pad.c", t->pad_c, TRK_RAILS * s, 0, 1)) ||
           (why = at_least("ballast.k", t->ballast_k, TRK_BALLAST * s, 0, 1)) ||
           (why = at_least("ballast.c", t->ballast_c, TRK_BALLAST * s, 0, 1)) ||
           (why = at_least("ballast.gap", t->ballast_gap, TRK_BALLAST * s, 0, 1)));
    return why;
}

static const char *check_spatial_numbers(const struct trk *t)
{
    const int64_t n = t->nodes, s = t->sleepers;
    const char *why;

    (void)((why = increasing("bending.lateral.x", t->lateral_bending_x, t->lateral_knots)) ||
           (why = at_least("bending.lateral", t->lateral_bending, TRK_RAILS * t->lateral_knots, 0, 0)) ||
           (why = at_least("rail.yaw", t->rail_yaw, TRK_RAILS * n, 0, 1)) ||
           (why = at_least("rail.twist", t->rail_twist, TRK_RAILS * n, 0, 1)) ||
           (why = at_least("rail.lateral.shear", t->rail_lateral_shear, TRK_RAILS * (n - 1), 0, 1)) ||
           (why = at_least("rail.lateral.rotary", t->rail_lateral_rotary, TRK_RAILS * (n - 1), 0, 1)) ||
           (why = at_least("rail.torsion", t->rail_torsion, TRK_RAILS * (n - 1), 0, 0)) ||
           (why = at_least("rail.polar", t->rail_polar, TRK_RAILS * (n - 1), 0, 1)) ||
           (why = at_least("sleeper.yaw", t->sleeper_yaw, s, 0, 0)) ||
           (why = at_least("pad.lateral.k", t->pad_lateral_k, TRK_RAILS * s, 0, 1)) ||
           (why = at_least("pad.lateral.c", t->pad_lateral_c, TRK_RAILS * s, 0, 1)) ||
           (why = at_least("pad.width", t->pad_width, 1, 0, 1)) ||
           (why = at_least("pad.length", t->pad_length, 1, 0, 1)) ||
           (why = at_least("ballast.lateral.k", t->ballast_lateral_k, s, 0, 1)) ||
           (why = at_least("ballast.lateral.c", t->ballast_lateral_c, s, 0, 1)) ||
           (why = at_least("ballast.yaw.k", t->ballast_yaw_k, s, 0, 1)) ||
           (why = at_least("ballast.yaw.c", t->ballast_yaw_c, s, 0, 1)) ||
           (why = at_least("check.bending", t->check_bending, 2, 0, t->check_nodes == 0)) ||
           (why = at_least("check.torsion", t->check_torsion, 1, 0, t->check_nodes == 0)) ||
           (why = at_least("check.density", t->check_density, 1, 0, t->check_nodes == 0)) ||
           (why = at_least("check.polar", t->check_polar, 1, 0, t->check_nodes == 0)) ||
           (why = at_least("check.pad.k", t->check_pad_k, 2, 0, 1)) ||
           (why = at_least("check.pad.c", t->check_pad_c, 2, 0, 1)));
    return why;
}

static const char *check_spatial(const struct trk *t)
{
    if (t->lateral_knots < 1)
        return "array bending.lateral.x: no knot, one at least is wanted";
    if (t->nodes < 2)
        return "array x: a spatial track of one rail node is none";
    if (t->check_nodes == 1)
        return "array check.node: a check rail of one node is no beam";
    for (int64_t k = 0; k < t->check_nodes; k++)
        if (t->check_node[k] < 0 || t->check_node[k] >= t->nodes || (k && t->check_node[k] != t->check_node[k - 1] + 1))
            return reason("array check.node: %lld at %lld is out of order or range", (long long)t->check_node[k], (long long)k);
    return check_spatial_numbers(t);
}

static const char *check_sleepers(const struct trk *t)
{
    for (int64_t k = 0; k < t->sleepers; k++) {
        int64_t i = t->sleeper_node[k];
        if (i < 0 || i >= t->nodes || (k && i <= t->sleeper_node[k - 1]))
            return reason("array sleeper.node: %lld at %lld is out of order or range", (long long)i, (long long)k);
        if (fabs(t->x[i] - t->sleeper_x[k]) > SAME_STATION)
            return reason("array sleeper.x: %g at %lld is not below its rail node at %g", t->sleeper_x[k], (long long)k, t->x[i]);
        if (k && t->sleeper_number[k] != t->sleeper_number[k - 1] + 1)
            return reason("array sleeper.number: not counting on at %lld", (long long)k);
    }
    for (int64_t k = 0; k < TRK_RAILS * t->sleepers; k++)
        if (t->pad_zone[k] < 0 || t->pad_zone[k] > t->zones)
            return reason("array pad.zone: %lld at %lld, but there are %lld zones", (long long)t->pad_zone[k], (long long)k,
                          (long long)t->zones);
    for (int64_t k = 0; k < TRK_BALLAST * t->sleepers; k++) {
        const int64_t state = t->ballast_state[k];
        if (state < TRK_BONDED || state > TRK_OPEN || (state == TRK_BONDED && t->ballast_gap[k] > 0))
            return reason("array ballast.state: %lld at %lld over a gap of %g m", (long long)state, (long long)k, t->ballast_gap[k]);
    }
    for (int64_t z = 0; z < t->zones; z++)
        if (!memchr(t->zone_name[z], 0, sizeof t->zone_name[z]))
            return reason("array zone.name: no end at %lld", (long long)z);
    return NULL;
}

/* Degrees of freedom come by node and bay, without a gap. */
static const char *check_dofs(const struct trk *t)
{
    int64_t dof = 0, k = 0, c = 0;

    for (int64_t i = 0; i < t->nodes; i++) {
        if (t->node_dof[i] != dof)
            return reason("array node.dof: %lld at %lld should be %lld", (long long)t->node_dof[i], (long long)i, (long long)dof);
        dof += TRK_RAILS * t->rail_dofs;
        if (c < t->check_nodes && t->check_node[c] == i) {
            if (t->check_dof[c] != dof)
                return reason("array check.dof: %lld at %lld should be %lld", (long long)t->check_dof[c], (long long)c, (long long)dof);
            dof += t->rail_dofs;
            c++;
        }
        if (k < t->sleepers && t->sleeper_node[k] == i) {
            if (t->sleeper_dof[k] != dof)
                return reason("array sleeper.dof: %lld at %lld should be %lld", (long long)t->sleeper_dof[k], (long long)k,
                              (long long)dof);
            dof += t->sleeper_dofs;
            k++;
        }
    }
    return NULL;
}

/* Rows increase in each column and end within the array, so that walking the columns is safe. */
static const char *check_columns(const struct trk *t, int64_t entries)
{
    if (t->Ap[0] != 0 || t->Ap[t->dofs] != entries)
        return reason("array A.p: must run from 0 to the %lld entries of A.i", (long long)entries);
    for (int64_t j = 0; j < t->dofs; j++)
        if (t->Ap[j + 1] < t->Ap[j] || t->Ap[j + 1] > entries)
            return reason("array A.p: not increasing at %lld", (long long)j + 1);
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            if (t->Ai[p] < 0 || t->Ai[p] >= t->dofs || (p > t->Ap[j] && t->Ai[p] <= t->Ai[p - 1]))
                return reason("array A.i: row %lld at %lld is out of order or range", (long long)t->Ai[p], (long long)p);
    return NULL;
}

static double largest(const double *x, int64_t n)
{
    double most = 0;
    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* next[i] is the entry of column i whose row is the column now walked: A_ij at p has its mirror A_ji at next[i]. */
static const char *check_symmetric(const struct trk *t, int64_t *next)
{
    const int64_t entries = t->Ap[t->dofs];
    const double *value[3] = {t->Kx, t->Cx, t->Mx};
    double slack[3];

    for (int m = 0; m < 3; m++)
        slack[m] = SYMMETRY * largest(value[m], entries);
    memcpy(next, t->Ap, (size_t)t->dofs * sizeof *next);
    for (int64_t j = 0; j < t->dofs; j++) {
        int diagonal = 0;
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            int64_t i = t->Ai[p], q = next[i]++;
            if (q >= t->Ap[i + 1] || t->Ai[q] != j)
                return reason("arrays A.p, A.i: row %lld of column %lld has no mirror", (long long)i, (long long)j);
            for (int m = 0; m < 3; m++)
                if (fabs(value[m][p] - value[m][q]) > slack[m])
                    return reason("array %c.x: not symmetric at row %lld of column %lld", "KCM"[m], (long long)i, (long long)j);
            diagonal |= i == j && t->Mx[p] > 0;
        }
        if (!diagonal)
            return reason("array M.x: no positive diagonal in column %lld", (long long)j);
    }
    return NULL;
}

const char *trk_check(const struct trk *t, int64_t entries)
{
    const char *why;

    if (t->sleepers < 1 || t->nodes < t->sleepers)
        return reason("a track needs a sleeper and a rail node on each; here are %lld nodes and %lld sleepers", (long long)t->nodes,
                      (long long)t->sleepers);
    if (t->knots < 1)
        return "array bending.x: no knot, one at least is wanted";
    if (!(t->rail_spacing > 0))
        return reason("rail.spacing: %g must be positive", t->rail_spacing);
    if (*t->check_rail != TRK_LEFT && *t->check_rail != TRK_RIGHT)
        return reason("array check.rail: %lld is no side", (long long)*t->check_rail);
    if ((why = check_numbers(t)) || (trk_is_spatial(t) && (why = check_spatial(t))) ||
        (why = check_sleepers(t)) || (why = check_dofs(t)) ||
        (why = check_columns(t, entries)))
        return why;
    int64_t *next = calloc((size_t)t->dofs, sizeof *next);
    if (!next)
        return REASON_MEMORY;
    why = check_symmetric(t, next);
    free(next);
    return why;
}
