/* What is on disk: shared by the parts of vxf, by nothing else.  All numbers little-endian. */
#ifndef VX_FORMATS_VXF_DISK_H
#define VX_FORMATS_VXF_DISK_H

#include "formats/vxf.h"

#if defined __BYTE_ORDER__ && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "the container is little-endian and is read in place"
#endif

enum { VXF_ALIGN = 64, VXF_VERSION = 1, VXF_ORDER = 0x01020304 };
#define VXF_HEADER_MAX ((uint64_t)16 << 20)

/* High bit, CR LF, end-of-file and LF: a transfer as text cannot pass unseen. */
#define VXF_MAGIC "\x89VXF\r\n\x1a\n"
#define VXF_BLOCK_MAGIC "\x89VXB\r\n\x1a\n"
#define VXF_END_MAGIC "\x89VXE\r\n\x1a\n"

struct vxf_preamble {
    char magic[8];
    uint32_t order;    /* VXF_ORDER */
    uint32_t version;  /* VXF_VERSION */
    char kind[8];      /* zero-padded */
    uint64_t header;   /* bytes of header text */
    uint64_t size;     /* bytes of the file; 0 where unknown: a stream on a pipe, or not complete */
    uint64_t hash;     /* xxh64 of the 32 bytes from magic to header, then the header text */
    uint64_t zero[2];
};

struct vxf_block {
    char magic[8];
    uint64_t index;    /* 0, 1, ... */
    int64_t records;   /* in this block; of the end block: in all */
    uint64_t bytes;    /* of payload, padded to 64 */
    uint64_t hash;     /* xxh64 of the payload */
    uint64_t head;     /* xxh64 of the five fields before */
    uint64_t zero[2];
};

_Static_assert(sizeof(struct vxf_preamble) == VXF_ALIGN, "preamble is 64 bytes");
_Static_assert(sizeof(struct vxf_block) == VXF_ALIGN, "block head is 64 bytes");

/* n rounded up to 64. */
static inline uint64_t vxf_pad(uint64_t n)
{
    return (n + VXF_ALIGN - 1) / VXF_ALIGN * VXF_ALIGN;
}

uint64_t vxf_hash(const void *data, size_t n);
uint64_t vxf_header_hash(const struct vxf_preamble *p, const char *text); /* text[p->header] */
uint64_t vxf_block_head_hash(const struct vxf_block *b);
uint64_t vxf_payload_hash(const struct vxf_list *l, int64_t records, const void *const *data); /* of a block of them, padded */

/* Bytes of one array, or of one record of a series; 0 with *overflow set where it does not fit. */
uint64_t vxf_bytes(const struct vxf_array *a, int *overflow);

/* The dims as text, "3x4" or "scalar". */
void vxf_dims_text(const struct vxf_array *a, char *text, size_t size);

/* All of f->base[f->size]. */
const char *vxf_check(struct vxf *f);
/* Parts of it: the preamble against the size of the file, then the header into lists. */
const char *vxf_check_preamble(const struct vxf *f, const struct vxf_preamble *p);
const char *vxf_parse_header(struct vxf *f, const struct vxf_preamble *p);

/* The records of series k from all blocks, one after another, in f->joined[k]. */
const char *vxf_join(struct vxf *f, int k);

/* Parts of writing: preamble, header and arrays; *size is their length, written into the preamble unless blocks follow. */
const char *vxf_write_head(const struct vxf_out *o, FILE *stream, uint64_t *size);
const char *vxf_write_all(FILE *stream, const void *data, size_t n);
const char *vxf_write_padded(FILE *stream, const void *data, uint64_t n); /* to a multiple of 64 */

/* Every number of data[n] is finite; whole numbers always are. */
int vxf_finite(enum vxf_type type, const void *data, int64_t n);

#endif
