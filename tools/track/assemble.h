/* K, C and M of a track on one full symmetric pattern. */
#ifndef VX_TRACK_ASSEMBLE_H
#define VX_TRACK_ASSEMBLE_H

#include "formats/trk.h"

/* Fills Ap, Ai, Kx, Cx and Mx from the rest of *t. */
const char *assemble_track(struct trk *t);

/* x [entries] of K or C: adds a ballast spring or damper of k (N/m, N s/m), by its number in [3][sleepers]. */
void assemble_ballast(const struct trk *t, double *x, int64_t spring, double k);

#endif
