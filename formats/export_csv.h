/* Arrays as comma-separated columns. */
#ifndef VX_FORMATS_EXPORT_CSV_H
#define VX_FORMATS_EXPORT_CSV_H

#include "formats/vxf.h"

/* A header line of names and units, then a row for each step of the first dim, which all arrays must share; a scalar is one row.
 * The other dims become columns name[1], name[2] or name[1][1], ...; a complex number two, name.re and name.im; an array of
 * unit "text" one cell for each text.  Numbers have all the digits that a reader needs to get the same bits.
 * A failure to write is left to ferror(out). */
const char *export_csv(const struct vxf_list *list, FILE *out);

#endif
