/* Writing a container: header lines are gathered, arrays referred to, and all of it goes out in one pass. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

void vxf_out_begin(struct vxf_out *o, const char *kind)
{
    memset(o, 0, sizeof *o);
    snprintf(o->kind, sizeof o->kind, "%s", kind);
    vxf_put_key(o, "SOFTWARE", "Veksel %s", VX_VERSION);
}

void vxf_out_free(struct vxf_out *o)
{
    free(o->text);
    free(o->array.item);
    free(o->series.item);
    free(o->tail.item);
    memset(o, 0, sizeof *o);
}

static void add_text(struct vxf_out *o, const char *text, size_t n)
{
    if (o->length + n + 1 > o->room) {
        size_t room = 2 * (o->length + n) + 256;
        char *more = realloc(o->text, room);
        if (!more) {
            o->why = REASON_MEMORY;
            return;
        }
        o->text = more;
        o->room = room;
    }
    memcpy(o->text + o->length, text, n);
    o->length += n;
    o->text[o->length] = 0;
}

/* A newline inside a value would begin another header line: control characters become spaces. */
void vxf_put_key(struct vxf_out *o, const char *key, const char *format, ...)
{
    va_list ap, again;
    char *text;
    int n;

    va_start(ap, format);
    va_copy(again, ap);
    n = vsnprintf(NULL, 0, format, ap);
    va_end(ap);
    text = malloc((size_t)n + 1);
    if (text) {
        vsnprintf(text, (size_t)n + 1, format, again);
        for (char *p = text; *p; p++)
            if (iscntrl((unsigned char)*p))
                *p = ' ';
        add_text(o, key, strlen(key));
        add_text(o, "= ", 2);
        add_text(o, text, (size_t)n);
        add_text(o, "\n", 1);
    } else
        o->why = REASON_MEMORY;
    va_end(again);
    free(text);
}

/* A blank would end the word in the header line. */
static int is_word(const char *text, size_t room)
{
    size_t n = strlen(text);

    for (size_t i = 0; i < n; i++)
        if (!isgraph((unsigned char)text[i]))
            return 0;
    return n > 0 && n < room;
}

static void add_array(struct vxf_out *o, struct vxf_list *list, const char *name, enum vxf_type type,
                      const char *unit, int ndim, const int64_t *dim, const void *data)
{
    struct vxf_array a = {.type = type, .ndim = ndim, .data = data};
    struct vxf_array *more;
    int overflow;

    if (!is_word(name, sizeof a.name) || !is_word(unit, sizeof a.unit) || ndim < 0 || ndim > VXF_DIMS) {
        o->why = reason("BUG: array \"%s\" with unit \"%s\" and %d dims cannot be written", name, unit, ndim);
        return;
    }
    snprintf(a.name, sizeof a.name, "%s", name);
    snprintf(a.unit, sizeof a.unit, "%s", unit);
    for (int i = 0; i < ndim; i++)
        a.dim[i] = dim[i];
    vxf_bytes(&a, &overflow);
    if (overflow)
        o->why = reason("array %s is too large", name);
    else if (data && !vxf_finite(type, data, vxf_count(&a)))
        o->why = reason("array %s would hold a number that is not finite", name);
    else if (vxf_find(&o->array, name) || vxf_find(&o->series, name) || vxf_find(&o->tail, name))
        o->why = reason("array %s stands twice", name);
    else if (!(more = realloc(list->item, (size_t)(list->n + 1) * sizeof *more)))
        o->why = REASON_MEMORY;
    else {
        list->item = more;
        list->item[list->n++] = a;
    }
}

void vxf_put(struct vxf_out *o, const char *name, enum vxf_type type, const char *unit, int ndim,
             const int64_t *dim, const void *data)
{
    if (!o->why)
        add_array(o, &o->array, name, type, unit, ndim, dim, data);
}

void vxf_put_series(struct vxf_out *o, const char *name, enum vxf_type type, const char *unit, int ndim,
                    const int64_t *dim)
{
    if (!o->why)
        add_array(o, &o->series, name, type, unit, ndim, dim, NULL);
}

void vxf_put_tail(struct vxf_out *o, const char *name, enum vxf_type type, const char *unit, int ndim,
                  const int64_t *dim)
{
    if (!o->why)
        add_array(o, &o->tail, name, type, unit, ndim, dim, NULL);
}

/* A line that came by two ways, as the track's does over two inputs, stands once. */
static int has_line(const struct vxf_out *o, const char *line, size_t n)
{
    for (const char *p = o->text; p && (p = strstr(p, line)); p++)
        if ((p == o->text || p[-1] == '\n') && p[n] == '\n')
            return 1;
    return 0;
}

void vxf_put_input(struct vxf_out *o, const struct vxf *input)
{
    const char *line;
    int length;

    for (int k = 0; (line = vxf_line(input, "CMD", k, &length)); k++) {
        char *text = malloc((size_t)length + 6);
        if (!text) {
            o->why = REASON_MEMORY;
            return;
        }
        snprintf(text, (size_t)length + 6, "CMD= %.*s", length, line);
        if (!has_line(o, text, strlen(text))) {
            add_text(o, text, strlen(text));
            add_text(o, "\n", 1);
        }
        free(text);
    }
    vxf_put_key(o, "INPUT", "%s %016llx", input->kind, (unsigned long long)vxf_content(input));
}

/* ---- the file ---- */

const char *vxf_write_all(FILE *stream, const void *data, size_t n)
{
    return fwrite(data, 1, n, stream) == n ? NULL : reason("write error: %s", strerror(errno));
}

const char *vxf_write_padded(FILE *stream, const void *data, uint64_t n)
{
    static const unsigned char zero[VXF_ALIGN];
    const char *why = n ? vxf_write_all(stream, data, n) : NULL;

    return why ? why : vxf_write_all(stream, zero, vxf_pad(n) - n);
}

/* The KEY= lines, then the lines of arrays, series and tail; NULL without memory. */
static char *header_text(const struct vxf_out *o, uint64_t *size)
{
    size_t room = o->length + (size_t)(o->array.n + o->series.n + o->tail.n) * 256 + 1, used = o->length;
    char *text = malloc(room), dims[80];
    uint64_t offset = 0;
    int overflow;

    if (!text)
        return NULL;
    memcpy(text, o->text, o->length);
    for (int i = 0; i < o->array.n; i++) {
        const struct vxf_array *a = &o->array.item[i];
        uint64_t bytes = vxf_bytes(a, &overflow);
        vxf_dims_text(a, dims, sizeof dims);
        used += (size_t)snprintf(text + used, room - used, "ARRAY= %s %s %s %s %llu %016llx\n", a->name,
                                 vxf_type_name(a->type), dims, a->unit, (unsigned long long)offset,
                                 (unsigned long long)vxf_hash(a->data, bytes));
        offset += vxf_pad(bytes);
    }
    for (int k = 0; k < 2; k++) {
        const struct vxf_list *list = k ? &o->tail : &o->series;
        for (int i = 0; i < list->n; i++) {
            vxf_dims_text(&list->item[i], dims, sizeof dims);
            used += (size_t)snprintf(text + used, room - used, "%s= %s %s %s %s\n", k ? "TAIL" : "SERIES",
                                     list->item[i].name, vxf_type_name(list->item[i].type), dims, list->item[i].unit);
        }
    }
    text[used] = 0;
    *size = sizeof(struct vxf_preamble) + vxf_pad(used) + offset;
    return text;
}

const char *vxf_write_head(const struct vxf_out *o, FILE *stream, uint64_t *size)
{
    struct vxf_preamble p = {.magic = VXF_MAGIC, .order = VXF_ORDER, .version = VXF_VERSION};
    const char *why = o->why;
    char *text;

    if (!why && o->tail.n && !o->series.n)
        why = "BUG: a tail without a series";
    if (why)
        return why;
    if (!(text = header_text(o, size)))
        return REASON_MEMORY;
    memcpy(p.kind, o->kind, sizeof p.kind);
    p.header = strlen(text);
    p.hash = vxf_header_hash(&p, text);
    p.size = o->series.n ? 0 : *size;
    if (!(why = vxf_write_all(stream, &p, sizeof p)))
        why = vxf_write_padded(stream, text, p.header);
    free(text);
    for (int i = 0; !why && i < o->array.n; i++) {
        int overflow;
        why = vxf_write_padded(stream, o->array.item[i].data, vxf_bytes(&o->array.item[i], &overflow));
    }
    return why;
}

const char *vxf_write(const struct vxf_out *o, FILE *stream)
{
    uint64_t size;

    return vxf_write_head(o, stream, &size);
}
