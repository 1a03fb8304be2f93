/* Small dense symmetric matrices that may be singular: L D L' without exchange of rows. */
#ifndef VX_VEHICLE_SEMIDEFINITE_H
#define VX_VEHICLE_SEMIDEFINITE_H

#include <stdint.h>

/* A[n][n] = L D L' in place: L below the diagonal, D on it.  Returns the first row without a positive pivot, or -1; a pivot within
 * round-off of zero is set to 0 with its column, a negative one stays and ends the factorisation. */
int64_t semidefinite_factor(int64_t n, double *A);

/* Solves A x = x in place, unknowns at zero pivots being zero.  left[n] is what of their equations is not met. */
void semidefinite_solve(int64_t n, const double *A, double *x, double *left);

#endif
