/* Figure of a .prof: its cross-sections at one scale, down columns in the order of the track, a colour for each body, each
 * rail named where it begins. */
#ifndef VX_DRAW_SECTIONS_H
#define VX_DRAW_SECTIONS_H

#include "formats/prof.h"
#include "tools/draw/chart.h"

enum { SECTIONS_MOST = 30 };      /* in one picture */

/* The sections with stations in from..to, evenly thinned to SECTIONS_MOST; shape is width over height of the picture. */
const char *sections_chart(struct chart *c, const struct prof *p, double from, double to, double shape);

/* Filled body and outline of polyline k of p, moved by (y, z), in the colour of its body; label as in chart_add_series. */
void sections_polyline(struct chart *c, struct chart_panel *panel, const struct prof *p, int64_t k, double y, double z,
                       const char *label);

#endif
