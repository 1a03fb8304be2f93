/* What a case asks of a passage, in the units and structs of its kernels. */
#ifndef VX_INTEGRATE_OPTIONS_H
#define VX_INTEGRATE_OPTIONS_H

#include "formats/case_text.h"
#include "tools/integrate/passage.h"

/* speed in m/s, which the case has in km/h; measured is what its irregularity.file holds, NULL where it names none.  The lists of c and
 * measured must outlive o. */
const char *options_read(struct passage_options *o, const struct case_text *c, double speed, const struct irregularity *measured);

/* A prescribed force on track t and what it moves, where the case has one (force.amplitude is not 0). */
const char *options_exciter(struct exciter *e, const struct case_text *c, const struct trk *t);

/* Creep forces by table c, which must outlive o, in contacts of both tables. */
const char *options_creep(struct passage_options *o, const struct creep *c, const struct ctab table[2]);

/* Whole steps between samples into *every. */
const char *options_sampling(const struct case_text *c, int64_t *every);

#endif
