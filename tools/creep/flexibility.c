/* Flexibilities of FASTSIM, blended between three and one. */
#include "tools/creep/flexibility.h"

#include <math.h>

#include "tools/creep/kalker.h"

#define TINY 1e-30  /* creepages below give any mean: no slip is near */

void flexibility(double a, double b, double N, double mu, double G, const double C[4], double xi, double eta, double phi,
                 double L[FLEXIBILITIES])
{
    double L1 = 8*a/(3*G*C[KALKER_C11]);
    double L2 = 8*a/(3*G*C[KALKER_C22]);
    double L3 = M_PI*a*sqrt(a/b)/(4*G*C[KALKER_C23]);

    double slip = xi*xi + eta*eta;
    double r = 3*M_PI/32*a*phi;                              /* spin as a creepage: phi (pi a^2/4)/(8 a/3) */
    double Lc = (slip + r*r + TINY*L1)/(xi*xi/L1 + eta*eta/L2 + r*r/L3 + TINY);

    double k = mu*N/(a*b*G);                                 /* creepages of saturation: k/C11, k/C22 */
    double k1 = k/C[KALKER_C11], k2 = k/C[KALKER_C22];
    double w = fmin(1, sqrt(slip/(k1*k1 + k2*k2))/3);

    L[FLEXIBILITY_XI]  = (1 - w)*L1 + w*Lc;
    L[FLEXIBILITY_ETA] = (1 - w)*L2 + w*Lc;
    L[FLEXIBILITY_PHI] = (1 - w)*L3 + w*Lc;
}
