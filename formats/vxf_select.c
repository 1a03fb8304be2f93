/* Every array of a container as one list: what compares and exports files need not know where an array stands. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <stdlib.h>
#include <string.h>

static const char *append(struct vxf_list *to, const struct vxf_array *a)
{
    struct vxf_array *more = realloc(to->item, (size_t)(to->n + 1) * sizeof *more);

    if (!more)
        return REASON_MEMORY;
    to->item = more;
    to->item[to->n++] = *a;
    return NULL;
}

/* A series has its records as first dim. */
static const char *append_series(struct vxf *f, int k, struct vxf_list *to)
{
    struct vxf_array a = f->series.item[k];
    const char *why;

    if (a.ndim == VXF_DIMS)
        return reason("series %s has too many dims", a.name);
    if ((why = vxf_join(f, k)))
        return why;
    memmove(a.dim + 1, a.dim, (size_t)a.ndim * sizeof a.dim[0]);
    a.dim[0] = f->records;
    a.ndim++;
    a.data = f->joined[k];
    return append(to, &a);
}

static const char *append_named(struct vxf *f, const char *name, struct vxf_list *to)
{
    const struct vxf_array *a;

    if ((a = vxf_find(&f->array, name)))
        return append(to, a);
    if ((a = vxf_find(&f->series, name)))
        return append_series(f, (int)(a - f->series.item), to);
    if ((a = vxf_find(&f->tail, name)))
        return f->complete ? append(to, a) : reason("%s is missing: the file is not complete", name);
    return reason("there is no array %s", name);
}

const char *vxf_select(struct vxf *f, int n, char *const *name, struct vxf_list *to)
{
    const char *why = NULL;

    *to = (struct vxf_list){0};
    for (int i = 0; i < n && !why; i++)
        why = append_named(f, name[i], to);
    for (int i = 0; n == 0 && i < f->array.n && !why; i++)
        why = append(to, &f->array.item[i]);
    for (int i = 0; n == 0 && i < f->series.n && !why; i++)
        why = append_series(f, i, to);
    for (int i = 0; n == 0 && i < f->tail.n && f->complete && !why; i++)
        why = append(to, &f->tail.item[i]);
    if (why) {
        free(to->item);
        *to = (struct vxf_list){0};
    }
    return why;
}
