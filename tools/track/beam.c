/* Uniform Euler-Bernoulli elements have Hermite's polynomials (Przemieniecki 1968, Theory of Matrix Structural Analysis); all others,
 * and all masses, are flexure.c's. */
#include "tools/track/beam.h"

#include "tools/track/flexure.h"

static int is_hermite(const struct beam *b)
{
    return b->bending > 0 && b->shear <= 0;
}

void beam_stiffness(const struct beam *b, double K[4][4])
{
    if (!is_hermite(b)) {
        flexure_stiffness(b, K);
        return;
    }
    const double L = b->length, k = b->bending / (L * L * L);
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

void beam_mass(const struct beam *b, double M[4][4])
{
    flexure_mass(b, M);
}

void beam_shape(const struct beam *b, double a, double N[4])
{
    if (!is_hermite(b)) {
        flexure_shape(b, a, N);
        return;
    }
    const double L = b->length, r = a / L, r2 = r * r, r3 = r2 * r;

    N[0] = 1 - 3 * r2 + 2 * r3;
    N[1] = -L * (r - 2 * r2 + r3);
    N[2] = 3 * r2 - 2 * r3;
    N[3] = -L * (r3 - r2);
}

void beam_slope(const struct beam *b, double a, double D[4])
{
    if (!is_hermite(b)) {
        flexure_slope(b, a, D);
        return;
    }
    const double L = b->length, r = a / L;

    D[0] = 6 * (r * r - r) / L;
    D[1] = -(1 - 4 * r + 3 * r * r);
    D[2] = -D[0];
    D[3] = -(3 * r * r - 2 * r);
}

double beam_compliance(const struct beam *b, double a)
{
    const double L = b->length, ab = a * (L - a);

    return is_hermite(b) ? ab * ab * ab / (3 * b->bending * L * L * L)      /* a^3 b^3 / (3 EI L^3) */
                         : flexure_between(b, a, a);
}

double beam_between(const struct beam *b, double x, double a)
{
    const double L = b->length, behind = L - a;

    return is_hermite(b) ? behind * behind * x * x * (3 * a * L - 3 * a * x - behind * x) / (6 * b->bending * L * L * L)
                         : flexure_between(b, x, a);
}
