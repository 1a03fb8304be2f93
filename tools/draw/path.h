/* Figure of a wheel's path along the rails of a turnout: from the text of vxcontact --path. */
#ifndef VX_DRAW_PATH_H
#define VX_DRAW_PATH_H

#include "formats/columns.h"
#include "tools/draw/chart.h"

/* Adds the k-th path to c, begun: height, place on the rail and place ahead over the station, a panel each.  Its name in the legend is
 * followed by the largest angle by which it turns upwards where the wheel goes from one rail body to the next; a disc marks the place. */
const char *path_add(struct chart *c, const struct columns *t, int k, const char *name);

#endif
