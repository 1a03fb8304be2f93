/* Measured sections as the profile input wants them: one reference gives top and gauge face, and every list its bodies. */
#ifndef VX_PROFILE_MEASURED_INPUT_H
#define VX_PROFILE_MEASURED_INPUT_H

#include "formats/sections.h"
#include "tools/profile/measured.h"
#include "tools/profile/section.h"

/* list[1 + t->sections.extra.n]: the sections of t's own list, then those of each extra; their points are put in order.  *s tells what
 * the first list had in common, and the gauge face of its reference. */
const char *measured_input(const struct prof_text *t, struct sections *list, struct section *s, struct set *set);

#endif
