/* K, C and M of a track on one full symmetric pattern. */
#ifndef VX_TRACK_ASSEMBLE_H
#define VX_TRACK_ASSEMBLE_H

#include "formats/trk.h"

/* Fills Ap, Ai, Kx, Cx and Mx from the rest of *t. */
const char *assemble_track(struct trk *t);

#endif
