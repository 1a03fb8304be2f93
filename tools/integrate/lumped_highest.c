/* The highest natural frequency, which limits the explicit step. */
#include "tools/integrate/lumped.h"

#include <math.h>
#include <string.h>

enum { POWER_ITERATIONS = 400 };

/* x <- M^-1 K x, scaled: the factor tends to the square of the highest frequency.  M^-1 K is similar to a symmetric
 * matrix, so the quotient with M as weight is that of Rayleigh and converges as the square of the vector does. */
double lumped_highest(struct lumped *l)
{
    size_t n = (size_t)(LUMPED_PARTS * l->stride);
    double lambda = 0, g = l->gravity;
    int pushes[3];

    memcpy(pushes, l->pushes, sizeof pushes);
    memset(l->pushes, 0, sizeof pushes);
    l->gravity = 0;
    memset(l->v, 0, n * sizeof *l->v);
    for (size_t i = 0; i < n; i++)
        l->u[i] = l->inverse[i] > 0 ? (i % 2 ? -1.0 : 1.0) / (1.0 + (double)(i % 7)) : 0;
    for (int k = 0; k < POWER_ITERATIONS; k++) {
        double xx = 0, xy = 0, yy = 0;
        lumped_accelerate(l);
        for (size_t i = 0; i < n; i++)
            if (l->inverse[i] > 0) {
                xx += l->u[i] * l->u[i] / l->inverse[i];
                xy -= l->u[i] * l->a[i] / l->inverse[i];
                yy += l->a[i] * l->a[i];
            }
        lambda = xy / xx;
        for (size_t i = 0; i < n; i++)
            l->u[i] = -l->a[i] / sqrt(yy);
    }
    memset(l->u, 0, n * sizeof *l->u);
    memset(l->a, 0, n * sizeof *l->a);
    l->gravity = g;
    memcpy(l->pushes, pushes, sizeof pushes);
    return sqrt(lambda);
}
