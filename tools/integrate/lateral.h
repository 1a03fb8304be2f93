/* Wheel and spatial rail to the side, within one step: the lateral force that a wheel puts on its rail where that force has moved it to.
 *
 * Creep resists the rail's motion by D = -dY/dv, a flange its place by a stiffness: both are large to what a light rail gives, so the force
 * is sought by secants.  Y and M move the head alike, as one force X = Y + share M, so what falls with X is  X(head(X)) - X. */
#ifndef VX_INTEGRATE_LATERAL_H
#define VX_INTEGRATE_LATERAL_H

#include "tools/integrate/way.h"
#include "tools/integrate/wheel.h"

struct lateral {
    struct head_force F;                /* assumed */
    struct head_force applied;          /* of it, that the rails have got */
    double low, high;                   /* N, X is between */
    double X_before, off_before;        /* N, of the pass before */
    int passes;
};

/* Foreseen by a straight line through the last two steps; nothing is applied yet. */
void lateral_foresee(struct lateral *l, const struct wheel_memory *memory);

/* Another round begins. */
void lateral_begin(struct lateral *l);

/* Where the rail's head is under the force assumed: into the rail's part of in. */
void lateral_stand(const struct lateral *l, const struct wheel_place *place, const struct way_rail *rail, const struct wheel_memory *memory, double h,
                   struct wheel_input *in);

/* Of the wheel on rail `side`, without what goes into the check rail. */
struct head_force lateral_force(const struct trk *t, int side, const struct wheel_input *in, const struct wheel_output *out);

/* The next force to assume, from what the assumed one made; damping N s/m is D.  Returns by how much that was off, N. */
double lateral_seek(struct lateral *l, const struct wheel_place *place, const struct way_rail *rail, const struct head_force *made, double damping,
                    double h);

#endif
