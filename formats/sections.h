/* The points of the sections that a list of the profile input names, all in the same axes: y to the right, z down, of a right side. */
#ifndef VX_FORMATS_SECTIONS_H
#define VX_FORMATS_SECTIONS_H

#include "formats/prof_text.h"

struct sections {
    struct slices slices;            /* stations and declared features */
    struct points *points;           /* m [slices.n] */
};

/* Mirrored as t states, else by the usual axes of a file's kind; plain points are in t's unit, m where it is unstated.  *hash goes on
 * over what was read. */
const char *sections_read(struct sections *s, const struct prof_text *t, const struct sections_list *l, uint64_t *hash);
void sections_free(struct sections *s);

#endif
