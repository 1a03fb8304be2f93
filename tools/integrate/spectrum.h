/* Track irregularity as a random series of a given spectrum.
 *
 * Spectra of ERRI B 176 RP 1 (1989), low and high level, W = 2 pi/wavelength in rad/m, Wc = 0.8246, Wr = 0.0206, Ws = 0.4380 rad/m:
 *
 *     longitudinal level   S = Av Wc^2/((W^2 + Wr^2)(W^2 + Wc^2))
 *     alignment            S = Aa Wc^2/((W^2 + Wr^2)(W^2 + Wc^2))
 *     cross level          S = 4 Av Wc^2 W^2/((W^2 + Wr^2)(W^2 + Wc^2)(W^2 + Ws^2)), of the difference in height
 *     gauge                S = Ag Wc^2 W^2/(likewise)
 *
 * Taken as one-sided: the variance is the integral of S over positive W alone.  So the longitudinal level of 3 to 25 m has a standard
 * deviation of 0.98 mm (low) and 1.61 mm (high). */
#ifndef VX_INTEGRATE_SPECTRUM_H
#define VX_INTEGRATE_SPECTRUM_H

#include <stdint.h>

#include "formats/irregularity.h"

enum spectrum_level { SPECTRUM_LOW, SPECTRUM_HIGH };

/* m3/rad of a quantity at W rad/m. */
double spectrum_density(enum spectrum_level level, enum irregularity_quantity quantity, double W);

/* Waves evenly spaced in W that do not repeat over `length` m, wavelengths from shortest to longest m, each of the amplitude its band
 * of the spectrum gives and of a phase drawn with the seed: value[n] m and slope[n] at x0, x0 + h, ...  The same bytes for the same
 * arguments. */
struct spectrum_waves {
    enum spectrum_level level;
    double shortest, longest, length;     /* m */
    int64_t seed;
};
void spectrum_series(const struct spectrum_waves *waves, enum irregularity_quantity quantity, double x0, double h, int64_t n, double *value,
                     double *slope);

#endif
