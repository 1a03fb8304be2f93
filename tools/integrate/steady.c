/* What of a train in its frames is not balanced, and how that changes with where it is: by differences, a wheelset's columns from its own wheels
 * alone. */
#include "tools/integrate/steady.h"
#include "formats/reason.h"
#include "tools/integrate/check_rail.h"
#include "tools/integrate/facing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CREEP_MOST = 20 };
#define CREEP_TOLERANCE 1e-6  /* N, vertical part of the creep force */
#define DIFFERENCE 1e-4       /* of a scale: 0.1 um, 0.1 urad of a wheelset */
#define SCALE 1e-3            /* m, rad, of wheelsets and rails, and of v/r0 */
#define SCALE_BODY 20e-3      /* m, rad, of bodies on springs */

/* ---- unknowns ---- */

static void add(struct steady *s, double *x, double scale, int64_t body, int dof, int64_t wheelset)
{
    s->unknown[s->n++] = (struct steady_unknown){x, scale, body, dof, wheelset};
}

/* i of the wheelset, or -1. */
static int64_t wheelset_of(const struct veh *v, int64_t body)
{
    for (int64_t i = 0; i < v->wheelsets; i++)
        if (v->wheelset[i] == body)
            return i;
    return -1;
}

static void list(struct steady *s)
{
    struct passage *p = s->p;
    const struct veh *v = p->vehicle;

    for (int64_t b = 0; b < v->bodies; b++) {
        const int64_t i = wheelset_of(v, b);
        for (int k = i < 0 ? VEH_X : VEH_Y; k < VEH_DOFS; k++)
            if (i >= 0 && k == VEH_PITCH)
                add(s, &s->v[6 * b + k], SCALE * p->o.speed / v->radius[i], b, k, i);
            else
                add(s, &s->q[6 * b + k], i < 0 ? SCALE_BODY : SCALE, b, k, i);
    }
    for (int64_t k = 0; k < 2 * v->wheelsets && *p->track->lateral_k > 0 && !trk_is_spatial(p->track); k++)
        add(s, &p->sideways.y[k], SCALE, -1, (int)(k % 2), k / 2);
}

/* Where the train is; of its motion only the spins of the wheelsets. */
static void take(struct steady *s)
{
    const struct train *t = &s->p->train;
    const struct veh *v = s->p->vehicle;

    for (int64_t b = 0; b < v->bodies; b++)
        train_in_frame(t, b, s->q + 6 * b, s->v + 6 * b);
    for (int64_t k = 0; k < t->dofs; k++)
        if (k % 6 != VEH_PITCH || wheelset_of(v, k / 6) < 0)
            s->v[k] = 0;
}

const char *steady_new(struct steady *s, struct passage *p)
{
    const size_t dofs = (size_t)p->train.dofs, n = dofs + 2 * (size_t)p->vehicle->wheelsets;

    *s = (struct steady){.p = p};
    s->unknown = calloc(n, sizeof *s->unknown);
    s->q = calloc(2 * dofs + 4 * n, sizeof *s->q);
    s->J = calloc(2 * n * n, sizeof *s->J);
    s->pivot = calloc(n, sizeof *s->pivot);
    s->memory = calloc(n, sizeof *s->memory);
    if (!s->unknown || !s->q || !s->J || !s->pivot || !s->memory) {
        steady_free(s);
        return REASON_MEMORY;
    }
    s->v = s->q + dofs;
    s->r = s->v + dofs;
    s->next = s->r + n;
    s->old = s->next + n;
    s->move = s->old + n;
    s->A = s->J + n * n;
    for (int64_t k = 0; k < 2 * p->vehicle->wheelsets; k++)
        s->load += p->vehicle->wheel_load[k] / (double)(2 * p->vehicle->wheelsets);
    take(s);
    list(s);
    return NULL;
}

void steady_free(struct steady *s)
{
    free(s->unknown);
    free(s->q);
    free(s->J);
    free(s->pivot);
    free(s->memory);
    *s = (struct steady){0};
}

/* ---- what is not balanced ---- */

/* Wheel (i, side) on its rail at rest. */
static const char *turn_wheel(struct passage *p, int64_t i, int side)
{
    const struct wheel_place place = passage_place(p, i, side);
    struct wheel_memory *memory = &p->memory[2 * i + side];
    struct wheel_output *w = &p->wheel[2 * i + side];
    struct way_rail rail;
    struct wheel_input in;
    double creep = HUGE_VAL;

    passage_wheel_input(p, i, side, &place, &rail, &in);
    in.rail_v = in.rail_slope = in.rail_vy = in.rail_turn = 0;
    for (int k = 0; k < CREEP_MOST && fabs(memory->creep_z - creep) > CREEP_TOLERANCE; k++) {
        creep = memory->creep_z;
        const char *why = wheel_force(&p->o.law, &in, memory, w);
        if (why)
            return reason("wheelset %lld, %s wheel: %s", (long long)i + 1, facing_side(p, side), why);
    }
    check_rail_add(p->track, side, &in, w);
    return NULL;
}

static const char *turn_wheelset(struct passage *p, int64_t i)
{
    const char *why = turn_wheel(p, i, 0);

    return why ? why : turn_wheel(p, i, 1);
}

/* m/N, by which a lateral force moves its own rail and the other one under a wheelset. */
static void lateral_give(const struct passage *p, double *own, double *other)
{
    const double rail = 1 / *p->track->lateral_k, sleeper = p->follows && *p->track->sleeper_lateral_k > 0 ? 1 / *p->track->sleeper_lateral_k : 0;

    *other = sleeper > 0 ? sleeper : p->follows ? rail : 0;
    *own = sleeper > 0 ? rail + sleeper : rail;
}

/* Residuals r [n] of the present positions and wheel forces. */
static void balance(struct steady *s, double *r)
{
    struct passage *p = s->p;
    struct train *t = &p->train;

    train_accelerate(t, p->wheel);
    couplings_centre(p->vehicle, &t->memory);
    train_accelerate(t, p->wheel);
    for (int64_t j = 0; j < s->n; j++) {
        const struct steady_unknown *u = &s->unknown[j];
        if (s->held && u->wheelset >= 0) {
            r[j] = 0;
        } else if (u->body >= 0) {
            double a[6];
            train_carried(t, u->body, a);
            r[j] = (t->f[6 * u->body + u->dof] - p->vehicle->mass[u->body] * (u->dof < VEH_ROLL ? a[u->dof] : 0)) / s->load;
        } else {
            const struct wheel_output *w = p->wheel + 2 * u->wheelset;
            double own, other;
            lateral_give(p, &own, &other);
            r[j] = (own * (w[u->dof].Y - w[u->dof].check) + other * (w[!u->dof].Y - w[!u->dof].check) - *u->x) / u->scale;
        }
    }
}

static void place(struct steady *s, int64_t body)
{
    train_put(&s->p->train, body, s->q + 6 * body, s->v + 6 * body);
}

const char *steady_residual(struct steady *s, double *r)
{
    const char *why = NULL;

    for (int64_t b = 0; b < s->p->vehicle->bodies; b++)
        place(s, b);
    for (int64_t i = 0; i < s->p->vehicle->wheelsets && !why && !s->held; i++)
        why = turn_wheelset(s->p, i);
    if (!why)
        balance(s, r);
    return why;
}

const char *steady_differ(struct steady *s, int64_t j)
{
    struct passage *p = s->p;
    const struct steady_unknown *u = &s->unknown[j];
    const int64_t i = u->wheelset;
    const double x = *u->x;
    struct wheel_memory memory[2];
    struct wheel_output wheel[2];
    const char *why = NULL;

    *u->x += DIFFERENCE * u->scale;
    if (u->body >= 0)
        place(s, u->body);
    if (i >= 0) {
        memcpy(memory, p->memory + 2 * i, sizeof memory);
        memcpy(wheel, p->wheel + 2 * i, sizeof wheel);
        why = turn_wheelset(p, i);
    }
    if (!why)
        balance(s, s->next);
    for (int64_t k = 0; k < s->n; k++)
        s->J[k * s->n + j] = (s->next[k] - s->r[k]) / DIFFERENCE;
    *u->x = x;
    if (u->body >= 0)
        place(s, u->body);
    if (i >= 0) {
        memcpy(p->memory + 2 * i, memory, sizeof memory);
        memcpy(p->wheel + 2 * i, wheel, sizeof wheel);
    }
    return why;
}

const char *steady_unbalanced(struct steady *s, double *most)
{
    struct passage *p = s->p;
    const size_t wheels = 2 * (size_t)p->vehicle->wheelsets;

    memcpy(s->memory, p->memory, wheels * sizeof *s->memory);
    const char *why = steady_residual(s, s->r);
    memcpy(p->memory, s->memory, wheels * sizeof *s->memory);
    couplings_relax(&p->train.memory);
    *most = 0;
    for (int64_t j = 0; j < s->n; j++)
        *most = fmax(*most, fabs(s->r[j]) * s->load);
    return why;
}
