#include "tools/profile/clean.h"

#include <math.h>
#include <stddef.h>

#include "formats/reason.h"

#define NEAREST 1e-6       /* m */
#define SHORTEST 5e-3      /* m, of the whole shape */
#define LONGEST 0.5        /* m */
#define TURN_COSINE (-0.5) /* of 120 degrees */
#define STEEPEST 60.0      /* |dz/dy| */

static void points_reverse(struct points *p)
{
    double *array[] = {p->y, p->z, p->weight};
    for (int k = 0; k < 3; k++)
        for (int64_t i = 0, j = p->n - 1; i < j; i++, j--) {
            double first = array[k][i];
            array[k][i] = array[k][j];
            array[k][j] = first;
        }
}

static void point_copy(struct points *p, int64_t to, int64_t from)
{
    p->y[to] = p->y[from];
    p->z[to] = p->z[from];
    p->weight[to] = p->weight[from];
}

/* The line a - b - c turns back at b. */
static int turns_back(const struct points *p, int64_t a, int64_t b, int64_t c)
{
    double uy = p->y[b] - p->y[a], uz = p->z[b] - p->z[a], vy = p->y[c] - p->y[b], vz = p->z[c] - p->z[b];
    return uy * vy + uz * vz < TURN_COSINE * hypot(uy, uz) * hypot(vy, vz);
}

static double distance(const struct points *p, int64_t a, int64_t b)
{
    return hypot(p->y[b] - p->y[a], p->z[b] - p->z[a]);
}

const char *clean_points(struct points *p, struct clean_count *count)
{
    double length = 0;
    int64_t m = 0;

    *count = (struct clean_count){0};
    if (p->n && p->y[p->n - 1] < p->y[0])
        points_reverse(p);
    for (int64_t i = 0; i < p->n; i++) {
        if (m && distance(p, m - 1, i) < NEAREST) {
            count->doubles++;
            continue;
        }
        if (m >= 2 && turns_back(p, m - 2, m - 1, i)) {
            count->zigzags++;
            m--;
        }
        point_copy(p, m++, i);
    }
    p->n = m;
    for (int64_t i = 1; i < m; i++) {
        double gap = distance(p, i - 1, i);
        length += gap;
        count->longest_gap = fmax(count->longest_gap, gap);
    }
    if (m < 3)
        return reason("%lld different points, a profile needs at least 3", (long long)m);
    if (length < SHORTEST || length > LONGEST)
        return reason("the shape is %g m long, should be %g to %g: wrong unit?", length, SHORTEST, LONGEST);
    return NULL;
}

const char *clean_outline(struct outline *o)
{
    int64_t first = 0, best_first = 0, best_end = 0;

    for (int64_t i = 0; i < o->n; i++) {
        if (!(fabs(o->slope[i]) <= STEEPEST))
            first = i + 1;
        else if (i > first && o->y[i] <= o->y[i - 1])
            first = i;
        if (i + 1 - first > best_end - best_first) {
            best_first = first;
            best_end = i + 1;
        }
    }
    if (best_end - best_first < 3)
        return "y does not increase along the shape";
    outline_keep(o, best_first, best_end);
    return NULL;
}
