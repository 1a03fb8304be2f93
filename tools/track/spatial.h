/* What a spatial track has beside a vertical one: rails sideways and in twist, sleepers sideways and in yaw, a check rail as a beam. */
#ifndef VX_TRACK_SPATIAL_H
#define VX_TRACK_SPATIAL_H

#include "formats/trk.h"
#include "formats/trk_text.h"

/* Fills it; rails, sleepers and railpads are laid. */
const char *spatial_lay(struct trk *t, const struct trk_text *in);

#endif
