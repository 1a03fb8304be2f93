/* Preamble and header of a container: what the file says it holds, checked against its size and hash. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const char *vxf_check_preamble(const struct vxf *f, const struct vxf_preamble *p)
{
    if (f->size < sizeof *p)
        return f->size == 0 ? "empty file" : "not a Veksel file (shorter than a preamble)";
    if (memcmp(p->magic, VXF_MAGIC, 4) != 0)
        return "not a Veksel file";
    if (memcmp(p->magic, VXF_MAGIC, sizeof p->magic) != 0)
        return "damaged by a transfer as text";
    if (p->order != VXF_ORDER)
        return "written with another byte order";
    if (p->version != VXF_VERSION)
        return reason("format version %u, this program reads %d", p->version, VXF_VERSION);
    if (p->zero[0] || p->zero[1] || !memchr(p->kind, 0, sizeof p->kind))
        return "damaged preamble";
    if (p->header > VXF_HEADER_MAX || p->header > f->size - sizeof *p)
        return "truncated: the header does not fit in the file";
    if (p->size && p->size != f->size)
        return reason(p->size > f->size ? "truncated: %llu of %llu bytes" : "longer than it should be: %llu of %llu bytes",
                      (unsigned long long)f->size, (unsigned long long)p->size);
    if (vxf_header_hash(p, (const char *)f->base + sizeof *p) != p->hash)
        return "damaged header (its hash differs)";
    return NULL;
}

static const char *parse_type(const char *text, enum vxf_type *type)
{
    for (int k = 0; k < VXF_TYPES; k++)
        if (strcmp(text, vxf_type_name((enum vxf_type)k)) == 0) {
            *type = (enum vxf_type)k;
            return NULL;
        }
    return reason("unknown element type %s", text);
}

static const char *parse_dims(const char *text, struct vxf_array *a)
{
    if (strcmp(text, "scalar") == 0)
        return NULL;
    for (;;) {
        char *end;
        if (a->ndim == VXF_DIMS || *text < '0' || *text > '9')
            return reason("array %s: bad dims", a->name);
        errno = 0;
        a->dim[a->ndim++] = strtoll(text, &end, 10);
        if (errno || (*end && *end != 'x'))
            return reason("array %s: bad dims", a->name);
        if (!*end)
            return NULL;
        text = end + 1;
    }
}

/* A name stands for one array, of whichever list. */
static const char *append(struct vxf *f, struct vxf_list *list, const struct vxf_array *a)
{
    struct vxf_array *more;
    int overflow;

    vxf_bytes(a, &overflow);
    if (overflow)
        return reason("array %s is too large", a->name);
    if (vxf_find(&f->array, a->name) || vxf_find(&f->series, a->name) || vxf_find(&f->tail, a->name))
        return reason("array %s stands twice", a->name);
    more = realloc(list->item, (size_t)(list->n + 1) * sizeof *more);
    if (!more)
        return REASON_MEMORY;
    list->item = more;
    list->item[list->n++] = *a;
    return NULL;
}

/* "name type dims unit [offset hash]" */
static const char *parse_array(struct vxf *f, const char *line, int length, struct vxf_list *list)
{
    char text[256], type[8], dims[80];
    unsigned long long offset = 0, hash = 0;
    struct vxf_array a = {0};
    const char *why;
    int end = -1, placed = list == &f->array;

    if (length >= (int)sizeof text)
        return "damaged header: a line is too long";
    memcpy(text, line, (size_t)length);
    text[length] = 0;
    if (placed ? sscanf(text, " %31s %7s %79s %15s %llu %llx%n", a.name, type, dims, a.unit, &offset, &hash, &end) < 6
               : sscanf(text, " %31s %7s %79s %15s%n", a.name, type, dims, a.unit, &end) < 4)
        return "damaged header: an array line is not complete";
    if (end != length)
        return "damaged header: junk after an array line";
    a.offset = offset;
    a.hash = hash;
    if ((why = parse_type(type, &a.type)) || (why = parse_dims(dims, &a)))
        return why;
    return append(f, list, &a);
}

static int printable(const char *text, uint64_t n)
{
    for (uint64_t i = 0; i < n; i++)
        if (((unsigned char)text[i] < ' ' && text[i] != '\n') || text[i] == 127)
            return 0;
    return 1;
}

const char *vxf_parse_header(struct vxf *f, const struct vxf_preamble *p)
{
    const char *why = NULL, *line;
    int length;

    f->header = malloc(p->header + 1);
    if (!f->header)
        return REASON_MEMORY;
    memcpy(f->header, f->base + sizeof *p, p->header);
    f->header[p->header] = 0;
    if (p->header == 0 || f->header[p->header - 1] != '\n' || !printable(f->header, p->header))
        return "damaged header";
    memcpy(f->kind, p->kind, sizeof p->kind);
    for (int k = 0; !why && (line = vxf_line(f, "ARRAY", k, &length)); k++)
        why = parse_array(f, line, length, &f->array);
    for (int k = 0; !why && (line = vxf_line(f, "SERIES", k, &length)); k++)
        why = parse_array(f, line, length, &f->series);
    for (int k = 0; !why && (line = vxf_line(f, "TAIL", k, &length)); k++)
        why = parse_array(f, line, length, &f->tail);
    f->stream = f->series.n > 0;
    if (!why && f->tail.n && !f->stream)
        why = "damaged header: a tail without a series";
    return why;
}
