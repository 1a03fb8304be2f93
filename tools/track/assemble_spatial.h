/* K, C and M of a spatial track. */
#ifndef VX_TRACK_ASSEMBLE_SPATIAL_H
#define VX_TRACK_ASSEMBLE_SPATIAL_H

#include "formats/trk.h"

/* As assemble_track. */
const char *assemble_spatial(struct trk *t);

#endif
