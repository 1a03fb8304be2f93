/* Reading, checking and writing tables of creep forces. */
#include "formats/creep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

#define EVEN 1e-9                /* of a step: how far an axis may be from even spacing */

static const struct { const char *name; double first, last; } axes[CREEP_AXES] = {
    {"shape", NAN, NAN}, {"size", 0, 1}, {"spin", 0, 1}, {"direction", -1, 1}};

static const char *check_axis(const struct creep *c, int k)
{
    const double *x = c->axis[k];
    int64_t n = c->n[k];
    if (n < 2)
        return reason("array %s: %lld nodes, two at least", axes[k].name, (long long)n);
    double step = (x[n - 1] - x[0])/(double)(n - 1);
    for (int64_t i = 0; i < n; i++)
        if (!(fabs(x[i] - (x[0] + step*(double)i)) <= EVEN*step))
            return reason("array %s: not increasing or not evenly spaced at %lld", axes[k].name, (long long)i);
    if (k == CREEP_SHAPE ? !(x[0] > 0 && x[n - 1] < 1) : !(x[0] == axes[k].first && x[n - 1] == axes[k].last))
        return reason("array %s: from %g to %g", axes[k].name, x[0], x[n - 1]);
    return NULL;
}

static const char *check(const struct creep *c)
{
    const char *why;

    if (strcmp(c->theory, "fastsim") != 0 && strcmp(c->theory, "exact") != 0)
        return reason("header key THEORY: \"%s\" is not fastsim or exact", c->theory);
    if (!(c->poisson >= 0 && c->poisson <= 0.5))
        return reason("array poisson: %g", c->poisson);
    for (int k = 0; k < CREEP_AXES; k++)
        if ((why = check_axis(c, k)))
            return why;
    for (int64_t i = 0; i < c->n[0]; i++)       /* small creepages have Kalker's coefficients */
        for (int64_t j = 0; j < c->n[2]*c->n[3]*CREEP_FORCES; j++)
            if (fabs(c->rest[i*c->n[1]*c->n[2]*c->n[3]*CREEP_FORCES + j]) > 0)
                return reason("array rest: not 0 at size 0");
    return NULL;
}

const char *creep_read(struct creep *c, const struct vxf *f)
{
    const void *poisson, *axis, *rest, *grid;
    int64_t dim[CREEP_AXES + 1];
    const char *why;

    memset(c, 0, sizeof *c);
    if ((why = vxf_is(f, "creep")) || (why = vxf_key(f, "THEORY", c->theory, sizeof c->theory)) ||
        (why = vxf_get(f, "grid", VXF_I64, "1", 0, NULL, &grid)) || (why = vxf_get(f, "poisson", VXF_F64, "1", 0, NULL, &poisson)))
        return why;
    for (int k = 0; k < CREEP_AXES; k++) {
        c->n[k] = -1;
        if ((why = vxf_get(f, axes[k].name, VXF_F64, "1", 1, &c->n[k], &axis)))
            return why;
        c->axis[k] = axis;
        dim[k] = c->n[k];
    }
    dim[CREEP_AXES] = CREEP_FORCES;
    if ((why = vxf_get(f, "rest", VXF_F64, "1", CREEP_AXES + 1, dim, &rest)))
        return why;
    c->grid = *(const int64_t *)grid;
    c->poisson = *(const double *)poisson;
    c->rest = rest;
    return check(c);
}

const char *creep_put(const struct creep *c, struct vxf_out *o)
{
    const char *why = check(c);

    if (why)
        return why;
    vxf_put_key(o, "THEORY", "%s", c->theory);
    vxf_put(o, "grid", VXF_I64, "1", 0, NULL, &c->grid);
    vxf_put(o, "poisson", VXF_F64, "1", 0, NULL, &c->poisson);
    for (int k = 0; k < CREEP_AXES; k++)
        vxf_put(o, axes[k].name, VXF_F64, "1", 1, &c->n[k], c->axis[k]);
    vxf_put(o, "rest", VXF_F64, "1", CREEP_AXES + 1, (int64_t[]){c->n[0], c->n[1], c->n[2], c->n[3], CREEP_FORCES}, c->rest);
    return NULL;
}

void creep_free(struct creep *c)
{
    free(c->store);
    memset(c, 0, sizeof *c);
}
