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
        dof[2 * end] = t->node_dof[t->nodes > 1 ? p->node + end : 0] + 2 * rail;
        dof[2 * end + 1] = dof[2 * end] + 1;
    }
}
