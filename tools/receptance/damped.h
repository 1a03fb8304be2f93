/* Damped modes of a track: (K + s C + s^2 M) x = 0, s = -ratio omega + i omega sqrt(1 - ratio^2). */
#ifndef VX_RECEPTANCE_DAMPED_H
#define VX_RECEPTANCE_DAMPED_H

#include "formats/mod.h"
#include "formats/trk.h"

/* The n modes whose eigenvalues s are nearest to 2 pi i near (Hz), of each pair the one with Im s >= 0, with increasing frequency |s|/2pi;
 * shapes are complex, scaled to x'(2 s M + C)x = 2i Im s, which is unit modal mass where damping mixes no modes.  n is at most a third of
 * the degrees of freedom.  mod_free them. */
const char *damped_track(struct mod *m, const struct trk *t, int64_t n, double near);

#endif
