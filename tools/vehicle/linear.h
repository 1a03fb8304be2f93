/* Mass, damping and stiffness of a vehicle about rest, wheelsets free. */
#ifndef VX_VEHICLE_LINEAR_H
#define VX_VEHICLE_LINEAR_H

#include "formats/veh.h"

/* M, C, K [6 bodies][6 bodies], SI; v->preload is read, its own matrices are not. */
void linear_matrices(const struct veh *v, double *M, double *C, double *K);

#endif
