/* Receptance of a track over frequency: deflection of the rail over the force on it, exp(+i omega t), z down. */
#ifndef VX_RECEPTANCE_SWEEP_H
#define VX_RECEPTANCE_SWEEP_H

#include "formats/frf.h"
#include "formats/trk.h"
#include "tools/track/point.h"

struct sweep { double from, to, step; };   /* Hz, both ends included */

/* Fills *r, which frf_free empties.  at is AT_SLEEPER or AT_MIDSPAN, told in the file alone: p says where. */
const char *sweep_point(struct frf *r, const struct trk *t, const struct point *p, int at, int excite, const struct sweep *s);

#endif
