/* Arrays as datasets of an HDF5 file. */
#ifndef VX_FORMATS_EXPORT_HDF5_H
#define VX_FORMATS_EXPORT_HDF5_H

#include "formats/vxf.h"

/* One dataset for each array in the root group, with the attribute unit; dims as in the array.  A complex number is a compound of r
 * and i, an array of unit "text" one of strings.  The dataset vxf_header is the header text.  No times are stored: the same arrays
 * give the same bytes.  The file is made in memory, so a pipe will do for out.
 * A failure to write is left to ferror(out). */
const char *export_hdf5(const struct vxf_list *list, const char *header, FILE *out);

#endif
