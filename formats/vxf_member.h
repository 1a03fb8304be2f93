/* The arrays of a kind of file as one table over the members of its struct. */
#ifndef VX_FORMATS_VXF_MEMBER_H
#define VX_FORMATS_VXF_MEMBER_H

#include <stddef.h>

#include "formats/vxf.h"

struct vxf_member {
    const char *name, *unit;
    enum vxf_type type;
    int ndim;                /* 1 or 2 */
    int dim[2];              /* which sizes the dims have, as indices into size[] */
    size_t at;               /* offsetof the member, a pointer to the array's data */
};

/* Points the member of *object at its array in f.  size[dim] < 0 is filled in from the file, any other must agree. */
const char *vxf_get_member(const struct vxf *f, const struct vxf_member *m, int64_t *size, void *object);

/* Adds n members of *object. */
void vxf_put_members(struct vxf_out *o, const struct vxf_member *m, int n, const int64_t *size, const void *object);

#endif
