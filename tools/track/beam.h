/* One Euler-Bernoulli beam element of a rail.
 *
 * x forward, z down.  Its four degrees of freedom are [w1 t1 w2 t2]: deflection w down and pitch t = -dw/dx, right-handed
 * about y, at its near and far end.  a is the distance from the near end, b = L - a. */
#ifndef VX_TRACK_BEAM_H
#define VX_TRACK_BEAM_H

/* K [4][4], N/m, N and N m, of bending stiffness EI (N m2) over the length L (m). */
void beam_stiffness(double EI, double L, double K[4][4]);

/* N [4]: the deflection at a is N.[w1 t1 w2 t2]; a unit force at a loads the ends by N (Hermite). */
void beam_shape(double L, double a, double N[4]);

/* 1/m, 1 [4]: dN/da, so that the slope dw/dx at a is D.[w1 t1 w2 t2]. */
void beam_slope(double L, double a, double D[4]);

/* m/N: deflection at a of the element with both ends held, under a unit force at a. */
double beam_compliance(double EI, double L, double a);

#endif
