/* Nodes stand on the sleepers and divide the rail between them into equal elements.  The rails end, free, at the outermost sleepers; the
 * half bay beyond is mass at the end nodes, so that a lumped node of a 0.6 m bay carries 36 kg of a 60 kg/m rail also there.  The rails of
 * a moving mass are a node each, a bay of mass that does not pitch. */
#include "tools/track/rails.h"

#include <stdlib.h>

#include "formats/reason.h"

static double *numbers(struct trk *t, int64_t n)
{
    return trk_room(t, n, sizeof(double));
}

static const struct yaml_table *bending_of(const struct trk_text *in, int rail)
{
    const struct yaml_table *own = rail == TRK_LEFT ? &in->rail.left.bending_stiffness : &in->rail.right.bending_stiffness;

    return own->n ? own : &in->rail.bending_stiffness;
}

/* Sleeper number 1 stands in the middle of the first bay from first_sleeper. */
static double station_of(const struct trk_text *in, const struct yaml_table *table, double at)
{
    return table->by_number ? in->first_sleeper + (at - 0.5) * in->sleeper.spacing : at;
}

static double bending_at(const struct trk_text *in, int rail, double x)
{
    return yaml_table_at(bending_of(in, rail), x, (x - in->first_sleeper) / in->sleeper.spacing + 0.5);
}

static int by_station(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Both rails over the knots of both. */
static const char *lay_bending(struct trk *t, const struct trk_text *in)
{
    const struct yaml_table *of[TRK_RAILS] = {bending_of(in, TRK_LEFT), bending_of(in, TRK_RIGHT)};
    const int64_t most = of[0]->n + of[1]->n;
    double *x = numbers(t, most), *bending = numbers(t, TRK_RAILS * most);
    int64_t n = 0;

    if (!x || !bending)
        return REASON_MEMORY;
    for (int rail = 0; rail < TRK_RAILS; rail++)
        for (int64_t k = 0; k < of[rail]->n; k++)
            x[n++] = of[rail]->n > 1 ? station_of(in, of[rail], of[rail]->at[k]) : in->from;
    qsort(x, (size_t)n, sizeof *x, by_station);
    t->knots = 1;
    for (int64_t k = 1; k < n; k++)
        if (x[k] > x[t->knots - 1])
            x[t->knots++] = x[k];
    for (int64_t k = 0; k < TRK_RAILS * t->knots; k++)
        bending[k] = bending_at(in, (int)(k / t->knots), x[k % t->knots]);
    t->bending_x = x;
    t->bending = bending;
    return NULL;
}

/* Lumped: all mass at the nodes.  Consistent: along the elements but for the half bays beyond the ends. */
static const char *lay_masses(struct trk *t, const struct trk_text *in, double h)
{
    const int64_t n = t->nodes;
    const int moving = in->model == TRK_TEXT_MOVING_MASS, lumped = moving || in->rail.mass_model == TRK_TEXT_LUMPED;
    double *mass = numbers(t, TRK_RAILS * n), *inertia = numbers(t, TRK_RAILS * n);
    double *density = numbers(t, TRK_RAILS * (n - 1)), *rotary = numbers(t, TRK_RAILS * (n - 1));

    if (!mass || !inertia || !density || !rotary)
        return REASON_MEMORY;
    for (int64_t k = 0; k < TRK_RAILS * n; k++) {
        const int end = k % n == 0 || k % n == n - 1;
        if (lumped)
            mass[k] = in->rail.mass * (moving ? in->sleeper.spacing : end ? (h + in->sleeper.spacing) / 2 : h);
        else
            mass[k] = end ? in->rail.mass * (in->sleeper.spacing / 2) : 0;
        inertia[k] = lumped && !moving ? in->rail.pitch_inertia : 0;
    }
    for (int64_t k = 0; k < TRK_RAILS * (n - 1) && !lumped; k++) {
        density[k] = in->rail.mass;
        rotary[k] = in->rail.beam == TRK_TEXT_TIMOSHENKO ? in->rail.rotary_inertia : 0;
    }
    t->rail_mass = mass;
    t->rail_inertia = inertia;
    t->rail_density = density;
    t->rail_rotary = rotary;
    return NULL;
}

const char *rails_lay(struct trk *t, const struct trk_text *in)
{
    const double h = in->sleeper.spacing / (double)in->rail.elements_per_bay;
    double *x = numbers(t, t->nodes), *shear = numbers(t, TRK_RAILS * (t->nodes - 1));
    const char *why = x && shear ? lay_bending(t, in) : REASON_MEMORY;

    if (why || (why = lay_masses(t, in, h)))
        return why;
    for (int64_t i = 0; i < t->nodes; i++)
        x[i] = in->from + in->sleeper.spacing / 2 + (double)i * h;
    for (int64_t k = 0; k < TRK_RAILS * (t->nodes - 1) && in->rail.beam == TRK_TEXT_TIMOSHENKO; k++)
        shear[k] = 1 / in->rail.shear_stiffness;
    t->x = x;
    t->rail_shear = shear;
    return NULL;
}

/* The first knot beyond x, or t->knots. */
static int64_t knot_beyond(const struct trk *t, double x)
{
    int64_t low = 0, high = t->knots;

    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (t->bending_x[middle] > x)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* The knots from the last one not beyond the near end to the first one not before the far end, and whether EI is one over them. */
struct beam rails_beam(const struct trk *t, int rail, int64_t i)
{
    const int64_t k = rail * (t->nodes - 1) + i, beyond = knot_beyond(t, t->x[i]), first = beyond ? beyond - 1 : 0;
    const double *x = t->bending_x, *EI = t->bending + rail * t->knots;
    int64_t last = first;
    int same = 1;

    while (last < t->knots - 1 && x[last] < t->x[i + 1])
        same &= EI[++last] == EI[first];
    return (struct beam){.length = t->x[i + 1] - t->x[i], .from = t->x[i], .bending = same ? EI[first] : 0, .shear = t->rail_shear[k],
                         .mass = t->rail_density[k], .rotary = t->rail_rotary[k], .knots = last - first + 1, .x = x + first,
                         .EI = EI + first};
}
