/* The edges of a head rounded by the discs that fit inside it: a morphological opening. */
#ifndef VX_PROFILE_OPENING_H
#define VX_PROFILE_OPENING_H

#include <stdint.h>

/* Heights z[n] (m, down) at even steps of y (m) become the upper edge of all discs of radius r (m) that fit below them; INFINITY is no
 * material, as is what lies beside the first and the last.  work[2 n]. */
void opening_round(int64_t n, double step, double r, double *z, double *work);

#endif
