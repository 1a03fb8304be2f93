/* Without load between the ends the moment is straight, M = c0 + c1 s.  With p = -t the turn of the cross-section (Timoshenko 1921,
 * Philosophical Magazine 41, 744)
 *   EI p' = c0 + c1 s,   w' = p - c1/(kappa G A),
 * so that with the moments of the flexibility, A_k(s) = int_0^s r^k/EI dr, and phi = 1/(kappa G A)
 *   p(s) = p1 + c0 A0 + c1 A1
 *   w(s) = w1 + p1 s + c0 (s A0 - A1) + c1 (s A1 - A2 - phi s);
 * the motion of the far end gives c0 and c1.  Stiffness follows from the energy int M^2/EI + phi c1^2. */
#include "tools/track/flexure.h"

#include <math.h>

/* Gauss with eight points: of 1/EI on a straight piece 6e-13 where EI doubles over it, 2e-8 where it becomes four times as large. */
enum { POINTS = 8 };
static const double AT[POINTS] = {-0.960289856497536232, -0.796666477413626740, -0.525532409916328986, -0.183434642495649805,
                                  0.183434642495649805, 0.525532409916328986, 0.796666477413626740, 0.960289856497536232};
static const double WEIGHT[POINTS] = {0.101228536290376259, 0.222381034453374471, 0.313706645877887287, 0.362683783378361983,
                                      0.362683783378361983, 0.313706645877887287, 0.222381034453374471, 0.101228536290376259};

static double bending_at(const struct beam *b, double station)
{
    int64_t low = 0, high = b->knots - 1;

    if (station <= b->x[0])
        return b->EI[0];
    if (station >= b->x[high])
        return b->EI[high];
    while (high - low > 1) {
        const int64_t middle = (low + high) / 2;
        *(b->x[middle] <= station ? &low : &high) = middle;
    }
    return b->EI[low] + (b->EI[high] - b->EI[low]) * (station - b->x[low]) / (b->x[high] - b->x[low]);
}

/* The nearest knot beyond s and before end, or end: EI is straight up to there. */
static double piece_end(const struct beam *b, double s, double end)
{
    for (int64_t k = 0; k < b->knots && !(b->bending > 0); k++)
        if (b->x[k] - b->from > s)
            return fmin(b->x[k] - b->from, end);
    return end;
}

/* A [3] from 0 to a. */
static void find_moments(const struct beam *b, double a, double A[3])
{
    if (b->bending > 0) {
        A[0] = a / b->bending;
        A[1] = a * a / (2 * b->bending);
        A[2] = a * a * a / (3 * b->bending);
        return;
    }
    A[0] = A[1] = A[2] = 0;
    for (double s = 0, end; s < a; s = end) {
        end = piece_end(b, s, a);
        for (int g = 0; g < POINTS; g++) {
            const double r = 0.5 * (s + end) + 0.5 * (end - s) * AT[g];
            const double f = 0.5 * (end - s) * WEIGHT[g] / bending_at(b, b->from + r);
            A[0] += f;
            A[1] += f * r;
            A[2] += f * r * r;
        }
    }
}

/* c = B u, u = [w1 t1 w2 t2]; A of the whole length. */
static void find_bending(const struct beam *b, const double A[3], double B[2][4])
{
    const double L = b->length, w0 = L * A[0] - A[1], w1 = L * A[1] - A[2] - b->shear * L;
    const double det = A[0] * w1 - A[1] * w0;
    const double turn[4] = {0, 1, 0, -1}, rise[4] = {-1, L, 1, 0};     /* p2 - p1 and w2 - w1 - p1 L */

    for (int i = 0; i < 4; i++) {
        B[0][i] = (w1 * turn[i] - A[1] * rise[i]) / det;
        B[1][i] = (A[0] * rise[i] - w0 * turn[i]) / det;
    }
}

/* N, P [4]: deflection w and turn p of the cross-section at s. */
static void find_shapes(const struct beam *b, double B[2][4], double s, double N[4], double P[4])
{
    double A[3];
    const double rigid_w[4] = {1, -s, 0, 0}, rigid_p[4] = {0, -1, 0, 0};

    find_moments(b, s, A);
    for (int i = 0; i < 4; i++) {
        N[i] = rigid_w[i] + B[0][i] * (s * A[0] - A[1]) + B[1][i] * (s * A[1] - A[2] - b->shear * s);
        P[i] = rigid_p[i] + B[0][i] * A[0] + B[1][i] * A[1];
    }
}

void flexure_stiffness(const struct beam *b, double K[4][4])
{
    double A[3], B[2][4];

    find_moments(b, b->length, A);
    find_bending(b, A, B);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j <= i; j++)
            K[i][j] = K[j][i] = A[0] * B[0][i] * B[0][j] + A[1] * (B[0][i] * B[1][j] + B[1][i] * B[0][j]) +
                                (A[2] + b->shear * b->length) * B[1][i] * B[1][j];
}

/* X += int m N N' + rho I P P' ds, below the diagonal */
static void add_inertia(const struct beam *b, double X[4][4])
{
    double A[3], B[2][4];

    find_moments(b, b->length, A);
    find_bending(b, A, B);
    for (double s = 0, end; s < b->length; s = end) {
        end = piece_end(b, s, b->length);
        for (int g = 0; g < POINTS; g++) {
            const double part = 0.5 * (end - s) * WEIGHT[g];
            double N[4], P[4];
            find_shapes(b, B, 0.5 * (s + end) + 0.5 * (end - s) * AT[g], N, P);
            for (int i = 0; i < 4; i++)
                for (int j = 0; j <= i; j++)
                    X[i][j] += part * (b->mass * N[i] * N[j] + b->rotary * P[i] * P[j]);
        }
    }
}

/* Shear also lets the inside of the element sag under its own inertia, by omega^2 m phi w s (L - s)/2 between held ends: as much inertia
 * again as omega^2 (m phi L^2/12) M u, and omega^2 M u = K u in a free vibration.  Bending does the same with L^4: it is left out. */
void flexure_mass(const struct beam *b, double M[4][4])
{
    const double sag = b->mass * b->shear * b->length * b->length / 12;

    flexure_stiffness(b, M);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j <= i; j++)
            M[i][j] *= sag;
    add_inertia(b, M);
    for (int i = 0; i < 4; i++)
        for (int j = i + 1; j < 4; j++)
            M[i][j] = M[j][i];
}

void flexure_shape(const struct beam *b, double a, double N[4])
{
    double A[3], B[2][4], P[4];

    find_moments(b, b->length, A);
    find_bending(b, A, B);
    find_shapes(b, B, a, N, P);
}

/* w' = p - phi c1 */
void flexure_slope(const struct beam *b, double a, double D[4])
{
    double A[3], B[2][4], N[4];

    find_moments(b, b->length, A);
    find_bending(b, A, B);
    find_shapes(b, B, a, N, D);
    for (int i = 0; i < 4; i++)
        D[i] -= b->shear * B[1][i];
}

/* What a unit force, and a unit moment, at the far end of a cantilever from the near end do at s; H of 0 to s. */
static void find_far(const struct beam *b, const double H[3], double s, double g[2])
{
    g[0] = s * b->length * H[0] - (s + b->length) * H[1] + H[2] + b->shear * s;
    g[1] = s * H[0] - H[1];
}

/* That cantilever's deflection at x under a unit force at a, less what its held far end takes back: g F^-1 g, F its flexibility there. */
double flexure_between(const struct beam *b, double x, double a)
{
    const double L = b->length;
    double A[3], Hx[3], Ha[3], gx[2], ga[2];

    find_moments(b, L, A);
    find_moments(b, x, Hx);
    find_moments(b, a, Ha);
    find_far(b, Hx, x, gx);
    find_far(b, Ha, a, ga);
    const double Fww = L * L * A[0] - 2 * L * A[1] + A[2] + b->shear * L, Fwp = L * A[0] - A[1], Fpp = A[0];
    const double own = x * a * Hx[0] - (x + a) * Hx[1] + Hx[2] + b->shear * x;
    const double taken = (gx[0] * ga[0] * Fpp - (gx[0] * ga[1] + gx[1] * ga[0]) * Fwp + gx[1] * ga[1] * Fww) / (Fww * Fpp - Fwp * Fwp);

    return fmax(own - taken, 0);
}
