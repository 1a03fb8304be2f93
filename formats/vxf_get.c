/* Questions to an open container: header lines, and arrays of a stated type, unit and shape. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *vxf_is(const struct vxf *f, const char *kind)
{
    return strcmp(f->kind, kind) == 0 ? NULL : reason("a .%s file where a .%s file is wanted", f->kind, kind);
}

const char *vxf_line(const struct vxf *f, const char *key, int k, int *length)
{
    size_t n = strlen(key);

    for (const char *p = f->header; *p; p = strchr(p, '\n') + 1)
        if (strncmp(p, key, n) == 0 && strncmp(p + n, "= ", 2) == 0 && k-- == 0) {
            *length = (int)(strchr(p, '\n') - (p + n + 2));
            return p + n + 2;
        }
    return NULL;
}

const char *vxf_key(const struct vxf *f, const char *key, char *value, size_t size)
{
    int length;
    const char *line = vxf_line(f, key, 0, &length);

    if (!line)
        return reason("header key %s is missing", key);
    if ((size_t)length >= size)
        return reason("header key %s is too long", key);
    memcpy(value, line, (size_t)length);
    value[length] = 0;
    return NULL;
}

const char *vxf_number(const struct vxf *f, const char *key, double *value)
{
    char text[64], *end;
    const char *why = vxf_key(f, key, text, sizeof text);

    if (why)
        return why;
    *value = strtod(text, &end);
    if (end == text || *end || !isfinite(*value))
        return reason("header key %s: %s is not a number", key, text);
    return NULL;
}

static const char *check_finite(const struct vxf_array *a, const void *data, int64_t n)
{
    const unsigned char *p = data;
    size_t size = vxf_type_size(a->type);
    int64_t i = 0;

    if (vxf_finite(a->type, data, n))
        return NULL;
    while (vxf_finite(a->type, p + (size_t)i * size, 1))
        i++;
    return reason("array %s: not a finite number at %lld", a->name, (long long)i);
}

static const char *check_shape(const struct vxf_list *list, const char *what, const char *name, enum vxf_type type,
                               const char *unit, int ndim, int64_t *dim, const struct vxf_array **found)
{
    const struct vxf_array *a = *found = vxf_find(list, name);

    if (!a)
        return reason("%s %s is missing", what, name);
    if (a->type != type)
        return reason("%s %s is %s, should be %s", what, name, vxf_type_name(a->type), vxf_type_name(type));
    if (strcmp(a->unit, unit) != 0)
        return reason("%s %s has unit %s, should have %s", what, name, a->unit, unit);
    if (a->ndim != ndim)
        return reason("%s %s has %d dims, should have %d", what, name, a->ndim, ndim);
    for (int i = 0; i < ndim; i++) {
        if (dim[i] >= 0 && dim[i] != a->dim[i])
            return reason("%s %s: dim %d is %lld, should be %lld", what, name, i + 1, (long long)a->dim[i],
                          (long long)dim[i]);
        dim[i] = a->dim[i];
    }
    return NULL;
}

const char *vxf_get(const struct vxf *f, const char *name, enum vxf_type type, const char *unit, int ndim,
                    int64_t *dim, const void **data)
{
    const struct vxf_array *a;
    const char *why = check_shape(&f->array, "array", name, type, unit, ndim, dim, &a);

    if (!why)
        why = check_finite(a, *data = a->data, vxf_count(a));
    return why;
}

const char *vxf_get_tail(const struct vxf *f, const char *name, enum vxf_type type, const char *unit, int ndim,
                         int64_t *dim, const void **data)
{
    const struct vxf_array *a;
    const char *why;

    if (!f->complete)
        return reason("tail array %s is missing: the file is not complete", name);
    why = check_shape(&f->tail, "tail array", name, type, unit, ndim, dim, &a);
    if (!why)
        why = check_finite(a, *data = a->data, vxf_count(a));
    return why;
}

const char *vxf_join(struct vxf *f, int k)
{
    int overflow;
    size_t record = vxf_bytes(&f->series.item[k], &overflow);
    unsigned char *to;

    if (!f->joined && !(f->joined = calloc((size_t)f->series.n, sizeof *f->joined)))
        return REASON_MEMORY;
    if (f->joined[k])
        return NULL;
    if (!(to = malloc(record * (size_t)f->records + 1)))
        return REASON_MEMORY;
    f->joined[k] = to;
    for (int i = 0; i < f->blocks; i++) {
        const struct vxf_block *b = (const void *)(f->base + f->block[i]);
        const unsigned char *from = (const unsigned char *)(b + 1);
        for (int j = 0; j < k; j++)
            from += vxf_pad(vxf_bytes(&f->series.item[j], &overflow) * (uint64_t)b->records);
        memcpy(to, from, record * (size_t)b->records);
        to += record * (size_t)b->records;
    }
    return NULL;
}

const char *vxf_get_series(struct vxf *f, const char *name, enum vxf_type type, const char *unit, int ndim,
                           int64_t *dim, const void **data)
{
    const struct vxf_array *a;
    const char *why = check_shape(&f->series, "series", name, type, unit, ndim, dim, &a);
    int k;

    if (why)
        return why;
    k = (int)(a - f->series.item);
    if ((why = vxf_join(f, k)))
        return why;
    *data = f->joined[k];
    return check_finite(a, *data, vxf_count(a) * f->records);
}
