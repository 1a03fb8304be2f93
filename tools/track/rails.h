/* The rails of a track as beam elements. */
#ifndef VX_TRACK_RAILS_H
#define VX_TRACK_RAILS_H

#include "formats/trk.h"
#include "formats/trk_text.h"
#include "tools/track/beam.h"

/* Stations, masses and stiffness of both rails; t->nodes and t->sleepers are known. */
const char *rails_lay(struct trk *t, const struct trk_text *in);

/* *x [*knots] and *EI [2][*knots], kept with the track: the stiffness of both rails over the knots of both. */
const char *rails_lay_bending(struct trk *t, const struct trk_text *in, const struct yaml_table *const of[TRK_RAILS], int64_t *knots,
                              const double **x, const double **EI);

/* The element of a rail behind node i; it points into *t. */
struct beam rails_beam(const struct trk *t, int rail, int64_t i);

/* The same sideways, of a spatial track: w is y, and t = -dw/dx the yaw with the other sign. */
struct beam rails_lateral_beam(const struct trk *t, int rail, int64_t i);

#endif
