/* Histories whose transfer functions are known: a static spring, a delay of whole samples, motion half of which comes from elsewhere. */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/kernel/random.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/transfer.h"

enum { N = 100000, DELAY = 3 };
static const double STEP = 1e-3;

static double F[N], z[N];

static void noise(double *x)
{
    for (int i = 0; i < N; i++)
        x[i] = 2 * random_number() - 1;
}

static const char *estimate(struct frf *r, int64_t segment, int window, double held)
{
    const struct transfer t = {.n = N, .step = STEP, .F = F, .z = z, .held = held, .segment = segment, .window = window};

    memset(r, 0, sizeof *r);
    return transfer_estimate(r, &t, &(struct sweep){10, 400, 10});
}

static void springs(void)
{
    struct frf r;
    double worst = 0;

    noise(F);
    for (int i = 0; i < N; i++)
        z[i] = 2e-9 * F[i];
    const char *why = estimate(&r, 1000, TRANSFER_HANN, 5e-10);
    if (ok(!why && r.n == 40 && r.coherences == 40 && r.hermites == 40, "a spring%s%s", why ? ": " : "", why ? why : ""))
        for (int k = 0; k < 40; k++)
            worst = fmax(worst, cabs(r.H[2 * k] + r.H[2 * k + 1] * I - 2e-9) + fabs(r.hermite[2 * k] - 1.5e-9) + 1e-9 * (1 - r.coherence[k]));
    ok(worst < 1e-21, "its receptance, without the element's own, and coherence 1 (%.1e)", worst);
    frf_free(&r);
    why = estimate(&r, N, TRANSFER_NONE, 0);
    ok(!why && r.coherences == 0 && r.hermites == 0, "one segment has no coherence, and nothing held no Hermite values");
    frf_free(&r);
}

/* A periodic delay by whole samples turns each bin by exp(-i omega delay). */
static void delays(void)
{
    struct frf r;
    double worst = 0;

    noise(F);
    for (int i = 0; i < N; i++)
        z[i] = F[(i - DELAY + N) % N];
    if (ok(!estimate(&r, N, TRANSFER_NONE, 0), "a delay"))
        for (int64_t k = 0; k < r.n; k++)
            worst = fmax(worst, cabs(r.H[2 * k] + r.H[2 * k + 1] * I - cexp(-2 * M_PI * I * r.frequency[k] * DELAY * STEP)));
    ok(worst < 1e-11, "turns clockwise with frequency (%.1e)", worst);
    frf_free(&r);
}

/* z = F + an independent noise of the same power: H = 1, coherence 1/2. */
static void disturbs(void)
{
    static double other[N];
    struct frf r;
    double coherence = 0, H = 0;

    noise(F);
    noise(other);
    for (int i = 0; i < N; i++)
        z[i] = F[i] + other[i];
    if (ok(!estimate(&r, 100, TRANSFER_HANN, 0), "a disturbed motion"))
        for (int64_t k = 0; k < r.n; k++) {
            coherence += r.coherence[k] / (double)r.n;
            H += r.H[2 * k] / (double)r.n;
        }
    near(coherence, 0.5, 0.01, "mean coherence");
    near(H, 1, 0.01, "mean receptance");
    frf_free(&r);
}

static void refuses(void)
{
    struct frf r;
    const char *why;

    noise(F);
    why = estimate(&r, 30, TRANSFER_NONE, 0);
    ok(why && strstr(why, "not multiples of 33.3"), "bins that are not there: %s", why ? why : "accepted");
    why = estimate(&r, 2 * N, TRANSFER_NONE, 0);
    ok(why && strstr(why, "not within"), "a segment longer than the history: %s", why ? why : "accepted");
    memset(F, 0, sizeof F);
    why = estimate(&r, N, TRANSFER_NONE, 0);
    ok(why && strstr(why, "excites nothing"), "no force: %s", why ? why : "accepted");
    for (int i = 0; i < N; i++)
        F[i] = sin(2 * M_PI * 100 * i * STEP);
    why = estimate(&r, N, TRANSFER_NONE, 0);
    ok(!why && r.n == 1 && r.frequency[0] == 100, "one sine for all frequencies leaves its own: %s", why ? why : "accepted");
    frf_free(&r);
}

int main(void)
{
    springs();
    delays();
    disturbs();
    refuses();
    return done();
}
