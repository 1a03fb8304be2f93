#include "tools/profile/kinks.h"

#include <math.h>

static double distance(const struct points *p, int64_t a, int64_t b)
{
    return hypot(p->y[b] - p->y[a], p->z[b] - p->z[a]);
}

/* Direction of the chord from point i to where it is half a window long, forwards or backwards; 0 where the line ends before. */
static int chord(const struct points *p, int64_t i, int64_t step, double *angle)
{
    int64_t j = i + step;

    while (j >= 0 && j < p->n && distance(p, i, j) < KINK_WINDOW / 2)
        j += step;
    if (j < 0 || j >= p->n)
        return 0;
    double near = distance(p, i, j - step), far = distance(p, i, j), part = (KINK_WINDOW / 2 - near) / (far - near);
    double y = p->y[j - step] + part * (p->y[j] - p->y[j - step]), z = p->z[j - step] + part * (p->z[j] - p->z[j - step]);
    *angle = atan2((double)step * (z - p->z[i]), (double)step * (y - p->y[i]));
    return 1;
}

static double turn_at(const struct points *p, int64_t i)
{
    double before, after;

    return chord(p, i, -1, &before) && chord(p, i, 1, &after) ? remainder(after - before, 2 * M_PI) : 0;
}

void kinks_find(const struct points *p, struct kinks *k)
{
    double worst = 0;            /* of the kink we are in */
    int64_t at = -1;

    *k = (struct kinks){0};
    for (int64_t i = 0; i <= p->n; i++) {
        double turn = i < p->n ? turn_at(p, i) : 0;
        if (at >= 0 && (i == p->n || distance(p, at, i) > KINK_WINDOW)) {
            if (k->n < KINKS_TOLD) {
                k->y[k->n] = p->y[at];
                k->turn[k->n] = worst;
            }
            k->n++;
            at = -1;
            worst = 0;
        }
        if (i < p->n && fabs(turn) > KINK_TURN && fabs(turn) > fabs(worst)) {
            worst = turn;
            at = i;
        }
    }
}
