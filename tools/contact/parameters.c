/* Harmonic linearisation.  In a motion y = middle + a sin(t) a function f(y) answers with the first term of its Fourier series,
 *
 *     k a sin(t),   k = 1/(pi a) integral from 0 to 2 pi of f(middle + a sin(t)) sin(t) dt
 *
 * With contact angles d of right and left wheel, positive where the plane rises towards the gauge, and the roll phi (Wickens 2003),
 *
 *     (tan d_r - tan d_l)/2 = epsilon y/l,   phi = -sigma y/l
 *
 * epsilon is the lateral stiffness by gravity: a wheelset of weight W is pushed back by W epsilon y/l.  Where wheels and rails are arcs of
 * radii Rw and Rr that touch at the angle d0 and the distance l from the middle (t = tan d0), the wheelset turns about the point in
 * which the normals meet, l/t above the rails, so that
 *
 *     sigma = l t/(l - r0 t),   epsilon = t/(l - r0 t) (l/sin d0 + Rw)/(Rw - Rr) l/cos^2 d0 */
#include "tools/contact/parameters.h"

#include <math.h>
#include <stddef.h>

enum { PANELS = 4000 };

double parameters_slope(const double *y, const double *f, int64_t n, double middle, double amplitude)
{
    double sum = 0;
    int64_t i = 0;

    for (int k = 0; k < PANELS; k++) {
        double t = (k + 0.5) * M_PI / PANELS, at = middle - amplitude * cos(t);
        while (i + 2 < n && y[i + 1] < at)
            i++;
        double value = f[i] + (f[i + 1] - f[i]) * (at - y[i]) / (y[i + 1] - y[i]);
        sum -= value * cos(t);
    }
    return 2 * sum / (PANELS * amplitude);
}

void parameters_gather(const struct wheelset_point *p, int64_t n, const struct parameters_curves *c)
{
    for (int64_t i = 0; i < n; i++) {
        c->y[i] = p[i].y;
        c->radius_difference[i] = p[i].radius_difference;
        c->tangent[i] = 0.5 * (-tan(p[i].angle[WHEELSET_RIGHT]) - tan(p[i].angle[WHEELSET_LEFT]));
        c->roll[i] = p[i].roll;
    }
}

const char *parameters_at(const struct parameters_curves *c, int64_t n, double amplitude, double e, double r0, struct parameters *p)
{
    const char *why = conicity_klingel(c->y, c->radius_difference, n, amplitude, e, r0, &p->klingel);

    if (why)
        return why;
    p->contact_angle = 0.5 * e * parameters_slope(c->y, c->tangent, n, p->klingel.middle, amplitude);
    p->roll = 0 - 0.5 * e * parameters_slope(c->y, c->roll, n, p->klingel.middle, amplitude);
    return NULL;
}
