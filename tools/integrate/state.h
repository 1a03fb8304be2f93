/* A passage at one instant, to a file and back, so that a run goes on from it bit for bit. */
#ifndef VX_INTEGRATE_STATE_H
#define VX_INTEGRATE_STATE_H

#include "formats/state.h"
#include "tools/integrate/passage.h"

/* The arrays of p that a step takes from the one before, into part [STATE_PARTS]; returns how many. */
int state_parts(struct passage *p, struct state_part *part);

/* Of p, after at least one step: all of s but contents of inputs and track.  *rest, which the caller frees, is the room s->rest points to. */
const char *state_take(struct state *s, const struct passage *p, double **rest);

/* p, new and not started, goes on from s; differs [n] are what state_compare found, for a track that must be the same within the state's
 * reach and may differ beyond: there it rests under its own weight as before.  Fails where the state does not fit. */
const char *state_resume(const struct state *s, struct passage *p, const struct state_difference *differs, int n);

#endif
