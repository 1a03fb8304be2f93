/* The account of the track's energy over a run: what the wheels do on its material, F N'du at every wheel, is stored by it, in motion,
 * bending, pads, ballast and height, or lost in dampers.  For the implicit scheme every step closes, but for rounding, with mean forces
 * and mean rates; for the explicit one sums over steps stand for integrals, which is of second order. */
#ifndef VX_INTEGRATE_ENERGY_H
#define VX_INTEGRATE_ENERGY_H

#include "tools/integrate/way.h"

struct energy {
    int counted;        /* 0: ballast that only pushes has no account */
    double begun;       /* J stored at rest */
    double work;        /* J of the wheels since: the last step's in full */
    double step;        /* J the last step's */
    int64_t at, of;     /* steps whose losses are taken; as many when `step` was begun */
    int64_t n;          /* sleepers, rounded up */
    double *lost;       /* J [n] in the dampers of each sleeper since */
};

const char *energy_new(struct energy *e, const struct way *w);
void energy_free(struct energy *e);

/* The track at rest as it is now. */
void energy_begin(struct energy *e, const struct way *w);

/* A step of a wheel from a place and force to the next ones, once the rails have moved. */
void energy_work(struct energy *e, const struct way *w, int rail, const struct wheel_place *before, double F_before,
                 const struct wheel_place *now, double F_now);

/* The same of the force on a rail's head. */
void energy_work_head(struct energy *e, const struct way *w, const struct head_place *before, const struct head_force *F_before,
                      const struct head_place *now, const struct head_force *F_now);

/* What the dampers took in the step: after way_finish. */
void energy_lose(struct energy *e, struct way *w);

/* J: work of the wheels since the beginning, stored since then, and lost.  Returns what of the work is neither, over the loss. */
double energy_end(const struct energy *e, const struct way *w, double *work, double *stored, double *lost);

#endif
