/* The contact table of one wheel on one rail: station x yaw x lateral displacement.
 *
 * Track axes: x forward, y to the right, z down.  Left sides are the exact mirror image of right ones. */
#ifndef VX_CONTACT_TABLE_H
#define VX_CONTACT_TABLE_H

#include "formats/ctab.h"
#include "formats/prof.h"

/* Raise it by hand when the kernels' numbers change: part of the key of cached tables. */
enum { TABLE_REVISION = 11 };

#define TABLE_LOAD 80e3      /* N, on a contact where none is given: a wheel of a loaded coach */

enum table_yaw {
    TABLE_NONE,              /* the orthogonal wheelset: one yaw, 0 */
    TABLE_THESIS,            /* the profile turned in two dimensions, closed over a section removed (thesis.h) */
    TABLE_EXACT              /* silhouette of the yawed wheel (locus.h) */
};

enum table_normal {
    TABLE_HERTZ,
    TABLE_STRIP              /* the columns of Hertz hold what the patch of strip.h has under the load */
};

struct table_grid {
    double u_max, u_step;    /* m, u runs over -u_max .. u_max; the step is that of the gap search too */
    double yaw_max;          /* rad; 0: 0.02, by TABLE_THESIS where a flange touches (clearance.h) */
    int64_t yaws;            /* over -yaw_max .. yaw_max, both included; 0: 21, by TABLE_THESIS 3 */
    double shear_modulus;    /* Pa */
    double poisson;          /* 1 */
    int normal;              /* enum table_normal */
    double load;             /* N, on a contact, under which patches are compared and made; 0: TABLE_LOAD */
};

/* Are they a wheel and a rail of one side? */
const char *table_pair(const struct prof *wheel, const struct prof *rail);

/* Fills t, to be released by ctab_free. */
const char *table_fill(struct ctab *t, const struct prof *wheel, const struct prof *rail, enum table_yaw method,
                       const struct table_grid *g);

#endif
