/* A track as it is under a load that stands on it: which ballast touches decides its matrices. */
#ifndef VX_RECEPTANCE_PRELOAD_H
#define VX_RECEPTANCE_PRELOAD_H

#include "formats/trk.h"
#include "tools/receptance/place.h"

/* *out is t with the K and C of the ballast that touches under its own weight and a load (N, down, where p is, on each rail of it); its other arrays are
 * those of t, which must outlive it; trk_free it. */
const char *preload_track(struct trk *out, const struct trk *t, const struct place *p, double load);

#endif
