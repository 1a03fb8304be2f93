/* The range of an axis where the caller has not given one. */
#ifndef VX_DRAW_LIMITS_H
#define VX_DRAW_LIMITS_H

#include "tools/draw/chart.h"

/* Of x over all panels, of y over what lies within xlo..xhi in SI; as given where the axis has limits, 0..1 (1..10 where
 * logarithmic) where there is nothing to draw. */
void limits_x(const struct chart *c, double *lo, double *hi);
void limits_y(const struct chart_panel *p, const struct chart_axis *x, double xlo, double xhi, double *lo, double *hi);

#endif
