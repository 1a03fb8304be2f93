/* Kalker's creep coefficients of an elliptic contact: the linear theory of rolling contact.
 *
 *   Fx = G a b C11 xi,  Fy = G a b C22 eta + G (a b)^1.5 C23 phi,  Mz = -G (a b)^1.5 C23 eta + G (a b)^2 C33 phi
 *
 * a lies along the rolling direction.  Kalker, Three-dimensional elastic bodies in rolling contact (1990), table E.3. */
#ifndef VX_CREEP_KALKER_H
#define VX_CREEP_KALKER_H

enum { KALKER_C11, KALKER_C22, KALKER_C23, KALKER_C33, KALKER_COEFFICIENTS };

/* C[4] for the ratio a/b > 0 of the semi-axes and Poisson's ratio 0 <= nu <= 0.5. */
void kalker(double ratio, double nu, double C[KALKER_COEFFICIENTS]);

#endif
