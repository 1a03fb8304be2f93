#include "tools/integrate/direction.h"

void direction_load(const struct direction *d, double F, double *f)
{
    for (int i = 0; i < d->n; i++)
        f[d->dof[i]] += F * d->share[i];
}

double direction_sample(const struct direction *d, const double *state)
{
    double sum = 0;

    for (int i = 0; i < d->n; i++)
        sum += d->share[i] * state[d->dof[i]];
    return sum;
}

double direction_give(const struct direction *a, const struct direction *b, const double *Z, int beyond)
{
    const int width = beyond + 1;
    double sum = 0;

    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) {
            const int64_t p = a->dof[i], q = b->dof[j];
            sum += a->share[i] * b->share[j] * (p < q ? Z[p * width + q - p] : Z[q * width + p - q]);
        }
    return sum;
}
