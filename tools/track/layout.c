/* Sleepers stand in the middle of equal bays, rail nodes on them and between. */
#include "tools/track/layout.h"

#include <math.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/track/along.h"
#include "tools/track/cant.h"
#include "tools/track/pads.h"
#include "tools/track/rails.h"
#include "tools/track/spatial.h"

static const double WHOLE = 1e-6;      /* length / spacing may differ this much from a whole number */

static double *numbers(struct trk *t, int64_t n)
{
    return trk_room(t, n, sizeof(double));
}

static const char *lay_sleepers(struct trk *t, const struct trk_text *in)
{
    const int64_t n = t->sleepers;
    double *x = numbers(t, n), *mass = numbers(t, n), *inertia = numbers(t, n), *y = numbers(t, n);
    int64_t *node = trk_room(t, n, sizeof *node), *number = trk_room(t, n, sizeof *number);

    if (!x || !mass || !inertia || !y || !node || !number)
        return REASON_MEMORY;
    for (int64_t k = 0; k < n; k++) {
        node[k] = k * in->rail.elements_per_bay;
        x[k] = t->x[node[k]];
        number[k] = (int64_t)floor(along_number(in, x[0]) + 0.5 + WHOLE) + k;
        mass[k] = along_at(&in->sleeper.mass, in, x[k]);
        inertia[k] = in->sleeper.roll == TRK_TEXT_HELD ? 0 : along_at(&in->sleeper.roll_inertia, in, x[k]);
        y[k] = along_at(&in->sleeper.centre, in, x[k]);
    }
    t->sleeper_x = x;
    t->sleeper_node = node;
    t->sleeper_number = number;
    t->sleeper_mass = mass;
    t->sleeper_inertia = inertia;
    t->sleeper_y = y;
    return NULL;
}

/* Both rails stand on every sleeper. */
static const char *check_centres(const struct trk *t, const struct trk_text *in)
{
    for (int64_t s = 0; s < t->sleepers; s++) {
        const double half = along_at(&in->sleeper.length, in, t->sleeper_x[s]) / 2;
        for (int rail = 0; rail < TRK_RAILS; rail++) {
            const double y = trk_pad_arm(t, rail, s);
            if (fabs(y) > half)
                return reason("sleeper.centre: the %s rail, %g m beside the middle of sleeper %lld, is beyond its end at %g m",
                              rail == TRK_LEFT ? "left" : "right", fabs(y), (long long)t->sleeper_number[s], half);
        }
    }
    return NULL;
}

/* What a spring takes of the total: a third, or of a moving mass, which stands on the outer two, a half. */
static double ballast_part(const struct trk_text *in, int spring, double total)
{
    if (in->model == TRK_TEXT_MOVING_MASS)
        return spring == 1 ? 0 : total / 2;
    return total / TRK_BALLAST;
}

/* The spring's own value at x where it has one, else `rest`. */
static double own_at(const struct yaml_table *own, const struct trk_text *in, double x, double rest)
{
    return own->n ? along_at(own, in, x) : rest;
}

static const char *lay_ballast(struct trk *t, const struct trk_text *in)
{
    const int64_t n = t->sleepers;
    const struct trk_text_spring *own[TRK_BALLAST] = {&in->ballast.left, &in->ballast.middle, &in->ballast.right};
    double *k = numbers(t, TRK_BALLAST * n), *c = numbers(t, TRK_BALLAST * n), *y = numbers(t, TRK_BALLAST * n);
    double *gap = numbers(t, TRK_BALLAST * n);
    int64_t *state = trk_room(t, TRK_BALLAST * n, sizeof *state);

    if (!k || !c || !y || !gap || !state)
        return REASON_MEMORY;
    for (int64_t s = 0; s < n; s++) {
        double x = t->sleeper_x[s], length = along_at(&in->sleeper.length, in, x), arm = length / 2 - in->ballast.edge;
        if (!(arm > 0))
            return reason("ballast.edge: sleeper %lld of length %g m is too short for springs %g m from its ends",
                          (long long)t->sleeper_number[s], length, in->ballast.edge);
        for (int b = 0; b < TRK_BALLAST; b++) {
            const int64_t i = b * n + s;
            k[i] = own_at(&own[b]->stiffness, in, x, ballast_part(in, b, along_at(&in->ballast.stiffness, in, x)));
            c[i] = own_at(&own[b]->damping, in, x, ballast_part(in, b, along_at(&in->ballast.damping, in, x)));
            y[i] = (b - 1) * arm;
            gap[i] = own_at(&own[b]->gap, in, x, along_at(&in->ballast.gap, in, x));
            if (in->model == TRK_TEXT_MOVING_MASS && gap[i] > 0)
                return "ballast.gap: a moving mass has no void beneath it";
            state[i] = (in->ballast.tension || in->model == TRK_TEXT_MOVING_MASS) && !(gap[i] > 0) ? TRK_BONDED : TRK_CLOSED;
        }
    }
    t->ballast_k = k;
    t->ballast_c = c;
    t->ballast_y = y;
    t->ballast_gap = gap;
    t->ballast_state = state;
    return NULL;
}

static const char *lay_lateral(struct trk *t, const struct trk_text *in)
{
    double *m = numbers(t, 1), *k = numbers(t, 1), *c = numbers(t, 1);
    double *ground_k = numbers(t, 1), *ground_c = numbers(t, 1), *running = numbers(t, 1);

    if (!m || !k || !c || !ground_k || !ground_c || !running)
        return REASON_MEMORY;
    *m = in->rail.lateral.mass;
    *k = in->rail.lateral.stiffness;
    *c = in->rail.lateral.damping;
    *ground_k = in->sleeper.lateral.stiffness;
    *ground_c = in->sleeper.lateral.damping;
    *running = in->rail.running_mass;
    t->sleeper_lateral_k = ground_k;
    t->sleeper_lateral_c = ground_c;
    t->running_m = running;
    t->lateral_m = m;
    t->lateral_k = k;
    t->lateral_c = c;
    return NULL;
}

/* Without a check rail its scalars stand all the same: side left, no stiffness, no knots. */
static const char *lay_check_rail(struct trk *t, const struct trk_text *in)
{
    const struct trk_text_check *c = in->check_rail.n ? in->check_rail.item : NULL;
    const int64_t n = c ? c->play.n : 0;
    double *k = numbers(t, 1), *damping = numbers(t, 1), *x = numbers(t, n), *play = numbers(t, n);
    int64_t *rail = trk_room(t, 1, sizeof *rail);

    if (!k || !damping || !x || !play || !rail)
        return REASON_MEMORY;
    if (c) {
        *rail = c->rail == TRK_TEXT_RIGHT ? TRK_RIGHT : TRK_LEFT;
        *k = c->stiffness;
        *damping = c->damping;
        memcpy(x, c->play.at, (size_t)n * sizeof *x);
        memcpy(play, c->play.value, (size_t)n * sizeof *play);
    }
    t->checks = n;
    t->check_rail = rail;
    t->check_k = k;
    t->check_c = damping;
    t->check_x = x;
    t->check_play = play;
    return NULL;
}

static const char *lay_curve(struct trk *t, const struct trk_text *in)
{
    double *x = numbers(t, in->curve.n), *curvature = numbers(t, in->curve.n);
    const struct trk_text_curve *c = in->curve.item;

    if (!x || !curvature)
        return REASON_MEMORY;
    for (int64_t i = 0; i < in->curve.n; i++) {
        x[i] = c[i].from;
        curvature[i] = c[i].curvature;
    }
    t->curves = in->curve.n;
    t->curve_x = x;
    t->curvature = curvature;
    return NULL;
}

/* Of both rails at each node, of the check rail where it has a node there, then of the sleeper below it. */
static const char *number_dofs(struct trk *t)
{
    int64_t *node = trk_room(t, t->nodes, sizeof *node), *sleeper = trk_room(t, t->sleepers, sizeof *sleeper);
    int64_t *check = trk_room(t, t->check_nodes, sizeof *check);
    int64_t dof = 0;

    if (!node || !sleeper || !check)
        return REASON_MEMORY;
    for (int64_t i = 0, k = 0, c = 0; i < t->nodes; i++) {
        node[i] = dof;
        dof += TRK_RAILS * t->rail_dofs;
        if (c < t->check_nodes && t->check_node[c] == i) {
            check[c++] = dof;
            dof += t->rail_dofs;
        }
        if (k < t->sleepers && t->sleeper_node[k] == i) {
            sleeper[k++] = dof;
            dof += t->sleeper_dofs;
        }
    }
    t->node_dof = node;
    t->sleeper_dof = sleeper;
    t->check_dof = check;
    t->dofs = dof;
    return NULL;
}

const char *layout_track(struct trk *t, const struct trk_text *in)
{
    const double bays = in->length / in->sleeper.spacing;
    const char *why;

    memset(t, 0, sizeof *t);
    strncpy(t->name, in->name, sizeof t->name - 1);
    t->rail_spacing = in->rail_spacing;
    t->rail_dofs = in->dofs == TRK_TEXT_SPATIAL ? TRK_SPATIAL_RAIL : TRK_VERTICAL_RAIL;
    t->sleeper_dofs = in->dofs == TRK_TEXT_SPATIAL ? TRK_SPATIAL_SLEEPER : TRK_VERTICAL_SLEEPER;
    t->sleepers = (int64_t)floor(bays + 0.5);
    t->nodes = (t->sleepers - 1) * in->rail.elements_per_bay + 1;
    if (in->model == TRK_TEXT_MOVING_MASS && fabs(bays - 1) > WHOLE)
        return reason("length: %g m is not the sleeper spacing of %g m, which a moving mass has", in->length, in->sleeper.spacing);
    if (in->model == TRK_TEXT_FIXED && (t->sleepers < 2 || fabs(bays - (double)t->sleepers) > WHOLE))
        return reason("length: %g m is not a whole number, two or more, of sleeper spacings of %g m", in->length, in->sleeper.spacing);
    if ((why = rails_lay(t, in)) || (why = lay_sleepers(t, in)) || (why = check_centres(t, in)) || (why = lay_ballast(t, in)) || (why = pads_lay(t, in)) ||
        (why = lay_lateral(t, in)) || (why = lay_check_rail(t, in)) || (why = lay_curve(t, in)) ||
        (why = cant_lay(t, in)))
        return why;
    if (trk_is_spatial(t) && (why = spatial_lay(t, in)))
        return why;
    return number_dofs(t);
}
