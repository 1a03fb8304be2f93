/* Natural modes of a track: K x = omega^2 M x. */
#ifndef VX_RECEPTANCE_MODES_H
#define VX_RECEPTANCE_MODES_H

#include "formats/mod.h"
#include "formats/trk.h"

/* The n modes whose squared frequencies are nearest to that of `near` (Hz; 0 gives the lowest), with increasing frequency and
 * unit modal mass.  n is at most half the degrees of freedom.  mod_free them. */
const char *modes_track(struct mod *m, const struct trk *t, int64_t n, double near);

#endif
