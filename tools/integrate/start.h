/* The static equilibrium a passage starts from, on straight level track. */
#ifndef VX_INTEGRATE_START_H
#define VX_INTEGRATE_START_H

#include "tools/integrate/passage.h"

/* Sets positions, spin and wheel memories of a new passage to rest under its weight at its first station: the track bent
 * by its own weight and the wheels, each wheel pressed into its rail by its load.  Lateral forces are not balanced, which is
 * rest only on straight track with both sides alike: not checked.  A track without a train rests
 * without weight.  *residual is the largest unbalanced vertical acceleration of a
 * body, over g. */
const char *passage_start(struct passage *p, double *residual);

#endif
