#include "tools/draw/limits.h"

#include <math.h>

/* A point that can be drawn on these axes. */
static int drawable(const struct chart_axis *x, const struct chart_axis *y, const struct chart_series *s, int64_t i)
{
    return isfinite(s->x[i]) && isfinite(s->y[i]) && (!x->log || s->x[i] > 0) && (!y->log || s->y[i] > 0);
}

static void settle(const struct chart_axis *a, double *lo, double *hi)
{
    if (a->lo != a->hi) {
        *lo = a->lo;
        *hi = a->hi;
    } else if (*lo > *hi) {
        *lo = a->log;
        *hi = a->log ? 10 : 1;
    } else if (*lo == *hi) {
        double half = a->whole || *lo == 0 ? 1 : 0.1 * fabs(*lo);
        *lo -= half;
        *hi += half;
    }
}

void limits_x(const struct chart *c, double *lo, double *hi)
{
    *lo = INFINITY;
    *hi = -INFINITY;
    for (int p = 0; p < c->panels; p++)
        for (const struct chart_series *s = c->panel[p].series; s; s = s->next)
            for (int64_t i = 0; i < s->n; i++)
                if (drawable(&c->x, &c->panel[p].y, s, i)) {
                    *lo = fmin(*lo, s->x[i]);
                    *hi = fmax(*hi, s->x[i]);
                }
    settle(&c->x, lo, hi);
}

void limits_y(const struct chart_panel *p, const struct chart_axis *x, double xlo, double xhi, double *lo, double *hi)
{
    *lo = INFINITY;
    *hi = -INFINITY;
    for (const struct chart_series *s = p->series; s; s = s->next)
        for (int64_t i = 0; i < s->n; i++)
            if (drawable(x, &p->y, s, i) && s->x[i] >= xlo && s->x[i] <= xhi) {
                *lo = fmin(*lo, s->y[i]);
                *hi = fmax(*hi, s->y[i]);
            }
    settle(&p->y, lo, hi);
}
