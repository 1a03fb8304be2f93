#include "tools/integrate/exciter.h"
#include "formats/reason.h"
#include "tools/track/rails.h"

#include <math.h>
#include <stdlib.h>

static const double STEPS_MOST = 1e8;

const char *exciter_new(struct exciter *e, const struct drive *force, double step, int64_t probes)
{
    const double steps = floor(force->duration / step + 0.5);
    const char *why;

    *e = (struct exciter){.probes = probes};
    if (!(steps >= 1 && steps <= STEPS_MOST))
        return reason("force.duration: %g s are %g steps, 1 to %g are possible", force->duration, steps, STEPS_MOST);
    e->steps = (int64_t)steps;
    e->F = calloc((size_t)e->steps + 1, sizeof *e->F);
    e->probe_on = calloc((size_t)probes, sizeof *e->probe_on);
    e->probe_x = calloc((size_t)probes, sizeof *e->probe_x);
    e->probe_sleeper = calloc((size_t)probes, sizeof *e->probe_sleeper);
    e->held = calloc((size_t)probes, sizeof *e->held);
    why = e->F && e->probe_on && e->probe_x && e->probe_sleeper && e->held ? drive_sample(force, step, e->steps, e->F) : REASON_MEMORY;
    if (why)
        exciter_free(e);
    return why;
}

void exciter_free(struct exciter *e)
{
    free(e->F);
    free(e->probe_on);
    free(e->probe_x);
    free(e->probe_sleeper);
    free(e->held);
    *e = (struct exciter){0};
}

static int64_t nearest_sleeper(const struct trk *t, double x)
{
    int64_t nearest = 0;

    for (int64_t i = 1; i < t->sleepers; i++)
        if (fabs(t->sleeper_x[i] - x) < fabs(t->sleeper_x[nearest] - x) * (1 - 1e-9))
            nearest = i;
    return nearest;
}

/* The element under x, the last one at the end of the rails. */
static int64_t element(const struct trk *t, double x)
{
    int64_t i = 0;

    while (i < t->nodes - 2 && x >= t->x[i + 1])
        i++;
    return i;
}

static int loads(const struct exciter *e, int rail)
{
    return e->on == RUN_ON_BOTH || e->on == rail;
}

const char *exciter_place(struct exciter *e, const struct trk *t)
{
    const double first = t->x[0], last = t->x[t->nodes - 1];

    if (t->nodes == 1)
        return "force: a prescribed force wants a track fixed in space, not a moving mass";
    if (e->x < first || e->x > last)
        return reason("force.at: %g m is not on the rails, %g to %g m", e->x, first, last);
    for (int64_t k = 0; k < e->probes; k++) {
        const int on = (int)e->probe_on[k];
        double *x = &e->probe_x[k];
        if (*x < first || *x > last)
            return reason("probe.%lld.at: %g m is not on the rails, %g to %g m", (long long)k + 1, *x, first, last);
        const int64_t i = element(t, *x);
        if (on == RUN_ON_SLEEPER) {
            e->probe_sleeper[k] = nearest_sleeper(t, *x);
            *x = t->sleeper_x[e->probe_sleeper[k]];
        } else if (loads(e, on) && element(t, e->x) == i) {
            const struct beam b = rails_beam(t, on, i);
            e->held[k] = beam_between(&b, fmin(*x, e->x) - t->x[i], fmax(*x, e->x) - t->x[i]);
        }
    }
    return NULL;
}

void exciter_load(const struct exciter *e, struct way *w, int64_t n)
{
    for (int rail = 0; rail < TRK_RAILS; rail++)
        if (loads(e, rail)) {
            const struct wheel_place at = way_find(w, rail, e->x);
            way_load(w, rail, &at, e->F[n]);
        }
}

double exciter_deflection(const struct exciter *e, const struct way *w, int64_t n, int64_t k)
{
    const int on = (int)e->probe_on[k];
    struct way_rail rail;

    if (on == RUN_ON_SLEEPER)
        return w->z[e->probe_sleeper[k]];
    const struct wheel_place at = way_find(w, on, e->probe_x[k]);
    way_look(w, on, &at, &rail);
    return rail.z + e->held[k] * e->F[n];
}
