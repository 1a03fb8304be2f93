/* The shape of the gap around a contact: how far it is from Hertz's parabola, and the patch where it is.
 *
 * In the plane of contact: lateral coordinate along it, positive to the right, gap along its normal, both from the contact point. */
#ifndef VX_CONTACT_PATCH_H
#define VX_CONTACT_PATCH_H

#include "tools/contact/gap.h"
#include "tools/contact/hertz.h"
#include "tools/contact/strip.h"

enum { PATCH_STRIPS = 400 };

/* Where the ellipse h of a gap B y^2 (1/m) carries `load` (N): the sum over y of |depth - depth under the parabola| over that of the
 * parabola, with depth = B b^2 - gap where positive, b the ellipse's semi-axis.  0 where the gap is the parabola.  Another part of the patch,
 * up to 15 mm away, adds its depth where the gap is less than Hertz's approach.  1 at the end of a rail. */
double patch_deviation(const struct gap_pair *p, const struct gap_minimum *m, double B, const struct hertz *h, double load);

enum patch_extent {
    PATCH_OWN,               /* the contact's own part: to where the gap falls again further than GAP_APART away */
    PATCH_ALL                /* all of the body within 20 mm */
};

/* The patch under `load` into strips [PATCH_STRIPS] and patch, starting from the ellipse h of a gap B y^2: how many strips, 0 at an end. */
int64_t patch_strips(const struct gap_pair *p, const struct gap_minimum *m, double B, const struct hertz *h, double load,
                     const struct strip_law *law, enum patch_extent extent, struct strip strip[PATCH_STRIPS], struct strip_patch *patch);

/* Replaces h by the ellipse and the stiffness that have the patch's own part under `load`; leaves it at an end. */
void patch_hertz(const struct gap_pair *p, const struct gap_minimum *m, double B, double load, const struct strip_law *law,
                 struct hertz *h);

#endif
