#include "tools/integrate/way.h"
#include "formats/reason.h"
#include "tools/track/rails.h"

#include <math.h>
#include <stdio.h>
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

static void show_newmark(struct way *w)
{
    const struct newmark *m = &w->newmark;

    for (int s = 0; s < 2; s++) {
        w->w[s] = m->w[s];
        w->wa[s] = m->wa[s];
        w->seat[s] = m->seat[s];
        w->arm[s] = m->arm[s];
        w->pad[s] = m->pad[s];
    }
    for (int s = 0; s < 3; s++)
        w->ballast[s] = m->ballast[s];
    w->z = m->z;
    w->roll = m->roll;
    w->za = m->za;
}

static const char *begin_explicit(struct way *w, double gravity)
{
    const char *why = lumped_new(&w->lumped, w->track, gravity);

    if (why)
        return why;
    w->limit = STEP_MARGIN * 2 / lumped_highest(&w->lumped);
    if (w->step > w->limit)
        return reason("step %g s is beyond the limit of the explicit scheme on this track, %.3g s", w->step, w->limit);
    w->scheme = WAY_EXPLICIT;
    show_lumped(w);
    return NULL;
}

static const char *begin_implicit(struct way *w, double gravity)
{
    const char *why = newmark_new(&w->newmark, w->track, gravity, w->step);

    if (why)
        return why;
    w->scheme = WAY_IMPLICIT;
    w->limit = HUGE_VAL;
    show_newmark(w);
    return NULL;
}

/* Explicit where it holds. */
static const char *choose(struct way *w, double gravity)
{
    const char *why = begin_explicit(w, gravity);

    snprintf(w->because, sizeof w->because, "%s", why ? why : "lumped Euler-Bernoulli rails, one element a bay, and a step within the limit");
    if (!why)
        return NULL;
    lumped_free(&w->lumped);
    return begin_implicit(w, gravity);
}

const char *way_new(struct way *w, const struct trk *t, double gravity, double step, enum way_scheme scheme)
{
    const char *why;

    *w = (struct way){.scheme = scheme, .because = "the case asks for it", .track = t, .gravity = gravity, .step = step, .limit = HUGE_VAL, .at_rest = 1};
    why = scheme == WAY_AUTO ? choose(w, gravity) : scheme == WAY_EXPLICIT ? begin_explicit(w, gravity) : begin_implicit(w, gravity);
    if (why)
        way_free(w);
    return why;
}

void way_free(struct way *w)
{
    lumped_free(&w->lumped);
    newmark_free(&w->newmark);
    *w = (struct way){0};
}

static int is_explicit(const struct way *w)
{
    return w->scheme == WAY_EXPLICIT;
}

void way_set(struct way *w, const double *u)
{
    if (is_explicit(w))
        lumped_set(&w->lumped, u);
    else
        newmark_set(&w->newmark, u);
    w->at_rest = 1;
}

void way_state(const struct way *w, double *u, double *v)
{
    if (is_explicit(w)) {
        lumped_state(&w->lumped, w->lumped.u, u);
        lumped_state(&w->lumped, w->lumped.v, v);
    } else {
        memcpy(u, w->newmark.u, (size_t)w->track->dofs * sizeof *u);
        memcpy(v, w->newmark.v, (size_t)w->track->dofs * sizeof *v);
    }
}

int way_parts(struct way *w, struct state_part *part)
{
    const struct lumped *l = &w->lumped;
    const struct newmark *m = &w->newmark;
    const int64_t n = LUMPED_PARTS * l->stride;

    if (is_explicit(w)) {
        const struct state_part lumped[] = {{"track.u", n, l->u}, {"track.v", n, l->v}, {"track.a", n, l->a}, {"track.before", n, l->before}};
        memcpy(part, lumped, sizeof lumped);
        return 4;
    }
    const struct state_part newmark[] = {{"track.u", m->n, m->u}, {"track.v", m->n, m->v}, {"track.a", m->n, m->a}};
    memcpy(part, newmark, sizeof newmark);
    return 3;
}

void way_resume(struct way *w)
{
    w->at_rest = 0;
}

static void advance_lumped(struct way *w)
{
    struct lumped *l = &w->lumped;

    if (w->at_rest)
        memcpy(l->before, l->a, (size_t)(LUMPED_PARTS * l->stride) * sizeof *l->a);
    lumped_step(l, w->step);
    w->accelerated = 1;
}

/* A step has done it already, unless this is not the first time. */
static void accelerate_lumped(struct way *w)
{
    if (!w->accelerated)
        lumped_accelerate(&w->lumped);
    w->accelerated = 0;
}

void way_advance(struct way *w)
{
    if (is_explicit(w))
        advance_lumped(w);
    else
        newmark_advance(&w->newmark);
    w->at_rest = 0;
}

struct wheel_place way_find(const struct way *w, int rail, double x)
{
    const struct trk *t = w->track;
    struct wheel_place p = wheel_place_find(t, is_explicit(w) ? w->lumped.beam[rail] : w->newmark.beam[rail], x);

    if (trk_is_spatial(t)) {
        const struct beam b = rails_lateral_beam(t, rail, p.node);
        head_find(&p.head, &b, t->rail_torsion[rail * (t->nodes - 1) + p.node], x - b.from, *t->rail_head, trk_rail_dof(t, rail, p.node),
                  trk_rail_dof(t, rail, p.node + 1));
    }
    return p;
}

void way_load(struct way *w, int rail, const struct wheel_place *p, double F)
{
    if (is_explicit(w))
        lumped_load(&w->lumped, rail, p, F);
    else
        newmark_load(&w->newmark, rail, p, F);
}

void way_load_head(struct way *w, const struct head_place *p, const struct head_force *F)
{
    direction_load(&p->y, F->Y, w->newmark.f);
    direction_load(&p->twist, F->M, w->newmark.f);
}

/* At rest the implicit one stays where statics put it. */
void way_move(struct way *w)
{
    if (is_explicit(w))
        accelerate_lumped(w);
    else if (!w->at_rest)
        newmark_move(&w->newmark);
}

double way_unrest(const struct way *w)
{
    return is_explicit(w) ? 0 : newmark_unrest(&w->newmark);
}

static void look_lumped(const struct lumped *l, int rail, const struct wheel_place *p, struct way_rail *r)
{
    r->z = lumped_sample(l, rail, p, p->shape, l->u);
    r->v = lumped_sample(l, rail, p, p->shape, l->v);
    r->slope = lumped_sample(l, rail, p, p->slope, l->u);
}

static void look_newmark(const struct newmark *m, int rail, const struct wheel_place *p, struct way_rail *r)
{
    r->z = newmark_sample(m, rail, p, p->shape, m->u);
    r->v = newmark_rate(m, rail, p, p->shape);
    r->slope = newmark_sample(m, rail, p, p->slope, m->u);
}

static void look_give(const struct newmark *m, int rail, const struct wheel_place *p, struct way_rail *r)
{
    r->give = newmark_give(m, p, rail, p->shape, rail);
    r->give_other = newmark_give(m, p, rail, p->shape, !rail);
    r->turn = newmark_give(m, p, rail, p->slope, rail);
    r->turn_other = newmark_give(m, p, rail, p->slope, !rail);
    r->quick = 2 / m->h;
}

void way_look(const struct way *w, int rail, const struct wheel_place *p, struct way_rail *r)
{
    *r = (struct way_rail){.local = p->compliance};
    if (is_explicit(w))
        look_lumped(&w->lumped, rail, p, r);
    else
        look_newmark(&w->newmark, rail, p, r);
    if (way_yields(w))
        look_give(&w->newmark, rail, p, r);
    if (trk_is_spatial(w->track))
        way_look_head(w, &p->head, &r->head, &r->head_turn, r->yield);
}

void way_look_head(const struct way *w, const struct head_place *p, struct head_motion *h, double *turn, double yield[3])
{
    const struct newmark *m = &w->newmark;

    *h = (struct head_motion){direction_sample(&p->y, m->u), newmark_speed(m, &p->y), direction_sample(&p->slope, m->u),
                              direction_sample(&p->twist, m->u), newmark_speed(m, &p->twist)};
    *turn = direction_sample(&p->turn, m->u);
    if (!way_yields(w))
        return;
    yield[0] = direction_give(&p->y, &p->y, m->Z, m->beyond);
    yield[1] = direction_give(&p->y, &p->twist, m->Z, m->beyond);
    yield[2] = direction_give(&p->twist, &p->twist, m->Z, m->beyond);
}

void way_finish(struct way *w)
{
    if (!is_explicit(w))
        newmark_finish(&w->newmark);
}

void way_moment(const struct way *w, int rail, double *m)
{
    if (is_explicit(w))
        lumped_moment(&w->lumped, rail, m);
    else
        newmark_moment(&w->newmark, rail, m);
}
