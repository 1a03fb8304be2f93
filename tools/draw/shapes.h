/* Figure of the modes of a vehicle, wheelsets held: each drawn in the view in which it moves most, over the vehicle at rest. */
#ifndef VX_DRAW_SHAPES_H
#define VX_DRAW_SHAPES_H

#include "formats/mod.h"
#include "tools/draw/views.h"

enum { SHAPES_MOST = 12 };

/* The view in whose plane the mode has most kinetic energy; of equals the first. */
enum view shapes_view(const struct veh *v, const double *shape);

/* The first modes of m, SHAPES_MOST at most. */
const char *shapes_chart(struct chart *c, const struct mod *m, const struct veh *v);

#endif
