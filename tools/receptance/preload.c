/* The equilibrium's own tangent is of K alone: K and C are assembled with the ballast that touches in it. */
#include "tools/receptance/preload.h"

#include <stdlib.h>

#include "formats/reason.h"
#include "tools/track/assemble.h"
#include "tools/track/equilibrium.h"

const char *preload_track(struct trk *out, const struct trk *t, const struct place *p, double load)
{
    struct equilibrium e;
    struct place down;
    double *f = calloc((size_t)t->dofs, sizeof *f), *u = calloc((size_t)t->dofs, sizeof *u);

    *out = *t;
    out->store = NULL;
    int64_t *state = trk_room(out, TRK_BALLAST * t->sleepers, sizeof *state);
    const char *why = f && u && state ? equilibrium_new(&e, t, EQUILIBRIUM_GRAVITY) : REASON_MEMORY;
    if (!why) {
        place_find(&down, t, p->on, p->at, p->x);
        place_load(&down, load, f);
        why = equilibrium_add(&e, f, u);
        equilibrium_states(&e, state);
        out->ballast_state = state;
        equilibrium_free(&e);
    }
    free(f);
    free(u);
    return why ? why : assemble_track(out);
}
