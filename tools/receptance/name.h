/* What an engineer calls a mode of a vehicle. */
#ifndef VX_RECEPTANCE_NAME_H
#define VX_RECEPTANCE_NAME_H

#include "formats/veh.h"

/* shape [6 bodies]; name: the bodies that move most and how, as "carbody bounce" or "bogie pitch, antiphase". */
void name_mode(const struct veh *v, const double *shape, char name[32]);

#endif
