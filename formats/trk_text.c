/* What the keys of a track input owe each other, and its reader. */
#include "formats/trk_text.h"

#include <math.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/trk.h"
#include "formats/trk_text_tables.h"

static const char *check_curve(const struct yaml_list *curve)
{
    const struct trk_text_curve *c = curve->item;

    for (int64_t i = 1; i < curve->n; i++)
        if (!(c[i].from > c[i - 1].from))
            return reason("curve.%lld.from: %g must be beyond the %g of the one before", (long long)i + 1, c[i].from, c[i - 1].from);
    return NULL;
}

static const char *check_check_rail(const struct yaml_list *list)
{
    const struct trk_text_check *c = list->item;

    if (list->n > 1)
        return reason("check_rail: %lld items, one at most is possible", (long long)list->n);
    if (list->n == 1 && (c->play.by_number || c->play.n < 2))
        return "check_rail.1.play: {station: [...], value: [...]} is wanted, from one end of the check rail to the other";
    if (list->n == 1 && c->beam.mass > 0 && !(c->beam.to > c->beam.from))
        return reason("check_rail.1.beam.to: %g must be beyond the %g of from", c->beam.to, c->beam.from);
    return NULL;
}

/* Of item `number` of a list. */
static const char *check_ranges(const char *list, int64_t number, const struct yaml_nums *sleepers)
{
    if (sleepers->n == 0)
        return reason("%s.%lld.sleepers: no sleeper, one range [first, last] at least is wanted", list, (long long)number);
    for (int64_t i = 0; i < sleepers->n; i += 2) {
        double first = sleepers->x[i], last = sleepers->x[i + 1];
        if (floor(first) < first || floor(last) < last || last < first)
            return reason("%s.%lld.sleepers: [%g, %g] must be two whole numbers, the first not above the last", list, (long long)number,
                          first, last);
        for (int64_t j = 0; j < i; j += 2)
            if (first <= sleepers->x[j + 1] && last >= sleepers->x[j])
                return reason("%s.%lld.sleepers: [%g, %g] and [%g, %g] have sleepers in common", list, (long long)number, sleepers->x[j],
                              sleepers->x[j + 1], first, last);
    }
    return NULL;
}

static const char *check_zone(const struct trk_text_zone *z, int64_t number)
{
    if (strlen(z->name) >= sizeof *((struct trk *)NULL)->zone_name)
        return reason("zone.%lld.name: \"%s\" is longer than 31 letters", (long long)number, z->name);
    return check_ranges("zone", number, &z->sleepers);
}

/* Zones are told apart by name, in plots and tables of results too. */
static const char *check_zone_name(const struct trk_text_zone *z, int64_t k)
{
    for (int64_t i = 0; i < k; i++)
        if (strcmp(z[i].name, z[k].name) == 0)
            return reason("zone.%lld.name: \"%s\" is the name of zone.%lld already", (long long)k + 1, z[k].name, (long long)i + 1);
    return NULL;
}

/* For both rails, or for each. */
static int given(const struct yaml_table *both, const struct yaml_table *left, const struct yaml_table *right)
{
    return both->n > 0 || (left->n > 0 && right->n > 0);
}

static const char *check_rail(const struct trk_text_rail *r)
{
    if (r->mass_model == TRK_TEXT_LUMPED && !given(&r->pitch_inertia, &r->left.pitch_inertia, &r->right.pitch_inertia))
        return "rail.pitch_inertia: a lumped rail needs it, the pitch inertia of a node in kg.m2";
    if (r->beam == TRK_TEXT_TIMOSHENKO && !given(&r->shear_stiffness, &r->left.shear_stiffness, &r->right.shear_stiffness))
        return "rail.shear_stiffness: a timoshenko rail needs it, kappa G A in N";
    if (r->beam == TRK_TEXT_TIMOSHENKO && r->mass_model == TRK_TEXT_CONSISTENT &&
        !given(&r->rotary_inertia, &r->left.rotary_inertia, &r->right.rotary_inertia))
        return "rail.rotary_inertia: a timoshenko rail with consistent mass needs it, rho I in kg.m";
    return NULL;
}

static const char *check_missing(const struct yaml_list *list)
{
    const struct trk_text_missing *m = list->item;
    const char *why = NULL;

    for (int64_t k = 0; k < list->n && !why; k++)
        why = check_ranges("railpad.missing", k + 1, &m[k].sleepers);
    return why;
}

/* What a spatial track needs beside a vertical one. */
static const char *check_spatial(const struct trk_text *in)
{
    const struct trk_text_rail *r = &in->rail;
    const int lumped = r->mass_model == TRK_TEXT_LUMPED, timoshenko = r->beam == TRK_TEXT_TIMOSHENKO;
    const struct { const char *key, *what; int given; } needs[] = {
        {"rail.lateral_bending_stiffness", "lateral EI in N.m2", r->lateral_bending_stiffness.n > 0},
        {"rail.yaw_inertia", "with lumped mass the yaw inertia of a node in kg.m2", r->yaw_inertia > 0 || !lumped},
        {"rail.lateral_shear_stiffness", "with timoshenko kappa G A sideways in N", r->lateral_shear_stiffness > 0 || !timoshenko},
        {"rail.lateral_rotary_inertia", "with timoshenko and consistent mass rho I in kg.m",
         r->lateral_rotary_inertia > 0 || !timoshenko || lumped},
        {"rail.torsional_stiffness", "GJ in N.m2", r->torsional_stiffness > 0},
        {"rail.polar_inertia", "rho Ip in kg.m", r->polar_inertia > 0},
        {"rail.head_height", "in m", r->head_height > 0},
        {"rail.foot_depth", "in m", r->foot_depth > 0},
        {"sleeper.yaw_inertia", "in kg.m2", in->sleeper.yaw_inertia.n > 0},
        {"railpad.lateral_stiffness", "in N/m", in->railpad.lateral_stiffness.n > 0},
        {"railpad.lateral_damping", "in N.s/m", in->railpad.lateral_damping.n > 0},
        {"railpad.width", "in m", in->railpad.width > 0},
        {"ballast.lateral_stiffness", "in N/m", in->ballast.lateral_stiffness.n > 0},
        {"ballast.lateral_damping", "in N.s/m", in->ballast.lateral_damping.n > 0},
        {"ballast.longitudinal_stiffness", "in N/m", in->ballast.longitudinal_stiffness.n > 0},
        {"ballast.longitudinal_damping", "in N.s/m", in->ballast.longitudinal_damping.n > 0},
    };

    if (in->model == TRK_TEXT_MOVING_MASS)
        return "dofs: spatial is not for model: moving_mass";
    for (size_t k = 0; k < sizeof needs / sizeof *needs; k++)
        if (!needs[k].given)
            return reason("%s: dofs: spatial needs it, %s", needs[k].key, needs[k].what);
    return NULL;
}

static const char *check(const struct trk_text *in)
{
    const struct trk_text_zone *z = in->zone.item;
    const char *why;

    if (strlen(in->name) >= sizeof ((struct trk *)NULL)->name)
        return reason("name: \"%s\" is longer than 63 letters", in->name);
    if (in->sleeper.roll == TRK_TEXT_HELD && in->model != TRK_TEXT_MOVING_MASS)
        return "sleeper.roll: held is for model: moving_mass alone";
    if (in->model != TRK_TEXT_MOVING_MASS && (in->rail.running_mass > 0 || in->sleeper.lateral.stiffness > 0))
        return "rail.running_mass, sleeper.lateral: they are for model: moving_mass alone";
    if (in->sleeper.lateral.stiffness > 0 && !(in->rail.lateral.stiffness > 0))
        return "sleeper.lateral: rail.lateral is missing, what the rails stand against it with";
    if (in->dofs == TRK_TEXT_SPATIAL && (why = check_spatial(in)))
        return why;
    if ((in->model == TRK_TEXT_FIXED && (why = check_rail(&in->rail))) || (why = check_curve(&in->curve)) ||
        (why = check_check_rail(&in->check_rail)) || (why = check_missing(&in->railpad.missing)))
        return why;
    for (int64_t k = 0; k < in->zone.n; k++)
        if ((why = check_zone(&z[k], k + 1)) || (why = check_zone_name(z, k)))
            return why;
    return trk_text_tables(in);
}

const char *trk_text_read(struct trk_text *in, const char *path, char *const *set, int sets, uint64_t *hash)
{
    const char *why = yaml_read(path, &trk_text_schema, set, sets, in, hash);
    if (why)
        return why;
    why = check(in);
    if (why) {
        trk_text_free(in);
        return yaml_blame(path, &trk_text_schema, set, sets, why);
    }
    return NULL;
}

void trk_text_free(struct trk_text *in)
{
    yaml_release(&trk_text_schema, in);
}
