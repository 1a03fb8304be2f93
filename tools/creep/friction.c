/* Friction by place and slip. */
#include "tools/creep/friction.h"

#include <math.h>

static int holds(const struct case_friction *r, char side, double s, double body, double angle)
{
    return (r->side == CASE_BOTH || (r->side == CASE_LEFT) == (side == 'l')) && (r->body < 0 || (double)r->body == body) && r->from <= s &&
           s <= r->to && r->angle <= fabs(angle);
}

double friction_of(const struct friction *f, double mu, char side, double s, double body, double angle, double w)
{
    for (int64_t i = 0; i < f->rules; i++)
        if (holds(&f->rule[i], side, s, body, angle))
            mu = f->rule[i].friction;
    if (f->limit < 1 && f->decay > 0)
        mu *= (1 - f->limit)*exp(-f->decay*w) + f->limit;
    return mu;
}
