/* Cant of the track. */
#ifndef VX_TRACK_CANT_H
#define VX_TRACK_CANT_H

#include "formats/trk.h"
#include "formats/trk_text.h"

/* Fills cants, cant_x and cant; a level track has none. */
const char *cant_lay(struct trk *t, const struct trk_text *in);

#endif
