/* Prescribed forces over time, as a hammer or a shaker gives them. */
#ifndef VX_INTEGRATE_DRIVE_H
#define VX_INTEGRATE_DRIVE_H

#include <stdint.h>

enum drive_kind { DRIVE_IMPULSE, DRIVE_SWEEP, DRIVE_NOISE };

struct drive {
    int kind;
    double amplitude;     /* N: largest of an impulse and a sweep, root mean square of noise */
    double from, to;      /* Hz, band of a sweep and of noise */
    double width;         /* s of an impulse */
    int64_t blows;        /* of a hammer, evenly over the duration, the first at once */
    double duration;      /* s, in all */
    double rest;          /* s at its end without force, of a sweep and of noise */
    uint64_t seed;        /* of noise */
};

/* F [n], N, at 0, step, 2 step and so on:
 *   impulse  A/2 (1 - cos 2 pi t/width)
 *   sweep    A sin 2 pi (from t + (to - from) t^2/2T), T the duration without rest
 *   noise    normally distributed, with a flat spectrum within the band and none beyond, of period T */
const char *drive_sample(const struct drive *e, double step, int64_t n, double *F);

#endif
