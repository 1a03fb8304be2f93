/* The static equilibrium a passage starts from, on straight level track. */
#ifndef VX_START_H
#define VX_START_H

#include "tools/integrate/passage.h"

/* Sets positions, spin and wheel memories of a new passage to rest under its weight at its first station: the track bent
 * by its own weight and the wheels, each wheel pressed into its rail by its load.  Lateral forces must balance by symmetry: the
 * start lies on straight track with both sides alike, or this fails.  *residual is the largest unbalanced vertical
 * acceleration of a body, over g. */
const char *passage_start(struct passage *p, double *residual);

#endif
