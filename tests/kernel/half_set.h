/* Half a wheelset under half a frame, as a wheel feels it; vehicles of data/vehicles/wheelset.yaml. */
#ifndef VX_HALF_SET_H
#define VX_HALF_SET_H

#include <complex.h>

#include "formats/veh.h"

/* m/N at the wheel, of exp(i omega t). */
static inline double complex half_set(const struct veh *v, double omega)
{
    const int64_t n = 6 * v->bodies, w = 6 * v->wheelset[0] + VEH_Z, f = 6 * (v->wheelset[0] ? 0 : 1) + VEH_Z;
    const double complex ww = v->K[w * n + w] + I * omega * v->C[w * n + w] - omega * omega * v->mass[w / 6];
    const double complex ff = v->K[f * n + f] + I * omega * v->C[f * n + f] - omega * omega * v->mass[f / 6];
    const double complex wf = v->K[w * n + f] + I * omega * v->C[w * n + f];

    return 2 / (ww - wf * wf / ff);
}

#endif
