/* Newton's method on the energy, which is convex and quadratic in pieces: K of the springs that touch gives the next state, an exact search
 * along the line to it keeps the energy falling, and so a finite number of pieces is met (Sun 1997, Mathematical Programming 76, 451).  Without
 * springs that only push it is one solution.  Where what touches does not hold the track, as a sleeper tilted onto one spring, the step is that
 * of all springs, each open one without force where it is: more than the energy can be, so it falls too. */
#include "tools/track/equilibrium.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/track/assemble.h"

enum { ROUNDS_MOST = 200, HALVINGS = 60 };
static const double TOUCH = 1e-12;    /* m, so near to its gap a spring counts as it did before */

struct equilibrium_push {
    int64_t spring;      /* of [3][sleepers] */
    int64_t z;           /* dof of its sleeper, roll follows */
    double y, k, gap;    /* m, N/m, m */
    int closed, held;    /* touches; has a part in K */
    double lean;         /* m, beyond the gap where it is held without force */
    double over, rate;   /* m, beyond the gap at a state, and its change along a line from there */
};

static double beyond(const struct equilibrium_push *p, const double *u)
{
    return u[p->z] + p->y * u[p->z + 1] - p->gap;
}

/* Column j of M, times g. */
static void weigh_dof(const struct trk *t, int64_t j, double gravity, double *f)
{
    for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
        f[t->Ai[p]] += t->Mx[p] * gravity;
}

/* f = g M v with v = 1 for each deflection down: what lies along the elements loads their nodes as it moves with them. */
static void weigh(const struct trk *t, double gravity, double *f)
{
    for (int64_t i = 0; i < t->nodes; i++)
        for (int rail = 0; rail < TRK_RAILS; rail++)
            weigh_dof(t, trk_rail_dof(t, rail, i), gravity, f);
    for (int64_t i = 0; i < t->check_nodes; i++)
        weigh_dof(t, t->check_dof[i], gravity, f);
    for (int64_t i = 0; i < t->sleepers; i++)
        weigh_dof(t, t->sleeper_dof[i], gravity, f);
}

/* Whether other springs touch at u than did. */
static int touch(struct equilibrium *e, const double *u)
{
    int changed = 0;

    for (int64_t i = 0; i < e->pushes; i++) {
        struct equilibrium_push *p = &e->push[i];
        const double over = beyond(p, u);
        const int now = fabs(over) > TOUCH ? over > 0 : p->closed;
        changed |= now != p->closed;
        p->closed = now;
    }
    return changed;
}

/* K of the springs that are held. */
static const char *factor_held(struct equilibrium *e)
{
    double *K = (double *)e->tangent.Kx;

    memcpy(K, e->bare, (size_t)e->track->Ap[e->track->dofs] * sizeof *K);
    for (int64_t i = 0; i < e->pushes; i++)
        if (e->push[i].held)
            assemble_ballast(&e->tangent, K, e->push[i].spring, e->push[i].k);
    return cholesky_again(&e->factor);
}

/* Of what touches at u, or of all; *newton says which. */
static const char *factor(struct equilibrium *e, const double *u, int *newton)
{
    for (int64_t i = 0; i < e->pushes; i++) {
        e->push[i].held = e->push[i].closed;
        e->push[i].lean = 0;
    }
    *newton = factor_held(e) == NULL;
    for (int64_t i = 0; i < e->pushes && !*newton; i++) {
        e->push[i].lean = e->push[i].held ? 0 : beyond(&e->push[i], u);
        e->push[i].held = 1;
    }
    return *newton ? NULL : factor_held(e);
}

/* K u = f + k (gap + lean) of what is held: Newton's step from any state, or that of all springs from where they lean. */
static const char *solve(struct equilibrium *e, const double *f, double *u)
{
    memcpy(e->load, f, (size_t)e->track->dofs * sizeof *f);
    for (int64_t i = 0; i < e->pushes; i++) {
        const struct equilibrium_push *p = &e->push[i];
        if (p->held) {
            e->load[p->z] += p->k * (p->gap + p->lean);
            e->load[p->z + 1] += p->k * (p->gap + p->lean) * p->y;
        }
    }
    return cholesky_solve(&e->factor, e->load, u);
}

/* d'K d with d = next - u. */
static double curvature(const struct trk *t, const double *u, const double *next)
{
    double sum = 0;

    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            sum += (next[j] - u[j]) * t->Kx[p] * (next[t->Ai[p]] - u[t->Ai[p]]);
    return sum;
}

/* The energy's slope along the line: -(1 - a) d'K d, and what springs differ from K, which takes those held as bonded. */
static double slope(const struct equilibrium *e, double dKd, double a)
{
    double sum = -(1 - a) * dKd;

    for (int64_t i = 0; i < e->pushes; i++) {
        const struct equilibrium_push *p = &e->push[i];
        const double over = p->over + a * p->rate;
        sum += p->k * p->rate * (fmax(over, 0) - (p->held ? over - p->lean : 0));
    }
    return sum;
}

/* The part of the way from u to next with the least energy, at most all of it. */
static double find_part(struct equilibrium *e, const double *u, const double *next)
{
    const double dKd = curvature(&e->tangent, u, next);
    double low = 0, high = 1;

    for (int64_t i = 0; i < e->pushes; i++) {
        e->push[i].over = beyond(&e->push[i], u);
        e->push[i].rate = beyond(&e->push[i], next) - e->push[i].over;
    }
    if (slope(e, dKd, 1) <= 0)
        return 1;
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        *(slope(e, dKd, middle) > 0 ? &high : &low) = middle;
    }
    return low;
}

const char *equilibrium_find(struct equilibrium *e, const double *f, double *u)
{
    const char *why = solve(e, f, u);
    double part = 1;
    int newton = 1;

    for (int round = 0; !why && (touch(e, u) || part < 1 || !newton); round++) {
        if (round == ROUNDS_MOST)
            return reason("no static equilibrium on the ballast after %d rounds", ROUNDS_MOST);
        if ((why = factor(e, u, &newton)) || (why = solve(e, f, e->next)))
            return why;
        part = find_part(e, u, e->next);
        for (int64_t i = 0; i < e->track->dofs; i++)
            u[i] = part < 1 ? u[i] + part * (e->next[i] - u[i]) : e->next[i];
    }
    return why;
}

const char *equilibrium_add(struct equilibrium *e, const double *f, double *u)
{
    const int64_t n = e->track->dofs;

    if (!e->pushes)
        return cholesky_solve(&e->factor, f, u);
    double *total = calloc((size_t)n, sizeof *total);
    if (!total)
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++)
        total[i] = e->weight[i] + f[i];
    const char *why = equilibrium_find(e, total, u);
    for (int64_t i = 0; i < n; i++)
        u[i] -= e->rest[i];
    free(total);
    return why;
}

/* The springs that only push, all touching, in K too. */
static const char *gather(struct equilibrium *e)
{
    const struct trk *t = e->track;
    const int64_t springs = TRK_BALLAST * t->sleepers;
    int64_t *open = trk_room(&e->tangent, springs, sizeof *open);

    e->push = calloc((size_t)springs, sizeof *e->push);
    if (!open || !e->push)
        return REASON_MEMORY;
    for (int64_t i = 0; i < springs; i++) {
        open[i] = t->ballast_state[i] == TRK_BONDED ? TRK_BONDED : TRK_OPEN;
        if (open[i] == TRK_OPEN)
            e->push[e->pushes++] = (struct equilibrium_push){.spring = i, .z = t->sleeper_dof[i % t->sleepers], .y = t->ballast_y[i],
                                                             .k = t->ballast_k[i], .gap = t->ballast_gap[i], .closed = 1,
                                                             .held = 1};
    }
    e->tangent.ballast_state = open;
    return e->pushes ? assemble_track(&e->tangent) : NULL;
}

static const char *begin(struct equilibrium *e)
{
    const size_t n = (size_t)e->track->dofs, entries = (size_t)e->track->Ap[n];
    const char *why = gather(e);

    if (why || !e->pushes)
        return why ? why : cholesky_new(&e->factor, &e->tangent);
    if (!(e->bare = calloc(entries, sizeof *e->bare)))
        return REASON_MEMORY;
    memcpy(e->bare, e->tangent.Kx, entries * sizeof *e->bare);
    for (int64_t i = 0; i < e->pushes; i++)
        assemble_ballast(&e->tangent, (double *)e->tangent.Kx, e->push[i].spring, e->push[i].k);
    return cholesky_new(&e->factor, &e->tangent);
}

const char *equilibrium_new(struct equilibrium *e, const struct trk *t, double gravity)
{
    const size_t n = (size_t)t->dofs;

    *e = (struct equilibrium){.track = t, .tangent = *t};
    e->tangent.store = NULL;
    e->weight = calloc(n, sizeof *e->weight);
    e->rest = calloc(n, sizeof *e->rest);
    e->next = calloc(n, sizeof *e->next);
    e->load = calloc(n, sizeof *e->load);
    const char *why = e->weight && e->rest && e->next && e->load ? begin(e) : REASON_MEMORY;
    if (!why) {
        weigh(t, gravity, e->weight);
        why = equilibrium_find(e, e->weight, e->rest);
    }
    if (why)
        equilibrium_free(e);
    return why;
}

void equilibrium_states(const struct equilibrium *e, int64_t *state)
{
    for (int64_t i = 0; i < TRK_BALLAST * e->track->sleepers; i++)
        state[i] = TRK_BONDED;
    for (int64_t i = 0; i < e->pushes; i++)
        state[e->push[i].spring] = e->push[i].closed ? TRK_CLOSED : TRK_OPEN;
}

void equilibrium_free(struct equilibrium *e)
{
    cholesky_free(&e->factor);
    trk_free(&e->tangent);
    free(e->weight);
    free(e->rest);
    free(e->next);
    free(e->load);
    free(e->push);
    free(e->bare);
    *e = (struct equilibrium){0};
}

const char *equilibrium_settle(struct trk *t, double gravity)
{
    const int64_t springs = TRK_BALLAST * t->sleepers;
    struct equilibrium e;
    int loose = 0;

    for (int64_t i = 0; i < springs; i++)
        loose |= t->ballast_state[i] != TRK_BONDED;
    int64_t *state = loose ? trk_room(t, springs, sizeof *state) : NULL;
    if (!state)
        return loose ? REASON_MEMORY : NULL;
    const char *why = equilibrium_new(&e, t, gravity);
    if (why)
        return why;
    equilibrium_states(&e, state);
    t->ballast_state = state;
    equilibrium_free(&e);
    return assemble_track(t);
}
