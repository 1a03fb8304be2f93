/* Figure of the contact that touches, by several methods of yaw: from the text of vxcontact --sweep. */
#ifndef VX_DRAW_YAW_H
#define VX_DRAW_YAW_H

#include "formats/columns.h"
#include "tools/draw/chart.h"

/* Adds the k-th of n sweeps to c, begun: place on wheel and rail, angle and rolling radius over displacement, a panel each.  Of one sweep
 * the methods differ by colour; of several the sweeps do, called `name`, and the methods by their dashes. */
const char *yaw_add(struct chart *c, const struct columns *t, int k, int n, const char *name);

#endif
