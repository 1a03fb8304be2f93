/* Random contacts in units of a b = 1, mu N = 1, G = 1. */
#include "tools/creep/compare.h"

#include <math.h>
#include <stdlib.h>

#include "formats/random.h"
#include "formats/reason.h"
#include "tools/creep/exact.h"
#include "tools/creep/fastsim.h"
#include "tools/creep/table.h"

#define WIDEST 10           /* a/b or b/a */
#define SMALLEST -5         /* logarithm of the creepage */
#define LARGEST 2

static double between(struct random *r, double a, double b)
{
    return a + (b - a)*random_uniform(r);
}

static const char *exact_once(int grid, double ratio, double nu, const double creep[3], double force[3])
{
    struct exact e;
    const char *why = exact_begin(&e, grid, ratio, nu);

    if (!why && !exact_force(&e, creep, force))
        why = reason("a/b %.3g: the exact theory does not come to rest", ratio);
    exact_free(&e);
    return why;
}

const char *creep_compare(const struct creep *t, enum creep_theory theory, int grid, int64_t n, uint64_t seed, struct creep_difference *d)
{
    struct fastsim *f = calloc(1, sizeof *f);
    const char *why = f ? NULL : REASON_MEMORY;
    struct random random;
    double sum = 0;

    random_begin(&random, seed);
    *d = (struct creep_difference){0};
    if (f)
        fastsim_begin(f, theory == CREEP_FASTSIM ? grid : 1);
    for (int64_t i = 0; !why && i < n; i++) {
        double ratio = exp(between(&random, -log(WIDEST), log(WIDEST))), a = sqrt(ratio), b = 1/a, F[3], want[3];
        double size = exp(between(&random, SMALLEST, LARGEST)), angle = between(&random, -M_PI, M_PI);
        double c[3] = {size*cos(angle), size*sin(angle), between(&random, -1, 1)};
        creep_table(t, a, b, 1, 1, 1, t->poisson, c[0], c[1], c[2], F);
        if (theory == CREEP_FASTSIM)
            fastsim(f, a, b, 1, 1, 1, t->poisson, c[0], c[1], c[2], want);
        else if ((why = exact_once(grid, ratio, t->poisson, c, want)))
            break;
        double off = hypot(F[0] - want[0], F[1] - want[1]);
        sum += off*off;
        if (off > d->most)
            *d = (struct creep_difference){0, off, ratio, {c[0], c[1], c[2]}};
    }
    d->rms = sqrt(sum/(double)n);
    free(f);
    return why;
}
