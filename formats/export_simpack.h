/* One polyline of a .prof as a Simpack profile, .prr for a rail, .prw for a wheel. */
#ifndef VX_FORMATS_EXPORT_SIMPACK_H
#define VX_FORMATS_EXPORT_SIMPACK_H

#include <stdio.h>

#include "formats/prof.h"

/* The points are those of a right side, in mm.  After the file's keys a rail runs from the gauge side to the field side; a wheel, whose points
 * stand with y towards the track's centre under mirror.y = 1 and inversion = 1, from the field side to the flange.  A failure to write
 * is left to ferror(out). */
void export_simpack(const struct prof *p, int64_t poly, FILE *out);

#endif
