/* Where the parts of a chart go on the paper: limits, scales and boxes, before anything is drawn.
 *
 * From the top: title, words of the vertical lines, then for each panel its legend and its box; numbers and label of x below
 * the last box, those of y to the left.  The legend stands outside the boxes, so it covers no data. */
#ifndef VX_DRAW_LAYOUT_H
#define VX_DRAW_LAYOUT_H

#include "tools/draw/chart.h"
#include "tools/draw/scale.h"
#include "tools/draw/text.h"

/* Sizes of type, pt. */
#define LAYOUT_TITLE 10.5
#define LAYOUT_LABEL 9.5
#define LAYOUT_NUMBER 8.5
#define LAYOUT_LEGEND 9.0
#define LAYOUT_NOTE 8.5

enum { LAYOUT_ENTRIES = 24 };

struct box { double x, y, w, h; };         /* px, from the upper left corner */

struct layout_entry {
    const struct chart_series *series;
    double x, y;                           /* px, left end of its sample of line, middle of the row */
};

struct layout {
    double point;                          /* px per pt */
    struct box sheet;                      /* of this chart: the picture, or its part of it */
    double title, words;                   /* px, base lines of the title and of the words of vertical lines */
    struct scale x, y[CHART_PANELS];       /* as shown: SI times factor */
    struct box box[CHART_PANELS];
    int entries;
    struct layout_entry entry[LAYOUT_ENTRIES];
};

extern const double layout_sample;         /* pt, length of a sample of line in the legend */

void layout_make(struct layout *l, const struct chart *c, const struct text *t, int width, int height);

/* Pixel of a point given in SI; NaN where there is none. */
void layout_place(const struct layout *l, const struct chart *c, int panel, double x, double y, double px[2]);

#endif
