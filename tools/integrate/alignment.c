#include "tools/integrate/alignment.h"
#include "formats/reason.h"

#include <math.h>
#include <stdlib.h>

/* From the beginning of piece i: d further on. */
static struct alignment_point advance(const struct alignment *a, int64_t i, double d)
{
    double k = a->curvature[i];

    return (struct alignment_point){
        .curvature = k,
        .heading = a->heading[i] + k * d,                              /* k d             */
        .offset = a->offset[i] + a->heading[i] * d + 0.5 * k * d * d,  /* h d + k d^2 / 2 */
    };
}

const char *alignment_new(struct alignment *a, int64_t n, const double *x, const double *curvature)
{
    *a = (struct alignment){.n = n, .x = x, .curvature = curvature};
    a->heading = calloc((size_t)n + 1, sizeof *a->heading);
    a->offset = calloc((size_t)n + 1, sizeof *a->offset);
    if (!a->heading || !a->offset) {
        alignment_free(a);
        return REASON_MEMORY;
    }
    for (int64_t i = 1; i < n; i++) {
        struct alignment_point p = advance(a, i - 1, x[i] - x[i - 1]);
        a->heading[i] = p.heading;
        a->offset[i] = p.offset;
    }
    return NULL;
}

void alignment_free(struct alignment *a)
{
    free(a->heading);
    free(a->offset);
    *a = (struct alignment){0};
}

void alignment_raise(struct alignment *a, int64_t n, const double *x, const double *cant, double base)
{
    a->cants = n;
    a->cant_x = x;
    a->cant = cant;
    a->base = base;
}

/* sin(angle) = cant/base, and its derivative along the track. */
static void roll(const struct alignment *a, double s, double *angle, double *twist)
{
    int64_t i = a->cants - 1;

    while (i >= 0 && s < a->cant_x[i])
        i--;
    const int64_t k = i < 0 ? 0 : i;
    const int inside = i >= 0 && i + 1 < a->cants;
    const double slope = inside ? (a->cant[i + 1] - a->cant[i]) / (a->cant_x[i + 1] - a->cant_x[i]) : 0;
    *angle = asin((a->cant[k] + slope * (s - a->cant_x[k])) / a->base);
    *twist = slope / (a->base * cos(*angle));
}

struct alignment_point alignment_at(const struct alignment *a, double s)
{
    struct alignment_point p = {0};
    int64_t i = a->n - 1;

    while (i >= 0 && s < a->x[i])
        i--;
    if (i >= 0)
        p = advance(a, i, s - a->x[i]);
    if (a->cants > 0)
        roll(a, s, &p.cant, &p.twist);
    return p;
}
