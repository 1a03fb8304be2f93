#include "tools/integrate/spectrum.h"
#include "formats/random.h"

#include <math.h>
#include <string.h>

#define WC 0.8246 /* rad/m */
#define WR 0.0206
#define WS 0.4380
#define MARGIN 1.25 /* of the length after which the waves repeat */

static const double A[2][IRREGULARITY_QUANTITIES] = {   /* m rad */
    [SPECTRUM_LOW] = {4.032e-7, 2.119e-7, 4.032e-7, 5.32e-8},
    [SPECTRUM_HIGH] = {1.080e-6, 6.125e-7, 1.080e-6, 1.032e-7},
};

double spectrum_density(enum spectrum_level level, enum irregularity_quantity quantity, double W)
{
    const double S = A[level][quantity] * WC * WC / ((W * W + WR * WR) * (W * W + WC * WC)), high_pass = W * W / (W * W + WS * WS);

    switch (quantity) {
    case IRREGULARITY_CROSS_LEVEL:
        return 4 * S * high_pass; /* an angle by rails 2 b apart: S/b^2 (2 b)^2 */
    case IRREGULARITY_GAUGE:
        return S * high_pass;
    default:
        return S;
    }
}

/* f = sum_k a_k cos(W_k x + p_k), a_k = sqrt(2 S dW); each wave goes from point to point by one turn. */
void spectrum_series(const struct spectrum_waves *waves, enum irregularity_quantity quantity, double x0, double h, int64_t n, double *value,
                     double *slope)
{
    const double from = 2 * M_PI / waves->longest, to = 2 * M_PI / waves->shortest;
    const int64_t count = (int64_t)ceil((to - from) * MARGIN * waves->length / (2 * M_PI));
    const double dW = (to - from) / (double)count;
    struct random random;

    random_begin(&random, (uint64_t)waves->seed * IRREGULARITY_QUANTITIES + (uint64_t)quantity);
    memset(value, 0, (size_t)n * sizeof *value);
    memset(slope, 0, (size_t)n * sizeof *slope);
    for (int64_t k = 0; k < count; k++) {
        const double W = from + ((double)k + 0.5) * dW, phase = 2 * M_PI * random_uniform(&random) + W * x0;
        const double a = sqrt(2 * spectrum_density(waves->level, quantity, W) * dW);
        const double turn_re = cos(W * h), turn_im = sin(W * h);
        double re = a * cos(phase), im = a * sin(phase);
        for (int64_t i = 0; i < n; i++) {
            const double next = re * turn_re - im * turn_im;
            value[i] += re;
            slope[i] -= W * im;
            im = re * turn_im + im * turn_re;
            re = next;
        }
    }
}
