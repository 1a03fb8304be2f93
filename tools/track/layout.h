/* From the track input to nodes, sleepers, springs and the numbering of the degrees of freedom. */
#ifndef VX_TRACK_LAYOUT_H
#define VX_TRACK_LAYOUT_H

#include "formats/trk.h"
#include "formats/trk_text.h"

/* Fills all of *t but its matrices (tools/track/assemble.h); trk_free it, after a failure too. */
const char *layout_track(struct trk *t, const struct trk_text *in);

#endif
