/* A point of the wheel at a on the axle, turned by t from the lowest of its circle, lies at
 *
 *     x = -a sin(psi) + r sin(t) cos(psi)     y = a cos(psi) + r sin(t) sin(psi)     z = r cos(t) below the axle
 *
 * The normal, outward radius minus r' times the axle's direction, has no part along a prismatic rail where
 *
 *     sin(t) = -r' tan(psi),   r' = dr/da
 *
 * which leaves one point for each a: y = a cos(psi) - r r' tan(psi) sin(psi), x = -(a + r r') sin(psi),
 * and dz/dy = r'/(cos(psi) cos(t)).  (Contact locus; Wang 1984, Vollebregt 2022.) */
#include "tools/contact/locus.h"

#include <math.h>

#define STEEPEST 0.99         /* of |sin(t)|: beyond, the profile is nearly a disc seen edge on */

void locus_silhouette(const double *y, const double *z, const double *slope, int64_t n, double position, double radius, double yaw,
                      double *ly, double *lz, double *lslope)
{
    double c = cos(yaw), s = sin(yaw), tangent = tan(yaw);

    for (int64_t i = 0; i < n; i++) {
        double a = position + y[i], r = radius + z[i], sin_t = -slope[i] * tangent;
        double cos_t = fabs(sin_t) < STEEPEST ? sqrt(1 - sin_t * sin_t) : (double)NAN;
        ly[i] = a * c + r * sin_t * s;
        lz[i] = r * cos_t - radius;
        lslope[i] = slope[i] / (c * cos_t);
        if (isnan(cos_t))
            ly[i] = (double)NAN;
    }
}

void locus_invert(double y, double z, double slope, double radius, double yaw, struct locus_point *p)
{
    double c = cos(yaw), s = sin(yaw), tangent = tan(yaw), flat = slope * c;   /* r'/cos(t) */

    p->rate = flat / sqrt(1 + flat * flat * tangent * tangent);
    double sin_t = -p->rate * tangent;
    p->turn = asin(sin_t);
    p->r = (radius + z) / sqrt(1 - sin_t * sin_t);
    p->a = (y - p->r * sin_t * s) / c;
    p->x = -(p->a + p->r * p->rate) * s;
}
