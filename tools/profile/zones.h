/* Published pieces of a shape (EN 13715, EN 13674-1: polynomials, arcs, lines over y) as points along it. */
#ifndef VX_PROFILE_ZONES_H
#define VX_PROFILE_ZONES_H

#include "formats/prof_text.h"

/* z, dz/dy of a zone at y; y beyond an arc's end stays at its vertical tangent. */
double zone_height(const struct prof_zone *z, double y);
double zone_slope(const struct prof_zone *z, double y);

/* Points at most `spacing` (m) apart along zone[n], y increasing; with `symmetric` the mirror image before them. */
const char *zones_points(int64_t n, const struct prof_zone *zone, int symmetric, double spacing, struct points *p);

#endif
