/* The rules between the keys of a vehicle input: between the parts of veh_text. */
#ifndef VX_FORMATS_VEH_TEXT_CHECK_H
#define VX_FORMATS_VEH_TEXT_CHECK_H

#include "formats/veh_text.h"

/* *line of the item that breaks a rule, 0 where it has none. */
const char *veh_text_check(const struct veh_text *in, int *line);

#endif
