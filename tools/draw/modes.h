/* Figure of the natural modes of a track: deflection of both rails and of the sleepers along it, a panel for each mode. */
#ifndef VX_DRAW_MODES_H
#define VX_DRAW_MODES_H

#include "formats/mod.h"
#include "formats/trk.h"
#include "tools/draw/chart.h"

/* The first modes of m, as many as there are panels; each is scaled to a largest deflection of 1. */
const char *modes_chart(struct chart *c, const struct mod *m, const struct trk *t);

#endif
