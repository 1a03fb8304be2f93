/* Tracks for tests, from a track input with overrides; run from the project root. */
#ifndef VX_TABLE1_H
#define VX_TABLE1_H

#include "formats/trk_text.h"
#include "tools/track/assemble.h"
#include "tools/track/layout.h"

/* set: [sets] "key=value" */
static inline const char *track_from(struct trk *t, const char *path, const char *const *set, int sets)
{
    struct trk_text in;

    *t = (struct trk){0};
    const char *why = trk_text_read(&in, path, (char *const *)set, sets, NULL);
    if (why)
        return why;
    why = layout_track(t, &in);
    trk_text_free(&in);
    return why ? why : assemble_track(t);
}

/* The straight track of Table 1. */
static inline const char *table1(struct trk *t, const char *const *set, int sets)
{
    return track_from(t, "data/tracks/thesis-straight.yaml", set, sets);
}

#endif
