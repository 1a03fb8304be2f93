#include "tools/integrate/options.h"
#include "formats/reason.h"

#include <math.h>

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

const char *options_read(struct passage_options *o, const struct case_text *c, double speed)
{
    if (c->end <= c->start)
        return reason("end, %g m, must lie beyond start, %g m", c->end, c->start);
    *o = (struct passage_options){
        .speed = speed,
        .start = c->start,
        .end = c->end,
        .step = c->step,
        .scheme = c->scheme == CASE_EXPLICIT ? WAY_EXPLICIT : c->scheme == CASE_IMPLICIT ? WAY_IMPLICIT : WAY_AUTO,
        .law = contact_law(c),
        .dips = c->dip.n,
        .dip = c->dip.item,
    };
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
