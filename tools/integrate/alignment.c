#include "tools/integrate/alignment.h"
#include "formats/reason.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* The beginning of piece i from that of the one before. */
static void reach(struct alignment *a, int64_t i)
{
    const struct alignment_point p = advance(a, i - 1, a->x[i] - a->x[i - 1]);

    a->heading[i] = p.heading;
    a->offset[i] = p.offset;
}

const char *alignment_new(struct alignment *a, int64_t n, const double *x, const double *curvature)
{
    *a = (struct alignment){.n = n, .x = x, .curvature = curvature};
    a->heading = calloc((size_t)n + 2, sizeof *a->heading);
    a->offset = calloc((size_t)n + 2, sizeof *a->offset);
    if (!a->heading || !a->offset) {
        alignment_free(a);
        return REASON_MEMORY;
    }
    for (int64_t i = 1; i < n; i++)
        reach(a, i);
    return NULL;
}

/* Into piece i, of which s is a place, comes a piece that begins at s. */
static const char *split(struct alignment *a, int64_t i, double s)
{
    const int64_t n = a->n + 1;
    double *own = calloc(2 * (size_t)n, sizeof *own);

    if (!own)
        return REASON_MEMORY;
    memcpy(own, a->x, (size_t)(i + 1) * sizeof *own);
    memcpy(own + n, a->curvature, (size_t)(i + 1) * sizeof *own);
    own[i + 1] = s;
    own[n + i + 1] = a->curvature[i];
    memcpy(own + i + 2, a->x + i + 1, (size_t)(a->n - i - 1) * sizeof *own);
    memcpy(own + n + i + 2, a->curvature + i + 1, (size_t)(a->n - i - 1) * sizeof *own);
    a->own = own;
    a->x = own;
    a->curvature = own + n;
    a->n = n;
    return NULL;
}

const char *alignment_begin(struct alignment *a, double s)
{
    int64_t i = a->n - 1;
    const char *why;

    while (i >= 0 && s < a->x[i])
        i--;
    if (i < 0)
        return NULL;
    if ((why = split(a, i, s)))
        return why;
    a->heading[i + 1] = a->offset[i + 1] = 0;
    for (int64_t j = i + 2; j < a->n; j++)
        reach(a, j);
    for (int64_t j = i; j >= 0; j--) { /* back over d: h = h1 - k d,  o = o1 - h d - k d^2 / 2 */
        const double d = a->x[j + 1] - a->x[j], k = a->curvature[j];
        a->heading[j] = a->heading[j + 1] - k * d;
        a->offset[j] = a->offset[j + 1] - a->heading[j] * d - 0.5 * k * d * d;
    }
    return NULL;
}

void alignment_free(struct alignment *a)
{
    free(a->own);
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
    else if (a->n > 0) { /* straight before the first piece */
        p.heading = a->heading[0];
        p.offset = a->offset[0] + a->heading[0] * (s - a->x[0]);
    }
    if (a->cants > 0)
        roll(a, s, &p.cant, &p.twist);
    return p;
}
