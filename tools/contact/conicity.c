/* A free wheelset that rolls without slip turns its path by dr per e r0:
 *
 *     y'' = -dr(y)/(e r0)
 *
 * With V(y) the integral of dr/(e r0), y'^2/2 + V(y) is constant: the wheelset swings between y1 and y2 of equal V, y2 - y1 being twice
 * the amplitude, about where dr = 0, and
 *
 *     half the wavelength = integral from y1 to y2 of dy/sqrt(2 (V(y2) - V(y)))
 *
 * For a cone, dr = 2 gamma y, the wavelength is 2 pi sqrt(e r0/(2 gamma)); the equivalent conicity is that of the cone with the same
 * wavelength, gamma = 2 e r0 (pi/wavelength)^2.  y = middle - amplitude cos(t) takes the roots out of both ends. */
#include "tools/contact/conicity.h"

#include <math.h>
#include <stddef.h>

#include "formats/reason.h"

#define EVEN 1e-10           /* 1, difference of V at both ends where the middle was found */

enum { PANELS = 4000 };

/* V (1) at y: dr straight between the knots, so V is a parabola there; V = 0 at y[0]. */
static double potential(const double *y, const double *dr, int64_t n, double e_r0, double at)
{
    double V = 0;

    for (int64_t i = 0; i + 1 < n && y[i] < at; i++) {
        double to = at < y[i + 1] ? at : y[i + 1], h = to - y[i];
        double end = dr[i] + (dr[i + 1] - dr[i]) * h / (y[i + 1] - y[i]);
        V += 0.5 * h * (dr[i] + end) / e_r0;
    }
    return V;
}

/* Middle of the swing: V equal at both ends; V is steeper outwards, so the difference rises with the middle. */
static double swing_middle(const double *y, const double *dr, int64_t n, double e_r0, double amplitude)
{
    double lo = y[0] + amplitude, hi = y[n - 1] - amplitude;

    for (int i = 0; i < 60; i++) {
        double m = 0.5 * (lo + hi);
        double rise = potential(y, dr, n, e_r0, m + amplitude) - potential(y, dr, n, e_r0, m - amplitude);
        *(rise > 0 ? &hi : &lo) = m;
    }
    return 0.5 * (lo + hi);
}

const char *conicity_klingel(const double *y, const double *dr, int64_t n, double amplitude, double e, double r0, struct conicity *c)
{
    if (n < 2)
        return "fewer than two displacements";
    if (!(amplitude > 0) || !(y[n - 1] - y[0] > 2 * amplitude))
        return reason("amplitude %g m must be positive and less than half of y's range, %g to %g m", amplitude, y[0], y[n - 1]);

    double e_r0 = e * r0, middle = swing_middle(y, dr, n, e_r0, amplitude);
    double y1 = middle - amplitude, top = potential(y, dr, n, e_r0, y1), sum = 0, V = top;
    double at = y1, uneven = fabs(potential(y, dr, n, e_r0, middle + amplitude) - top);
    int64_t i = 0;
    *c = (struct conicity){.middle = middle};
    if (uneven > EVEN)
        return reason("amplitude %g m: the motion does not turn within %g to %g m", amplitude, y[0], y[n - 1]);
    for (int k = 0; k < PANELS; k++) {
        double t = (k + 0.5) * M_PI / PANELS, next = middle - amplitude * cos(t);
        while (at < next) {                                       /* V from `at` to `next`, knot by knot */
            while (i + 2 < n && y[i + 1] <= at)
                i++;
            double to = i + 2 < n && y[i + 1] < next ? y[i + 1] : next, slope = (dr[i + 1] - dr[i]) / (y[i + 1] - y[i]);
            V += (to - at) * (dr[i] + slope * (0.5 * (at + to) - y[i])) / e_r0;
            at = to;
        }
        if (!(top - V > 0))
            return NULL;                                          /* flat, or no return to the middle */
        sum += amplitude * sin(t) / sqrt(2 * (top - V)) * M_PI / PANELS;
    }
    c->wavelength = 2 * sum;
    c->conicity = 2 * e_r0 * (M_PI / c->wavelength) * (M_PI / c->wavelength);
    return NULL;
}
