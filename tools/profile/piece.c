#include "tools/profile/piece.h"

#include <math.h>

#include "tools/profile/features.h"

#define STEP 1e-4        /* m */
#define SHORTEST 5e-3    /* m */
#define MARGIN 2e-4      /* m, a feature nearer to an end is that end */

static void point_at(const struct curve *c, double s, double *y, double *z)
{
    double f[3];

    spline_at(&c->y, s, f);
    *y = f[0];
    spline_at(&c->z, s, f);
    *z = f[0];
}

static void piece_make(const struct curve *c, const struct curve *shape, double from, double to, struct piece *p)
{
    double y, z;

    *p = (struct piece){.from = from, .to = to, .y_least = INFINITY, .y_most = -INFINITY, .features = FEATURES};
    for (int64_t i = 0, n = (int64_t)((to - from) / STEP); i <= n; i++) {
        point_at(c, from + (to - from) * (double)i / (double)n, &y, &z);
        p->y_least = fmin(p->y_least, y);
        p->y_most = fmax(p->y_most, y);
    }
    features_find(shape, from, to, p->feature);
    for (int k = 0; k < FEATURES; k++)
        if (p->feature[k] < from + MARGIN || p->feature[k] > to - MARGIN)
            p->feature[k] = NAN;
}

int piece_cut(const struct curve *c, const struct curve *shape, double from, double to, double deepest, struct piece piece[PIECES_MOST])
{
    int64_t steps = (int64_t)ceil((to - from) / STEP);
    double begin = NAN, before = INFINITY, y, z;
    int n = 0;

    for (int64_t i = 0; i <= steps; i++) {
        double s = from + (to - from) * (double)i / (double)steps, step = (to - from) / (double)steps;
        point_at(c, s, &y, &z);
        double crossing = isfinite(before) ? s - step * (z - deepest) / (z - before) : s;
        if (z <= deepest && isnan(begin))
            begin = crossing;
        if (!isnan(begin) && (z > deepest || i == steps)) {
            double end = z > deepest ? crossing : to;
            if (end - begin > SHORTEST && n < PIECES_MOST) {
                piece_make(c, shape, begin, end, &piece[n]);
                piece[n].cut[0] = begin > from;
                piece[n++].cut[1] = end < to;
            }
            begin = NAN;
        }
        before = z;
    }
    return n;
}

void piece_declare(struct piece *p, int n, const double *at)
{
    p->features = n;
    for (int k = 0; k < n; k++)
        p->feature[k] = at[k] > p->from + MARGIN && at[k] < p->to - MARGIN ? at[k] : NAN;
}
