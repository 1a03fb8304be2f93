/* Every node of the table by a theory, in units of a b = 1, mu N = 1, G = 1. */
#include "tools/creep/tabulate.h"

#include <math.h>
#include <stdlib.h>
#include <stdio.h>

#include "formats/reason.h"
#include "tools/creep/exact.h"
#include "tools/creep/fastsim.h"
#include "tools/creep/kalker.h"
#include "tools/creep/table.h"

const char *const creep_theories[] = {"fastsim", "exact", NULL};

static const struct { int64_t n; double first, last; } AXES[CREEP_AXES] = {
    {9, 0.0625, 0.9375}, {15, 0, 1}, {11, 0, 1}, {13, -1, 1}};     /* a/b from 1/15 to 15 */

#define ENDLESS 1e6         /* the size of creepages at r/(1 + r) = 1 */

struct theory {
    enum creep_theory which;
    double nu, ratio;
    double C[KALKER_COEFFICIENTS];
    struct fastsim fastsim;
    struct exact exact;
};

static const char *force(struct theory *t, double x, double y, double s, double F[3])
{
    double creep[3] = {x/t->C[KALKER_C11], y/t->C[KALKER_C22], s/t->C[KALKER_C23]};

    if (t->which == CREEP_FASTSIM)
        fastsim(&t->fastsim, sqrt(t->ratio), 1/sqrt(t->ratio), 1, 1, 1, t->nu, creep[0], creep[1], creep[2], F);
    else if (!exact_force(&t->exact, creep, F))
        return reason("a/b %.3g, x %.3g, y %.3g, s %.3g: the exact theory does not come to rest", t->ratio, x, y, s);
    return NULL;
}

/* One shape, spin and direction from small to large creepages; rest[sizes] `stride` apart. */
static const char *tabulate_sizes(struct theory *theory, const struct creep *t, double spin, double direction, double *rest,
                                  int64_t stride)
{
    if (theory->which == CREEP_EXACT)
        exact_clear(&theory->exact);
    for (int64_t i = 1; i < t->n[CREEP_SIZE]; i++) {
        double size = t->axis[CREEP_SIZE][i], r = size < 1 ? CREEP_SIZE_HALF*size/(1 - size) : ENDLESS, F[3], linear[3];
        double s = spin*r*theory->C[KALKER_C23]/creep_spin(theory->C, 1/sqrt(theory->ratio)), y = (1 - spin)*direction*r;
        double x = (1 - spin)*(1 - fabs(direction))*r;
        const char *why = force(theory, x, y, s, F);
        if (why)
            return why;
        creep_linear(theory->C, x, y, s, linear);
        for (int k = 0; k < CREEP_FORCES; k++)
            rest[i*stride + k] = (F[k] - linear[k]*CREEP_SIZE_HALF/(CREEP_SIZE_HALF + r))/size;
    }
    return NULL;
}

static const char *tabulate_shape(struct theory *theory, const struct creep *t, double *rest)
{
    const int64_t directions = t->n[CREEP_DIRECTION], stride = t->n[CREEP_SPIN]*directions*CREEP_FORCES;

    kalker(theory->ratio, theory->nu, theory->C);
    for (int64_t k = 0; k < t->n[CREEP_SPIN]*directions; k++) {
        const char *why = tabulate_sizes(theory, t, t->axis[CREEP_SPIN][k/directions], t->axis[CREEP_DIRECTION][k % directions],
                                         rest + k*CREEP_FORCES, stride);
        if (why)
            return why;
    }
    return NULL;
}

static const char *tabulate_shapes(struct theory *theory, const struct creep *t, double *rest)
{
    const int64_t block = t->n[1]*t->n[2]*t->n[3]*CREEP_FORCES;
    const char *why = NULL;

    for (int64_t i = 0; !why && i < t->n[CREEP_SHAPE]; i++) {
        double q = t->axis[CREEP_SHAPE][i];
        theory->ratio = q/(1 - q);
        if (theory->which == CREEP_EXACT && (why = exact_begin(&theory->exact, (int)t->grid, theory->ratio, theory->nu)))
            return why;
        why = tabulate_shape(theory, t, rest + i*block);
        exact_free(&theory->exact);
    }
    return why;
}

const char *tabulate(struct creep *t, enum creep_theory theory, int grid, double nu)
{
    int64_t axes = 0, nodes = 1;
    struct theory *how = calloc(1, sizeof *how);

    for (int k = 0; k < CREEP_AXES; k++) {
        axes += AXES[k].n;
        nodes *= AXES[k].n;
    }
    double *axis = calloc((size_t)(axes + nodes*CREEP_FORCES), sizeof *axis);
    *t = (struct creep){.grid = grid, .poisson = nu, .store = axis, .rest = axis + axes};
    snprintf(t->theory, sizeof t->theory, "%s", creep_theories[theory]);
    const char *why = axis && how ? NULL : REASON_MEMORY;
    for (int k = 0; !why && k < CREEP_AXES; k++) {
        t->n[k] = AXES[k].n;
        t->axis[k] = axis;
        for (int64_t i = 0; i < AXES[k].n; i++)
            *axis++ = AXES[k].first + (AXES[k].last - AXES[k].first)*(double)i/(double)(AXES[k].n - 1);
    }
    if (!why) {
        how->which = theory;
        how->nu = nu;
        fastsim_begin(&how->fastsim, theory == CREEP_FASTSIM ? grid : 1);
        why = tabulate_shapes(how, t, axis);
    }
    free(how);
    if (why)
        creep_free(t);
    return why;
}
