/* What an engineer calls a mode of a track. */
#ifndef VX_RECEPTANCE_KIND_H
#define VX_RECEPTANCE_KIND_H

#include "formats/trk.h"

/* The motion x [dofs]: in phase where the rails move alike, antiphase where against each other, else nothing; of a spatial track, before it,
 * vertical, lateral or torsion. */
void kind_name(const struct trk *t, const double *x, char name[32]);

#endif
