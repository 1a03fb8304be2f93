/* Sideways motion of the rails under the wheels.  y to the right.
 *
 * On a fixed track each rail yields under each wheel by itself, a mass on a spring and damper to the ground that rolls along.  A moving mass goes
 * sideways as one, or, with a lateral stiffness of its sleeper, each rail against the sleeper and that against the ground.
 *
 * Creep damps a rail mass within a step, so accelerations are those of the linear-implicit Euler scheme: springs and dampers at the end of the
 * step, as is D = -dY/dy' of small creepages.  First order, which matters to nothing slower than a few steps. */
#ifndef VX_INTEGRATE_SIDEWAYS_H
#define VX_INTEGRATE_SIDEWAYS_H

#include "formats/trk.h"
#include "tools/integrate/wheel.h"

struct sideways {
    int64_t wheelsets;
    double *y, *v, *a;          /* m, m/s, m/s2 [wheelsets][2] of the rail under each wheel, then [wheelsets] of the sleepers */
};

const char *sideways_new(struct sideways *s, int64_t wheelsets);
void sideways_free(struct sideways *s);

/* Under the forces of the wheels w [wheelsets][2], without what goes into the check rail; nothing where the rails do not yield.
 * follows: t is a moving mass, one for each wheelset. */
void sideways_accelerate(struct sideways *s, const struct trk *t, int follows, double h, const struct wheel_output *w);

void sideways_move(struct sideways *s, double h);

#endif
