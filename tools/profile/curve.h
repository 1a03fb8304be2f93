/* A smooth curve through points: y and z each a smoothing spline over the length along the points, so that steep faces are
 * as good as flat ones. */
#ifndef VX_PROFILE_CURVE_H
#define VX_PROFILE_CURVE_H

#include "formats/points.h"
#include "tools/profile/spline.h"

struct curve {
    double length;           /* m */
    struct spline y, z;
};

struct curve_residual {
    double worst, rms;       /* m, distance of the points from the curve along its normal */
    double worst_y;          /* m, where */
};

/* smoothing: m, the wavelength that is halved; 0 passes through every point. */
const char *curve_fit(struct curve *c, const struct points *p, double smoothing);
void curve_free(struct curve *c);

/* y, z, slope dz/dy and curvature (y' z'' - z' y'')/(y'^2 + z'^2)^1.5 at length s. */
void curve_at(const struct curve *c, double s, double *y, double *z, double *slope, double *curvature);

/* Only y and z (m). */
void curve_point(const struct curve *c, double s, double p[2]);

struct curve_residual curve_compare(const struct curve *c, const struct points *p);

#endif
