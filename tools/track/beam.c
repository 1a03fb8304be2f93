/* Euler-Bernoulli element: exact for loads at its ends; the deflection under a load between them is that of the Hermite
 * polynomials plus that of the element with held ends.  Przemieniecki 1968, Theory of Matrix Structural Analysis. */
#include "tools/track/beam.h"

void beam_stiffness(double EI, double L, double K[4][4])
{
    const double k = EI / (L * L * L);
    const double w = 12 * k, c = 6 * k * L, near = 4 * k * L * L, far = 2 * k * L * L;
    const double value[4][4] = {
        { w,   -c,   -w,   -c},
        {-c, near,    c,  far},
        {-w,    c,    w,    c},
        {-c,  far,    c, near}};                     /* t = -dw/dx turns the sign of c */

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            K[i][j] = value[i][j];
}

void beam_shape(double L, double a, double N[4])
{
    const double r = a / L, r2 = r * r, r3 = r2 * r;

    N[0] = 1 - 3 * r2 + 2 * r3;
    N[1] = -L * (r - 2 * r2 + r3);
    N[2] = 3 * r2 - 2 * r3;
    N[3] = -L * (r3 - r2);
}

void beam_slope(double L, double a, double D[4])
{
    const double r = a / L;

    D[0] = 6 * (r * r - r) / L;
    D[1] = -(1 - 4 * r + 3 * r * r);
    D[2] = -D[0];
    D[3] = -(3 * r * r - 2 * r);
}

double beam_compliance(double EI, double L, double a)
{
    const double b = L - a, ab = a * b;

    return ab * ab * ab / (3 * EI * L * L * L);      /* a^3 b^3 / (3 EI L^3) */
}
