/* Coefficient of friction of a contact: by place, and falling with the velocity of slip.
 *
 *   mu(w) = mu0 ((1 - A) exp(-B w) + A),   w = v sqrt(xi^2 + eta^2) at the contact's centre
 *
 * Polach, Creep forces in simulations of traction vehicles running on adhesion limit, Wear 258 (2005). */
#ifndef VX_CREEP_FRICTION_H
#define VX_CREEP_FRICTION_H

#include "formats/case_text.h"

/* Zero: constant everywhere. */
struct friction {
    double limit, decay;                /* 1, s/m: A and B; decay 0 is constant friction */
    int64_t rules;
    const struct case_friction *rule;   /* [rules] the last that holds wins */
};

/* Of a contact, mu where no rule holds, of the wheel on side 'l' or 'r' at station s m, on rail body `body`, at contact angle
 * `angle` rad, slipping at w m/s. */
double friction_of(const struct friction *f, double mu, char side, double s, double body, double angle, double w);

#endif
