/* Receptance of a track over frequency: motion over force, exp(+i omega t), z down. */
#ifndef VX_RECEPTANCE_SWEEP_H
#define VX_RECEPTANCE_SWEEP_H

#include "formats/frf.h"
#include "formats/trk.h"
#include "tools/receptance/place.h"

struct sweep { double from, to, step; };   /* Hz, both ends included */

/* Fills *r, which frf_free empties: the motion at one place, the left rail's where it is both, over a unit force at another, on each rail
 * where it is both.  quantity is FRF_RECEPTANCE and so on. */
const char *sweep_places(struct frf *r, const struct trk *t, const struct place *force, const struct place *motion, int quantity,
                         const struct sweep *s);

#endif
