#include "tools/receptance/place.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
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
    add(p, t->sleeper_dof[nearest] + (p->lateral ? TRK_SLEEPER_Y : TRK_Z), 1);
}

static void add_lateral(struct place *p, const struct trk *t, int rail)
{
    int64_t dof[POINT_LATERAL];
    double share[POINT_LATERAL], held;

    point_lateral(&p->point, t, rail, *t->rail_head, dof, share, &held);
    for (int k = 0; k < POINT_LATERAL; k++)
        add(p, dof[k], share[k]);
}

static void add_vertical(struct place *p, const struct trk *t, int rail)
{
    int64_t dof[4];

    point_dofs(&p->point, t, rail, dof);
    for (int k = 0; k < 4; k++)
        add(p, dof[k], p->point.shape[rail][k]);
}

static void find(struct place *p, const struct trk *t, int on, int at, double x, int lateral)
{
    memset(p, 0, sizeof *p);
    p->on = on;
    p->at = at;
    p->lateral = lateral;
    if (on == PLACE_SLEEPER) {
        find_sleeper(p, t, x);
        return;
    }
    point_at(&p->point, t, at == AT_STATION ? x : point_station(t, at, x));
    p->x = p->point.x;
    for (int rail = 0; rail < TRK_RAILS; rail++)
        if (point_loads(on, rail))
            (lateral ? add_lateral : add_vertical)(p, t, rail);
}

void place_find(struct place *p, const struct trk *t, int on, int at, double x)
{
    find(p, t, on, at, x, 0);
}

void place_find_lateral(struct place *p, const struct trk *t, int on, int at, double x)
{
    find(p, t, on, at, x, 1);
}

/* Sideways at the running surface the element bends and twists; x <= a as in beam_between. */
static double held_lateral(const struct trk *t, int rail, int64_t node, double x, double a)
{
    const struct beam b = rails_lateral_beam(t, rail, node);
    const double h = *t->rail_head, twist = x * (b.length - a) / (t->rail_torsion[rail * (t->nodes - 1) + node] * b.length);

    return beam_between(&b, x, a) + h * h * twist;
}

/* A decimal number and nothing else. */
static int is_number(const char *text, double *value)
{
    char *end;

    *value = strtod(text, &end);
    return end > text && !*end && strspn(text, "+-.0123456789eE") == strlen(text);
}

const char *place_near(const struct trk *t, double near)
{
    const double first = t->x[0], last = t->x[t->nodes - 1];

    if (near > PLACE_MIDDLE && !(near >= first && near <= last))
        return reason("%g must be %g to %g, where the rails are", near, first, last);
    return NULL;
}

const char *place_named(struct place *p, const struct trk *t, int on, const char *where, double near, int lateral)
{
    const double first = t->x[0], last = t->x[t->nodes - 1];
    double x = near > PLACE_MIDDLE ? near : 0.5 * (first + last);
    int at = AT_SLEEPER;

    while (at < AT_STATION && strcmp(where, place_at[at]) != 0)
        at++;
    if (at == AT_MIDSPAN && t->sleepers == 1)
        return "midspan: a moving mass has no span";
    if (at == AT_STATION && !is_number(where, &x))
        return reason("\"%s\" must be sleeper, midspan or a station in m", where);
    if (at == AT_STATION && !(x >= first && x <= last))
        return reason("%g must be %g to %g, where the rails are", x, first, last);
    (lateral ? place_find_lateral : place_find)(p, t, on, at, x);
    return NULL;
}

void place_load(const struct place *p, double force, double *f)
{
    for (int k = 0; k < p->dofs; k++)
        f[p->dof[k]] += force * p->share[k];
}

double place_motion(const struct place *p, const double *u)
{
    double w = 0;

    for (int k = 0; k < p->dofs; k++)
        w += p->share[k] * u[p->dof[k]];
    return w;
}

double place_held(const struct place *force, const struct place *seen, const struct trk *t)
{
    const int64_t node = seen->point.node;

    if (force->lateral != seen->lateral || force->on == PLACE_SLEEPER || seen->on == PLACE_SLEEPER ||
        force->point.node != node || !point_loads(force->on, point_rail(seen->on)))
        return 0;
    const int rail = point_rail(seen->on);
    if (force->lateral)
        return held_lateral(t, rail, node, fmin(force->x, seen->x) - t->x[node], fmax(force->x, seen->x) - t->x[node]);
    if (force->x == seen->x)
        return seen->point.compliance[rail];
    const struct beam b = rails_beam(t, rail, node);
    return beam_between(&b, fmin(force->x, seen->x) - t->x[node], fmax(force->x, seen->x) - t->x[node]);
}
