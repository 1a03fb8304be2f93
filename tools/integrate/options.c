#include "tools/integrate/options.h"
#include "formats/reason.h"

#include <math.h>

#define POISSON_EQUAL 1e-9

static struct wheel_law contact_law(const struct case_text *c)
{
    struct wheel_law law = {
        .normal = c->contact.law == CASE_HERTZ ? WHEEL_HERTZ : WHEEL_LINEAR,
        .hertz_damping = c->contact.hertz_damping,
        .friction = c->friction,
        .varied = {c->falling.limit, c->falling.decay, c->friction_on.n, c->friction_on.item},
        .step = c->step,
    };

    wheel_condense(&law, c->contact.stiffness, c->contact.damping, c->contact.series);
    fastsim_begin(&law.grid, (int)c->contact.grid);
    return law;
}

static struct excitation_options excitation_of(const struct case_text *c, const struct irregularity *measured)
{
    struct excitation_options e = {
        .dips = c->dip.n, .joints = c->joint.n, .flats = c->flat.n,
        .dip = c->dip.item, .joint = c->joint.item, .flat = c->flat.item,
        .measured = measured,
        .scale = c->irregularity.scale, .fade = c->irregularity.fade, .from = fmin(c->start, c->end), .to = fmax(c->start, c->end),
        .trailing = c->direction == CASE_TRAILING,
    };

    if (c->force.amplitude > 0) /* no wheel */
        return (struct excitation_options){0};
    if (c->irregularity.spectrum != CASE_NO_SPECTRUM)
        e.waves = (struct spectrum_waves){
            c->irregularity.spectrum == CASE_ERRI_LOW ? SPECTRUM_LOW : SPECTRUM_HIGH,
            c->irregularity.shortest, c->irregularity.longest, fabs(c->end - c->start), c->irregularity.seed,
        };
    return e;
}

static const char *check_irregularity(const struct case_text *c)
{
    if (c->irregularity.file && c->irregularity.spectrum != CASE_NO_SPECTRUM)
        return "irregularity: file and spectrum exclude each other";
    if (c->irregularity.shortest >= c->irregularity.longest)
        return reason("irregularity: shortest, %g m, must be below longest, %g m", c->irregularity.shortest, c->irregularity.longest);
    return NULL;
}

const char *options_read(struct passage_options *o, const struct case_text *c, double speed, const struct irregularity *measured)
{
    const char *why = check_irregularity(c);

    if (why)
        return why;
    const int trailing = c->direction == CASE_TRAILING && !(c->force.amplitude > 0);
    if (!trailing && c->end <= c->start && !(c->force.amplitude > 0))
        return reason("end, %g m, must lie beyond start, %g m", c->end, c->start);
    if (trailing && c->end >= c->start)
        return reason("end, %g m, must lie before start, %g m, in the direction trailing", c->end, c->start);
    *o = (struct passage_options){
        .speed = speed,
        .start = trailing ? -c->start : c->start,
        .end = trailing ? -c->end : c->end,
        .trailing = trailing,
        .step = c->step,
        .scheme = c->scheme == CASE_EXPLICIT ? WAY_EXPLICIT : c->scheme == CASE_IMPLICIT ? WAY_IMPLICIT : WAY_AUTO,
        .implicit_train = c->train_scheme,
        .law = contact_law(c),
        .excitation = excitation_of(c, measured),
    };
    return NULL;
}

const char *options_exciter(struct exciter *e, const struct case_text *c, const struct trk *t)
{
    static const int kind[] = {[CASE_IMPULSE] = DRIVE_IMPULSE, [CASE_SWEEP] = DRIVE_SWEEP, [CASE_NOISE] = DRIVE_NOISE};
    static const int on[] = {[CASE_ON_LEFT] = RUN_ON_LEFT, [CASE_ON_RIGHT] = RUN_ON_RIGHT, [CASE_ON_SLEEPER] = RUN_ON_SLEEPER};
    const struct case_force *f = &c->force;
    const struct case_probe *probe = c->probe.item;
    const struct drive x = {kind[f->kind], f->amplitude, f->from, f->to, f->width, f->blows, f->duration, f->rest, (uint64_t)f->seed};
    const char *why;

    if (f->to <= f->from)
        return reason("force.to, %g Hz, must lie beyond force.from, %g Hz", f->to, f->from);
    if (f->rest >= f->duration)
        return reason("force.rest, %g s, leaves nothing of force.duration, %g s", f->rest, f->duration);
    if ((why = exciter_new(e, &x, c->step, c->probe.n ? c->probe.n : 1)))
        return why;
    e->on = f->rail;
    e->x = e->probe_x[0] = f->at;
    e->probe_on[0] = f->rail == RUN_ON_RIGHT ? RUN_ON_RIGHT : RUN_ON_LEFT;
    for (int64_t k = 0; k < c->probe.n; k++) {
        e->probe_on[k] = on[probe[k].on];
        e->probe_x[k] = probe[k].at;
    }
    if ((why = exciter_place(e, t)))
        exciter_free(e);
    return why;
}

const char *options_creep(struct passage_options *o, const struct creep *c, const struct ctab table[2])
{
    for (int i = 0; i < 2; i++)
        if (fabs(table[i].poisson - c->poisson) > POISSON_EQUAL)
            return reason("creep: of Poisson's ratio %g, but the contact tables of %g", c->poisson, table[i].poisson);
    o->law.creep = c;
    return NULL;
}

const char *options_sampling(const struct case_text *c, int64_t *every)
{
    const double steps = 1 / (c->sampling * c->step);

    *every = steps <= 1 ? 1 : (int64_t)rint(steps);
    if (steps > 1 && fabs(steps - rint(steps)) > 1e-6 * steps)
        return reason("sampling, %g Hz, is not a whole number of steps of %g s", c->sampling, c->step);
    return NULL;
}
