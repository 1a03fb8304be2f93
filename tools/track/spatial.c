/* A railpad that is missing holds the rail in no direction.  Ballast resists the yaw of a sleeper of length L by its longitudinal stiffness,
 * even along it: k L^2/12.  The check rail stands on every sleeper between its ends, its nodes beside those of the rails. */
#include "tools/track/spatial.h"

#include <math.h>

#include "formats/reason.h"
#include "tools/track/along.h"
#include "tools/track/rails.h"

static double *numbers(struct trk *t, int64_t n)
{
    return trk_room(t, n, sizeof(double));
}

/* One number that is kept with the track; NULL when out of memory. */
static const double *keep(struct trk *t, double value)
{
    double *x = numbers(t, 1);

    if (x)
        *x = value;
    return x;
}

static const char *lay_bending(struct trk *t, const struct trk_text *in)
{
    const struct yaml_table *left = &in->rail.left.lateral_bending_stiffness, *right = &in->rail.right.lateral_bending_stiffness;
    const struct yaml_table *both = &in->rail.lateral_bending_stiffness;
    const struct yaml_table *const of[TRK_RAILS] = {left->n ? left : both, right->n ? right : both};

    return rails_lay_bending(t, in, of, &t->lateral_knots, &t->lateral_bending_x, &t->lateral_bending);
}

/* Inertia at the nodes: all of the lumped model, else in twist that of the half bays beyond the ends. */
static const char *lay_nodes(struct trk *t, const struct trk_text *in)
{
    const int64_t n = t->nodes;
    const double bay = in->sleeper.spacing, h = bay / (double)in->rail.elements_per_bay;
    const int lumped = in->rail.mass_model == TRK_TEXT_LUMPED;
    double *yaw = numbers(t, TRK_RAILS * n), *twist = numbers(t, TRK_RAILS * n);

    if (!yaw || !twist)
        return REASON_MEMORY;
    for (int64_t k = 0; k < TRK_RAILS * n; k++) {
        const int end = k % n == 0 || k % n == n - 1;
        yaw[k] = lumped ? in->rail.yaw_inertia : 0;
        twist[k] = in->rail.polar_inertia * ((end ? bay / 2 : 0) + (!lumped ? 0 : end ? h / 2 : h));
    }
    t->rail_yaw = yaw;
    t->rail_twist = twist;
    return NULL;
}

static const char *lay_elements(struct trk *t, const struct trk_text *in)
{
    const int64_t n = TRK_RAILS * (t->nodes - 1);
    const int consistent = in->rail.mass_model == TRK_TEXT_CONSISTENT, timoshenko = in->rail.beam == TRK_TEXT_TIMOSHENKO;
    double *shear = numbers(t, n), *rotary = numbers(t, n), *torsion = numbers(t, n), *polar = numbers(t, n);

    if (!shear || !rotary || !torsion || !polar)
        return REASON_MEMORY;
    for (int64_t k = 0; k < n; k++) {
        shear[k] = timoshenko ? 1 / in->rail.lateral_shear_stiffness : 0;
        rotary[k] = timoshenko && consistent ? in->rail.lateral_rotary_inertia : 0;
        torsion[k] = in->rail.torsional_stiffness;
        polar[k] = consistent ? in->rail.polar_inertia : 0;
    }
    t->rail_lateral_shear = shear;
    t->rail_lateral_rotary = rotary;
    t->rail_torsion = torsion;
    t->rail_polar = polar;
    return NULL;
}

static const char *lay_sleepers(struct trk *t, const struct trk_text *in)
{
    const int64_t n = t->sleepers;
    double *inertia = numbers(t, n), *k = numbers(t, n), *c = numbers(t, n), *yaw_k = numbers(t, n), *yaw_c = numbers(t, n);

    if (!inertia || !k || !c || !yaw_k || !yaw_c)
        return REASON_MEMORY;
    for (int64_t s = 0; s < n; s++) {
        const double x = t->sleeper_x[s], length = along_at(&in->sleeper.length, in, x), arms = length * length / 12;
        inertia[s] = along_at(&in->sleeper.yaw_inertia, in, x);
        k[s] = along_at(&in->ballast.lateral_stiffness, in, x);
        c[s] = along_at(&in->ballast.lateral_damping, in, x);
        yaw_k[s] = along_at(&in->ballast.longitudinal_stiffness, in, x) * arms;
        yaw_c[s] = along_at(&in->ballast.longitudinal_damping, in, x) * arms;
    }
    t->sleeper_yaw = inertia;
    t->ballast_lateral_k = k;
    t->ballast_lateral_c = c;
    t->ballast_yaw_k = yaw_k;
    t->ballast_yaw_c = yaw_c;
    return NULL;
}

static const char *lay_pads(struct trk *t, const struct trk_text *in)
{
    const struct trk_text_zone *z = in->zone.item;
    const int64_t n = t->sleepers;
    double *k = numbers(t, TRK_RAILS * n), *c = numbers(t, TRK_RAILS * n);

    if (!k || !c)
        return REASON_MEMORY;
    for (int64_t i = 0; i < TRK_RAILS * n; i++) {
        const struct trk_text_zone_pad own = t->pad_zone[i] ? z[t->pad_zone[i] - 1].railpad : (struct trk_text_zone_pad){0};
        const double x = t->sleeper_x[i % n];
        if (!(t->pad_k[i] > 0))
            continue;
        k[i] = own.lateral_stiffness > 0 ? own.lateral_stiffness : along_at(&in->railpad.lateral_stiffness, in, x);
        c[i] = own.lateral_damping > 0 ? own.lateral_damping : along_at(&in->railpad.lateral_damping, in, x);
    }
    t->pad_lateral_k = k;
    t->pad_lateral_c = c;
    return NULL;
}

/* The first and the last sleeper between its ends, and that each bears it. */
static const char *find_ends(const struct trk *t, const struct trk_text *in, const struct trk_text_beam *b, int64_t *first, int64_t *last)
{
    *first = t->sleepers;
    *last = -1;
    for (int64_t s = 0; s < t->sleepers; s++) {
        const double x = t->sleeper_x[s], half = along_at(&in->sleeper.length, in, x) / 2, y = b->side - t->sleeper_y[s];
        if (x < b->from || x > b->to)
            continue;
        if (fabs(y) > half)
            return reason("check_rail.1.beam.side: %g m beside the middle of sleeper %lld is beyond its end at %g m", fabs(y),
                          (long long)t->sleeper_number[s], half);
        *first = s < *first ? s : *first;
        *last = s;
    }
    if (*last <= *first)
        return reason("check_rail.1.beam.from: between %g and %g m stand fewer than two sleepers", b->from, b->to);
    return NULL;
}

/* Its scalars, zero without it. */
static const char *lay_check_numbers(struct trk *t, const struct trk_text_beam *b)
{
    double *bending = numbers(t, 2), *k = numbers(t, 2), *c = numbers(t, 2);

    if (!bending || !k || !c)
        return REASON_MEMORY;
    bending[0] = b->bending_stiffness;
    bending[1] = b->lateral_bending_stiffness;
    k[0] = b->stiffness;
    k[1] = b->lateral_stiffness > 0 ? b->lateral_stiffness : b->stiffness;
    c[0] = b->damping;
    c[1] = b->lateral_damping > 0 ? b->lateral_damping : b->damping;
    t->check_bending = bending;
    t->check_pad_k = k;
    t->check_pad_c = c;
    t->check_y = keep(t, b->side);
    t->check_torsion = keep(t, b->torsional_stiffness);
    t->check_density = keep(t, b->mass);
    t->check_polar = keep(t, b->polar_inertia);
    t->check_head = keep(t, b->head_height);
    t->check_foot = keep(t, b->foot_depth);
    return t->check_y && t->check_torsion && t->check_density && t->check_polar && t->check_head && t->check_foot ? NULL : REASON_MEMORY;
}

static const char *lay_check(struct trk *t, const struct trk_text *in)
{
    const struct trk_text_check *check = in->check_rail.n ? in->check_rail.item : NULL;
    const struct trk_text_beam none = {0}, *b = check ? &check->beam : &none;
    int64_t first = 0, last = 0;
    const char *why = b->mass > 0 ? find_ends(t, in, b, &first, &last) : NULL;

    if (why || (why = lay_check_numbers(t, b)))
        return why;
    t->check_nodes = b->mass > 0 ? t->sleeper_node[last] - t->sleeper_node[first] + 1 : 0;
    int64_t *node = trk_room(t, t->check_nodes, sizeof *node);
    if (!node)
        return REASON_MEMORY;
    for (int64_t i = 0; i < t->check_nodes; i++)
        node[i] = t->sleeper_node[first] + i;
    t->check_node = node;
    return NULL;
}

const char *spatial_lay(struct trk *t, const struct trk_text *in)
{
    const char *why;

    t->rail_head = keep(t, in->rail.head_height);
    t->rail_foot = keep(t, in->rail.foot_depth);
    t->sleeper_seat = keep(t, in->sleeper.seat_height);
    t->pad_width = keep(t, in->railpad.width);
    t->pad_length = keep(t, in->railpad.length);
    if (!t->rail_head || !t->rail_foot || !t->sleeper_seat || !t->pad_width || !t->pad_length)
        return REASON_MEMORY;
    (void)((why = lay_bending(t, in)) || (why = lay_nodes(t, in)) || (why = lay_elements(t, in)) || (why = lay_sleepers(t, in)) ||
           (why = lay_pads(t, in)) || (why = lay_check(t, in)));
    return why;
}
