/* One polyline of a .prof as points for other programs. */
#ifndef VX_FORMATS_EXPORT_POINTS_H
#define VX_FORMATS_EXPORT_POINTS_H

#include <stdio.h>

#include "formats/prof.h"

/* *poly is the polyline of the body (NULL where the section holds but one) in the section nearest to station *at (NULL where the .prof
 * holds but one). */
const char *export_poly(const struct prof *p, const double *at, const char *body, int64_t *poly);

/* y (m) of point i as on a right side; z needs no turning. */
double export_y(const struct prof *p, int64_t i);

/* Index in y and z of the j-th point of a polyline in the order of a right side, whose y increases. */
int64_t export_point(const struct prof *p, int64_t poly, int64_t j);

/* Lines y z in mm under a heading, those of a right side.  A failure to write is left to ferror(out). */
void export_points(const struct prof *p, int64_t poly, FILE *out);

#endif
