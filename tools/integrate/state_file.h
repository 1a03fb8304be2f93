/* The .state of a passage: what it is made of beside the instant of state.h; put out, and gone on from. */
#ifndef VX_INTEGRATE_STATE_FILE_H
#define VX_INTEGRATE_STATE_FILE_H

#include "tools/integrate/state.h"

/* What the passage is made of: hashes of contents, and the track's file. */
struct state_file_origin {
    uint64_t vehicle, contact[2], text;
    const struct vxf *track;
};

/* Into o, begun and with its history; `failed` is NULL, or why the run ends there.  The caller frees *rest when o is written. */
const char *state_file_put(struct passage *p, const struct state_file_origin *from, const char *failed, struct vxf_out *o, double **rest);

/* Whether all that would go into it is finite. */
int state_file_is_finite(struct passage *p);

/* p goes on from the state in the file, read into s; differs[STATE_DIFFERENCES] says in *n places how its track differs beyond the state's
 * reach.  Refuses what must not differ. */
const char *state_file_resume(struct passage *p, const struct state_file_origin *from, const struct vxf *file, struct state *s,
                              struct state_difference *differs, int *n);

#endif
