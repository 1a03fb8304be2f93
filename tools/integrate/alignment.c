#include "tools/integrate/alignment.h"
#include "formats/reason.h"

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

struct alignment_point alignment_at(const struct alignment *a, double s)
{
    int64_t i = a->n - 1;

    while (i >= 0 && s < a->x[i])
        i--;
    return i < 0 ? (struct alignment_point){0} : advance(a, i, s - a->x[i]);
}
