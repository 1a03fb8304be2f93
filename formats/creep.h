/* .creep: creep forces of elliptic contacts in steady rolling, tabulated: creep(5).
 *
 * Creepages are scaled by the forces of Kalker's linear theory over mu N,
 *   x = G a b C11 xi/(mu N),  y = G a b C22 eta/(mu N),  s = G (a b)^1.5 C23 phi/(mu N),
 *   z = s (C23 + C11 b/(3 sqrt(a b)))/C23,  r = |x| + |y| + |z|,  h = CREEP_SIZE_HALF,
 * and x >= 0, s >= 0 suffice by symmetry.  The axes are evenly spaced:
 *   shape a/(a + b);  size r/(h + r), 0 to 1;  spin z/r, 0 to 1;  direction y/(|x| + |y|), -1 to 1.
 * With M = Mz/(mu N sqrt(a b)), a node holds what is left of Fx/(mu N), Fy/(mu N), M after
 *   (x, y + s, s C33/C23 - y C23/C22) h/(h + r),
 * divided by size: 0 at size 0, so small creepages have Kalker's coefficients. */
#ifndef VX_FORMATS_CREEP_H
#define VX_FORMATS_CREEP_H

#include "formats/vxf.h"

enum { CREEP_SHAPE, CREEP_SIZE, CREEP_SPIN, CREEP_DIRECTION, CREEP_AXES };
enum { CREEP_FORCES = 3 };
#define CREEP_SIZE_HALF 1.5      /* r in the middle of its axis, about where half of the contact slides */

struct creep {
    char theory[8];              /* fastsim or exact */
    int64_t grid;                /* strips or elements across */
    double poisson;              /* 1 */
    int64_t n[CREEP_AXES];       /* nodes, at least 2 */
    const double *axis[CREEP_AXES]; /* 1 [n] increasing, evenly spaced */
    const double *rest;          /* 1 [shapes][sizes][spins][directions][CREEP_FORCES] */
    void *store;                 /* what creep_free releases; NULL where the arrays belong to a file */
};

/* Points into f. */
const char *creep_read(struct creep *c, const struct vxf *f);
const char *creep_put(const struct creep *c, struct vxf_out *o);
void creep_free(struct creep *c);

#endif
