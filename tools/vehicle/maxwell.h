/* A damper in series with a spring: the Maxwell element. */
#ifndef VX_VEHICLE_MAXWELL_H
#define VX_VEHICLE_MAXWELL_H

#include <stdint.h>

/* Force N after a step h s in which the whole lengthens by de m at a constant rate, F N before it.  The damper's force G[n] N over
 * rate v[n] m/s rises from 0, 0, odd; the spring has k N/m. */
double maxwell_step(double F, double de, double h, double k, int64_t n, const double *v, const double *G);

#endif
