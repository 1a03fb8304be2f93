#include "formats/sections.h"

#include <stdlib.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "formats/reason.h"

static const char *section_read(struct points *p, const struct prof_text *t, const char *file)
{
    struct shape_choice c = {'r', t->unit == PROF_MM ? 1e-3 : 1, 0, SHAPE_ANY};
    struct shape s;
    const char *why = shape_read(&s, file, &c);

    if (why)
        return reason("%s: %s", file, why);
    int mirror_y = t->mirror_y == PROF_MIRROR_UNSTATED ? s.kind->y_to_centre : t->mirror_y == PROF_MIRROR_YES;
    int mirror_z = t->mirror_z == PROF_MIRROR_UNSTATED ? s.kind->z_up : t->mirror_z == PROF_MIRROR_YES;
    for (int64_t i = 0; i < s.points.n; i++) {
        s.points.y[i] = (mirror_y ? -s.points.y[i] : s.points.y[i]) + t->shift_y;
        s.points.z[i] = mirror_z ? -s.points.z[i] : s.points.z[i];
    }
    *p = s.points;
    return NULL;
}

const char *sections_read(struct sections *s, const struct prof_text *t, const struct sections_list *l, uint64_t *hash)
{
    *s = (struct sections){0};
    const char *why = sections_text_slices(l, &s->slices);
    int64_t n = s->slices.n;

    if (!why && !(s->points = calloc((size_t)n, sizeof *s->points)))
        why = REASON_MEMORY;
    for (int64_t i = 0; !why && i < n; i++) {
        struct points *p = &s->points[i];
        if (!(why = section_read(p, t, s->slices.file[i])))
            *hash = XXH64(p->z, (size_t)p->n * sizeof *p->z, XXH64(p->y, (size_t)p->n * sizeof *p->y, *hash));
    }
    if (why) {
        sections_free(s);
        return why;
    }
    *hash = XXH64(s->slices.station, (size_t)n * sizeof *s->slices.station, *hash);
    *hash = XXH64(s->slices.feature, (size_t)(n * s->slices.features) * sizeof *s->slices.feature, *hash);
    return NULL;
}

void sections_free(struct sections *s)
{
    for (int64_t i = 0; s->points && i < s->slices.n; i++)
        points_free(&s->points[i]);
    free(s->points);
    slices_free(&s->slices);
    *s = (struct sections){0};
}
