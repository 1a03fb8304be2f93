/* Zhai's explicit two-step scheme (Zhai 1996, IJNME 39, 4199) with both parameters 1/2:
 *   x(n+1) = x + v h + (a - a(n-1)/2) h^2,   v(n+1) = v + (3 a - a(n-1)) h/2,
 * second order; stable up to about 2/omega of the highest frequency. */
#ifndef VX_INTEGRATE_TWO_STEP_H
#define VX_INTEGRATE_TWO_STEP_H

#include <stdint.h>

/* x, v, a, before [n]: positions, rates, accelerations now and a step before, which become those of now.  With before = a the first step is
 * x + v h + a h^2/2, v + a h. */
void two_step(int64_t n, double h, double *x, double *v, const double *a, double *before);

#endif
