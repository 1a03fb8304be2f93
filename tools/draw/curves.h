/* The data of a chart: filled outlines first, then lines and marks, each cut at the box of its panel. */
#ifndef VX_DRAW_CURVES_H
#define VX_DRAW_CURVES_H

#include "tools/draw/layout.h"

/* Where the pieces of a series lie that can be drawn: pixels in xy [n][2] at most, points closer than a fraction of a pixel
 * to the last left out.  Starts at point *from, sets it to where the next piece starts; returns the points of this
 * piece, 0 at the end. */
int curves_piece(const struct layout *l, const struct chart *c, int panel, const struct chart_series *s, int64_t *from,
                 double *xy);

const char *curves_draw(const struct layout *l, const struct chart *c, struct canvas *canvas);

#endif
