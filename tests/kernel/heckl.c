/* The track against the infinite beam on 401 discrete supports, Euler-Bernoulli and Timoshenko (Heckl 1995, Acustica 81, 559): with the
 * deflection G(x) of the free beam under a unit force and the supports' dynamic stiffness k,
 *   w_i + sum_j G(x_i - x_j) k w_j = G(x_i - x_0),   H = G(0) - sum_j G(x_0 - x_j) k w_j.   Run from the root. */
#include "tools/receptance/sweep.h"

#include <complex.h>
#include <stdlib.h>

#include <lapacke.h>

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"

enum { SUPPORTS = 401 };

static const double EI = 6.11e6, MASS = 60, BAY = 0.6;

/* Waves exp(q x) with EI q^4 + w^2 (m EI/GA + rho I) q^2 - m w^2 (1 - rho I w^2/GA) = 0 and turn p = (q + m w^2/(GA q)) times the
 * deflection; under the force p = 0 and the shear force on either side is half of it. */
struct waves { double complex q[2], size[2]; };

static struct waves find_waves(double GA, double rotary, double w)
{
    const double d = w * w * (MASS * EI / GA + rotary) / (2 * EI), e = MASS * w * w * (1 - rotary * w * w / GA) / EI;
    struct waves s = {.q = {-I * sqrt(sqrt(d * d + e) + d), -sqrt(sqrt(d * d + e) - d)}};
    double complex turn[2];

    for (int k = 0; k < 2; k++)
        turn[k] = s.q[k] + MASS * w * w / (GA * s.q[k]);
    s.size[0] = 0.5 / (MASS * w * w * (1 / s.q[0] - turn[0] / (turn[1] * s.q[1])));
    s.size[1] = -s.size[0] * turn[0] / turn[1];
    return s;
}

static double complex green(const struct waves *s, double x)
{
    return s->size[0] * cexp(s->q[0] * fabs(x)) + s->size[1] * cexp(s->q[1] * fabs(x));
}

/* Table 1, both rails loaded alike: pad in series with half a sleeper on half the ballast. */
static double complex support(double w)
{
    const double complex pad = 300e6 + 50e3 * w * I, below = 140e6 - 190 * w * w + 60e3 * w * I;
    return pad * below / (pad + below);
}

static double complex exact(double GA, double rotary, double frequency, double at)
{
    const double w = 2 * M_PI * frequency;
    const double complex k = support(w);
    const struct waves s = find_waves(GA, rotary, w);
    double complex *A = calloc(SUPPORTS * (SUPPORTS + 1), sizeof *A), *g = A + SUPPORTS * SUPPORTS, H = green(&s, 0);
    lapack_int pivot[SUPPORTS];

    for (int i = 0; i < SUPPORTS; i++) {
        for (int j = 0; j < SUPPORTS; j++)
            A[i * SUPPORTS + j] = (i == j) + k * green(&s, (i - j) * BAY);
        g[i] = green(&s, (i - SUPPORTS / 2) * BAY - at);
    }
    const int info = LAPACKE_zgesv(LAPACK_ROW_MAJOR, SUPPORTS, 1, A, SUPPORTS, pivot, g, 1);
    for (int j = 0; j < SUPPORTS; j++)
        H -= green(&s, (j - SUPPORTS / 2) * BAY - at) * k * g[j];
    free(A);
    return info ? NAN : H;
}

static double complex track(const char *beam, int elements, double frequency, int at)
{
    char number[32];
    const char *set[] = {"from=-60", "length=120", "rail.mass_model=consistent", beam, number};
    struct trk t;
    struct place p;
    struct frf r = {0};
    double complex H = NAN;

    snprintf(number, sizeof number, "rail.elements_per_bay=%d", elements);
    if (table1(&t, set, 5) == NULL) {
        place_find(&p, &t, PLACE_BOTH, at, 0);
        if (sweep_places(&r, &t, &p, &p, 0, &(struct sweep){frequency, frequency, 1}) == NULL)
            H = r.H[0] + r.H[1] * I;
    }
    frf_free(&r);
    trk_free(&t);
    return H;
}

static const double HERTZ[] = {10, 119, 256, 483, 800, 1000, 1200};
enum { ROWS = sizeof HERTZ / sizeof HERTZ[0] };

/* Published to six digits: the method itself. */
static void method(void)
{
    near(cabs(exact(1e30, 0, 119, 0)) / 9.93529e-9, 1, 1e-6, "Euler-Bernoulli, 119 Hz over a sleeper: 9.93529e-9 m/N");
    near(cabs(exact(1e30, 0, 1000, BAY / 2)) / 7.94059e-10, 1, 1e-6, "1000 Hz halfway: 7.94059e-10 m/N");
}

static void euler(void)
{
    for (int k = 0; k < ROWS; k++)
        for (int at = AT_SLEEPER; at <= AT_MIDSPAN; at++) {
            const double complex want = exact(1e30, 0, HERTZ[k], at * BAY / 2);
            const double off = cabs(track("rail.beam=euler", 8, HERTZ[k], at) / want - 1);
            ok(off < 1e-4, "Euler-Bernoulli, %g Hz %s: %.1e from the exact beam", HERTZ[k], at ? "halfway" : "over a sleeper", off);
        }
}

static void timoshenko(void)
{
    for (int k = 0; k < ROWS; k++)
        for (int at = AT_SLEEPER; at <= AT_MIDSPAN; at++) {
            const double complex want = exact(2.49e8, 0.2385, HERTZ[k], at * BAY / 2);
            const double four = cabs(track("rail.beam=timoshenko", 4, HERTZ[k], at) / want - 1);
            const double eight = cabs(track("rail.beam=timoshenko", 8, HERTZ[k], at) / want - 1);
            ok(eight < 1e-2, "Timoshenko, %g Hz %s: %.1e from the exact beam", HERTZ[k], at ? "halfway" : "over a sleeper", eight);
            near(log2(four / eight), 2, 0.25, "with the second order");
        }
}

int main(void)
{
    method();
    euler();
    timoshenko();
    return done();
}
