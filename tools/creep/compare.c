/* Random contacts in units of a b = 1, mu N = 1, G = 1. */
#include "tools/creep/compare.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/creep/exact.h"
#include "tools/creep/fastsim.h"
#include "tools/creep/table.h"

#define WIDEST 10           /* a/b or b/a */
#define SMALLEST -5         /* logarithm of the creepage */
#define LARGEST 2

/* Evenly between a and b: splitmix64, Steele, Lea and Flood 2014. */
static double draw(uint64_t *state, double a, double b)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15;

    z = (z ^ z >> 30)*0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27)*0x94d049bb133111eb;
    return a + (b - a)*(double)((z ^ z >> 31) >> 11)/9007199254740992.0;    /* 2^53 */
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
    double sum = 0;

    *d = (struct creep_difference){0};
    if (f)
        fastsim_begin(f, theory == CREEP_FASTSIM ? grid : 1);
    for (int64_t i = 0; !why && i < n; i++) {
        double ratio = exp(draw(&seed, -log(WIDEST), log(WIDEST))), a = sqrt(ratio), b = 1/a, F[3], want[3];
        double size = exp(draw(&seed, SMALLEST, LARGEST)), angle = draw(&seed, -M_PI, M_PI);
        double c[3] = {size*cos(angle), size*sin(angle), draw(&seed, -1, 1)};
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
