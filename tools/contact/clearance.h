/* How far a wheel moves towards its rail before the flange touches. */
#ifndef VX_CONTACT_CLEARANCE_H
#define VX_CONTACT_CLEARANCE_H

#include "formats/prof.h"

/* On the rail's first section without yaw: the least displacement (m), in steps of u_step up to u_max, at which the contact that touches
 * stands at 45 degrees or more. */
const char *clearance_find(const struct prof *wheel, const struct prof *rail, double u_max, double u_step, double *clearance);

#endif
