/* Words at points of a chart, each where it covers least: beside its point, clear of lines, of other words and of the frame. */
#ifndef VX_DRAW_NOTES_H
#define VX_DRAW_NOTES_H

#include "tools/draw/layout.h"

void notes_draw(const struct layout *l, const struct chart *c, struct text *t);

#endif
