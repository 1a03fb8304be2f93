#include "tools/integrate/head.h"

#define NEAR 1e-4 /* of the length, for the derivative of a compliance that has no closed form here */

/* Half of db/da: uniform Euler-Bernoulli a^3 c^3/(3 EI L^3), c = L - a, else by differences within the element. */
static double half_slope(const struct beam *b, double a)
{
    const double L = b->length, c = L - a;

    if (b->bending > 0 && b->shear <= 0)
        return a * a * c * c * (c - a) / (2 * b->bending * L * L * L);
    const double from = a > NEAR * L ? a - NEAR * L : a, to = c > NEAR * L ? a + NEAR * L : a;
    return 0.5 * (beam_compliance(b, to) - beam_compliance(b, from)) / (to - from);
}

/* y + height twist; yaw = dy/dx is the other way round than a beam's turn, and twist is straight between the ends. */
void head_find(struct head_place *p, const struct beam *lateral, double torsion, double a, double height, int64_t near, int64_t far)
{
    const double L = lateral->length, r = a / L;
    double N[4], D[4];

    beam_shape(lateral, a, N);
    beam_slope(lateral, a, D);
    *p = (struct head_place){.y.n = 6, .slope.n = 6, .twist.n = 2, .turn.n = 2, .height = height};
    for (int end = 0; end < 2; end++) {
        const int64_t w = end ? far : near;
        const double share = end ? r : 1 - r, change = end ? 1 / L : -1 / L;
        const int64_t dof[3] = {w + TRK_Y, w + TRK_YAW, w + TRK_TWIST};
        const double y[3] = {N[2 * end], -N[2 * end + 1], height * share}, slope[3] = {D[2 * end], -D[2 * end + 1], height * change};
        for (int k = 0; k < 3; k++) {
            p->y.dof[3 * end + k] = p->slope.dof[3 * end + k] = dof[k];
            p->y.share[3 * end + k] = y[k];
            p->slope.share[3 * end + k] = slope[k];
        }
        p->twist.dof[end] = p->turn.dof[end] = dof[2];
        p->twist.share[end] = share;
        p->turn.share[end] = change;
    }
    p->b = beam_compliance(lateral, a);
    p->b_half = half_slope(lateral, a);
    p->t = a * (L - a) / (torsion * L);
    p->t_half = 0.5 * (L - 2 * a) / (torsion * L);
}

int head_find_check(struct head_place *p, const struct trk *t, double x)
{
    const int64_t n = t->check_nodes;
    int64_t i = 0;

    if (n < 2 || x < t->x[t->check_node[0]] || x > t->x[t->check_node[n - 1]])
        return 0;
    while (i < n - 2 && x >= t->x[t->check_node[i + 1]])
        i++;
    const double from = t->x[t->check_node[i]];
    const struct beam b = {.length = t->x[t->check_node[i + 1]] - from, .bending = t->check_bending[1]};
    head_find(p, &b, *t->check_torsion, x - from, *t->check_head, t->check_dof[i], t->check_dof[i + 1]);
    return 1;
}

/* Under a moving force d(b F)/dt = v b' F + b F'; of that v b' F/2 is the slope's, the rest the material's. */
void head_bend(const struct head_place *p, const struct head_force *F, const struct head_force *rate, double speed, struct head_motion *m)
{
    const double h = p->height, moment = F->M + h * F->Y, moment_rate = rate->M + h * rate->Y;
    const double half = p->b_half * F->Y + h * p->t_half * moment;

    m->y += p->b * F->Y + h * p->t * moment;
    m->v += speed * half + p->b * rate->Y + h * p->t * moment_rate;
    m->slope += half;
    m->roll += p->t * moment;
    m->vroll += speed * 2 * p->t_half * moment + p->t * moment_rate;
}
