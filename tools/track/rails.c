/* Nodes stand on the sleepers and divide the rail between them into equal elements.  The rails end, free, at the outermost sleepers; the
 * half bay beyond is mass at the end nodes, so that a lumped node of a 0.6 m bay carries 36 kg of a 60 kg/m rail also there.  The rails of
 * a moving mass are a node each, a bay of mass that does not pitch. */
#include "tools/track/rails.h"

#include <stdlib.h>

#include "formats/reason.h"
#include "tools/track/along.h"

static double *numbers(struct trk *t, int64_t n)
{
    return trk_room(t, n, sizeof(double));
}

/* What the rail has of its own, or that of both. */
static const struct yaml_table *own_or_both(const struct yaml_table *own, const struct yaml_table *both)
{
    return own->n ? own : both;
}

static const struct trk_text_own *own_of(const struct trk_text *in, int rail)
{
    return rail == TRK_LEFT ? &in->rail.left : &in->rail.right;
}

static const struct yaml_table *bending_of(const struct trk_text *in, int rail)
{
    return own_or_both(&own_of(in, rail)->bending_stiffness, &in->rail.bending_stiffness);
}

/* Mean over a < x < b, exact: trapezia between the knots. */
static double mean(const struct trk_text *in, const struct yaml_table *table, double a, double b)
{
    double x = a, value = along_at(table, in, a), sum = 0;

    if (table->n == 1)
        return value;
    for (int64_t k = 0; k <= table->n; k++) {
        const double next = k < table->n ? along_station(table, in, table->at[k]) : b;
        if (next <= x || next > b)
            continue;
        const double there = along_at(table, in, next);
        sum += 0.5 * (value + there) * (next - x);
        x = next;
        value = there;
    }
    return sum / (b - a);
}

static int by_station(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

const char *rails_lay_bending(struct trk *t, const struct trk_text *in, const struct yaml_table *const of[TRK_RAILS], int64_t *knots,
                              const double **at, const double **EI)
{
    const int64_t most = of[0]->n + of[1]->n;
    double *x = numbers(t, most), *bending = numbers(t, TRK_RAILS * most);
    int64_t n = 0;

    if (!x || !bending)
        return REASON_MEMORY;
    for (int rail = 0; rail < TRK_RAILS; rail++)
        for (int64_t k = 0; k < of[rail]->n; k++)
            x[n++] = of[rail]->n > 1 ? along_station(of[rail], in, of[rail]->at[k]) : in->from;
    qsort(x, (size_t)n, sizeof *x, by_station);
    *knots = 1;
    for (int64_t k = 1; k < n; k++)
        if (x[k] > x[*knots - 1])
            x[(*knots)++] = x[k];
    for (int64_t k = 0; k < TRK_RAILS * *knots; k++)
        bending[k] = along_at(of[k / *knots], in, x[k % *knots]);
    *at = x;
    *EI = bending;
    return NULL;
}

/* What stands at the nodes x [nodes] of a rail: all mass of the lumped model, else that of the half bays beyond the ends.  A lumped node
 * carries what is nearer to it than to another, and of a moving mass a bay. */
static void lay_nodes(const struct trk_text *in, int rail, int64_t n, const double *x, double *mass, double *inertia)
{
    const struct yaml_table *of = own_or_both(&own_of(in, rail)->mass, &in->rail.mass);
    const struct yaml_table *pitch = own_or_both(&own_of(in, rail)->pitch_inertia, &in->rail.pitch_inertia);
    const double bay = in->sleeper.spacing, h = bay / (double)in->rail.elements_per_bay;
    const int moving = in->model == TRK_TEXT_MOVING_MASS, lumped = moving || in->rail.mass_model == TRK_TEXT_LUMPED;

    for (int64_t i = 0; i < n; i++) {
        const int first = i == 0, last = i == n - 1;
        const double behind = first ? bay / 2 : h / 2, ahead = last ? bay / 2 : h / 2;
        if (lumped)
            mass[i] = mean(in, of, x[i] - behind, x[i] + ahead) * (moving ? bay : first || last ? (h + bay) / 2 : h);
        else if (first || last)
            mass[i] = mean(in, of, first ? x[i] - behind : x[i], first ? x[i] : x[i] + ahead) * (bay / 2);
        inertia[i] = lumped && !moving ? along_at(pitch, in, x[i]) : 0;
    }
}

/* What lies along the elements between them, each with the mean of its own: density and rotary stay zero of a lumped rail. */
static void lay_elements(const struct trk_text *in, int rail, int64_t n, const double *x, double *density, double *rotary, double *shear)
{
    const struct trk_text_own *own = own_of(in, rail);
    const int consistent = in->rail.mass_model == TRK_TEXT_CONSISTENT, timoshenko = in->rail.beam == TRK_TEXT_TIMOSHENKO;

    for (int64_t i = 0; i < n - 1; i++) {
        if (consistent)
            density[i] = mean(in, own_or_both(&own->mass, &in->rail.mass), x[i], x[i + 1]);
        if (consistent && timoshenko)
            rotary[i] = mean(in, own_or_both(&own->rotary_inertia, &in->rail.rotary_inertia), x[i], x[i + 1]);
        if (timoshenko)
            shear[i] = 1 / mean(in, own_or_both(&own->shear_stiffness, &in->rail.shear_stiffness), x[i], x[i + 1]);
    }
}

const char *rails_lay(struct trk *t, const struct trk_text *in)
{
    const int64_t n = t->nodes;
    const double h = in->sleeper.spacing / (double)in->rail.elements_per_bay;
    double *x = numbers(t, n), *mass = numbers(t, TRK_RAILS * n), *inertia = numbers(t, TRK_RAILS * n);
    double *density = numbers(t, TRK_RAILS * (n - 1)), *rotary = numbers(t, TRK_RAILS * (n - 1)), *shear = numbers(t, TRK_RAILS * (n - 1));
    const struct yaml_table *const bending[TRK_RAILS] = {bending_of(in, TRK_LEFT), bending_of(in, TRK_RIGHT)};

    if (!x || !mass || !inertia || !density || !rotary || !shear)
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++)
        x[i] = in->from + in->sleeper.spacing / 2 + (double)i * h;
    for (int rail = 0; rail < TRK_RAILS; rail++) {
        const int64_t at = rail * n, behind = rail * (n - 1);
        lay_nodes(in, rail, n, x, mass + at, inertia + at);
        lay_elements(in, rail, n, x, density + behind, rotary + behind, shear + behind);
    }
    t->x = x;
    t->rail_mass = mass;
    t->rail_inertia = inertia;
    t->rail_density = density;
    t->rail_rotary = rotary;
    t->rail_shear = shear;
    return rails_lay_bending(t, in, bending, &t->knots, &t->bending_x, &t->bending);
}

/* The first of the knots x beyond this station, or how many there are. */
static int64_t knot_beyond(int64_t knots, const double *x, double station)
{
    int64_t low = 0, high = knots;

    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (x[middle] > station)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* The knots from the last one not beyond the near end to the first one not before the far end, and whether EI is one over them. */
static struct beam beam_behind(const struct trk *t, int64_t i, int64_t knots, const double *x, const double *EI)
{
    const int64_t beyond = knot_beyond(knots, x, t->x[i]), first = beyond ? beyond - 1 : 0;
    int64_t last = first;
    int same = 1;

    while (last < knots - 1 && x[last] < t->x[i + 1])
        same &= EI[++last] == EI[first];
    return (struct beam){.length = t->x[i + 1] - t->x[i], .from = t->x[i], .bending = same ? EI[first] : 0, .knots = last - first + 1,
                         .x = x + first, .EI = EI + first};
}

struct beam rails_beam(const struct trk *t, int rail, int64_t i)
{
    const int64_t k = rail * (t->nodes - 1) + i;
    struct beam b = beam_behind(t, i, t->knots, t->bending_x, t->bending + rail * t->knots);

    b.shear = t->rail_shear[k];
    b.mass = t->rail_density[k];
    b.rotary = t->rail_rotary[k];
    return b;
}

struct beam rails_lateral_beam(const struct trk *t, int rail, int64_t i)
{
    const int64_t k = rail * (t->nodes - 1) + i;
    struct beam b = beam_behind(t, i, t->lateral_knots, t->lateral_bending_x, t->lateral_bending + rail * t->lateral_knots);

    b.shear = t->rail_lateral_shear[k];
    b.mass = t->rail_density[k];
    b.rotary = t->rail_lateral_rotary[k];
    return b;
}
