/* A wheelset on its rails in three numbers, as linear vehicle models want them: equivalent conicity, contact angle parameter and roll
 * parameter, each over an amplitude of the lateral displacement.
 *
 * x forward, y to the right, z down; right-handed angles. */
#ifndef VX_CONTACT_PARAMETERS_H
#define VX_CONTACT_PARAMETERS_H

#include "tools/contact/conicity.h"
#include "tools/contact/wheelset.h"

struct parameters {
    struct conicity klingel;
    double contact_angle;            /* 1, epsilon: tan of the contact angle, half of right less left, grows by epsilon y/l */
    double roll;                     /* 1, sigma: the roll is -sigma y/l */
};

/* The functions of y these follow from, [n] each: filled from the points of a sweep, p[n]. */
struct parameters_curves {
    double *y;                       /* m */
    double *radius_difference;       /* m, right less left */
    double *tangent;                 /* 1, of the contact angles, half of right less left, both positive towards the gauge */
    double *roll;                    /* rad */
};

void parameters_gather(const struct wheelset_point *p, int64_t n, const struct parameters_curves *c);

/* At an amplitude (m), with the distance e of the contact points (m; l = e/2) and the rolling radius r0 (m). */
const char *parameters_at(const struct parameters_curves *c, int64_t n, double amplitude, double e, double r0, struct parameters *p);

/* The slope (of f's unit per m) by which a function f(y), straight between the knots y, f [n], y increasing, acts on a motion
 * y = middle + amplitude sin(t): the first term of its Fourier series over the amplitude. */
double parameters_slope(const double *y, const double *f, int64_t n, double middle, double amplitude);

#endif
