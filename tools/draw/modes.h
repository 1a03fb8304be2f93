/* Figure of natural modes of a track: rails as lines, sleepers as dots, a panel each, downwards; the largest deflection of a node or a
 * sleeper is 1. */
#ifndef VX_DRAW_MODES_H
#define VX_DRAW_MODES_H

#include "formats/mod.h"
#include "formats/trk.h"
#include "tools/draw/chart.h"

void modes_begin(struct chart *c, const struct trk *t);    /* title and axes of c, begun */

/* Adds the first modes of m, at most so many; what they point to must live until the chart is drawn. */
const char *modes_add(struct chart *c, const struct mod *m, const struct trk *t, int most);

#endif
