/* Pointers are copied as bytes: members have the type of their elements, the table does not know it. */
#include "formats/vxf_member.h"

#include <string.h>

const char *vxf_get_member(const struct vxf *f, const struct vxf_member *m, int64_t *size, void *object)
{
    int64_t dim[2];
    const void *data;

    for (int k = 0; k < m->ndim; k++)
        dim[k] = size[m->dim[k]];
    const char *why = vxf_get(f, m->name, m->type, m->unit, m->ndim, dim, &data);
    if (why)
        return why;
    for (int k = 0; k < m->ndim; k++)
        size[m->dim[k]] = dim[k];
    memcpy((char *)object + m->at, &data, sizeof data);
    return NULL;
}

void vxf_put_members(struct vxf_out *o, const struct vxf_member *m, int n, const int64_t *size, const void *object)
{
    for (int i = 0; i < n; i++) {
        int64_t dim[2] = {0};
        const void *data;
        for (int k = 0; k < m[i].ndim; k++)
            dim[k] = size[m[i].dim[k]];
        memcpy(&data, (const char *)object + m[i].at, sizeof data);
        vxf_put(o, m[i].name, m[i].type, m[i].unit, m[i].ndim, dim, data);
    }
}
