/* Flexibilities L of FASTSIM: the traction grows by slip/L over each metre from the leading edge, with L such
 * that the force at small creepages is that of the linear theory.
 *
 * Three of them, one per creepage, are right for small creepages; one weighted mean is right where all slides.  They are blended by the
 * size of the creepages: Vollebregt, CONTACT user guide (2022), simplified theory. */
#ifndef VX_CREEP_FLEXIBILITY_H
#define VX_CREEP_FLEXIBILITY_H

enum { FLEXIBILITY_XI, FLEXIBILITY_ETA, FLEXIBILITY_PHI, FLEXIBILITIES };

/* L[3] m3/N of the contact with semi-axes a (rolling direction), b m, force N, friction mu, shear modulus G Pa, coefficients
 * C[4] of kalker(), creepages xi, eta and spin phi 1/m. */
void flexibility(double a, double b, double N, double mu, double G, const double C[4], double xi, double eta, double phi,
                 double L[FLEXIBILITIES]);

#endif
