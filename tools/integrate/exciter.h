/* A prescribed force on the rails and the places whose motion it is to move: a receptance test in time.
 *
 * x forward, z down; force and deflection are positive down. */
#ifndef VX_INTEGRATE_EXCITER_H
#define VX_INTEGRATE_EXCITER_H

#include "formats/run.h"
#include "tools/integrate/drive.h"
#include "tools/integrate/way.h"

struct exciter {
    int on;                          /* RUN_ON_LEFT, RUN_ON_RIGHT or RUN_ON_BOTH, each rail with the whole force */
    double x;                        /* m */
    int64_t steps;
    double *F;                       /* N [steps + 1] from the start on */
    int64_t probes;
    int64_t *probe_on;               /* [probes] RUN_ON_LEFT, RUN_ON_RIGHT or RUN_ON_SLEEPER, the one nearest to probe_x */
    double *probe_x;                 /* m [probes] */
    int64_t *probe_sleeper;          /* [probes] its index */
    double *held;                    /* m/N [probes] of the deflection, what the element gives with held ends under a unit force */
};

/* Room for the histories of so many steps and probes; the caller says where they are, then exciter_place. */
const char *exciter_new(struct exciter *e, const struct drive *force, double step, int64_t probes);
void exciter_free(struct exciter *e);

/* Moves sleeper probes onto their sleepers and finds what the elements give; fails where a place is not on the track. */
const char *exciter_place(struct exciter *e, const struct trk *t);

/* Loads the rails with the force of step n. */
void exciter_load(const struct exciter *e, struct way *w, int64_t n);

/* m, deflection at probe k at step n. */
double exciter_deflection(const struct exciter *e, const struct way *w, int64_t n, int64_t k);

#endif
