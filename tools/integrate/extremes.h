/* Extremes of a passage over all of its steps. */
#ifndef VX_INTEGRATE_EXTREMES_H
#define VX_INTEGRATE_EXTREMES_H

#include "formats/run.h"
#include "tools/integrate/passage.h"

struct extremes {
    int64_t wheelsets, sleepers, nodes;
    double *of[RUN_EXTREMES];            /* as run.h */
    double *moment;                      /* N m [nodes] */
};

/* Of a passage that run describes. */
const char *extremes_new(struct extremes *e, const struct run *run);
void extremes_free(struct extremes *e);

/* Takes in the present step. */
void extremes_step(struct extremes *e, const struct passage *p);

/* N m [nodes], bending moment of a rail at the present step, until the next call; the rails of a moving mass do not bend. */
const double *extremes_moment(struct extremes *e, const struct passage *p, int rail);

#endif
