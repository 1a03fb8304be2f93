/* The edges of a head rounded by the discs that fit inside it: a morphological opening. */
#ifndef VX_PROFILE_OPENING_H
#define VX_PROFILE_OPENING_H

#include <stdint.h>

/* Heights z[n] (m, down) at y = i step (m) become the upper edge of all discs of radius r (m) that fit below them; no material lies beside
 * the first, nor from y = wall (m) on, which need not be a step.  Where discs touch two surfaces, or surface and wall, they do so exactly, so
 * that the edge moves as smoothly as the surfaces.  work[2 n]. */
void opening_round(int64_t n, double step, double wall, double r, double *z, double *work);

#endif
