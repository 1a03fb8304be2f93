/* What every user of a vehicle relies on in its couplings: between the parts of veh. */
#ifndef VX_FORMATS_VEH_CHECK_H
#define VX_FORMATS_VEH_CHECK_H

#include "formats/veh.h"

const char *veh_check_coupling(const struct veh *v, int64_t c);

#endif
