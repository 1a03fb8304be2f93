/* Wheel loads -> track -> wheelset heights -> bodies on their springs -> wheel loads, until the loads stand still: the track is
 * so much stiffer than the springs that each round gains two digits. */
#include "tools/integrate/start.h"
#include "formats/reason.h"
#include "tools/integrate/steady.h"
#include "tools/track/equilibrium.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS_MOST = 30, HEIGHT_MOST = 60 };
#define LOAD_TOLERANCE 1e-3   /* N */
#define HEIGHT_TOLERANCE 1e-3 /* N, of a wheel load found by its height */
#define BALANCED 1e-4         /* of a wheel load, N or N m: what rest on straight level track may leave, for rounding of the tables */

struct rest {
    struct passage *p;
    struct equilibrium track;
    double *f, *u;          /* [track dofs] */
    double *load;           /* N [wheels] */
    double shift;           /* N, largest change of a lateral force since rails were put aside for it */
    int64_t n;              /* dofs that move: all of bodies that are not wheelsets */
    int64_t *free;          /* [n] their numbers */
    double *K;              /* [n][n] their stiffness */
    double *x;              /* [n] */
    lapack_int *pivot;      /* [n] */
};

/* ---- track ---- */

/* Own weight and wheel loads as nodal forces. */
static void track_loads(struct rest *r)
{
    const struct trk *t = r->p->track;

    memcpy(r->f, r->track.weight, (size_t)t->dofs * sizeof *r->f);
    for (int64_t k = 0; k < 2 * r->p->vehicle->wheelsets; k++) {
        int s = (int)(k % 2);
        struct wheel_place at = passage_place(r->p, k / 2, s);
        for (int j = 0; j < 4; j++)
            r->f[trk_rail_dof(t, s, at.node + j / 2) + j % 2] += at.shape[j] * r->load[k];
        if (trk_is_spatial(t)) {
            direction_load(&at.head.y, r->p->memory[k].Y, r->f);
            direction_load(&at.head.twist, r->p->memory[k].M, r->f);
        }
    }
}

static const char *settle_track(struct rest *r)
{
    const char *why;

    track_loads(r);
    if ((why = equilibrium_find(&r->track, r->f, r->u)))
        return why;
    way_set(&r->p->rails, r->u);
    return NULL;
}

/* ---- wheels ---- */

static void wheel_input(const struct passage *p, int64_t i, int side, struct wheel_input *in)
{
    const struct wheel_place place = passage_place(p, i, side);
    struct way_rail rail;

    passage_wheel_input(p, i, side, &place, &rail, in);
}

/* On a spatial rail; the next round has it. */
static void push_aside(struct rest *r, int64_t k, const struct wheel_input *in, const struct wheel_output *out)
{
    const struct head_force F = lateral_force(r->p->track, (int)(k % 2), in, out);
    struct wheel_memory *m = &r->p->memory[k];

    r->shift = fmax(r->shift, fabs(F.Y - m->Y));
    m->Y = m->Y_before = F.Y;
    m->M = m->M_before = F.M;
}

/* Height z of the wheel at which it carries `load`, with both wheels of the set at that height: bisection on a force that grows with z. */
static const char *seek_height(struct rest *r, int64_t k, double *z)
{
    struct passage *p = r->p;
    struct wheel_input in;
    struct wheel_output out = {0};
    double low, high, load = r->load[k];

    wheel_input(p, k / 2, (int)(k % 2), &in);
    in.roll = in.vroll = in.rail_v = in.vz = 0;
    in.rail_slope = in.rail_turn = 0;
    low = in.rail_z - 0.02;
    high = in.rail_z + 0.02;
    for (int i = 0; i < HEIGHT_MOST; i++) {
        struct wheel_memory memory = {.local = in.compliance * load, .Y = p->memory[k].Y, .M = p->memory[k].M};
        const char *why;
        in.z = 0.5 * (low + high);
        for (int j = 0; j < 3; j++) /* the creep force enters a step late */
            if ((why = wheel_force(&p->o.law, &in, &memory, &out)))
                return why;
        p->memory[k] = memory;
        if (fabs(out.Q - load) < HEIGHT_TOLERANCE)
            break;
        *(out.Q < load ? &low : &high) = in.z;
    }
    *z = in.z;
    if (trk_is_spatial(p->track)) {
        push_aside(r, k, &in, &out);
    } else if (*p->track->lateral_k > 0 && (!p->follows || *p->track->sleeper_lateral_k > 0)) { /* else both sides push on one mass */
        r->shift = fmax(r->shift, fabs(out.Y - *p->track->lateral_k * p->sideways.y[k]));
        p->sideways.y[k] = out.Y / *p->track->lateral_k; /* the next round has it */
    }
    return NULL;
}

/* Wheelsets stand where both wheels carry their loads, rolling without longitudinal creep. */
static const char *settle_wheelsets(struct rest *r)
{
    struct passage *p = r->p;

    for (int64_t i = 0; i < p->vehicle->wheelsets; i++) {
        double z[2], *q = p->train.q + 6 * p->vehicle->wheelset[i];
        double base = p->table[1]->wheel_position - p->table[0]->wheel_position;
        for (int s = 0; s < 2; s++) {
            const char *why = seek_height(r, 2 * i + s, &z[s]);
            if (why)
                return why;
        }
        q[VEH_Z] = 0.5 * (z[0] + z[1]);
        q[VEH_ROLL] = (z[1] - z[0]) / base;
    }
    return NULL;
}

/* Longitudinal creep forces of a wheelset rolling at `spin` beyond -v/r0, summed about the axle. */
static const char *axle_moment(struct rest *r, int64_t i, double spin, double *moment)
{
    struct passage *p = r->p;
    const char *why = NULL;

    p->train.v[6 * p->vehicle->wheelset[i] + VEH_PITCH] = spin;
    *moment = 0;
    for (int s = 0; s < 2 && !why; s++) {
        struct wheel_input in;
        struct wheel_memory memory = p->memory[2 * i + s];
        struct wheel_output out;
        wheel_input(p, i, s, &in);
        in.rail_slope = in.rail_turn = 0;
        why = wheel_force(&p->o.law, &in, &memory, &out);
        *moment += out.moment[1];
    }
    return why;
}

/* Free rolling: the spin at which the moment vanishes, bracketed by 2 % of v/r0; the moment falls with spin. */
static const char *settle_spin(struct rest *r, int64_t i)
{
    double high = 0.02 * r->p->o.speed / r->p->vehicle->radius[i], low = -high, moment;

    for (int k = 0; k < HEIGHT_MOST; k++) {
        double middle = 0.5 * (low + high);
        const char *why = axle_moment(r, i, middle, &moment);
        if (why)
            return why;
        *(moment > 0 ? &low : &high) = middle;
    }
    return NULL;
}

/* ---- bodies ---- */

static void find_free(struct rest *r)
{
    const struct veh *v = r->p->vehicle;

    for (int64_t i = 0; i < v->bodies; i++)
        for (int k = 0; k < 6 && !veh_is_wheelset(v, i); k++)
            r->free[r->n++] = 6 * i + k;
}

/* Bodies follow their wheelsets: one Newton step on the couplings, linear about rest. */
static const char *settle_bodies(struct rest *r)
{
    const struct veh *v = r->p->vehicle;
    struct train *t = &r->p->train;
    lapack_int n = (lapack_int)r->n;

    train_accelerate(t, r->p->wheel);
    for (int64_t i = 0; i < r->n; i++) {
        r->x[i] = t->f[r->free[i]];
        for (int64_t j = 0; j < r->n; j++)
            r->K[i * r->n + j] = v->K[r->free[i] * t->dofs + r->free[j]];
    }
    if (n > 0 && LAPACKE_dgesv(LAPACK_ROW_MAJOR, n, 1, r->K, n, r->pivot, r->x, 1) != 0)
        return "a body of the vehicle is not supported";
    for (int64_t i = 0; i < r->n; i++)
        t->q[r->free[i]] += r->x[i];
    return NULL;
}

/* What each wheelset's couplings and weight press down, shared by its wheels; *change is the largest change. */
static void share_loads(struct rest *r, double *change)
{
    const struct veh *v = r->p->vehicle;
    double base = r->p->table[1]->wheel_position - r->p->table[0]->wheel_position;

    memset(r->p->wheel, 0, (size_t)(2 * v->wheelsets) * sizeof *r->p->wheel);
    train_accelerate(&r->p->train, r->p->wheel);
    *change = 0;
    for (int64_t i = 0; i < v->wheelsets; i++) {
        const double *f = r->p->train.f + 6 * v->wheelset[i];
        for (int s = 0; s < 2; s++) {
            double load = 0.5 * f[VEH_Z] + (s ? 1 : -1) * f[VEH_ROLL] / base;
            *change = fmax(*change, fabs(load - r->load[2 * i + s]));
            r->load[2 * i + s] = load;
        }
    }
}

/* ---- all of it ---- */

/* The spin turns the creep force, which carries a little of the load: heights again after it. */
static const char *settle_wheels(struct rest *r)
{
    const char *why = settle_wheelsets(r);

    for (int64_t i = 0; i < r->p->vehicle->wheelsets && !why; i++)
        why = settle_spin(r, i);
    r->shift = 0;
    return why ? why : settle_wheelsets(r);
}

static const char *settle(struct rest *r)
{
    const struct veh *v = r->p->vehicle;
    const char *why = NULL;
    double change = HUGE_VAL;

    memcpy(r->load, v->wheel_load, (size_t)(2 * v->wheelsets) * sizeof *r->load);
    for (int i = 0; i < ROUNDS_MOST && change > LOAD_TOLERANCE && !why; i++)
        if (!(why = settle_track(r)) && !(why = settle_wheels(r)) && !(why = settle_bodies(r))) {
            share_loads(r, &change);
            change = fmax(change, r->shift);
        }
    if (!why && change > LOAD_TOLERANCE)
        why = reason("no static equilibrium found: wheel loads still change by %.3g N", change);
    return why;
}

/* ---- in curves, on cant, with unlike sides ---- */

/* Bodies that stand in straight frames stand so in those of the alignment. */
static void follow_alignment(struct passage *p)
{
    struct train *t = &p->train;

    train_locate(t, &p->alignment, p->station);
    for (int64_t i = 0; i < p->vehicle->bodies; i++) {
        double q[6], v[6];
        memcpy(q, t->q + 6 * i, sizeof q);
        memcpy(v, t->v + 6 * i, sizeof v);
        train_put(t, i, q, v);
    }
}

/* Wheel loads -> track -> train -> wheel loads. */
static const char *settle_steady(struct rest *r, struct steady *s)
{
    const int64_t wheels = 2 * r->p->vehicle->wheelsets;
    const char *why = NULL;
    double change = HUGE_VAL;

    for (int i = 0; i < ROUNDS_MOST && change > LOAD_TOLERANCE && !why; i++) {
        if ((why = settle_track(r)) || (why = steady_find(s)))
            break;
        r->shift = 0;
        for (int64_t k = 0; k < wheels && trk_is_spatial(r->p->track); k++) {
            struct wheel_input in;
            wheel_input(r->p, k / 2, (int)(k % 2), &in);
            push_aside(r, k, &in, &r->p->wheel[k]);
        }
        change = r->shift;
        for (int64_t k = 0; k < wheels; k++) {
            change = fmax(change, fabs(r->p->wheel[k].Q - r->load[k]));
            r->load[k] = r->p->wheel[k].Q;
        }
    }
    if (!why && change > LOAD_TOLERANCE)
        why = reason("no quasi-static equilibrium found: wheel loads still change by %.3g N", change);
    return why;
}

/* A train that its straight rest does not leave balanced. */
static const char *balance(struct rest *r)
{
    struct steady s;
    double left;
    const char *why;

    follow_alignment(r->p);
    if ((why = steady_new(&s, r->p)))
        return why;
    why = steady_unbalanced(&s, &left);
    if (!why && left > BALANCED * s.load)
        why = settle_steady(r, &s);
    steady_free(&s);
    return why;
}

/* The forces of that state; the motion begins with these accelerations. */
static const char *begin(struct passage *p, double *residual)
{
    const char *why = passage_forces(p);

    *residual = 0;
    if (why)
        return why;
    for (int64_t i = 0; i < p->vehicle->bodies; i++) {
        double carried[6];
        train_carried(&p->train, i, carried);
        for (int k = VEH_Y; k <= VEH_Z; k++)
            *residual = fmax(*residual, fabs(p->train.a[6 * i + k] - carried[k]) / p->vehicle->gravity);
    }
    for (size_t k = 0; k < (size_t)(2 * p->vehicle->wheelsets); k++) {
        p->memory[k].before = p->memory[k].local;
        p->memory[k].Q_before = p->memory[k].Q;
        p->memory[k].Y_before = p->memory[k].Y;
        p->memory[k].M_before = p->memory[k].M;
    }
    if (p->o.account)
        passage_account(p);
    memcpy(p->train.before, p->train.a, (size_t)p->train.dofs * sizeof *p->train.a);
    return NULL;
}

const char *passage_start(struct passage *p, double *residual)
{
    const struct veh *v = p->vehicle;
    struct rest r = {.p = p};
    size_t wheels = (size_t)(2 * v->wheelsets), dofs = (size_t)p->train.dofs;
    const char *why;

    train_locate(&p->train, &p->alignment, p->station);
    if (!v->bodies)
        return begin(p, residual);
    train_level(&p->train);
    r.f = calloc((size_t)p->track->dofs, sizeof *r.f);
    r.u = calloc((size_t)p->track->dofs, sizeof *r.u);
    r.load = calloc(wheels, sizeof *r.load);
    r.free = calloc(dofs, sizeof *r.free);
    r.K = calloc(dofs * dofs, sizeof *r.K);
    r.x = calloc(dofs, sizeof *r.x);
    r.pivot = calloc(dofs, sizeof *r.pivot);
    if (!r.f || !r.u || !r.load || !r.free || !r.K || !r.x || !r.pivot)
        why = REASON_MEMORY;
    else if (!(why = equilibrium_new(&r.track, p->track, p->vehicle->gravity))) {
        find_free(&r);
        if (!(why = settle(&r)) && !(why = balance(&r)))
            why = begin(p, residual);
        equilibrium_free(&r.track);
    }
    free(r.f);
    free(r.u);
    free(r.load);
    free(r.free);
    free(r.K);
    free(r.x);
    free(r.pivot);
    return why;
}
