/* Columns side by side; which arrays fit is decided before the first byte goes out. */
#include "formats/export_csv.h"

#include <inttypes.h>
#include <string.h>

#include "formats/reason.h"

static int is_text(const struct vxf_array *a)
{
    return a->type == VXF_U8 && a->ndim > 0 && strcmp(a->unit, "text") == 0;
}

/* The last dim of a text counts its letters. */
static int cell_dims(const struct vxf_array *a)
{
    return a->ndim - is_text(a);
}

static int64_t rows(const struct vxf_array *a)
{
    return cell_dims(a) > 0 ? a->dim[0] : 1;
}

static int64_t columns(const struct vxf_array *a)
{
    int64_t n = 1;

    for (int k = 1; k < cell_dims(a); k++)
        n *= a->dim[k];
    return n;
}

static const char *check_rows(const struct vxf_list *list)
{
    for (int i = 1; i < list->n; i++)
        if (rows(&list->item[i]) != rows(&list->item[0]))
            return reason("%s has %" PRId64 " rows, %s has %" PRId64 ": name arrays of one length", list->item[0].name,
                          rows(&list->item[0]), list->item[i].name, rows(&list->item[i]));
    return NULL;
}

/* ---- cells ---- */

/* In quotes where a comma or a quote stands inside. */
static void put_text(const char *text, size_t n, FILE *out)
{
    int quoted = 0;

    for (size_t i = 0; i < n; i++)
        quoted = quoted || text[i] == ',' || text[i] == '"' || text[i] == '\n' || text[i] == '\r';
    if (quoted)
        putc('"', out);
    for (size_t i = 0; i < n; i++) {
        if (text[i] == '"')
            putc('"', out);
        putc(text[i], out);
    }
    if (quoted)
        putc('"', out);
}

/* "name[2][1].re (unit)" for column c. */
static void put_title(const struct vxf_array *a, int64_t c, const char *part, FILE *out)
{
    char text[256], index[6 * 24] = "", one[24];

    for (int k = cell_dims(a) - 1; k > 0; c /= a->dim[k--]) {
        snprintf(one, sizeof one, "[%" PRId64 "]", c % a->dim[k] + 1);
        memmove(index + strlen(one), index, strlen(index) + 1);
        memcpy(index, one, strlen(one));
    }
    snprintf(text, sizeof text, "%s%s%s (%s)", a->name, index, part, a->unit);
    put_text(text, strlen(text), out);
}

static void put_titles(const struct vxf_array *a, FILE *out)
{
    for (int64_t c = 0; c < columns(a); c++) {
        if (c)
            putc(',', out);
        put_title(a, c, a->type == VXF_C128 ? ".re" : "", out);
        if (a->type == VXF_C128) {
            putc(',', out);
            put_title(a, c, ".im", out);
        }
    }
}

static void put_cell(const struct vxf_array *a, int64_t i, FILE *out)
{
    const double *x = a->data;
    size_t room = is_text(a) ? (size_t)a->dim[a->ndim - 1] : 0;

    if (is_text(a)) {
        const char *text = (const char *)a->data + (size_t)i * room;
        put_text(text, strnlen(text, room), out);
        return;
    }
    switch (a->type) {
    case VXF_F64:
        fprintf(out, "%.17g", x[i]);
        break;
    case VXF_F32:
        fprintf(out, "%.9g", ((const float *)a->data)[i]);
        break;
    case VXF_I64:
        fprintf(out, "%" PRId64, ((const int64_t *)a->data)[i]);
        break;
    case VXF_I32:
        fprintf(out, "%" PRId32, ((const int32_t *)a->data)[i]);
        break;
    case VXF_U8:
        fprintf(out, "%d", ((const uint8_t *)a->data)[i]);
        break;
    case VXF_C128:
        fprintf(out, "%.17g,%.17g", x[2 * i], x[2 * i + 1]);
        break;
    case VXF_TYPES:
        break;
    }
}

static void put_cells(const struct vxf_array *a, int64_t row, FILE *out)
{
    int64_t n = columns(a);

    for (int64_t c = 0; c < n; c++) {
        if (c)
            putc(',', out);
        put_cell(a, row * n + c, out);
    }
}

const char *export_csv(const struct vxf_list *list, FILE *out)
{
    const char *why = check_rows(list);
    int64_t n = list->n ? rows(&list->item[0]) : 0;

    if (why)
        return why;
    for (int64_t row = -1; row < n; row++) {
        for (int i = 0, first = 1; i < list->n; i++) {
            if (columns(&list->item[i]) == 0)
                continue;
            if (!first)
                putc(',', out);
            first = 0;
            if (row < 0)
                put_titles(&list->item[i], out);
            else
                put_cells(&list->item[i], row, out);
        }
        putc('\n', out);
    }
    return NULL;
}
