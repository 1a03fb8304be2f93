/* Railpads and ballast of a track from a measured receptance: factors on all their stiffnesses and dampings by least squares.
 *
 * The residual is ln(H / measured H), so that each frequency counts by its relative error, in magnitude and phase. */
#ifndef VX_RECEPTANCE_CALIBRATE_H
#define VX_RECEPTANCE_CALIBRATE_H

#include "formats/trk.h"
#include "tools/receptance/place.h"

enum { CALIBRATE_PAD_K, CALIBRATE_PAD_C, CALIBRATE_BALLAST_K, CALIBRATE_BALLAST_C, CALIBRATE_N };

extern const char *const calibrate_name[];   /* [CALIBRATE_N], then NULL */

struct measured {
    struct place force, motion;
    int quantity;                            /* FRF_RECEPTANCE and so on */
    int64_t n;
    const double *frequency;                 /* Hz [n] */
    const double *re, *im;                   /* [n] of H */
};

struct calibration {
    double factor[CALIBRATE_N];              /* on the track's own values; 1 where not fitted */
    double uncertainty[CALIBRATE_N];         /* standard, relative; 0 where not fitted or at a bound */
    int bound[CALIBRATE_N];                  /* -1, 1: at the lower or the upper bound */
    double before, after;                    /* root mean square of |residual| at the start and at the end */
    int64_t steps;
};

/* Fits the parameters for which fit [CALIBRATE_N] is true, factors from lo to hi, starting from 1. */
const char *calibrate_track(struct calibration *c, const struct trk *t, const struct measured *m, const int *fit, double lo, double hi);

/* *out is *t with the factors applied, assembled; trk_free it before t. */
const char *calibrate_apply(struct trk *out, const struct trk *t, const double *factor);

/* Mean of each parameter over the railpads, or over the sleepers the ballast under a whole one: value [CALIBRATE_N], N/m and N s/m. */
void calibrate_values(const struct trk *t, double *value);

#endif
