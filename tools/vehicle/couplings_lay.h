/* From the couplings of a vehicle input to those of a vehicle: numbered, mirrored, with the numbers of their bodies. */
#ifndef VX_VEHICLE_COUPLINGS_LAY_H
#define VX_VEHICLE_COUPLINGS_LAY_H

#include "formats/veh.h"
#include "formats/veh_text.h"

/* The arrays of a vehicle while they are written. */
struct vehicle_parts {
    char (*body_name)[32], (*coupling_name)[32];
    double *mass, *inertia, *cg, *point, *end, *stiffness, *damping, *preload, *series, *rest, *coefficient, *load, *share, *lever;
    double *knot_at, *knot_force, *radius, *wheel_load, *K, *C, *M;
    double *given;      /* N [couplings] preload that the input fixes, else 0 */
    int64_t *type, *ends, *bearing, *axis, *spring, *knot_first, *wheelset;
};

/* Takes room for all arrays of couplings and knots and fills them from the input, preloads aside.  The bodies are in place. */
const char *couplings_lay(struct veh *v, struct vehicle_parts *p, const struct veh_text_parts *in);

#endif
