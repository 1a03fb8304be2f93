/* Couplings on a drawing: a zigzag along each axis with a spring, a piston along each with a damper, two bars with the stop's clearance between
 * them, two faces along each with friction, a line for a rod or a damper along one, a ring for what acts about axes; a dot where they are. */
#ifndef VX_DRAW_SYMBOLS_H
#define VX_DRAW_SYMBOLS_H

#include "tools/draw/views.h"

/* Entries of the legend for what v has, on a panel of the drawing. */
void symbols_legend(struct chart *c, struct chart_panel *p, const struct veh *v);

/* Coupling k in this view, as large as size m. */
void symbols_add(struct chart *c, struct chart_panel *p, enum view view, const struct veh *v, int64_t k, double size);

#endif
