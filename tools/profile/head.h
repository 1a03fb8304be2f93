/* Rail heads cut by machining: switch rail, wing rail and nose; and the face of a check rail.
 *
 * A right rail: y to the right, field side positive, z down from the top of the plain rail, the gauge face at -y.  What is left
 * of a head lies below all the surfaces it is cut by, so its own is the deepest of them; its edges are then rounded by the
 * discs that fit inside (a morphological opening). */
#ifndef VX_PROFILE_HEAD_H
#define VX_PROFILE_HEAD_H

#include "tools/profile/section.h"

struct head_options {
    double edge_radius;       /* m, at most 0.4 of the width */
    double smoothing;         /* m */
    double spacing;           /* m */
};

/* The head of a switch rail `thickness` thick behind its gauge face, its top `lowering` below the plain rail's top: the crown goes down
 * as a whole, the gauge side below it stays. */
const char *head_blade(const struct section *rail, double thickness, double lowering, const struct head_options *o,
                       struct outline *blade);

/* A nose between the gauge faces of two rails `width` apart, at least `lowering` below the plain rail's top; the right one of
 * them is the mirror image of the left. */
const char *head_nose(const struct section *rail, double width, double lowering, const struct head_options *o,
                      struct outline *nose);

struct head_top {
    double level;             /* m from the gauge face: from here to the plain rail's top the machined one is level */
    double crown_radius;      /* m, of the crown between there and the edge */
};

/* The head of a wing rail, by `share` between the plain rail (0) and one with a machined top (1).  Machined, the gauge side goes straight up
 * to a crown that carries a cone near the edge; the field side is that of the plain rail. */
const char *head_wing(const struct section *rail, double share, const struct head_top *top, const struct head_options *o,
                      struct outline *wing);

struct head_face {
    double height;            /* m, of the top above the rail's */
    double width;             /* m, of its level top */
    double edge_radius;       /* m */
    double inclination;       /* 1, to the vertical, leaning away from the rail */
    double depth;             /* m below the rail's top, where the face stands at y = 0 */
};

/* A check rail inside a right rail: level top, rounded edge, working face down to `deepest` (m) below the rail's top. */
const char *head_check(const struct head_face *face, double deepest, double spacing, struct outline *check);

#endif
