#include "tools/profile/curve.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"

const char *curve_fit(struct curve *c, const struct points *p, double smoothing)
{
    double lambda = spline_lambda(smoothing), *s = calloc((size_t)p->n, sizeof *s);
    const char *why;

    *c = (struct curve){0};
    if (!s)
        return REASON_MEMORY;
    for (int64_t i = 1; i < p->n; i++)
        s[i] = s[i - 1] + hypot(p->y[i] - p->y[i - 1], p->z[i] - p->z[i - 1]);
    c->length = s[p->n - 1];
    if (!(why = spline_fit(&c->y, p->n, s, p->y, p->weight, lambda)))
        why = spline_fit(&c->z, p->n, s, p->z, p->weight, lambda);
    free(s);
    if (why)
        curve_free(c);
    return why;
}

void curve_free(struct curve *c)
{
    spline_free(&c->y);
    spline_free(&c->z);
    *c = (struct curve){0};
}

void curve_at(const struct curve *c, double s, double *y, double *z, double *slope, double *curvature)
{
    double Y[3], Z[3];

    spline_at(&c->y, s, Y);
    spline_at(&c->z, s, Z);
    *y = Y[0];
    *z = Z[0];
    *slope = Z[1] / Y[1];
    *curvature = (Y[1] * Z[2] - Z[1] * Y[2]) / pow(Y[1] * Y[1] + Z[1] * Z[1], 1.5);
}

void curve_point(const struct curve *c, double s, double p[2])
{
    double f[3];

    spline_at(&c->y, s, f);
    p[0] = f[0];
    spline_at(&c->z, s, f);
    p[1] = f[0];
}

struct curve_residual curve_compare(const struct curve *c, const struct points *p)
{
    struct curve_residual r = {0};
    double Y[3], Z[3], sum = 0;

    for (int64_t i = 0; i < p->n; i++) {
        spline_at(&c->y, c->y.s[i], Y);
        spline_at(&c->z, c->z.s[i], Z);
        double d = fabs((p->z[i] - Z[0]) * Y[1] - (p->y[i] - Y[0]) * Z[1]) / hypot(Y[1], Z[1]);
        sum += d * d;
        if (d > r.worst) {
            r.worst = d;
            r.worst_y = p->y[i];
        }
    }
    r.rms = sqrt(sum / (double)p->n);
    return r;
}
