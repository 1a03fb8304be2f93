/* What surrounds the data: title, frames, grid, numbers, labels, vertical lines, legend. */
#ifndef VX_DRAW_AXES_H
#define VX_DRAW_AXES_H

#include "tools/draw/layout.h"

void axes_draw(const struct layout *l, const struct chart *c, struct canvas *canvas, struct text *t);
void axes_legend(const struct layout *l, struct canvas *canvas, struct text *t);

#endif
