/* The container of every binary file of Veksel: vxf(5).
 *
 *   preamble  64 bytes: magic, byte order, version, kind, length of header, size of file, xxh64 of header
 *   header    text, "KEY= value" lines, one ARRAY line per array, SERIES and TAIL lines in a stream
 *   arrays    little-endian, 64-byte aligned, in the order of the ARRAY lines, each with its xxh64
 *   blocks    only in a stream: records of all SERIES, appended; an end block carries the TAIL arrays
 *
 * Functions return NULL or the reason why not (formats/reason.h).  Nothing here exits or prints. */
#ifndef VX_FORMATS_VXF_H
#define VX_FORMATS_VXF_H

#include <stdint.h>
#include <stdio.h>

#include "formats/reason.h"

enum vxf_type { VXF_F64, VXF_F32, VXF_I64, VXF_I32, VXF_U8, VXF_C128, VXF_TYPES };

enum { VXF_DIMS = 6, VXF_NAME = 32, VXF_UNIT = 16, VXF_KIND = 8 };

struct vxf_array {
    char name[VXF_NAME];     /* printable, without blanks; stands once in a file */
    char unit[VXF_UNIT];     /* "m", "N/m", "1" where there is none, "text" for u8 rows of NUL-padded text */
    enum vxf_type type;
    int ndim;                /* 0 is a scalar */
    int64_t dim[VXF_DIMS];   /* [ndim], the last varies fastest; of a SERIES: of one record */
    uint64_t offset;         /* bytes from the end of the header, a multiple of 64 */
    uint64_t hash;           /* xxh64 of the data */
    const void *data;
};

struct vxf_list {
    int n;
    struct vxf_array *item;  /* [n] */
};

/* ---- reading ---- */

struct vxf {
    char kind[VXF_KIND + 1];
    char *header;            /* NUL-terminated */
    struct vxf_list array, series, tail;
    int64_t records;         /* in the series */
    int stream;              /* blocks follow the arrays */
    int complete;            /* the end block was seen; always 1 without blocks */
    unsigned char *base;     /* the whole file, mapped or read */
    size_t size;
    int mapped;
    int blocks;
    size_t *block;           /* [blocks] offsets of the block heads in base */
    void **joined;           /* [series.n] records of one series joined, made when asked for */
};

/* Opens path ("-" is standard input) and checks all of it: preamble, header, sizes, order, padding and
 * every hash.  Nothing is left open on failure. */
const char *vxf_open(struct vxf *f, const char *path);
void vxf_close(struct vxf *f);

/* The same for a regular file already open, read instead of mapped: others may replace, remove or cut it short meanwhile. */
const char *vxf_open_fd(struct vxf *f, int fd);
/* Only preamble and header, checked: lines, names and shapes, for vxf_line, vxf_key and vxf_find, but no data. */
const char *vxf_open_header(struct vxf *f, int fd);

/* The kind must be this one. */
const char *vxf_is(const struct vxf *f, const char *kind);

/* Value of the first line "key= value", without the newline, into value[size]. */
const char *vxf_key(const struct vxf *f, const char *key, char *value, size_t size);
const char *vxf_number(const struct vxf *f, const char *key, double *value);

/* The k-th line "key= value" from the start of the header, or NULL; *length excludes the newline. */
const char *vxf_line(const struct vxf *f, const char *key, int k, int *length);

/* Array `name` of this type, unit and shape.  A dim of -1 is filled in from the file, any other must agree.
 * Floating-point numbers are finite. */
const char *vxf_get(const struct vxf *f, const char *name, enum vxf_type type, const char *unit, int ndim,
                    int64_t *dim, const void **data);

/* The same for a series (*records is its length) and for a tail array. */
const char *vxf_get_series(struct vxf *f, const char *name, enum vxf_type type, const char *unit, int ndim,
                           int64_t *dim, const void **data);
const char *vxf_get_tail(const struct vxf *f, const char *name, enum vxf_type type, const char *unit, int ndim,
                         int64_t *dim, const void **data);

const struct vxf_array *vxf_find(const struct vxf_list *list, const char *name);

/* The n arrays named, of whichever list, or all where n is 0.  A series has its records as first dim; the tail of a file that is not
 * complete is left out.  The caller frees to->item; the data belong to f. */
const char *vxf_select(struct vxf *f, int n, char *const *name, struct vxf_list *to);

/* Hash of what the file holds: keys, names, types, shapes, units and data, not its history. */
uint64_t vxf_content(const struct vxf *f);

/* The header line tells how the file was made (SOFTWARE, CMD, INPUT), not what it holds. */
int vxf_is_history(const char *line);

size_t vxf_type_size(enum vxf_type type);
const char *vxf_type_name(enum vxf_type type);
int64_t vxf_count(const struct vxf_array *a); /* elements of the array, or of one record */

/* ---- writing ---- */

struct vxf_out {
    char kind[VXF_KIND + 1];
    char *text;              /* the KEY= lines so far */
    size_t length, room;
    struct vxf_list array, series, tail;
    const char *why;         /* first failure of a put, told by vxf_write or vxf_stream_begin */
};

void vxf_out_begin(struct vxf_out *o, const char *kind);
void vxf_out_free(struct vxf_out *o);

/* Adds a line "key= ..." to the header. */
void vxf_put_key(struct vxf_out *o, const char *key, const char *format, ...) VX_PRINTF(3, 4);

/* Adds an array; data must live until the file is written.  A floating-point number that is not finite
 * is refused, so NaN never reaches a file. */
void vxf_put(struct vxf_out *o, const char *name, enum vxf_type type, const char *unit, int ndim,
             const int64_t *dim, const void *data);

/* Copies the history of an input: its CMD lines, and one line INPUT= kind hash. */
void vxf_put_input(struct vxf_out *o, const struct vxf *input);

const char *vxf_write(const struct vxf_out *o, FILE *stream);

/* ---- streams: long histories, readable while they grow ---- */

struct vxf_stream {
    FILE *file;
    struct vxf_out *out;
    uint64_t start;          /* bytes before the first block */
    uint64_t bytes;          /* written so far */
    int64_t blocks, records;
};

/* Announce what follows the arrays, before vxf_stream_begin; dims are those of one record. */
void vxf_put_series(struct vxf_out *o, const char *name, enum vxf_type type, const char *unit, int ndim,
                    const int64_t *dim);
void vxf_put_tail(struct vxf_out *o, const char *name, enum vxf_type type, const char *unit, int ndim,
                  const int64_t *dim);

const char *vxf_stream_begin(struct vxf_stream *s, struct vxf_out *o, FILE *stream);
/* data[k] are `records` records of the k-th series, in the order they were put. */
const char *vxf_stream_block(struct vxf_stream *s, int64_t records, const void *const *data);
/* data[k] is the k-th tail array.  The size of the file goes into its preamble, but not on standard output. */
const char *vxf_stream_end(struct vxf_stream *s, const void *const *data);

#endif
