#include "tools/profile/set.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

const char *set_section(struct set *t, double station)
{
    double *larger = realloc(t->station, (size_t)(t->sections + 1) * sizeof *larger);
    if (!larger)
        return REASON_MEMORY;
    t->station = larger;
    t->station[t->sections++] = station;
    return NULL;
}

const char *set_body(struct set *t, int64_t body, struct outline *o)
{
    struct set_poly *larger = realloc(t->poly, (size_t)(t->polys + 1) * sizeof *larger);
    if (!larger) {
        outline_free(o);
        return REASON_MEMORY;
    }
    t->poly = larger;
    t->poly[t->polys++] = (struct set_poly){t->sections - 1, body, *o};
    *o = (struct outline){0};
    return NULL;
}

void set_free(struct set *t)
{
    for (int64_t i = 0; i < t->polys; i++)
        outline_free(&t->poly[i].outline);
    free(t->station);
    free(t->poly);
    free(t->names);
    *t = (struct set){0};
}

/* One block of memory, the numbers first. */
struct store { double *station, *y, *z, *slope, *curvature, *fall; int64_t *section, *body, *first; char (*name)[PROF_NAME]; };

static void *store_new(const struct set *t, int64_t points, struct store *s)
{
    int64_t numbers = t->sections + 5 * points, indices = 3 * t->polys + 1;
    double *block = calloc(1, (size_t)(numbers + indices) * 8 + (size_t)t->bodies * PROF_NAME);
    if (!block)
        return NULL;
    s->station = block;
    s->y = s->station + t->sections;
    s->z = s->y + points;
    s->slope = s->z + points;
    s->curvature = s->slope + points;
    s->fall = s->curvature + points;
    s->section = (int64_t *)(s->fall + points);
    s->body = s->section + t->polys;
    s->first = s->body + t->polys;
    s->name = (char (*)[PROF_NAME])(s->first + t->polys + 1);
    return block;
}

static void poly_store(const struct set_poly *poly, char side, struct store *s, int64_t at)
{
    const struct outline *o = &poly->outline;
    size_t bytes = (size_t)o->n * sizeof *o->y;

    memcpy(s->y + at, o->y, bytes);
    memcpy(s->z + at, o->z, bytes);
    memcpy(s->slope + at, o->slope, bytes);
    memcpy(s->curvature + at, o->curvature, bytes);
    memcpy(s->fall + at, o->fall, bytes);
    if (side == 'l')
        outline_mirror(&(struct outline){o->n, s->y + at, s->z + at, s->slope + at, s->curvature + at, s->fall + at});
}

const char *set_prof(const struct set *t, char side, struct prof *p)
{
    struct store s;
    int64_t points = 0;

    for (int64_t i = 0; i < t->polys; i++)
        points += t->poly[i].outline.n;
    if (!(p->store = store_new(t, points, &s)))
        return REASON_MEMORY;
    memcpy(s.station, t->station, (size_t)t->sections * sizeof *s.station);
    for (int64_t i = 0; i < t->bodies; i++)
        strncpy(s.name[i], t->names ? t->names[i] : t->body[i], PROF_NAME - 1);
    for (int64_t i = 0; i < t->polys; i++) {
        s.section[i] = t->poly[i].section;
        s.body[i] = t->poly[i].body;
        poly_store(&t->poly[i], side, &s, s.first[i]);
        s.first[i + 1] = s.first[i] + t->poly[i].outline.n;
    }
    p->side = side;
    p->position = side == 'l' ? -p->position : p->position;
    p->sections = t->sections;
    p->bodies = t->bodies;
    p->polys = t->polys;
    p->points = points;
    p->station = s.station;
    p->body = (const char (*)[PROF_NAME])s.name;
    p->poly_section = s.section;
    p->poly_body = s.body;
    p->poly_first = s.first;
    p->y = s.y;
    p->z = s.z;
    p->slope = s.slope;
    p->curvature = s.curvature;
    p->fall = s.fall;
    return NULL;
}
