#include "tools/profile/measured_input.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/profile/gauge.h"
#include "tools/profile/resample.h"

static const char *sections_add(const struct prof_text *t, struct sections *list, struct measured *m)
{
    const struct slices *l = &list->slices;
    const char *why = NULL;

    m->features = l->features;
    for (int64_t i = 0; !why && i < l->n; i++)
        if ((why = measured_add(m, l->station[i], &list->points[i], l->feature ? l->feature + i * l->features : NULL, t->smoothing)))
            why = reason("%s: %s", l->file[i], why);
    return why;
}

/* z of the reference's top, y of its gauge face. */
static const char *reference_read(const struct prof_text *t, const struct measured *m, double *top, double *face)
{
    int64_t i = t->sections.reference - 1;
    struct outline o;
    const char *why;

    if (i >= m->n)
        return reason("sections.reference: section %lld of %lld", (long long)i + 1, (long long)m->n);
    if ((why = resample_curve(&m->section[i].curve, t->spacing, &o)))
        return why;
    *top = INFINITY;
    for (int64_t j = 0; j < o.n; j++)
        *top = fmin(*top, o.z[j]);
    if (t->sections.position > 0)
        *face = t->gauge / 2 - t->sections.position;
    else if ((why = gauge_face(&o, t->gauge_depth, face)))
        why = reason("section %lld: %s: state sections.position, or another reference", (long long)i + 1, why);
    outline_free(&o);
    return why;
}

static const char *lists_join(const struct prof_text *t, struct sections *list, struct measured *m, struct section *s, double *top)
{
    const struct sections_extra *extra = t->sections.extra.item;
    const struct sections_name *name = t->sections.names.item;
    const char *why = sections_add(t, list, m);

    if (why || (why = reference_read(t, m, top, &s->gauge_face)) || (why = measured_join(m, *top + t->sections.cut_depth, "rail")))
        return why;
    s->points = m->points;
    s->clean = m->clean;
    s->residual = m->residual;
    for (int64_t b = 0; b < m->bodies && b < t->sections.names.n; b++)
        snprintf(m->body[b].name, sizeof m->body[b].name, "%s", name[b].name);
    for (int64_t i = 0; !why && i < t->sections.extra.n; i++)
        if ((why = sections_add(t, &list[i + 1], &m[i + 1])) ||
            (why = measured_join(&m[i + 1], *top + t->sections.cut_depth, extra[i].name)))
            why = reason("%s: %s", extra[i].name, why);
    return why;
}

const char *measured_input(const struct prof_text *t, struct sections *list, struct section *s, struct set *set)
{
    struct measured_options o = {t->smoothing, t->spacing, t->sections.every, 0, t->sections.at};
    int64_t lists = t->sections.extra.n + 1;
    struct measured *m = calloc((size_t)lists, sizeof *m);
    const char *why;

    *s = (struct section){.cant = NAN};
    *set = (struct set){0};
    if (!m)
        return REASON_MEMORY;
    if (!(why = lists_join(t, list, m, s, &o.top)))
        why = measured_set(m, lists, &o, set);
    for (int64_t i = 0; i < lists; i++)
        measured_free(&m[i]);
    free(m);
    return why;
}
