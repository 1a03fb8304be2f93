/* The beam element against closed forms of beam theory (Roark 1989): exact for Euler-Bernoulli, so only rounding is left. */
#include "tools/track/beam.h"

#include "tests/kernel/tap.h"

static const double EI = 6.11e6, L = 0.6, EPS = 1e-13;
static const struct beam RAIL = {.length = 0.6, .bending = 6.11e6};

/* K of the two degrees of freedom i, j alone: [ui uj] = K^-1 [fi fj]. */
static void solve_two(double K[4][4], int i, int j, double fi, double fj, double *ui, double *uj)
{
    const double det = K[i][i] * K[j][j] - K[i][j] * K[j][i];

    *ui = (K[j][j] * fi - K[i][j] * fj) / det;
    *uj = (K[i][i] * fj - K[j][i] * fi) / det;
}

static void rigid_motion(double K[4][4])
{
    const double lift[4] = {1, 0, 1, 0}, turn[4] = {0, 1, -L, 1};      /* w = -t x */

    for (int i = 0; i < 4; i++) {
        double f = 0, g = 0;
        for (int j = 0; j < 4; j++) {
            f += K[i][j] * lift[j];
            g += K[i][j] * turn[j];
        }
        near(f, 0, EPS * K[0][0], "lifting the free element needs no force");
        near(g, 0, EPS * K[0][0], "turning the free element needs no force");
    }
}

static void symmetry(double K[4][4])
{
    int same = 1;

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            same &= K[i][j] == K[j][i];
    ok(same, "K is symmetric, bit for bit");
}

/* Held at the near end, force P = 1 down at the far one: w = L^3/3EI, slope L^2/2EI down, which is a negative pitch. */
static void cantilever(double K[4][4])
{
    double w, t;

    solve_two(K, 2, 3, 1, 0, &w, &t);
    near(w * 3 * EI / (L * L * L), 1, EPS, "cantilever: tip deflection L^3/3EI");
    near(t * 2 * EI / (L * L), -1, EPS, "cantilever: tip pitch -L^2/2EI");
}

/* Supported at both ends, unit force at a: w(a) = a^2 b^2 / 3EI L, from shape, solution and compliance together. */
static void simply_supported(double K[4][4])
{
    for (int k = 1; k < 8; k++) {
        double a = k * L / 8, b = L - a, N[4], t1, t2;
        beam_shape(&RAIL, a, N);
        solve_two(K, 1, 3, N[1], N[3], &t1, &t2);
        double w = N[1] * t1 + N[3] * t2 + beam_compliance(&RAIL, a);
        near(w * 3 * EI * L / (a * a * b * b), 1, 4 * EPS, "simply supported: deflection under the load a^2 b^2/3EIL");
    }
}

static void shape(void)
{
    double N[4];

    beam_shape(&RAIL, 0, N);
    ok(N[0] == 1 && N[1] == 0 && N[2] == 0 && N[3] == 0, "a load at the near end loads that end alone");
    beam_shape(&RAIL, L, N);
    near(fabs(N[0]) + fabs(N[1]) + fabs(N[2] - 1) + fabs(N[3]), 0, EPS, "a load at the far end loads that end alone");
    beam_shape(&RAIL, L / 2, N);
    near(fabs(N[0] - 0.5) + fabs(N[2] - 0.5) + fabs(N[1] + L / 8) + fabs(N[3] - L / 8), 0, EPS,
         "halfway the shape is 1/2, -L/8, 1/2, L/8");
    near(beam_compliance(&RAIL, L / 2) * 192 * EI / (L * L * L), 1, EPS, "compliance halfway is L^3/192EI");
    near(beam_compliance(&RAIL, 0.3), 1.841e-10, 1e-13, "1.841e-10 m/N for a bay of 0.6 m");
}

/* The cubic's own derivative: central differences are exact but for h^2 of its third derivative, 12/L^3. */
static void slope(void)
{
    double before[4], behind[4], D[4];
    const double h = 1e-5, a = 0.23;

    beam_shape(&RAIL, a - h, before);
    beam_shape(&RAIL, a + h, behind);
    beam_slope(&RAIL, a, D);
    for (int i = 0; i < 4; i++)
        near((behind[i] - before[i]) / (2 * h), D[i], 1e-8, "beam_slope is the derivative of beam_shape");
}

int main(void)
{
    double K[4][4];

    beam_stiffness(&RAIL, K);
    symmetry(K);
    rigid_motion(K);
    cantilever(K);
    simply_supported(K);
    shape();
    slope();
    return done();
}
