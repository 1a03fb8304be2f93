/* Natural frequencies of beams of consistent mass against closed forms, and the order in which they converge. */
#include "tools/track/beam.h"

#include <lapacke.h>
#include <stdlib.h>

#include "tests/kernel/tap.h"

static const double EI = 6.11e6, MASS = 60, GA = 2.49e8, ROTARY = 0.2385, BAY = 0.6;

enum ends { FREE, SUPPORTED };

/* n elements in each of the bays, on supports without pitch stiffness at all ends of bays or nowhere: Hz, increasing, into f [most]. */
static void frequencies(const struct beam *one, int bays, int n, enum ends ends, double *f, int most)
{
    const int all = 2 * (bays * n + 1);
    double *K = calloc(2 * (size_t)(all * all) + (size_t)all, sizeof *K), *M = K + all * all, *lambda = M + all * all, k[4][4], m[4][4];
    struct beam b = *one;

    b.length = BAY / n;
    beam_stiffness(&b, k);
    beam_mass(&b, m);
    for (int e = 0; e < bays * n; e++)
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                K[(2 * e + i) * all + 2 * e + j] += k[i][j];
                M[(2 * e + i) * all + 2 * e + j] += m[i][j];
            }
    for (int s = 0; s <= bays && ends == SUPPORTED; s++)       /* a support: its row and column are gone, its frequency far above */
        for (int j = 0; j < all; j++) {
            const int d = 2 * s * n;
            K[d * all + j] = K[j * all + d] = j == d ? 1e13 : 0;
            M[d * all + j] = M[j * all + d] = j == d ? 1 : 0;
        }
    const int info = LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'U', all, K, all, M, all, lambda);
    for (int i = 0; i < most; i++)
        f[i] = info ? NAN : sqrt(fmax(lambda[i], 0)) / (2 * M_PI);
    free(K);
}

static struct beam euler(void)
{
    return (struct beam){.bending = EI, .mass = MASS};
}

static struct beam timoshenko(void)
{
    return (struct beam){.bending = EI, .mass = MASS, .shear = 1 / GA, .rotary = ROTARY};
}

/* The smaller root of (rho I m/GA) w^4 - (m + rho I q^2 + m EI q^2/GA) w^2 + EI q^4 = 0, q = mode pi/L (Timoshenko 1922). */
static double supported(double GA_, double rotary, double q)
{
    const double a = rotary * MASS / GA_, b = MASS + rotary * q * q + MASS * EI * q * q / GA_, c = EI * q * q * q * q;

    return sqrt(2 * c / (b + sqrt(b * b - 4 * a * c))) / (2 * M_PI);
}

/* cos x cosh x = 1 by Newton, x near (k + 1/2) pi. */
static double free_root(int k)
{
    double x = (k + 0.5) * M_PI;

    for (int i = 0; i < 20; i++)
        x -= (cos(x) - 1 / cosh(x)) / (-sin(x) + tanh(x) / cosh(x));
    return x;
}

/* Free Timoshenko beam of length l, even and odd modes: with w^2, the wave numbers a (sine) and b (sinh) of
 *   EI q^4 - w^2 (m EI/GA + rho I) q^2 - m w^2 (1 - rho I w^2/GA) = 0
 * and p' = c w' of each wave, moment and shear vanish at l/2.  The determinant. */
static double free_determinant(double f, double l, int odd)
{
    const double w2 = pow(2 * M_PI * f, 2), d = w2 * (MASS * EI / GA + ROTARY) / (2 * EI), e = MASS * w2 * (1 - ROTARY * w2 / GA) / EI;
    const double a = sqrt(sqrt(d * d + e) + d), b = sqrt(sqrt(d * d + e) - d), h = l / 2;
    const double pa = a - MASS * w2 / (GA * a), pb = b + MASS * w2 / (GA * b);      /* turn over deflection */

    if (odd)   /* w = sin, p = pa cos; M = p', Q = w' - p */
        return -pa * a * sin(a * h) * (b - pb) * cosh(b * h) - pb * b * sinh(b * h) * (a - pa) * cos(a * h);
    return -pa * a * cos(a * h) * (b - pb) * sinh(b * h) + pb * b * cosh(b * h) * (a - pa) * sin(a * h);
}

static double free_timoshenko(double from, double to, double l, int odd)
{
    const int sign = free_determinant(from, l, odd) > 0;

    for (int i = 0; i < 80; i++) {
        const double middle = 0.5 * (from + to);
        *((free_determinant(middle, l, odd) > 0) == sign ? &from : &to) = middle;
    }
    return 0.5 * (from + to);
}

/* The first modes of a beam of one bay. */
static void simply_supported(void)
{
    const struct beam e = euler(), t = timoshenko();
    double f[3];
    char text[80];

    frequencies(&e, 1, 16, SUPPORTED, f, 3);
    for (int k = 1; k <= 3; k++) {
        snprintf(text, sizeof text, "simply supported, Euler-Bernoulli: mode %d at (k pi/L)^2 sqrt(EI/m)", k);
        near(f[k - 1] / (pow(k * M_PI / BAY, 2) * sqrt(EI / MASS) / (2 * M_PI)), 1, 2e-6 * pow(k, 4), text);
    }
    frequencies(&t, 1, 16, SUPPORTED, f, 3);
    for (int k = 1; k <= 3; k++) {
        snprintf(text, sizeof text, "simply supported, Timoshenko: mode %d at %.2f Hz", k, supported(GA, ROTARY, k * M_PI / BAY));
        near(f[k - 1] / supported(GA, ROTARY, k * M_PI / BAY), 1, 1e-4 * k * k, text);
    }
}

static void both_free(void)
{
    const struct beam e = euler(), t = timoshenko();
    const double l = 4 * BAY;
    double f[5], bound[3] = {0, 0, 0};
    char text[80];

    frequencies(&e, 4, 8, FREE, f, 5);
    ok(f[0] < 0.1 && f[1] < 0.1, "free: two rigid motions");
    for (int k = 1; k <= 3; k++) {
        bound[k - 1] = pow(free_root(k) / l, 2) * sqrt(EI / MASS) / (2 * M_PI);
        snprintf(text, sizeof text, "free, Euler-Bernoulli: mode %d at %.3f Hz, cos x cosh x = 1", k, bound[k - 1]);
        near(f[k + 1] / bound[k - 1], 1, 1e-6 * pow(k, 4), text);
    }
    frequencies(&t, 4, 8, FREE, f, 5);
    for (int k = 1; k <= 3; k++) {
        const double want = free_timoshenko(0.6 * bound[k - 1], bound[k - 1], l, k % 2 == 0);
        snprintf(text, sizeof text, "free, Timoshenko: mode %d at %.3f Hz", k, want);
        near(f[k + 1] / want, 1, 3e-4, text);
    }
}

/* Observed order of the lowest frequency of a rail over six bays: pinned-pinned. */
static double order(const struct beam *b, double want, int coarse, const char *name)
{
    double f[3];

    for (int i = 0; i < 3; i++)
        frequencies(b, 6, coarse << i, SUPPORTED, &f[i], 1);
    printf("# %s, %d, %d and %d elements a bay: %.4f, %.4f, %.4f Hz for %.4f Hz\n", name, coarse, 2 * coarse, 4 * coarse, f[0], f[1], f[2], want);
    return log2((f[1] - want) / (f[2] - want));
}

static void pinned_pinned(void)
{
    const struct beam e = euler(), t = timoshenko();
    const double want = M_PI / (2 * BAY * BAY) * sqrt(EI / MASS);
    double f;

    near(want, 1392.39, 0.005, "pinned-pinned of a continuous beam, pi/(2 L^2) sqrt(EI/m)");
    near(order(&e, want, 2, "Euler-Bernoulli"), 4, 0.1, "consistent mass converges to it with the fourth order");
    near(supported(GA, ROTARY, M_PI / BAY), 1056, 1.5, "Timoshenko's lies at 1056 Hz");
    for (int n = 4; n <= 8; n *= 2) {
        frequencies(&t, 6, n, SUPPORTED, &f, 1);
        near(f, 1056, 1.5, n == 4 ? "with four elements a bay too" : "and with eight");
    }
    ok(order(&t, supported(GA, ROTARY, M_PI / BAY), 2, "Timoshenko") > 1.9, "which converge with the second order at least");
}

int main(void)
{
    simply_supported();
    both_free();
    pinned_pinned();
    return done();
}
