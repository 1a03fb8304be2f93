/* Natural cubic smoothing spline through points (s, x) of weight w: the f that minimises
 *
 *     sum_i w_i (s_{i+1} - s_{i-1})/2 (x_i - f(s_i))^2  +  lambda integral f''^2 ds,
 *
 * Reinsch, Numer. Math. 10 (1967) 177; f'' = 0 at both ends.  With lambda = (L/2 pi)^4 a wave of length L keeps half its
 * amplitude, longer ones nearly all, shorter ones little.  lambda = 0 is the interpolating natural spline. */
#ifndef VX_PROFILE_SPLINE_H
#define VX_PROFILE_SPLINE_H

#include <stdint.h>

struct spline {
    int64_t n;
    double *s;       /* [n] knots, increasing */
    double *f;       /* [n] values */
    double *m;       /* [n] second derivatives, 0 at the ends */
};

/* n >= 2 points s[n] strictly increasing, x[n]; weight[n] positive, or NULL for 1. */
const char *spline_fit(struct spline *p, int64_t n, const double *s, const double *x, const double *weight, double lambda);
void spline_free(struct spline *p);

/* Value, first and second derivative at s; beyond the ends the line goes straight on. */
void spline_at(const struct spline *p, double s, double out[3]);

double spline_lambda(double wavelength);

#endif
