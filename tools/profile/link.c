#include "tools/profile/link.h"

#include <math.h>

#define NEAREST 2e-4         /* m, between features */
#define GROWTH 0.25          /* of the distance between features that are the same in both sections */
#define GROWTH_LEAST 5e-3    /* m */
#define END_GROWTH 0.1       /* the same of ends */
#define END_LEAST 2e-3       /* m */
#define ROUNDING 1e-12       /* m */

static int alike(double a, double b, double share, double least)
{
    return fabs(a - b) <= share * fmax(a, b) + least;
}

static void knot_put(struct link *l, int at, double a, double b)
{
    for (int i = l->n++; i > at; i--) {
        l->a[i] = l->a[i - 1];
        l->b[i] = l->b[i - 1];
    }
    l->a[at] = a;
    l->b[at] = b;
}

void link_make(const struct piece *a, const struct piece *b, struct link *l)
{
    l->n = 0;
    for (int k = 0; k < a->features && k < b->features; k++) {
        double da = a->feature[k] - (l->n ? l->a[l->n - 1] : -INFINITY), db = b->feature[k] - (l->n ? l->b[l->n - 1] : -INFINITY);
        if (isnan(da) || isnan(db) || (l->n && (da < NEAREST || db < NEAREST || !alike(da, db, GROWTH, GROWTH_LEAST))))
            continue;
        knot_put(l, l->n, a->feature[k], b->feature[k]);
    }
    if (l->n == 0)
        knot_put(l, 0, a->from, b->from);
    double la = l->a[0] - a->from, lb = l->b[0] - b->from, shorter = fmin(la, lb);
    if (shorter > 0 && !a->cut[0] && !b->cut[0] && alike(la, lb, END_GROWTH, END_LEAST))
        knot_put(l, 0, a->from, b->from);
    else if (shorter > 0)
        knot_put(l, 0, l->a[0] - shorter, l->b[0] - shorter);
    int last = l->n - 1;
    la = a->to - l->a[last], lb = b->to - l->b[last], shorter = fmin(la, lb);
    if (shorter > 0 && !a->cut[1] && !b->cut[1] && alike(la, lb, END_GROWTH, END_LEAST))
        knot_put(l, l->n, a->to, b->to);
    else if (shorter > 0)
        knot_put(l, l->n, l->a[last] + shorter, l->b[last] + shorter);
}

double link_map(int n, const double *from, const double *to, double at)
{
    int i = 1;

    if (at < from[0] - ROUNDING || at > from[n - 1] + ROUNDING)
        return NAN;
    while (i < n - 1 && from[i] < at)
        i++;
    return to[i - 1] + (to[i] - to[i - 1]) * (at - from[i - 1]) / (from[i] - from[i - 1]);
}
