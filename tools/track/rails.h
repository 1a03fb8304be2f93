/* The rails of a track as beam elements. */
#ifndef VX_TRACK_RAILS_H
#define VX_TRACK_RAILS_H

#include "formats/trk.h"
#include "formats/trk_text.h"
#include "tools/track/beam.h"

/* Stations, masses and stiffness of both rails; t->nodes and t->sleepers are known. */
const char *rails_lay(struct trk *t, const struct trk_text *in);

/* The element of a rail behind node i; it points into *t. */
struct beam rails_beam(const struct trk *t, int rail, int64_t i);

#endif
