#include "tools/integrate/extremes.h"
#include "formats/reason.h"
#include "tools/contact/clones.h"

#include <math.h>
#include <stdlib.h>

const char *extremes_new(struct extremes *e, const struct run *run)
{
    *e = (struct extremes){.wheelsets = run->wheelsets, .sleepers = run->sleepers, .nodes = run->nodes};
    for (int c = 0; c < RUN_EXTREMES; c++)
        if (!(e->of[c] = calloc((size_t)run_count(run, &run_extremes[c]) + 1, sizeof *e->of[c])))
            return REASON_MEMORY;
    for (int64_t k = 0; k < 2 * e->wheelsets; k++)
        e->of[RUN_MIN_Q][k] = HUGE_VAL;
    e->moment = calloc((size_t)e->nodes, sizeof *e->moment);
    return e->moment ? NULL : REASON_MEMORY;
}

void extremes_free(struct extremes *e)
{
    for (int c = 0; c < RUN_EXTREMES; c++)
        free(e->of[c]);
    free(e->moment);
    *e = (struct extremes){0};
}

const double *extremes_moment(struct extremes *e, const struct passage *p, int rail)
{
    if (!p->follows)
        way_moment(&p->rails, rail, e->moment);
    return e->moment;
}

CLONES static void keep_largest(int64_t n, const double *restrict x, double *restrict largest)
{
    for (int64_t i = 0; i < n; i++)
        largest[i] = x[i] > largest[i] ? x[i] : largest[i];
}

CLONES static void keep_magnitude(int64_t n, const double *restrict x, double *restrict largest)
{
    for (int64_t i = 0; i < n; i++) {
        double magnitude = x[i] < 0 ? -x[i] : x[i];
        largest[i] = magnitude > largest[i] ? magnitude : largest[i];
    }
}

/* Compression of a pad: its own ends, not its force over its stiffness, which the damper shares. */
CLONES static void keep_compression(int64_t n, const double *restrict w, const double *restrict z, const double *restrict roll,
                                    const double *restrict arm, double *restrict largest)
{
    for (int64_t i = 0; i < n; i++) {
        double d = w[i] - z[i] - arm[i] * roll[i];
        largest[i] = d > largest[i] ? d : largest[i];
    }
}

static void keep_wheels(struct extremes *e, const struct passage *p)
{
    for (int64_t k = 0; k < 2 * e->wheelsets; k++) {
        double Q = p->wheel[k].Q;
        if (Q > e->of[RUN_MAX_Q][k]) {
            e->of[RUN_MAX_Q][k] = Q;
            e->of[RUN_AT_MAX_Q][k] = passage_wheel_station(p, k / 2);
        }
        e->of[RUN_MIN_Q][k] = fmin(e->of[RUN_MIN_Q][k], Q);
        e->of[RUN_MAX_Y][k] = fmax(e->of[RUN_MAX_Y][k], fabs(p->wheel[k].Y));
    }
}

/* Sleepers stand evenly or nearly so: guess, then walk. */
static int64_t sleeper_near(const struct trk *t, double s)
{
    const double *x = t->sleeper_x;
    int64_t last = t->sleepers - 1, i = (int64_t)((s - x[0]) / (x[last] - x[0]) * (double)last);

    i = i < 0 ? 0 : i > last ? last : i;
    while (i > 0 && s < x[i])
        i--;
    while (i < last && s >= x[i + 1])
        i++;
    return i + (i < last && x[i + 1] - s < s - x[i]);
}

/* The same by where it happens: at the sleeper nearest to the wheel. */
static void keep_wheels_by_sleeper(struct extremes *e, const struct passage *p)
{
    const int64_t n = e->sleepers;

    for (int64_t k = 0; k < 2 * e->wheelsets; k++) {
        double s = passage_wheel_station(p, k / 2);
        int64_t i = p->follows ? k / 2 : sleeper_near(p->track, s);
        double *Q = &e->of[RUN_SLEEPER_MAX_Q][k % 2 * n + i], *Y = &e->of[RUN_SLEEPER_MAX_Y][k % 2 * n + i];
        *Q = fmax(*Q, p->wheel[k].Q);
        *Y = fmax(*Y, fabs(p->wheel[k].Y));
    }
}

static void keep_track(struct extremes *e, const struct passage *p)
{
    const struct way *w = &p->rails;
    const int64_t n = e->sleepers, nodes = e->nodes;

    for (int s = 0; s < 2; s++) {
        keep_largest(n, w->pad[s], e->of[RUN_MAX_PAD] + s * n);
        keep_compression(n, w->seat[s], w->z, w->roll, w->arm[s], e->of[RUN_MAX_PAD_COMPRESSION] + s * n);
        keep_magnitude(nodes, extremes_moment(e, p, s), e->of[RUN_MAX_NODE_M] + s * nodes);
    }
    for (int s = 0; s < 3; s++)
        keep_largest(n, w->ballast[s], e->of[RUN_MAX_BALLAST] + s * n);
    keep_magnitude(n, w->za, e->of[RUN_MAX_SLEEPER_A]);
}

void extremes_step(struct extremes *e, const struct passage *p)
{
    keep_wheels(e, p);
    keep_wheels_by_sleeper(e, p);
    keep_track(e, p);
}
