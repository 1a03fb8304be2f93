/* A curve as an outline of evenly spaced points. */
#ifndef VX_PROFILE_RESAMPLE_H
#define VX_PROFILE_RESAMPLE_H

#include "tools/profile/curve.h"
#include "tools/profile/outline.h"

/* At most `spacing` (m) apart along the curve, both ends included. */
const char *resample_curve(const struct curve *c, double spacing, struct outline *o);

#endif
