/* From a vehicle input to the vehicle at rest. */
#ifndef VX_VEHICLE_VEHICLE_H
#define VX_VEHICLE_VEHICLE_H

#include "formats/veh.h"
#include "formats/veh_text.h"

/* Bodies of the input, then its wheelsets; couplings, each right one followed by its mirrored twin, then stops.  With preloads, static
 * wheel loads and the matrices about rest.  veh_free on *v also after a failure. */
const char *vehicle_build(struct veh *v, const struct veh_text *in);

#endif
