/* One rail body over its sections as a CONTACT .slcs with a Simpack .prr for each slice in a folder beside it. */
#ifndef VX_FORMATS_EXPORT_SLICES_H
#define VX_FORMATS_EXPORT_SLICES_H

#include <stdio.h>

#include "formats/prof.h"

/* The folder has the name of the .slcs without its ending and lies beside it; it is made where it is not, slices in it are overwritten.
 * The sections that hold the body (NULL where there is but one) must follow one another.  A failure to write to `out`, which becomes the
 * .slcs, is left to ferror(out). */
const char *export_slices(const struct prof *p, const char *body, const char *slcs, FILE *out);

#endif
