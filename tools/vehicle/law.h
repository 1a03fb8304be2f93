/* The law of one coupling: force on its second body from elongation and rate. */
#ifndef VX_VEHICLE_LAW_H
#define VX_VEHICLE_LAW_H

#include "formats/veh.h"
#include "tools/vehicle/couplings_memory.h"

/* F[3] N along axes, from e[3] m and ed[3] m/s in them.  m may be NULL: a move from rest at once. */
void law_along(const struct veh *v, int64_t c, const struct couplings_memory *m, const double e[3], const double ed[3], double F[3]);

/* T[3] N m about axes, from turn[3] rad and rate[3] rad/s. */
void law_about(const struct veh *v, int64_t c, const struct couplings_memory *m, const double turn[3], const double rate[3], double T[3]);

/* N along the line of a rod or damper, from e m and rate m/s. */
double law_line(const struct veh *v, int64_t c, const struct couplings_memory *m, double e, double rate);

#endif
