/* Tables over station or sleeper number of a track input: where they may lie. */
#ifndef VX_FORMATS_TRK_TEXT_TABLES_H
#define VX_FORMATS_TRK_TEXT_TABLES_H

#include "formats/trk_text.h"

/* Each table of two places or more has one on the track at least, or the track between two; places by number, but of rails, are whole. */
const char *trk_text_tables(const struct trk_text *in);

#endif
