/* The element's shapes, Hermite's polynomials where it is uniform without shear, carry a force between the nodes to them, and the nodes'
 * motion back; what the element itself gives under the force is its compliance with held ends, which a massless element has at every
 * frequency and one with mass far below the resonance of its held ends. */
#include "tools/track/point.h"

#include <math.h>

#include "tools/track/rails.h"

double point_station(const struct trk *t, int at, double x)
{
    const int64_t n = at == AT_MIDSPAN ? t->sleepers - 1 : t->sleepers;
    double best = t->sleeper_x[0];

    for (int64_t k = 0; k < n; k++) {
        double station = at == AT_MIDSPAN ? 0.5 * (t->sleeper_x[k] + t->sleeper_x[k + 1]) : t->sleeper_x[k];
        if (k == 0 || fabs(station - x) < fabs(best - x) * (1 - 1e-9))
            best = station;
    }
    return best;
}

void point_at(struct point *p, const struct trk *t, double x)
{
    int64_t i = 0;

    x = fmin(fmax(x, t->x[0]), t->x[t->nodes - 1]);
    while (i < t->nodes - 2 && x >= t->x[i + 1])
        i++;
    *p = (struct point){.x = x, .node = i};
    for (int rail = 0; rail < TRK_RAILS && t->nodes == 1; rail++)
        p->shape[rail][0] = 1;
    for (int rail = 0; rail < TRK_RAILS && t->nodes > 1; rail++) {
        const struct beam b = rails_beam(t, rail, i);
        beam_shape(&b, x - t->x[i], p->shape[rail]);
        p->compliance[rail] = beam_compliance(&b, x - t->x[i]);
    }
}

void point_dofs(const struct point *p, const struct trk *t, int rail, int64_t dof[4])
{
    for (int end = 0; end < 2; end++) {
        dof[2 * end] = trk_rail_dof(t, rail, t->nodes > 1 ? p->node + end : 0);
        dof[2 * end + 1] = dof[2 * end] + 1;
    }
}

/* y + height twist at a from the near end of an element of two planes; twist is straight between the ends, and with
 * these held a moment twists it by a (L - a)/(GJ L). */
static void lay_lateral(const struct beam *b, double torsion, double a, double height, int64_t near, int64_t far, int64_t *dof, double *share,
                        double *held)
{
    const double r = a / b->length;
    double N[4];

    beam_shape(b, a, N);
    for (int end = 0; end < 2; end++) {
        const int64_t w = end ? far : near;
        dof[3 * end] = w + TRK_Y;
        dof[3 * end + 1] = w + TRK_YAW;
        dof[3 * end + 2] = w + TRK_TWIST;
        share[3 * end] = N[2 * end];
        share[3 * end + 1] = -N[2 * end + 1];                /* yaw = dy/dx */
        share[3 * end + 2] = height * (end ? r : 1 - r);
    }
    *held = beam_compliance(b, a) + height * height * a * (b->length - a) / (torsion * b->length);
}

void point_lateral(const struct point *p, const struct trk *t, int rail, double height, int64_t *dof, double *share, double *held)
{
    const struct beam b = rails_lateral_beam(t, rail, p->node);

    lay_lateral(&b, t->rail_torsion[rail * (t->nodes - 1) + p->node], p->x - t->x[p->node], height, trk_rail_dof(t, rail, p->node),
                trk_rail_dof(t, rail, p->node + 1), dof, share, held);
}

int point_check(const struct trk *t, double x, double height, int64_t *dof, double *share, double *held)
{
    const int64_t n = t->check_nodes;
    int64_t i = 0;

    if (n == 0 || x < t->x[t->check_node[0]] || x > t->x[t->check_node[n - 1]])
        return 0;
    while (i < n - 2 && x >= t->x[t->check_node[i + 1]])
        i++;
    const double from = t->x[t->check_node[i]];
    const struct beam b = {.length = t->x[t->check_node[i + 1]] - from, .bending = t->check_bending[1]};
    lay_lateral(&b, *t->check_torsion, x - from, height, t->check_dof[i], t->check_dof[i + 1], dof, share, held);
    return 1;
}
