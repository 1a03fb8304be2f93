/* MAT version 5 after The MathWorks, MAT-File Format (2015): 128 bytes of header, then one miMATRIX element for each variable, made of
 * flags, dims, name and data, each with a tag of type and bytes and padded to 8.  Data are stored by column. */
#include "formats/export_mat.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

enum { MI_INT8 = 1, MI_UINT8 = 2, MI_INT32 = 5, MI_UINT32 = 6, MI_SINGLE = 7, MI_DOUBLE = 9, MI_INT64 = 12, MI_MATRIX = 14,
       MI_UTF8 = 16 };
enum { MX_CHAR = 4, MX_DOUBLE = 6, MX_SINGLE = 7, MX_UINT8 = 9, MX_INT32 = 12, MX_INT64 = 14, MX_COMPLEX = 0x800 };
enum { MAT_LARGEST = INT32_MAX };

#define HEADER_NAME "vxf_header"

static const struct { uint32_t class, data; size_t size; } types[VXF_TYPES] = {
    [VXF_F64] = {MX_DOUBLE, MI_DOUBLE, 8}, [VXF_F32] = {MX_SINGLE, MI_SINGLE, 4}, [VXF_I64] = {MX_INT64, MI_INT64, 8},
    [VXF_I32] = {MX_INT32, MI_INT32, 4},   [VXF_U8] = {MX_UINT8, MI_UINT8, 1},    [VXF_C128] = {MX_DOUBLE | MX_COMPLEX, MI_DOUBLE, 8},
};

static uint32_t pad(uint64_t n)
{
    return (uint32_t)((n + 7) / 8 * 8);
}

/* A tag, then n bytes padded to 8. */
static void put(FILE *out, uint32_t type, const void *data, uint32_t n)
{
    static const char zero[8];
    uint32_t tag[2] = {type, n};

    fwrite(tag, sizeof tag, 1, out);
    fwrite(data, 1, n, out);
    fwrite(zero, 1, pad(n) - n, out);
}

static void put_preamble(FILE *out)
{
    static const char text[] = "MATLAB 5.0 MAT-file, written by Veksel";
    char head[128];
    uint16_t version[2] = {0x0100, 'M' << 8 | 'I'};

    memset(head, ' ', 116);
    memcpy(head, text, sizeof text - 1);
    memset(head + 116, 0, 8);
    memcpy(head + 124, version, sizeof version);
    fwrite(head, sizeof head, 1, out);
}

static void name_of(const char *name, char *to)
{
    snprintf(to, VXF_NAME + 1, "%s%s", isalpha((unsigned char)*name) ? "" : "x", name);
    for (; *to; to++)
        if (!isalnum((unsigned char)*to))
            *to = '_';
}

/* Part 0 or 1 (imaginary) of all elements in order of columns: the first subscript runs fastest. */
static void put_data(const struct vxf_array *a, uint32_t type, int part, FILE *out)
{
    static const char zero[8];
    size_t size = types[a->type].size, each = vxf_type_size(a->type);
    int64_t count = vxf_count(a), index[VXF_DIMS] = {0}, stride[VXF_DIMS], at = 0;
    uint32_t tag[2] = {type, (uint32_t)((uint64_t)count * size)};

    for (int64_t k = a->ndim, n = 1; k > 0; n *= a->dim[--k])
        stride[k - 1] = n;
    fwrite(tag, sizeof tag, 1, out);
    for (int64_t i = 0; i < count; i++) {
        fwrite((const char *)a->data + (size_t)at * each + (size_t)part * size, size, 1, out);
        for (int k = 0; k < a->ndim; k++) {
            at += stride[k];
            if (++index[k] < a->dim[k])
                break;
            at -= index[k] * stride[k];
            index[k] = 0;
        }
    }
    fwrite(zero, 1, pad(tag[1]) - tag[1], out);
}

static void put_variable(const struct vxf_array *a, const char *name, FILE *out)
{
    int text = a->type == VXF_U8 && strcmp(a->unit, "text") == 0;
    uint32_t class = text ? MX_CHAR : types[a->type].class, type = text ? MI_UTF8 : types[a->type].data;
    uint32_t flags[2] = {class, 0}, parts = a->type == VXF_C128 ? 2 : 1;
    uint64_t bytes = (uint64_t)vxf_count(a) * types[a->type].size;
    int ndim = a->ndim < 2 ? 2 : a->ndim;
    int32_t dim[VXF_DIMS] = {1, 1};
    uint32_t matrix[2] = {MI_MATRIX};

    for (int k = 0; k < a->ndim; k++)
        dim[k] = (int32_t)a->dim[k];
    matrix[1] = (uint32_t)(8 + sizeof flags + 8 + pad((uint64_t)ndim * 4) + 8 + pad(strlen(name)) + parts * (8 + pad(bytes)));
    fwrite(matrix, sizeof matrix, 1, out);
    put(out, MI_UINT32, flags, sizeof flags);
    put(out, MI_INT32, dim, (uint32_t)ndim * 4);
    put(out, MI_INT8, name, (uint32_t)strlen(name));
    for (uint32_t part = 0; part < parts; part++)
        put_data(a, type, (int)part, out);
}

static const char *check(const struct vxf_list *list)
{
    char name[VXF_NAME + 1], other[VXF_NAME + 1];

    for (int i = 0; i < list->n; i++) {
        const struct vxf_array *a = &list->item[i];
        uint64_t bytes = (uint64_t)vxf_count(a) * vxf_type_size(a->type);
        name_of(a->name, name);
        if (bytes > MAT_LARGEST - 256)
            return reason("%s is too large for a MAT file of version 5, use --hdf5", a->name);
        for (int k = 0; k < a->ndim; k++)
            if (a->dim[k] > INT32_MAX)
                return reason("%s is too long for a MAT file of version 5, use --hdf5", a->name);
        for (int j = 0; j <= i; j++) {
            name_of(j < i ? list->item[j].name : HEADER_NAME, other);
            if (strcmp(name, other) == 0)
                return reason("two variables would be called %s", name);
        }
    }
    return NULL;
}

const char *export_mat(const struct vxf_list *list, const char *header, FILE *out)
{
    const char *why = check(list);
    struct vxf_array text = {.type = VXF_U8, .unit = "text", .ndim = 2, .dim = {1, (int64_t)strlen(header)}, .data = header};
    char name[VXF_NAME + 1];

    if (why)
        return why;
    put_preamble(out);
    for (int i = 0; i < list->n; i++) {
        name_of(list->item[i].name, name);
        put_variable(&list->item[i], name, out);
    }
    put_variable(&text, HEADER_NAME, out);
    return NULL;
}
