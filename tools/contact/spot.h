/* The patch of one wheel on one rail at any displacement and yaw, strip by strip, with Hertz's beside it.
 *
 * x forward, y to the right, z down; right-handed angles.  Lateral coordinates of the patch lie in the plane of contact. */
#ifndef VX_CONTACT_SPOT_H
#define VX_CONTACT_SPOT_H

#include "formats/ctab.h"
#include "formats/prof.h"
#include "tools/contact/patch.h"
#include "tools/contact/report.h"

struct spot_place {
    double s, yaw, u;                /* m, rad, m, as of a table */
    double load;                     /* N, normal */
    double shear_modulus, poisson;   /* Pa, 1 */
};

struct spot {
    float row[CTAB_ALL];               /* the contact as in a table */
    int64_t strips;                  /* in `strip` */
    struct strip strip[PATCH_STRIPS];
    struct strip_patch patch;        /* of the whole body within 20 mm */
};

/* Of the contact that touches first, at the section nearest to s. */
const char *spot_find(const struct prof *wheel, const struct prof *rail, const struct spot_place *at, struct spot *o);

/* The totals, then the strips of the patch from left to right. */
void spot_report(const struct spot *o, double load, const struct report_printer *out);

#endif
