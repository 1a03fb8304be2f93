/* Damping of the modes of a track, from its complex eigenvalues. */
#ifndef VX_RECEPTANCE_DAMPING_H
#define VX_RECEPTANCE_DAMPING_H

#include "formats/trk.h"

/* ratio [n]: -Re s / |s| of the eigenvalue s that continues each undamped mode; frequency [n] (Hz) and shape [n][dofs] are those
 * modes with unit modal mass. */
const char *damping_track(const struct trk *t, int64_t n, const double *frequency, const double *shape, double *ratio);

#endif
