/* What the couplings of a vehicle remember from step to step. */
#ifndef VX_VEHICLE_COUPLINGS_MEMORY_H
#define VX_VEHICLE_COUPLINGS_MEMORY_H

#include "formats/veh.h"

/* Elongation m, rad and force N, N m on the second body, as its law sees them: along the axes, about them for a friction with a lever, or
 * in the first number along a line. */
struct couplings_state { double e[3], F[3]; };

/* What couplings remember: the state at the end of the last step, and that of the present positions, a step after it.  Series dampers
 * and friction need it; all else follows from the positions. */
struct couplings_memory {
    double step;                            /* s since `before`; 0: at once, so that a series damper has relaxed */
    struct couplings_state *before, *now;   /* [couplings] */
    int64_t couplings;
};

/* At rest: links centred, friction without force, dampers relaxed. */
const char *couplings_memory_new(struct couplings_memory *m, const struct veh *v);
void couplings_memory_free(struct couplings_memory *m);

/* As new. */
void couplings_relax(struct couplings_memory *m);

/* The present becomes the past of a step h s. */
void couplings_keep(struct couplings_memory *m, double h);

/* Frictions hold no force at the present positions, dampers have relaxed. */
void couplings_centre(const struct veh *v, struct couplings_memory *m);

#endif
