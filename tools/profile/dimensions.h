/* What a profile measures, for its user to check (vxprofile --check). */
#ifndef VX_PROFILE_DIMENSIONS_H
#define VX_PROFILE_DIMENSIONS_H

#include "tools/profile/outline.h"

/* Of a wheel; not a number where the shape has none. */
struct dimensions {
    double flange_height;     /* m, Sh: tip below the running circle (EN 15313) */
    double flange_thickness;  /* m, Sd: from the back to the face, 10 mm below the running circle */
    double flange_slope;      /* m, qR: from there to the face 2 mm above the tip, across */
};

/* flange_back: m, from the flange back to the running circle. */
void dimensions_wheel(const struct outline *o, double flange_back, struct dimensions *c);

/* Inclination of a rail (1): the slope, towards the track's centre, of the straight line through the top 10 mm to both sides of the middle
 * between the side faces, all in the inclined rail's own axes; that of a new rail, whose head is symmetric.  gauge_depth: m, below the top
 * where the faces are taken.  Not a number where one side does not reach it. */
double dimensions_cant(const struct outline *o, double gauge_depth);

#endif
