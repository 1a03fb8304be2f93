/* Which way round a shape is: brings its points to those of a right side, y towards the field, z down.
 *
 * What is stated counts.  Else what the shape itself shows:
 *   z, wheel   the flange is the one deep extremum between the ends: z points towards it
 *   z, rail    the top is the one extremum between the ends, the crown: z points away from it
 *   y, wheel   the flange lies in the outer third that faces the track's centre
 *   y, rail    only one side reaches down to the gauge depth: the gauge is measured there; or both sides are alike
 * Else the usual axes of the file's kind, where they are the kind's rule, or where the lower corner of a rail (worn, or inclined) lies on
 * the gauge side as well.  What then is open is refused, and so is a kind's rule that the shape contradicts. */
#ifndef VX_PROFILE_ORIENT_H
#define VX_PROFILE_ORIENT_H

#include "formats/prof_text.h"

struct orient {
    int mirror_y, mirror_z;      /* what was done, before the shift */
    double shift_y;              /* m */
    const char *by_y, *by_z, *by_shift;   /* how it is known, static texts */
};

/* Turns the points of s in place by what t states and what they show. */
const char *orient_shape(struct shape *s, const struct prof_text *t, struct orient *o);

#endif
