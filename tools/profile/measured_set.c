/* Measured sections as a set: at every station of every list, and between these as far as the bodies change. */
#include "tools/profile/measured.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

#define MOTION 5e-4          /* m, of a body from one section to the next where `every` does not say */
#define ROUNDING 1e-9        /* of a number of parts */
#define SAME 1e-6            /* m, moved less it is the same */
#define SMOOTHING_AGAIN 0.5  /* of the sections' own wavelength, between them */

struct stations { int64_t n; double *x; };

static const char *station_put(struct stations *s, double x)
{
    double *larger = realloc(s->x, (size_t)(s->n + 1) * sizeof *larger);
    if (!larger)
        return REASON_MEMORY;
    s->x = larger;
    s->x[s->n++] = x;
    return NULL;
}

/* Sections of a body, and the stations between them. */
static const char *body_stations(const struct loft *l, double every, struct stations *s)
{
    const char *why = NULL;

    for (int64_t i = 0; !why && i < l->n; i++) {
        why = station_put(s, l->section[i].station);
        if (i == l->n - 1 || why)
            break;
        double from = l->section[i].station, length = l->section[i + 1].station - from, motion = loft_motion(l, i);
        int64_t parts = motion < SAME ? 1 : (int64_t)ceil((every > 0 ? length / every : motion / MOTION) - ROUNDING);
        for (int64_t j = 1; !why && j < parts; j++)
            why = station_put(s, from + length * (double)j / (double)parts);
    }
    return why;
}

static int station_compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static const char *stations_gather(const struct measured *list, int64_t lists, double every, struct stations *s)
{
    const char *why = NULL;

    for (int64_t i = 0; i < lists && !why; i++)
        for (int64_t b = 0; b < list[i].bodies && !why; b++)
            why = body_stations(&list[i].body[b], every, s);
    if (why)
        return why;
    qsort(s->x, (size_t)s->n, sizeof *s->x, station_compare);
    int64_t n = 0;
    for (int64_t i = 0; i < s->n; i++)
        if (n == 0 || s->x[i] > s->x[n - 1])
            s->x[n++] = s->x[i];
    s->n = n;
    return NULL;
}

static const char *names_gather(const struct measured *list, int64_t lists, struct set *set)
{
    int64_t n = 0;

    *set = (struct set){0};
    for (int64_t i = 0; i < lists; i++)
        set->bodies += list[i].bodies;
    if (!(set->names = calloc((size_t)set->bodies, sizeof *set->names)))
        return REASON_MEMORY;
    for (int64_t i = 0; i < lists; i++)
        for (int64_t b = 0; b < list[i].bodies; b++)
            memcpy(set->names[n++], list[i].body[b].name, sizeof *set->names);
    return NULL;
}

static const char *section_set(const struct measured *list, int64_t lists, const struct measured_options *o, double station,
                               struct set *set)
{
    const char *why = NULL;
    int64_t body = 0;

    for (int64_t i = 0; i < lists; i++)
        for (int64_t b = 0; b < list[i].bodies; b++, body++) {
            struct outline outline;
            if ((why = loft_outline(&list[i].body[b], station, o->spacing, SMOOTHING_AGAIN * o->smoothing, &outline)))
                return why;
            if (outline.n == 0)
                continue;
            outline_shift(&outline, 0, -o->top);
            if ((why = clean_outline(&outline))) {
                outline_free(&outline);
                return reason("station %g m: %s", station, why);
            }
            if ((why = set_body(set, body, &outline)))
                return why;
        }
    return NULL;
}

const char *measured_set(const struct measured *list, int64_t lists, const struct measured_options *o, struct set *set)
{
    struct stations s = {0};
    const char *why = names_gather(list, lists, set);

    if (!why)
        why = stations_gather(list, lists, o->every, &s);
    for (int64_t i = 0; !why && i < s.n; i++)
        if (!(why = set_section(set, s.x[i] + o->at)))
            why = section_set(list, lists, o, s.x[i], set);
    free(s.x);
    return why;
}
