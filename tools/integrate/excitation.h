/* What moves a wheel on an ideal track: irregularity of the rails, dips, joints, flats of the wheels themselves.
 *
 * x forward, y to the right, z down.  All of it is geometry: a height the wheel has to follow and a line the rail takes. */
#ifndef VX_INTEGRATE_EXCITATION_H
#define VX_INTEGRATE_EXCITATION_H

#include <stdint.h>

#include "formats/case_text.h"
#include "formats/irregularity.h"
#include "tools/integrate/spectrum.h"

struct excitation_options {
    int64_t dips, joints, flats;
    const struct case_dip *dip;                /* [dips] must outlive the excitation, as the next two */
    const struct case_joint *joint;            /* [joints] */
    const struct case_flat *flat;              /* [flats] */
    const struct irregularity *measured;       /* NULL for none */
    struct spectrum_waves waves;               /* shortest 0 for none */
    double scale;                              /* 1, of the irregularity */
    double from, to;                           /* m, between which the irregularity is wanted; none before `from` */
    double fade;                               /* m, > 0, over which it comes up from `from` on; trailing, from `to` back */
    int trailing;                              /* stations asked for are times -1, sides and axes turned: facing.h */
};

/* Geometry of both rails at even stations, cubic between them. */
struct excitation {
    struct excitation_options o;
    int64_t n;                                 /* 0: no irregularity */
    double x0, h;                              /* m */
    double *knot;                              /* [n][8] z, y of the left, z, y of the right rail in m, then their slopes times h */
};

/* Height, down, and line, to the right, of a rail, or of what rolls on it. */
struct excitation_at {
    double z, z_slope, y, y_slope;             /* m, 1, m, 1 */
};

/* Fails where a measured irregularity does not reach from `from` to `to`. */
const char *excitation_new(struct excitation *e, const struct excitation_options *o);
void excitation_free(struct excitation *e);

/* At station s, for wheel `side` (0 left, 1 right) of wheelset i (from 0), of radius r m. */
void excitation_find(const struct excitation *e, double s, int64_t i, int side, double r, struct excitation_at *at);

#endif
