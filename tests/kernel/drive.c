/* Histories of prescribed forces: their size, their band, their repeatability. */
#include <math.h>
#include <string.h>

#include "tests/kernel/tap.h"
#include "tools/integrate/drive.h"

enum { N = 8000 };
static const double STEP = 1e-3;

static double F[N], again[N];

/* N^2, mean power of the sine of f Hz over the first n samples. */
static double power_at(double f, int n)
{
    double re = 0, im = 0;

    for (int i = 0; i < n; i++) {
        re += F[i] * cos(2 * M_PI * f * i * STEP);
        im += F[i] * sin(2 * M_PI * f * i * STEP);
    }
    return 2 * (re * re + im * im) / ((double)n * n);
}

static double mean_square(int n)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += F[i] * F[i];
    return sum / n;
}

static void strikes(void)
{
    const struct drive e = {.kind = DRIVE_IMPULSE, .amplitude = 7, .width = 0.01, .blows = 4, .duration = 8};
    double sum = 0, most = 0;
    int struck = 0;

    ok(!drive_sample(&e, STEP, N, F), "four blows");
    for (int i = 0; i < N; i++) {
        sum += F[i] * STEP;
        most = fmax(most, F[i]);
        struck += F[i] > 0 && i % 2000 < 10;
    }
    near(sum, 4 * 7 * 0.01 / 2, 1e-12, "impulse, half of amplitude and width");
    near(most, 7, 1e-12, "largest force");
    ok(struck == 4 * 9, "within the width, two seconds apart");
}

static void sweeps(void)
{
    const struct drive e = {.kind = DRIVE_SWEEP, .amplitude = 3, .from = 10, .to = 60, .duration = 8, .rest = 2};
    double rest = 0;
    int crossings = 0;

    ok(!drive_sample(&e, STEP, N, F), "a sweep");
    for (int i = 1; i < N; i++) {
        rest += i >= 6000 ? fabs(F[i]) : 0;
        crossings += F[i - 1] < 0 && F[i] >= 0;
    }
    ok(crossings >= 209 && crossings <= 211, "goes through its mean frequency times its time, 210 periods (%d)", crossings);
    near(mean_square(6000), 4.5, 0.05, "mean square");
    ok(!(rest > 0), "and rests");
}

static void hisses(void)
{
    struct drive e = {.kind = DRIVE_NOISE, .amplitude = 5, .from = 20, .to = 120, .duration = 8, .seed = 3};
    double inside = 0, outside = 0;

    ok(!drive_sample(&e, STEP, N, F), "noise");
    near(mean_square(N), 25, 1e-9, "root mean square");
    for (int k = 1; k < 400; k++)
        *(k >= 20 && k <= 120 ? &inside : &outside) += power_at(k, N);
    ok(outside < 1e-20 * inside, "within its band alone (%.1e outside)", outside / inside);
    drive_sample(&e, STEP, N, again);
    ok(memcmp(F, again, sizeof F) == 0, "the same seed, the same noise");
    e.seed = 4;
    drive_sample(&e, STEP, N, again);
    ok(memcmp(F, again, sizeof F) != 0, "another seed, another noise");
    e.from = 20.01;
    e.to = 20.02;
    ok(drive_sample(&e, STEP, N, F) != NULL, "a band without a sine is refused");
}

int main(void)
{
    strikes();
    sweeps();
    hisses();
    return done();
}
