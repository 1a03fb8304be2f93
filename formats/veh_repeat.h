/* The bogies of a vehicle input written out. */
#ifndef VX_FORMATS_VEH_REPEAT_H
#define VX_FORMATS_VEH_REPEAT_H

#include "formats/veh_text.h"

/* Copies the parts of every bogie to the vehicle, once for each of its places: x from the place, the place's number (over all bogies, from 1)
 * after the names, and after a name in `from`, `to` or `spring` that is one of the bogie's own.  */
const char *veh_repeat(struct veh_text *in);

#endif
