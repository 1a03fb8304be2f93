#include "tools/draw/modes.h"

#include <math.h>
#include <string.h>

enum { MODES = 4 };

/* Deflections of the n nodes with degrees of freedom dof[k] + behind of a shape, over its largest one. */
static double *deflections(struct chart *c, const double *shape, int64_t n, const int64_t *dof, int behind, double largest)
{
    double *w = chart_numbers(c, n);

    for (int64_t k = 0; w && k < n; k++)
        w[k] = shape[dof[k] + behind] / largest;
    return w;
}

/* The deflection of rails and sleepers largest in magnitude, with its sign. */
static double largest_of(const struct trk *t, const double *shape)
{
    double largest = 0;

    for (int64_t k = 0; k < t->nodes; k++)
        for (int rail = 0; rail < TRK_RAILS; rail++)
            if (fabs(shape[t->node_dof[k] + 2 * rail]) > fabs(largest))
                largest = shape[t->node_dof[k] + 2 * rail];
    for (int64_t k = 0; k < t->sleepers; k++)
        if (fabs(shape[t->sleeper_dof[k]]) > fabs(largest))
            largest = shape[t->sleeper_dof[k]];
    return largest == 0 ? 1 : largest;
}

static void add_mode(struct chart *c, const struct mod *m, const struct trk *t, int64_t mode)
{
    const double *shape = m->shape + mode * m->dofs;
    double largest = largest_of(t, shape);
    struct chart_panel *p = chart_add_panel(c, chart_words(c, "%.2f Hz", m->frequency[mode]), 1);
    const double *left = deflections(c, shape, t->nodes, t->node_dof, 0, largest);
    const double *right = deflections(c, shape, t->nodes, t->node_dof, 2, largest);
    const double *sleeper = deflections(c, shape, t->sleepers, t->sleeper_dof, 0, largest);

    if (!left || !right || !sleeper)
        return;
    p->y.down = 1;
    chart_add_series(c, p, "left rail", t->nodes, t->x, left);
    chart_add_series(c, p, "right rail", t->nodes, t->x, right)->dash = CANVAS_DASHED;
    struct chart_series *s = chart_add_series(c, p, "sleepers", t->sleepers, t->sleeper_x, sleeper);
    s->width = 0;
    s->mark = CANVAS_DISC;
    s->size = 3;
}

const char *modes_chart(struct chart *c, const struct mod *m, const struct trk *t)
{
    if (strcmp(m->of, "trk") != 0 || m->dofs != t->dofs)
        return "the modes are not those of this track";
    c->title = chart_words(c, "Natural modes of %s", t->name);
    c->x.label = "station (m)";
    c->alike = 1;
    for (int64_t k = 0; k < m->n && k < MODES; k++)
        add_mode(c, m, t, k);
    return c->why;
}
