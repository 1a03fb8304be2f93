/* Elastic contact of two bodies of like material by Hertz.
 *
 * The undeformed gap is A x^2 + B y^2, x along the track.  N = C d^1.5 with d the approach of the bodies along the normal;
 * semi-axes a = a1 N^(1/3) along x, b = b1 N^(1/3) along y; highest pressure 3 N/(2 pi a b). */
#ifndef VX_CONTACT_HERTZ_H
#define VX_CONTACT_HERTZ_H

/* 1/m: a flatter or hollow gap is taken as this (the floor of the ANALYN method; half-space theory fails before it). */
#define HERTZ_FLATTEST 0.1

struct hertz {
    double C;          /* N/m^1.5 */
    double a1, b1;     /* m/N^(1/3) */
};

/* A and B in 1/m, shear modulus G in Pa, Poisson's ratio nu. */
void hertz_contact(double A, double B, double G, double nu, struct hertz *h);

/* A and B from the wheel's curvatures along its meridian and around its axis (1/m, positive where convex), the rail's
 * lateral curvature, and the angle beta (rad) by which the wheel's meridian is turned out of the rail's section. */
void hertz_curvatures(double meridian, double around, double rail, double beta, double *A, double *B);

#endif
