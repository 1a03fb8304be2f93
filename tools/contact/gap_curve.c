/* Polylines on the grid by cubic Hermite polynomials, and what sections further along the track add to one. */
#include "tools/contact/gap.h"

#include <math.h>

#include "tools/profile/hermite.h"

static void gap_range(const double *y, int64_t n, double step, int64_t *first, int64_t *last)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (int64_t i = 0; i < n; i++) {                             /* comparisons with NaN are false */
        lo = y[i] < lo ? y[i] : lo;
        hi = y[i] > hi ? y[i] : hi;
    }
    *first = lo <= hi ? (int64_t)ceil(lo / step) : 0;
    *last = lo <= hi ? (int64_t)floor(hi / step) : -1;
}

int64_t gap_nodes(const double *y, int64_t n, double step)
{
    int64_t first, last;

    gap_range(y, n, step, &first, &last);
    return last >= first ? last - first + 1 : 0;
}

/* The piece from point i to i + 1 onto the nodes it covers and lies lowest on. */
static void tabulate_piece(const struct gap_line *l, int64_t i, double step, struct gap_curve *c)
{
    double h = l->y[i + 1] - l->y[i], along_y = (l->along[i + 1] - l->along[i]) / h;
    double bend_y = (l->bend[i + 1] - l->bend[i]) / h;
    int64_t end = (int64_t)floor(l->y[i + 1] / step);

    for (int64_t j = (int64_t)ceil(l->y[i] / step); j <= end; j++) {
        double d = (double)j * step - l->y[i], t = d / h;
        struct hermite p = hermite_at(l->z[i], l->slope[i], l->z[i + 1], l->slope[i + 1], h, t);
        int64_t at = j - c->first;
        if (!isnan(c->slope[at]) && p.z <= c->z[at])
            continue;
        c->z[at] = p.z;
        c->slope[at] = p.slope;
        c->k[at] = l->k[i] + t * (l->k[i + 1] - l->k[i]);
        c->along[at] = l->along[i] + d * along_y;
        c->along_y[at] = along_y;
        c->bend[at] = l->bend[i] + d * bend_y;
        c->bend_y[at] = bend_y;
        c->at[at] = 0;
    }
}

void gap_tabulate(const struct gap_line *line, double step, struct gap_curve *c)
{
    int64_t last;

    gap_range(line->y, line->n, step, &c->first, &last);
    c->n = last >= c->first ? last - c->first + 1 : 0;
    for (int64_t j = 0; j < c->n; j++)
        c->slope[j] = (double)NAN;
    for (int64_t i = 0; i + 1 < line->n; i++)
        if (line->y[i + 1] > line->y[i])
            tabulate_piece(line, i, step, c);
    c->level = 1;
    for (int64_t i = 0; i < line->n; i++)
        c->level &= line->along[i] == 0 && line->bend[i] == 0;
}

void gap_join(struct gap_curve *c, const struct gap_curve *from, double x, double b)
{
    for (int64_t i = 0, j = c->first - from->first; i < c->n; i++, j++) {
        if (j < 0 || j >= from->n || isnan(from->slope[j]))
            continue;
        if (!isnan(c->slope[i]) && from->z[j] + 0.5 * b * x * x >= c->z[i] + 0.5 * b * c->at[i] * c->at[i])
            continue;
        c->z[i] = from->z[j];
        c->slope[i] = from->slope[j];
        c->k[i] = from->k[j];
        c->along[i] = from->along[j];
        c->along_y[i] = from->along_y[j];
        c->bend[i] = from->bend[j];
        c->bend_y[i] = from->bend_y[j];
        c->at[i] = x;
        c->level = 0;
    }
}
