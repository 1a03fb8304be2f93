/* Static stiffness of a track as a wheel meets it, and the bowl that axles press into it.
 *
 * x forward, z down; loads and deflections are positive down, beside own weight.  Ballast may only push: tools/track/equilibrium.h. */
#ifndef VX_RECEPTANCE_STIFFNESS_H
#define VX_RECEPTANCE_STIFFNESS_H

#include "formats/trk.h"

enum { STIFFNESS_LEFT, STIFFNESS_RIGHT, STIFFNESS_LEFT_OF_BOTH, STIFFNESS_RIGHT_OF_BOTH, STIFFNESS_N };

/* *x [*n] stations along the whole track, every so many m from its beginning; the caller frees it. */
const char *stiffness_stations(const struct trk *t, double every, int64_t *n, double **x);

/* k [n][STIFFNESS_N], N/m, at stations x [n] (m): load over the deflection under it, of each rail loaded alone and of each where both are
 * loaded alike.  Of load N, which matters where ballast only pushes; 0: of a small load, beside own weight. */
const char *stiffness_along(const struct trk *t, double load, int64_t n, const double *x, double *k);

/* w [n][2], m: deflection of the left and the right rail at stations x [n] (m) under a load (N) at each of axle [axles] (m), on the rails
 * that excite names. */
const char *stiffness_bowl(const struct trk *t, int excite, double load, int axles, const double *axle, int64_t n, const double *x,
                           double *w);

#endif
