/* The beam element with shear and with a bending stiffness that varies, against closed forms. */
#include "tools/track/beam.h"

#include "tests/kernel/tap.h"

static const double L = 0.6, EI = 6.11e6, PHI = 1 / 2.49e8, MASS = 60, ROTARY = 0.2385, EPS = 1e-12;
static const double RAMP_X[2] = {10, 10.6}, RAMP[2] = {6.11e6, 9.165e6};               /* over the element */
static const double KNEE_X[4] = {9, 10.1, 10.25, 12}, KNEE[4] = {6e6, 6e6, 9e6, 9e6};  /* knots within it */

static struct beam timoshenko(void)
{
    return (struct beam){.length = L, .bending = EI, .shear = PHI, .mass = MASS, .rotary = ROTARY};
}

static struct beam varying(const double *x, const double *bending, int64_t n, double from, double length)
{
    return (struct beam){.length = length, .mass = MASS, .from = from, .knots = n, .x = x, .EI = bending};
}

/* K u at every row for the two rigid motions, over the largest entry. */
static void properties(const struct beam *b, const char *what)
{
    const double motion[2][4] = {{1, 0, 1, 0}, {0, 1, -b->length, 1}};
    double K[4][4], M[4][4], worst = 0, inertia[2] = {0, 0};
    int same = 1;

    beam_stiffness(b, K);
    beam_mass(b, M);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++) {
            double f = 0, g = 0;
            for (int j = 0; j < 4; j++) {
                f += K[i][j] * motion[k][j];
                g += M[i][j] * motion[k][j];
                same &= K[i][j] == K[j][i] && M[i][j] == M[j][i];
            }
            worst = fmax(worst, fabs(f) / K[0][0]);
            inertia[k] += motion[k][i] * g;
        }
    near(worst, 0, EPS, what);
    ok(same, "K and M are symmetric, bit for bit");
    near(inertia[0] / (b->mass * b->length), 1, EPS, "lifted, it weighs m L");
    near(inertia[1] / (b->mass * pow(b->length, 3) / 3 + b->rotary * b->length), 1, EPS, "turned about its end, m L^3/3 + rho I L");
}

/* Przemieniecki 1968, Theory of Matrix Structural Analysis, 5.117: P = 12 EI/(kappa G A L^2). */
static void shear_stiffness(void)
{
    const struct beam b = timoshenko();
    const double P = 12 * EI * PHI / (L * L), k = EI / (L * L * L * (1 + P));
    double K[4][4], N[4];

    beam_stiffness(&b, K);
    near(K[0][0] / (12 * k), 1, EPS, "Timoshenko: 12 EI/(L^3 (1 + P))");
    near(K[0][1] / (-6 * k * L), 1, EPS, "6 EI/(L^2 (1 + P))");
    near(K[1][1] / ((4 + P) * k * L * L), 1, EPS, "(4 + P) EI/(L (1 + P))");
    near(K[1][3] / ((2 - P) * k * L * L), 1, EPS, "(2 - P) EI/(L (1 + P))");
    near(beam_compliance(&b, L / 2) / (L * L * L / (192 * EI) + L * PHI / 4), 1, EPS, "held ends: L^3/192EI + L/(4 kappa G A)");
    beam_shape(&b, L / 2, N);
    near(fabs(N[0] - 0.5) + fabs(N[2] - 0.5) + fabs(N[1] + L / 8) + fabs(N[3] - L / 8), 0, EPS, "halfway the shape is that without shear");
}

/* m L/420 (156 22L 54 -13L; ...) with t = -dw/dx. */
static void hermite_mass(void)
{
    const struct beam b = {.length = L, .bending = EI, .mass = MASS};
    const double m = MASS * L / 420;
    double M[4][4];

    beam_mass(&b, M);
    near(M[0][0] / (156 * m), 1, EPS, "Euler-Bernoulli: 156 m L/420");
    near(M[0][1] / (-22 * L * m), 1, EPS, "22 m L^2/420");
    near(M[0][2] / (54 * m), 1, EPS, "54 m L/420");
    near(M[0][3] / (13 * L * m), 1, EPS, "13 m L^2/420");
    near(M[1][1] / (4 * L * L * m), 1, EPS, "4 m L^3/420");
    near(M[1][3] / (-3 * L * L * m), 1, EPS, "3 m L^3/420");
}

/* int_0^L s^2/EI ds of EI = e + g s, in logarithms: the tip of a cantilever held at its far end. */
static double ramp_flexibility(double e, double g)
{
    const double far = e + g * L;

    return ((far * far - e * e) / 2 - 2 * e * (far - e) + e * e * log(far / e)) / (g * g * g);
}

static void ramp(void)
{
    const struct beam b = varying(RAMP_X, RAMP, 2, 10, L);
    const double g = (RAMP[1] - RAMP[0]) / L;
    double K[4][4];

    beam_stiffness(&b, K);
    const double w = K[1][1] / (K[0][0] * K[1][1] - K[0][1] * K[1][0]);
    near(w / ramp_flexibility(RAMP[0], g), 1, EPS, "EI rising by half over the element: int s^2/EI of the near end, in logarithms");
    const double t = K[0][0] / (K[0][0] * K[1][1] - K[0][1] * K[1][0]);
    near(t / (log(RAMP[1] / RAMP[0]) / g), 1, EPS, "and int 1/EI");
}

/* The middle of [w t] x 3 condensed: k the chain of two elements. */
static void condense(double A[4][4], double B[4][4], double K[4][4])
{
    double k[6][6] = {{0}};

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            k[i][j] += A[i][j];
            k[i + 2][j + 2] += B[i][j];
        }
    const double a = k[2][2], b = k[2][3], d = k[3][3], det = a * d - b * b;
    const int end[4] = {0, 1, 4, 5};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            const double *p = k[end[i]], *q = k[end[j]];
            K[i][j] = p[end[j]] - (p[2] * (d * q[2] - b * q[3]) + p[3] * (a * q[3] - b * q[2])) / det;
        }
}

/* An element is the chain of two, joined anywhere, the joint under a force: what beam_shape and beam_compliance say. */
static void chain(struct beam b, double a, const char *what)
{
    struct beam near_part = b, far_part = b;
    double A[4][4], B[4][4], K[4][4], want[4][4], N[4], worst = 0;

    near_part.length = a;
    far_part.length = b.length - a;
    far_part.from = b.from + a;
    beam_stiffness(&near_part, A);
    beam_stiffness(&far_part, B);
    beam_stiffness(&b, K);
    condense(A, B, want);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            worst = fmax(worst, fabs(K[i][j] - want[i][j]) / K[0][0]);
    near(worst, 0, EPS, what);
    const double p = A[2][2] + B[0][0], q = A[2][3] + B[0][1], r = A[3][3] + B[1][1], det = p * r - q * q;
    near(beam_compliance(&b, a) * det / r, 1, 1e-9, "its compliance is that of the joint");
    beam_shape(&near_part, a / 3, N);
    near(beam_between(&b, a / 3, a) / (N[2] * r / det - N[3] * q / det), 1, 1e-9, "what is seen beside the force, the near part's shape");
    beam_shape(&b, a, N);
    const double shape[4] = {-(r * A[2][0] - q * A[3][0]) / det, -(r * A[2][1] - q * A[3][1]) / det, -(r * B[0][2] - q * B[1][2]) / det,
                             -(r * B[0][3] - q * B[1][3]) / det};
    for (int i = 0; i < 4; i++)
        near(N[i], shape[i], 1e-11, "and its shape the motion of the joint");
}

static void slope(const struct beam *b, double a)
{
    const double h = 1e-5;
    double before[4], behind[4], D[4];

    beam_shape(b, a - h, before);
    beam_shape(b, a + h, behind);
    beam_slope(b, a, D);
    for (int i = 0; i < 4; i++)
        near((behind[i] - before[i]) / (2 * h), D[i], 1e-8, "beam_slope is the derivative of beam_shape");
}

static void between(const struct beam *b)
{
    near(beam_between(b, 0.23, 0.23) / beam_compliance(b, 0.23), 1, 1e-9, "between a point and itself: the compliance");
    near(beam_compliance(b, 0), 0, 1e-25, "none over the near end");
    near(beam_compliance(b, L), 0, 1e-22, "nor over the far one");
}

int main(void)
{
    const struct beam shear = timoshenko(), ramped = varying(RAMP_X, RAMP, 2, 10, L), knee = varying(KNEE_X, KNEE, 4, 10, L);

    properties(&shear, "Timoshenko: rigid motions need no force");
    properties(&ramped, "EI rising: rigid motions need no force");
    properties(&knee, "EI with knees: rigid motions need no force");
    shear_stiffness();
    hermite_mass();
    ramp();
    chain(shear, 0.17, "Timoshenko: one element is two, joined at 0.17 m");
    chain(ramped, 0.17, "EI rising: one element is two");
    chain(knee, 0.1, "EI with knees: one element is two, joined at a knee");
    chain(knee, 0.17, "or between");
    slope(&shear, 0.23);
    slope(&knee, 0.23);
    between(&shear);
    between(&knee);
    return done();
}
