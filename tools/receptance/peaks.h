/* Peaks and dips of a receptance. */
#ifndef VX_RECEPTANCE_PEAKS_H
#define VX_RECEPTANCE_PEAKS_H

#include <stdint.h>

struct peak {
    int is_dip;
    double frequency;   /* Hz */
    double amplitude;   /* in the unit of H */
};

/* Inner extrema of |H| over frequency [n] (Hz), H [n][2], into peak [n]; returns how many. */
int64_t peaks_find(int64_t n, const double *frequency, const double *H, struct peak *peak);

#endif
