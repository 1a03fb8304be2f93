/* A zone lists sleepers by number: all of them in the track, and no railpad twice.  So does who names railpads that are missing, which may
 * stand in a zone all the same. */
#include "tools/track/pads.h"

#include <string.h>

#include "formats/reason.h"
#include "tools/track/along.h"

/* Railpad i of [2][sleepers] is in the zones one and two, counted from 1. */
static const char *twice(const struct trk *t, const struct trk_text *in, int64_t i, int64_t one, int64_t two)
{
    const struct trk_text_zone *z = in->zone.item;
    const char *rail = i < t->sleepers ? "left" : "right";
    const long long number = t->sleeper_number[i % t->sleepers];

    if (one == two)
        return reason("zone.%lld.sleepers: the %s railpad of sleeper %lld stands twice", (long long)two, rail, number);
    return reason("zone.%lld.sleepers: the %s railpad of sleeper %lld is in two zones, %s and %s", (long long)two, rail, number,
                  z[one - 1].name, z[two - 1].name);
}

/* Ranges of item `number` of a list. */
static const char *within(const struct trk *t, const char *list, int64_t number, const struct yaml_nums *sleepers)
{
    const int64_t from = t->sleeper_number[0], to = t->sleeper_number[t->sleepers - 1];

    for (int64_t r = 0; r < sleepers->n; r += 2)
        if (sleepers->x[r] < (double)from || sleepers->x[r + 1] > (double)to)
            return reason("%s.%lld.sleepers: [%g, %g] is not within the track, sleepers %lld to %lld", list, (long long)number, sleepers->x[r],
                          sleepers->x[r + 1], (long long)from, (long long)to);
    return NULL;
}

/* Whether railpad i of [2][sleepers] is in range r. */
static int in_range(const struct trk *t, int64_t i, const struct yaml_nums *sleepers, int64_t r, int rail)
{
    const double s = (double)t->sleeper_number[i % t->sleepers];

    return s >= sleepers->x[r] && s <= sleepers->x[r + 1] && (rail == TRK_TEXT_BOTH || rail == i / t->sleepers);
}

/* zone [2][sleepers]: of each railpad, from 1, this one added. */
static const char *mark_zone(const struct trk *t, const struct trk_text *in, int64_t number, int64_t *zone)
{
    const struct trk_text_zone *z = (const struct trk_text_zone *)in->zone.item + number - 1;
    const char *why = within(t, "zone", number, &z->sleepers);

    for (int64_t r = 0; r < z->sleepers.n && !why; r += 2)
        for (int64_t i = 0; i < TRK_RAILS * t->sleepers; i++)
            if (in_range(t, i, &z->sleepers, r, z->rail)) {
                if (zone[i])
                    return twice(t, in, i, zone[i], number);
                zone[i] = number;
            }
    return why;
}

/* A railpad that is missing has neither stiffness nor damping: k, c [2][sleepers]. */
static const char *leave_out(const struct trk *t, const struct trk_text *in, double *k, double *c)
{
    const struct trk_text_missing *m = in->railpad.missing.item;
    const char *why = NULL;

    if (in->model == TRK_TEXT_MOVING_MASS && in->railpad.missing.n)
        return "railpad.missing: a moving mass has both its railpads";
    for (int64_t j = 0; j < in->railpad.missing.n && !why; j++) {
        why = within(t, "railpad.missing", j + 1, &m[j].sleepers);
        for (int64_t i = 0; i < TRK_RAILS * t->sleepers && !why; i++)
            for (int64_t r = 0; r < m[j].sleepers.n; r += 2)
                if (in_range(t, i, &m[j].sleepers, r, m[j].rail))
                    k[i] = c[i] = 0;
    }
    return why;
}

/* Two springs at least hold what can go down and turn: railpads and ballast a sleeper, railpads a rail.  k [2][sleepers] of the railpads. */
static const char *check_held(const struct trk *t, const double *k)
{
    const int64_t n = t->sleepers;
    int64_t pads[TRK_RAILS] = {0};

    for (int64_t s = 0; s < n; s++) {
        int springs = 0;
        for (int b = 0; b < TRK_BALLAST; b++)
            springs += t->ballast_k[b * n + s] > 0;
        for (int rail = 0; rail < TRK_RAILS; rail++) {
            springs += k[rail * n + s] > 0;
            pads[rail] += k[rail * n + s] > 0;
        }
        if (springs < 2)
            return reason("sleeper %lld: %d of its railpads and ballast springs is there, two at least must hold it",
                          (long long)t->sleeper_number[s], springs);
    }
    for (int rail = 0; rail < TRK_RAILS && n > 1; rail++)
        if (pads[rail] < 2)
            return reason("railpad.missing: the %s rail has %lld railpads left, two at least must hold it", rail ? "right" : "left",
                          (long long)pads[rail]);
    return NULL;
}

const char *pads_lay(struct trk *t, const struct trk_text *in)
{
    const int64_t n = t->sleepers;
    double *k = trk_room(t, TRK_RAILS * n, sizeof *k), *c = trk_room(t, TRK_RAILS * n, sizeof *c);
    int64_t *zone = trk_room(t, TRK_RAILS * n, sizeof *zone);
    char (*name)[32] = trk_room(t, in->zone.n, sizeof *name);
    const struct trk_text_zone *z = in->zone.item;
    const char *why = NULL;

    if (!k || !c || !zone || !name)
        return REASON_MEMORY;
    for (int64_t i = 0; i < in->zone.n && !why; i++) {
        strncpy(name[i], z[i].name, sizeof name[i] - 1);
        why = mark_zone(t, in, i + 1, zone);
    }
    for (int64_t i = 0; i < TRK_RAILS * n; i++) {
        const struct trk_text_zone_pad own = zone[i] ? z[zone[i] - 1].railpad : (struct trk_text_zone_pad){0};
        k[i] = own.stiffness > 0 ? own.stiffness : along_at(&in->railpad.stiffness, in, t->sleeper_x[i % n]);
        c[i] = own.damping > 0 ? own.damping : along_at(&in->railpad.damping, in, t->sleeper_x[i % n]);
    }
    if (!why)
        why = leave_out(t, in, k, c);
    if (!why)
        why = check_held(t, k);
    t->pad_k = k;
    t->pad_c = c;
    t->pad_zone = zone;
    t->zones = in->zone.n;
    t->zone_name = (const char (*)[32])name;
    return why;
}
