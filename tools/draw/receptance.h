/* Figure of receptances: magnitude, both axes logarithmic, with its peaks named, phase below, and coherence where there is
 * one. */
#ifndef VX_DRAW_RECEPTANCE_H
#define VX_DRAW_RECEPTANCE_H

#include "formats/columns.h"
#include "formats/frf.h"
#include "tools/draw/chart.h"

/* Axes and panels of c, for a quantity of frf.h. */
void receptance_begin(struct chart *c, int quantity);

/* Adds the curve of r, whose frequencies must live until the chart is drawn; label NULL tells what was excited and where.  Where r holds
 * the values by Hermite interpolation, they are added in grey. */
const char *receptance_add(struct chart *c, const struct frf *r, const char *label);

/* Adds a table of frequency, real and imaginary part as dots; it must live until the chart is drawn; label NULL: "measured". */
const char *receptance_add_measured(struct chart *c, const struct columns *t, int quantity, const char *label);

/* Peaks of a [n]: maxima that fall by `ratio` on both sides before a higher one.  Indices in peak [most]; their number. */
int receptance_peaks(int64_t n, const double *a, double ratio, int most, int64_t *peak);

#endif
