#include "tools/draw/modes.h"

#include <math.h>
#include <string.h>

enum { PIECES = 8 };       /* of the line between two nodes */

/* A direction of motion: where its displacement stands in a rail and a sleeper, and the slope of a rail over the turn that follows it, 0 of
 * twist, which is straight between nodes. */
struct direction { int64_t rail, sleeper; double slope; };

static const struct direction DOWN = {TRK_W, TRK_Z, -1}, SIDEWAYS = {TRK_Y, TRK_SLEEPER_Y, 1}, TWIST = {TRK_TWIST, TRK_ROLL, 0};

/* Displacement of a rail, in a shape `behind` w of the left one, at point i of PIECES an element, and its station: between nodes by Hermite's
 * polynomials of displacement and turn; a moving mass is one node. */
static double bent(const struct trk *t, const double *shape, int64_t behind, double slope, int64_t i, double *x)
{
    const int64_t k = i / PIECES < t->nodes - 1 || i == 0 ? i / PIECES : t->nodes - 2;
    const double *one = &shape[t->node_dof[k] + behind];

    *x = t->x[k];
    if (i == PIECES * k)
        return one[0];
    const double *two = &shape[t->node_dof[k + 1] + behind];
    const double L = t->x[k + 1] - t->x[k], r = (double)(i - PIECES * k) / PIECES, s = 1 - r;
    *x += r * L;
    if (slope == 0)
        return s * one[0] + r * two[0];
    return s * s * (1 + 2 * r) * one[0] + slope * r * s * s * L * one[1] + r * r * (1 + 2 * s) * two[0] - slope * r * r * s * L * two[1];
}

static void add_rail(struct chart *c, struct chart_panel *p, const struct trk *t, const double *shape, int rail, const struct direction *d,
                     double largest)
{
    const int64_t n = PIECES * (t->nodes - 1) + 1;
    double *x = chart_numbers(c, n), *w = chart_numbers(c, n);

    if (!x || !w)
        return;
    for (int64_t i = 0; i < n; i++)
        w[i] = bent(t, shape, t->rail_dofs * rail + d->rail, d->slope, i, &x[i]) / largest;
    struct chart_series *s = chart_add_series(c, p, rail == TRK_LEFT ? "left rail" : "right rail", n, x, w);
    s->dash = rail == TRK_LEFT ? CANVAS_SOLID : CANVAS_DASHED;
    if (n == 1)
        s->mark = CANVAS_DISC;
}

static void add_sleepers(struct chart *c, struct chart_panel *p, const struct trk *t, const double *shape, const struct direction *d,
                         double largest)
{
    double *z = chart_numbers(c, t->sleepers);

    for (int64_t k = 0; z && k < t->sleepers; k++)
        z[k] = shape[t->sleeper_dof[k] + d->sleeper] / largest;
    if (!z)
        return;
    struct chart_series *s = chart_add_series(c, p, "sleepers", t->sleepers, t->sleeper_x, z);
    s->width = 0;
    s->mark = CANVAS_DISC;
    s->size = 3;
}

/* A check rail that is a beam, at its nodes. */
static void add_check(struct chart *c, struct chart_panel *p, const struct trk *t, const double *shape, const struct direction *d, double largest)
{
    double *x = chart_numbers(c, t->check_nodes), *w = chart_numbers(c, t->check_nodes);

    if (!x || !w || t->check_nodes == 0)
        return;
    for (int64_t k = 0; k < t->check_nodes; k++) {
        x[k] = t->x[t->check_node[k]];
        w[k] = shape[t->check_dof[k] + d->rail] / largest;
    }
    chart_add_series(c, p, "check rail", t->check_nodes, x, w);
}

/* The displacement of rails, between their nodes too, and of sleepers that is largest in magnitude, with its sign. */
static double largest_of(const struct trk *t, const double *shape, const struct direction *d)
{
    double largest = 0;

    for (int64_t i = 0; i <= PIECES * (t->nodes - 1); i++)
        for (int rail = 0; rail < TRK_RAILS; rail++) {
            double x;
            const double w = bent(t, shape, t->rail_dofs * rail + d->rail, d->slope, i, &x);
            largest = fabs(w) > fabs(largest) ? w : largest;
        }
    for (int64_t k = 0; k < t->check_nodes; k++)
        if (fabs(shape[t->check_dof[k] + d->rail]) > fabs(largest))
            largest = shape[t->check_dof[k] + d->rail];
    for (int64_t k = 0; k < t->sleepers; k++)
        if (fabs(shape[t->sleeper_dof[k] + d->sleeper]) > fabs(largest))
            largest = shape[t->sleeper_dof[k] + d->sleeper];
    return largest;
}

/* A spatial track is shown from the side or, where it moves more sideways, from above; of torsion the twist of rails and the roll of sleepers. */
static void add_mode(struct chart *c, const struct mod *m, const struct trk *t, int64_t mode)
{
    const double *shape = m->shape + mode * m->dofs, down = largest_of(t, shape, &DOWN);
    const double aside = trk_is_spatial(t) ? largest_of(t, shape, &SIDEWAYS) : 0;
    const int torsion = trk_is_spatial(t) && !strncmp(m->name[mode], "torsion", strlen("torsion"));
    const struct direction *d = torsion ? &TWIST : fabs(aside) > fabs(down) ? &SIDEWAYS : &DOWN;
    const double most = largest_of(t, shape, d), largest = most == 0 ? 1 : most;
    const char *which = !trk_is_spatial(t) ? "" : torsion ? ", turn" : d == &DOWN ? ", z" : ", y";
    struct chart_panel *p = chart_add_panel(c, chart_words(c, "%.2f Hz%s", m->frequency[mode], which), 1);

    p->y.down = 1;
    add_rail(c, p, t, shape, TRK_LEFT, d, largest);
    add_rail(c, p, t, shape, TRK_RIGHT, d, largest);
    add_sleepers(c, p, t, shape, d, largest);
    add_check(c, p, t, shape, d, largest);
}

void modes_begin(struct chart *c, const struct trk *t)
{
    c->title = chart_words(c, "Natural modes of %s", t->name);
    c->x.label = "station (m)";
    c->alike = 1;
}

const char *modes_add(struct chart *c, const struct mod *m, const struct trk *t, int most)
{
    if (strcmp(m->of, "trk") != 0 || m->dofs != t->dofs)
        return "the modes are not those of this track";
    for (int64_t k = 0; k < m->n && k < most && c->panels < CHART_PANELS; k++)
        add_mode(c, m, t, k);
    return c->why;
}
