/* Receptance of a track from the history of a force and of what it moves: motion over force, exp(+i omega t), z down.
 *
 * H1 = S_Fz / S_FF with the spectra averaged over segments of the history, coherence |S_Fz|^2 / (S_FF S_zz) (Bendat and Piersol 2010;
 * segments after Welch 1967). */
#ifndef VX_RECEPTANCE_TRANSFER_H
#define VX_RECEPTANCE_TRANSFER_H

#include "formats/frf.h"
#include "tools/receptance/sweep.h"

enum transfer_window { TRANSFER_NONE, TRANSFER_HANN };

struct transfer {
    int64_t n;             /* samples */
    double step;           /* s between them */
    const double *F, *z;   /* N, m [n] */
    double held;           /* m/N of z over F, what the element of the rail gives with held ends */
    int64_t segment;       /* samples, up to n */
    int window;            /* hann: segments overlap by half */
};

/* Fills n, frequency, H, hermite where held is not 0, and coherence where there are two segments or more, of *r, which frf_free empties.  The
 * frequencies of s must be multiples of 1/(segment step); those where the force has less than 1e-4 of its largest power are left out. */
const char *transfer_estimate(struct frf *r, const struct transfer *t, const struct sweep *s);

#endif
