/* Arrays as variables of a MAT file, version 5. */
#ifndef VX_FORMATS_EXPORT_MAT_H
#define VX_FORMATS_EXPORT_MAT_H

#include "formats/vxf.h"

/* Element (i, j, ...) of a variable is element [i - 1][j - 1]... of the array; a 1-D array is a column.  A character that a name may
 * not have, as the dot, becomes _.  An array of unit "text" is a character matrix.  The variable vxf_header holds the header text
 * of the file, with the units.  No date is written; a pipe will do for out.
 * A failure to write is left to ferror(out). */
const char *export_mat(const struct vxf_list *list, const char *header, FILE *out);

#endif
