/* One beam element of a rail, of Euler-Bernoulli or Timoshenko, whose bending stiffness may vary along it.
 *
 * x forward, z down.  Its four degrees of freedom are [w1 t1 w2 t2]: deflection w down and pitch t, right-handed about y, of its near
 * and far cross-section; t = -dw/dx where shear deforms nothing.  a is the distance from the near end, b = L - a.
 *
 * Stiffness, shapes and compliance are exact for loads at the ends and at a, at rest; the mass matrix moves with those shapes, and where shear deforms
 * adds the sag of the inside under its own inertia, m L^2/(12 kappa G A) K, as if the ends moved
 * in a free vibration (flexure.c). */
#ifndef VX_TRACK_BEAM_H
#define VX_TRACK_BEAM_H

#include <stdint.h>

struct beam {
    double length;                  /* m */
    double bending;                 /* N m2, EI; 0 where it varies: then by the knots */
    double shear;                   /* 1/N, 1/(kappa G A); 0 is stiff: Euler-Bernoulli */
    double mass;                    /* kg/m */
    double rotary;                  /* kg m, rho I: pitch inertia of a metre */
    double from;                    /* m, station of the near end */
    int64_t knots;
    const double *x, *EI;           /* m, N m2 [knots] EI over station, straight between, constant beyond */
};

/* K [4][4], N/m, N and N m; symmetric bit for bit. */
void beam_stiffness(const struct beam *b, double K[4][4]);

/* M [4][4], kg, kg m and kg m2; symmetric bit for bit. */
void beam_mass(const struct beam *b, double M[4][4]);

/* N [4]: the deflection at a is N.[w1 t1 w2 t2]; a unit force at a loads the ends by N. */
void beam_shape(const struct beam *b, double a, double N[4]);

/* 1/m, 1 [4]: dN/da, so that the slope dw/dx at a is D.[w1 t1 w2 t2]. */
void beam_slope(const struct beam *b, double a, double D[4]);

/* m/N: deflection at a of the element with both ends held, under a unit force at a. */
double beam_compliance(const struct beam *b, double a);

/* m/N: deflection of that element at x under the force at a, x <= a; and the other way round. */
double beam_between(const struct beam *b, double x, double a);

#endif
