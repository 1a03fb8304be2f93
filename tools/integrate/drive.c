#include "tools/integrate/drive.h"
#include "formats/random.h"
#include "formats/reason.h"

#include <math.h>
#include <string.h>

#include <fftw3.h>

static void strike(const struct drive *e, double step, int64_t n, double *F)
{
    for (int64_t i = 0; i < n; i++) {
        const double t = fmod((double)i * step, e->duration / (double)e->blows);
        F[i] = t < e->width ? 0.5 * e->amplitude * (1 - cos(2 * M_PI * t / e->width)) : 0;
    }
}

static void sweep(const struct drive *e, double step, int64_t n, double *F)
{
    const double T = e->duration - e->rest;

    for (int64_t i = 0; i < n; i++) {
        const double t = (double)i * step;
        F[i] = t < T ? e->amplitude * sin(2 * M_PI * (e->from * t + (e->to - e->from) * t * t / (2 * T))) : 0;
    }
}

/* Normal coefficients of the sines within the band, transformed, and scaled to the amplitude. */
static const char *hiss(const struct drive *e, double step, int64_t n, double *F)
{
    const int64_t m = (int64_t)fmin((double)n, floor((e->duration - e->rest) / step + 0.5));
    const double T = (double)m * step;
    double *f = fftw_alloc_real((size_t)(2 * (m / 2 + 1)));
    fftw_complex *c = (fftw_complex *)f;
    struct random random;
    double power = 0;

    if (!f)
        return REASON_MEMORY;
    random_begin(&random, e->seed);
    for (int64_t k = 0; k <= m / 2; k++) {
        c[k][0] = c[k][1] = 0;
        if ((double)k / T >= e->from && (double)k / T <= e->to)
            random_normal(&random, c[k]);
        power += 2 * (c[k][0] * c[k][0] + c[k][1] * c[k][1]);
    }
    fftw_plan plan = fftw_plan_dft_c2r_1d((int)m, c, f, FFTW_ESTIMATE);
    if (plan)
        fftw_execute(plan);
    fftw_destroy_plan(plan);
    memset(F, 0, (size_t)n * sizeof *F);
    for (int64_t i = 0; i < m && plan && power > 0; i++)
        F[i] = e->amplitude * f[i] / sqrt(power);
    fftw_free(f);
    if (!plan)
        return REASON_MEMORY;
    return power > 0 ? NULL : "no sine of the duration's period lies within the band of the noise";
}

const char *drive_sample(const struct drive *e, double step, int64_t n, double *F)
{
    if (e->kind == DRIVE_NOISE)
        return hiss(e, step, n, F);
    (e->kind == DRIVE_SWEEP ? sweep : strike)(e, step, n, F);
    return NULL;
}
