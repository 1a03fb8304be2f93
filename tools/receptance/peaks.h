/* Peaks and dips of a receptance. */
#ifndef VX_RECEPTANCE_PEAKS_H
#define VX_RECEPTANCE_PEAKS_H

#include <stdint.h>

struct peak {
    int is_dip;
    double frequency;   /* Hz */
    double amplitude;   /* m/N */
};

/* Inner extrema of |H| over frequency [n] (Hz), H [n][2] (m/N), into peak [n]; returns how many. */
int64_t peaks_find(int64_t n, const double *frequency, const double *H, struct peak *peak);

#endif
