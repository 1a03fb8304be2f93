#include "tools/integrate/two_step.h"
#include "tools/contact/clones.h"

CLONES static void advance_two_step(int64_t n, double h, double *restrict x, double *restrict v, const double *restrict a, double *restrict before)
{
    for (int64_t i = 0; i < n; i++) {
        x[i] += v[i] * h + (a[i] - 0.5 * before[i]) * h * h;
        v[i] += (1.5 * a[i] - 0.5 * before[i]) * h;
        before[i] = a[i];
    }
}

void two_step(int64_t n, double h, double *x, double *v, const double *a, double *before)
{
    advance_two_step(n, h, x, v, a, before);
}
