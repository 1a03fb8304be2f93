#include "tools/post/zones.h"

#include <stdio.h>
#include <string.h>

static void keep(struct zone_extreme *e, double value, int64_t sleeper)
{
    if (value > e->value)
        *e = (struct zone_extreme){value, sleeper};
}

static void add_seat(const struct run *r, int64_t rail, int64_t i, struct zone *z)
{
    int64_t k = rail * r->sleepers + i, number = r->sleeper_number[i];

    z->sleepers++;
    keep(&z->Q, r->extreme[RUN_SLEEPER_MAX_Q][k], number);
    keep(&z->Y, r->extreme[RUN_SLEEPER_MAX_Y][k], number);
    keep(&z->pad, r->extreme[RUN_MAX_PAD][k], number);
    keep(&z->compression, r->extreme[RUN_MAX_PAD_COMPRESSION][k], number);
    for (int s = 0; s < 3; s++)
        keep(&z->ballast, r->extreme[RUN_MAX_BALLAST][s * r->sleepers + i], number);
}

const char *zones_find(const struct run *r, struct zone *zone)
{
    if (!r->complete)
        return "the run is not complete, so its extremes are missing";
    memset(zone, 0, (size_t)(r->zones + 1) * sizeof *zone);
    snprintf(zone[0].name, sizeof zone[0].name, "no zone");
    for (int64_t i = 0; i < r->zones; i++)
        snprintf(zone[i + 1].name, sizeof zone[i + 1].name, "%s", r->zone_name[i]);
    for (int64_t rail = 0; rail < 2; rail++)
        for (int64_t i = 0; i < r->sleepers; i++)
            add_seat(r, rail, i, &zone[r->pad_zone[rail * r->sleepers + i]]);
    return NULL;
}
