#include "tools/profile/piece.h"

#include <math.h>

#include "tools/profile/features.h"

#define STEP 1e-4        /* m */
#define SHORTEST 5e-3    /* m */
#define MARGIN 2e-4      /* m, a feature nearer to an end is that end */

static void piece_make(const struct curve *c, const struct curve *shape, double from, double to, struct piece *p)
{
    double at[2];

    *p = (struct piece){.from = from, .to = to, .y_least = INFINITY, .y_most = -INFINITY, .features = FEATURES};
    for (int64_t i = 0, n = (int64_t)((to - from) / STEP); i <= n; i++) {
        curve_point(c, from + (to - from) * (double)i / (double)n, at);
        p->y_least = fmin(p->y_least, at[0]);
        p->y_most = fmax(p->y_most, at[0]);
    }
    features_find(shape, from, to, p->feature);
    for (int k = 0; k < FEATURES; k++)
        if (p->feature[k] < from + MARGIN || p->feature[k] > to - MARGIN)
            p->feature[k] = NAN;
}

int piece_cut(const struct curve *c, const struct curve *shape, double from, double to, double deepest, struct piece piece[PIECES_MOST])
{
    int64_t steps = (int64_t)ceil((to - from) / STEP);
    double begin = NAN, before = INFINITY, at[2];
    int n = 0;

    for (int64_t i = 0; i <= steps; i++) {
        double s = from + (to - from) * (double)i / (double)steps, step = (to - from) / (double)steps;
        curve_point(c, s, at);
        double z = at[1], crossing = isfinite(before) ? s - step * (z - deepest) / (z - before) : s;
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
