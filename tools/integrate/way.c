#include "tools/integrate/way.h"
#include "formats/reason.h"
#include "tools/integrate/two_step.h"

#include <math.h>
#include <string.h>

/* Of 2/omega of the track alone.  The turnout's diverging route at 80 km/h keeps its forces at 0.84; at 0.89 the creep forces of the flange
 * shake the rail, at 0.94 Hertz's stiffness on the nodes does, and without a train the dampers at 0.99. */
static const double STEP_MARGIN = 0.84;

static void show_lumped(struct way *w)
{
    const struct lumped *l = &w->lumped;
    int64_t k = l->stride;

    for (int s = 0; s < 2; s++) {
        w->w[s] = w->seat[s] = l->u + (s ? LUMPED_WR : LUMPED_WL) * k;
        w->wa[s] = l->a + (s ? LUMPED_WR : LUMPED_WL) * k;
        w->arm[s] = l->arm[s];
        w->pad[s] = l->pad[s];
    }
    for (int s = 0; s < 3; s++)
        w->ballast[s] = l->ballast[s];
    w->z = l->u + LUMPED_Z * k;
    w->roll = l->u + LUMPED_ROLL * k;
    w->za = l->a + LUMPED_Z * k;
}

static const char *begin_explicit(struct way *w, double gravity)
{
    const char *why = lumped_new(&w->lumped, w->track, gravity);

    if (why)
        return why;
    w->limit = STEP_MARGIN * 2 / lumped_highest(&w->lumped);
    if (w->step > w->limit)
        return reason("step %g s is beyond the limit of the explicit scheme on this track, %.3g s", w->step, w->limit);
    show_lumped(w);
    return NULL;
}

const char *way_new(struct way *w, const struct trk *t, double gravity, double step, enum way_scheme scheme)
{
    const char *why;

    *w = (struct way){.scheme = scheme, .track = t, .step = step, .limit = HUGE_VAL, .at_rest = 1};
    why = begin_explicit(w, gravity);
    if (why)
        way_free(w);
    return why;
}

void way_free(struct way *w)
{
    lumped_free(&w->lumped);
    *w = (struct way){0};
}

void way_set(struct way *w, const double *u)
{
    lumped_set(&w->lumped, u);
    w->at_rest = 1;
}

void way_advance(struct way *w)
{
    struct lumped *l = &w->lumped;

    if (w->at_rest)
        memcpy(l->before, l->a, (size_t)(LUMPED_PARTS * l->stride) * sizeof *l->a);
    w->at_rest = 0;
    two_step(LUMPED_PARTS * l->stride, w->step, l->u, l->v, l->a, l->before);
}

struct wheel_place way_find(const struct way *w, int rail, double x)
{
    return lumped_find(&w->lumped, rail, x);
}

void way_load(struct way *w, int rail, const struct wheel_place *p, double F)
{
    lumped_load(&w->lumped, rail, p, F);
}

void way_move(struct way *w)
{
    lumped_accelerate(&w->lumped);
}

void way_look(const struct way *w, int rail, const struct wheel_place *p, struct way_rail *r)
{
    const struct lumped *l = &w->lumped;

    *r = (struct way_rail){.local = p->compliance};
    r->z = lumped_sample(l, rail, p, p->shape, l->u);
    r->v = lumped_sample(l, rail, p, p->shape, l->v);
    r->slope = lumped_sample(l, rail, p, p->slope, l->u);
}

double way_acceleration(const struct way *w, int rail, const struct wheel_place *p)
{
    return lumped_sample(&w->lumped, rail, p, p->shape, w->lumped.a);
}

void way_finish(struct way *w)
{
    (void)w;
}

void way_moment(const struct way *w, int rail, double *m)
{
    lumped_moment(&w->lumped, rail, m);
}
