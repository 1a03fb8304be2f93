#include "tools/integrate/state.h"
#include "formats/reason.h"
#include "tools/integrate/facing.h"
#include "tools/track/equilibrium.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The track counts as moved where it lies off its rest by this: a railpad of 300 MN/m then has 0.3 N. */
#define REACH_TOLERANCE 1e-9 /* m */
#define RAIL_TOLERANCE 1e-9  /* m */
#define EVERYWHERE 1e9       /* m: a track that follows the train */

/* ---- parts ---- */

static void add(struct state_part *part, int *n, const char *name, int64_t count, double *x)
{
    part[(*n)++] = (struct state_part){name, count, x};
}

int state_parts(struct passage *p, struct state_part *part)
{
    const int64_t wheels = 2 * p->vehicle->wheelsets;
    struct train *t = &p->train;
    int n = 0;

    add(part, &n, "train.q", t->dofs, t->q);
    add(part, &n, "train.v", t->dofs, t->v);
    add(part, &n, "train.a", t->dofs, t->a);
    add(part, &n, "train.before", t->dofs, t->before);
    add(part, &n, "couplings", t->memory.couplings * (int64_t)(sizeof *t->memory.now / sizeof(double)), t->memory.now->e);
    add(part, &n, "wheel.memory", wheels * (int64_t)(sizeof *p->memory / sizeof(double)), &p->memory->local);
    add(part, &n, "rail.sideways", 3 * (wheels + p->vehicle->wheelsets), p->sideways.y);
    return n + way_parts(&p->rails, part + n);
}

/* ---- taking ---- */

static const char *direction(const struct passage *p)
{
    return p->o.trailing ? "trailing" : "facing";
}

/* Stations of the outermost rail nodes that lie off their rest, or of the wheels if these reach farther. */
static void find_reach(struct state *s, const struct passage *p)
{
    const struct trk *t = p->track;

    s->reach[0] = p->follows ? -EVERYWHERE : HUGE_VAL;
    s->reach[1] = p->follows ? EVERYWHERE : -HUGE_VAL;
    for (int64_t i = 0; i < 2 * t->nodes; i++) {
        const int rail = (int)(i / t->nodes);
        const int64_t node = i % t->nodes;
        if (fabs(p->rails.w[rail][node] - s->rest[trk_rail_dof(t, rail, node)]) > REACH_TOLERANCE) {
            s->reach[0] = fmin(s->reach[0], t->x[node]);
            s->reach[1] = fmax(s->reach[1], t->x[node]);
        }
    }
    for (int64_t i = 0; i < p->vehicle->wheelsets; i++) {
        s->reach[0] = fmin(s->reach[0], passage_wheel_station(p, i));
        s->reach[1] = fmax(s->reach[1], passage_wheel_station(p, i));
    }
    if (p->o.trailing) {
        const double first = s->reach[0];
        s->reach[0] = -s->reach[1];
        s->reach[1] = -first;
    }
}

/* The track under its own weight into *rest [dofs], which the caller frees. */
static const char *find_rest(const struct passage *p, double **rest)
{
    struct equilibrium e;
    const char *why;

    if (!(*rest = calloc((size_t)p->track->dofs, sizeof **rest)))
        return REASON_MEMORY;
    if ((why = equilibrium_new(&e, p->track, p->vehicle->gravity)))
        return why;
    memcpy(*rest, e.rest, (size_t)p->track->dofs * sizeof **rest);
    equilibrium_free(&e);
    return NULL;
}

const char *state_take(struct state *s, const struct passage *p, double **rest)
{
    const char *why = find_rest(p, rest);

    if (why)
        return why;
    *s = (struct state){.speed = p->o.speed, .step = p->o.step, .start = facing_station(p, p->o.start),
                        .station = facing_station(p, p->station), .steps = (double)p->n,
                        .dofs = p->track->dofs, .rest = *rest};
    snprintf(s->direction, sizeof s->direction, "%s", direction(p));
    snprintf(s->scheme, sizeof s->scheme, "%s", p->rails.scheme == WAY_EXPLICIT ? "explicit" : "implicit");
    find_reach(s, p);
    return NULL;
}

/* ---- going on ---- */

static const char *check(const struct state *s, const struct passage *p, const struct state_difference *differs, int n)
{
    if (*s->failed)
        return reason("it is what a run that failed has left: %s", s->failed);
    if (s->speed != p->o.speed)
        return reason("its speed is %.9g m/s, that of the case %.9g", s->speed, p->o.speed);
    if (s->step != p->o.step)
        return reason("its step is %.9g s, that of the case %.9g", s->step, p->o.step);
    if (strcmp(s->scheme, p->rails.scheme == WAY_EXPLICIT ? "explicit" : "implicit"))
        return reason("it is of the %s scheme, which is not that of this run", s->scheme);
    if (strcmp(s->direction, direction(p)))
        return reason("it runs %s, the case %s", s->direction, direction(p));
    if (facing_station(p, s->station) >= p->o.end)
        return reason("it is at %.3f m, where the case ends or beyond", s->station);
    if (s->dofs != p->track->dofs)
        return reason("its track has %lld degrees of freedom, this one %lld", (long long)s->dofs, (long long)p->track->dofs);
    for (int k = 0; k < n; k++)
        if (differs[k].from <= s->reach[1] && differs[k].to >= s->reach[0])
            return reason("%s of the track differs from %.2f to %.2f m, but the state reaches from %.2f to %.2f m", differs[k].name,
                          differs[k].from, differs[k].to, s->reach[0], s->reach[1]);
    return NULL;
}

/* How the track's displacements move from its rest in s to that of p, into *shift, which the caller frees, in the order of way_parts. */
static const char *find_shift(const struct state *s, struct passage *p, double **shift)
{
    struct state_part part[WAY_PARTS];
    double *rest = NULL;
    const char *why = find_rest(p, &rest);

    way_parts(&p->rails, part);
    *shift = calloc((size_t)part[0].n, sizeof **shift);
    if (!why && !*shift)
        why = REASON_MEMORY;
    if (!why) {
        way_set(&p->rails, s->rest);
        memcpy(*shift, part[0].x, (size_t)part[0].n * sizeof **shift);
        way_set(&p->rails, rest);
        for (int64_t i = 0; i < part[0].n; i++)
            (*shift)[i] = part[0].x[i] - (*shift)[i];
    }
    free(rest);
    return why;
}

/* Dips, joints, flats and irregularity may differ ahead of the wheels, but not under them. */
static const char *check_rail(const struct passage *p)
{
    for (int64_t k = 0; k < 2 * p->vehicle->wheelsets; k++) {
        struct excitation_at at;
        excitation_find(&p->excitation, passage_wheel_station(p, k / 2), k / 2, (int)(k % 2), p->vehicle->radius[k / 2], &at);
        const double off = fmax(fabs(at.z - p->memory[k].dip), fabs(at.y - p->memory[k].line));
        if (off > RAIL_TOLERANCE)
            return reason("under wheelset %lld the %s rail's irregularity is off that of the state by %.3g mm", (long long)(k / 2 + 1),
                          k % 2 ? "right" : "left", 1e3 * off);
    }
    return NULL;
}

const char *state_resume(const struct state *s, struct passage *p, const struct state_difference *differs, int n)
{
    struct state_part part[STATE_PARTS], way[WAY_PARTS];
    const int parts = state_parts(p, part);
    double *shift = NULL;
    const char *why = check(s, p, differs, n);

    way_parts(&p->rails, way);
    if (!why && n)
        why = find_shift(s, p, &shift);
    if (!why)
        why = state_get(s, parts, part);
    for (int64_t i = 0; i < way[0].n && n && !why; i++)
        way[0].x[i] += shift[i];
    free(shift);
    if (why)
        return why;
    way_resume(&p->rails);
    p->o.start = facing_station(p, s->start);
    p->n = (int64_t)s->steps;
    p->steps = passage_steps(&p->o);
    p->time = (double)p->n * p->o.step;
    p->station = p->o.start + p->o.speed * p->time;
    for (int64_t k = 0; k < 2 * p->vehicle->wheelsets; k++)
        p->couple[k].place = passage_place(p, k / 2, (int)(k % 2));
    if (p->o.account)
        passage_account(p);
    return check_rail(p);
}
