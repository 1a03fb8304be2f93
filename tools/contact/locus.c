/* A point of the wheel at a on the axle, turned by t from the lowest of its circle, lies at
 *
 *     x = -a sin(psi) + r sin(t) cos(psi)     y = a cos(psi) + r sin(t) sin(psi)     z = r cos(t) below the axle
 *
 * The normal, outward radius minus r' times the axle's direction, has no part along a prismatic rail where
 *
 *     sin(t) = -r' tan(psi),   r' = dr/da
 *
 * which leaves one point for each a: y = a cos(psi) - r r' tan(psi) sin(psi), x = -(a + r r') sin(psi),
 * and dz/dy = r'/(cos(psi) cos(t)).  (Contact locus; Wang 1984, Vollebregt 2022.)  In the plane y = const a = y cos(psi) - x sin(psi), and
 * (z + r0)^2 = r(a)^2 - (x cos(psi) + y sin(psi))^2 has there
 *
 *     d2z/dx2 = -b,   b = (cos^2(psi) - (r'^2 + r r'') sin^2(psi))/(r cos(t)) */
#include "tools/contact/locus.h"

#include <math.h>

#define STEEPEST 0.99         /* of |sin(t)|: beyond, the profile is nearly a disc seen edge on */
#define FLATTEST 0.25         /* least b r cos(t): where the silhouette is about to fold b goes to 0 */

void locus_silhouette(const struct locus_wheel *w, double yaw, const struct locus *o)
{
    double c = cos(yaw), s = sin(yaw), tangent = tan(yaw);

    for (int64_t i = 0; i < w->n; i++) {
        double rate = w->slope[i], a = w->position + w->y[i], r = w->radius + w->z[i], sin_t = -rate * tangent;
        double cos_t = fabs(sin_t) < STEEPEST ? sqrt(1 - sin_t * sin_t) : (double)NAN;
        double second = w->k[i] * pow(1 + rate * rate, 1.5);
        o->y[i] = isnan(cos_t) ? cos_t : a * c + r * sin_t * s;
        o->z[i] = r * cos_t - w->radius;
        o->slope[i] = rate / (c * cos_t);
        o->x[i] = -(w->y[i] + r * rate) * s;
        o->bend[i] = fmax(c * c - (rate * rate + r * second) * s * s, FLATTEST) / (r * cos_t);
    }
}

void locus_invert(double x, double y, double z, double slope, double radius, double yaw, struct locus_point *p)
{
    double c = cos(yaw), s = sin(yaw), ahead = x * c + y * s, down = radius + z;

    p->a = y * c - x * s;
    p->r = hypot(ahead, down);
    p->turn = atan2(ahead, down);
    p->rate = (slope * down + ahead * s) / (p->r * c);            /* dz/dy = (r' cos(psi) - sin(t) sin(psi))/cos(t) */
}
