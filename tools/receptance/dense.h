/* Natural modes of a vehicle on wheelsets that are held. */
#ifndef VX_RECEPTANCE_DENSE_H
#define VX_RECEPTANCE_DENSE_H

#include "formats/mod.h"
#include "formats/veh.h"

/* The n modes whose squared frequencies are nearest to that of `near` (Hz; 0 gives the lowest), with increasing frequency, unit
 * modal mass and names; shapes count all bodies, zero at the wheelsets.  mod_free them. */
const char *dense_vehicle(struct mod *m, const struct veh *v, int64_t n, double near);

#endif
