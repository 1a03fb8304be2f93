/* The patch of one wheel on one rail at any displacement and yaw, strip by strip, with Hertz's beside it.
 *
 * x forward, y to the right, z down; right-handed angles.  Lateral coordinates of the patch lie in the plane of contact. */
#ifndef VX_CONTACT_SPOT_H
#define VX_CONTACT_SPOT_H

#include "formats/columns.h"
#include "formats/ctab.h"
#include "formats/prof.h"
#include "tools/contact/patch.h"

struct spot_place {
    double s, yaw, u;                /* m, rad, m, as of a table */
    double load;                     /* N, normal */
    double shear_modulus, poisson;   /* Pa, 1 */
};

struct spot {
    float row[CTAB_N];               /* the contact as in a table */
    int64_t rows;
    struct strip_row strip[PATCH_ROWS];
    struct strip_patch patch;        /* of the whole body within 20 mm */
};

/* Of the contact that touches first, at the section nearest to s. */
const char *spot_find(const struct prof *wheel, const struct prof *rail, const struct spot_place *at, struct spot *o);

/* Columns to print: totals, and those of a strip. */
enum { SPOT_TOTALS = 13, SPOT_STRIP = 3 };
extern const struct column spot_totals[SPOT_TOTALS], spot_strip[SPOT_STRIP];
void spot_total_row(const struct spot *o, double load, double row[SPOT_TOTALS]);

#endif
