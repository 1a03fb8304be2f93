/* Samples without aliases: a low-pass over the steps around each sample.
 *
 * A sinc cut by a Hamming window, of 8 samples' width, symmetric, so without delay: 0 dB to 0.25, -6 dB at 0.5, below -50 dB from 0.75 of
 * the sampling frequency on (Oppenheim and Schafer, Discrete-Time Signal Processing, ch. 7). */
#ifndef VX_INTEGRATE_LOWPASS_H
#define VX_INTEGRATE_LOWPASS_H

#include <stdint.h>

enum { LOWPASS_HALF = 4 };      /* samples to either side */

/* w[2 LOWPASS_HALF every + 1] for samples every so many steps, of sum 1; the middle belongs to the sample's own step. */
void lowpass_weights(int64_t every, double *w);

#endif
