#include "tools/integrate/lowpass.h"

#include <math.h>

/* w(k) = sin(pi k/every)/(pi k) (0.54 + 0.46 cos(pi k/half)) */
void lowpass_weights(int64_t every, double *w)
{
    const int64_t half = LOWPASS_HALF * every;
    double sum = 0;

    for (int64_t k = -half; k <= half; k++) {
        const double x = M_PI * (double)k / (double)every;
        w[k + half] = (k ? sin(x) / x : 1) * (0.54 + 0.46 * cos(M_PI * (double)k / (double)half));
        sum += w[k + half];
    }
    for (int64_t k = 0; k <= 2 * half; k++)
        w[k] /= sum;
}
