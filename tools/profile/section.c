#include "tools/profile/section.h"

#include <math.h>
#include <stddef.h>

#include "tools/profile/cant.h"
#include "tools/profile/dimensions.h"
#include "tools/profile/gauge.h"
#include "tools/profile/resample.h"

/* Height of a wheel at its running circle y = 0. */
static const char *running_circle(const struct outline *o, double *z)
{
    for (int64_t i = 1; i < o->n; i++)
        if (o->y[i - 1] <= 0 && o->y[i] > 0) {
            *z = o->z[i - 1] - o->y[i - 1] * (o->z[i] - o->z[i - 1]) / (o->y[i] - o->y[i - 1]);
            return NULL;
        }
    return "the wheel does not reach its running circle y = 0: see shift_y";
}

static double top(const struct outline *o)
{
    double least = o->z[0];
    for (int64_t i = 1; i < o->n; i++)
        least = fmin(least, o->z[i]);
    return least;
}

static const char *outline_place(struct section *s, const struct section_options *o)
{
    double z0;
    const char *why;

    if (o->wheel) {
        if ((why = clean_outline(&s->outline)) || (why = running_circle(&s->outline, &z0)))
            return why;
        outline_shift(&s->outline, 0, -z0);
        return NULL;
    }
    outline_shift(&s->outline, 0, -top(&s->outline));
    if ((why = gauge_face(&s->outline, o->gauge_depth, &s->gauge_face)))
        return why;
    s->cant = dimensions_cant(&s->outline, o->gauge_depth);
    return clean_outline(&s->outline);
}

const char *section_make(struct section *s, struct points *p, const struct section_options *o)
{
    struct curve curve = {0};
    const char *why;

    *s = (struct section){.points = p->n};
    if ((why = clean_points(p, &s->clean)))
        return why;
    if (!o->wheel)
        cant_rotate(p->n, p->y, p->z, o->cant);
    kinks_find(p, &s->kinks);
    if ((why = curve_fit(&curve, p, o->smoothing)))
        return why;
    s->residual = curve_compare(&curve, p);
    if (!(why = resample_curve(&curve, o->spacing, &s->outline)))
        why = outline_place(s, o);
    curve_free(&curve);
    if (why)
        section_free(s);
    return why;
}

void section_free(struct section *s)
{
    outline_free(&s->outline);
}
