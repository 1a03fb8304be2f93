/* Railpads: the reference along the track, and zones of their own. */
#ifndef VX_TRACK_PADS_H
#define VX_TRACK_PADS_H

#include "formats/trk.h"
#include "formats/trk_text.h"

/* Fills pad_k, pad_c, pad_zone, zones and zone_name; sleepers and ballast are laid. */
const char *pads_lay(struct trk *t, const struct trk_text *in);

#endif
