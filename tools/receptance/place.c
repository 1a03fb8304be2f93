#include "tools/receptance/place.h"

#include <math.h>
#include <string.h>

#include "tools/track/rails.h"

const char *const place_on[] = {"left", "right", "both", "sleeper", NULL}, *const place_at[] = {"sleeper", "midspan", "station", NULL};

static void add(struct place *p, int64_t dof, double share)
{
    p->dof[p->dofs] = dof;
    p->share[p->dofs++] = share;
}

static void find_sleeper(struct place *p, const struct trk *t, double x)
{
    int64_t nearest = 0;

    for (int64_t k = 1; k < t->sleepers; k++)
        if (fabs(t->sleeper_x[k] - x) < fabs(t->sleeper_x[nearest] - x) * (1 - 1e-9))
            nearest = k;
    p->at = AT_SLEEPER;
    p->x = t->sleeper_x[nearest];
    add(p, t->sleeper_dof[nearest], 1);
}

void place_find(struct place *p, const struct trk *t, int on, int at, double x)
{
    memset(p, 0, sizeof *p);
    p->on = on;
    p->at = at;
    if (on == PLACE_SLEEPER) {
        find_sleeper(p, t, x);
        return;
    }
    point_at(&p->point, t, at == AT_STATION ? x : point_station(t, at, x));
    p->x = p->point.x;
    for (int rail = 0; rail < TRK_RAILS; rail++) {
        int64_t dof[4];
        point_dofs(&p->point, t, rail, dof);
        for (int k = 0; k < 4 && point_loads(on, rail); k++)
            add(p, dof[k], p->point.shape[rail][k]);
    }
}

double place_held(const struct place *force, const struct place *seen, const struct trk *t)
{
    const int64_t node = seen->point.node;

    if (force->on == PLACE_SLEEPER || seen->on == PLACE_SLEEPER || force->point.node != node || !point_loads(force->on, point_rail(seen->on)))
        return 0;
    const int rail = point_rail(seen->on);
    if (force->x == seen->x)
        return seen->point.compliance[rail];
    const struct beam b = rails_beam(t, rail, node);
    return beam_between(&b, fmin(force->x, seen->x) - t->x[node], fmax(force->x, seen->x) - t->x[node]);
}
