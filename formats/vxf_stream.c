/* Appending to a long history: blocks of records, each with its hash, and an end block that carries the tail. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>

const char *vxf_stream_begin(struct vxf_stream *s, struct vxf_out *o, FILE *stream)
{
    *s = (struct vxf_stream){.file = stream, .out = o};
    return vxf_write_head(o, stream, &s->bytes);
}

/* One block of `each` records of each array of the list; `records` is what its head says. */
static const char *write_block(struct vxf_stream *s, const char *magic, const struct vxf_list *list, int64_t each,
                               int64_t records, const void *const *data)
{
    struct vxf_block b = {.index = (uint64_t)s->blocks, .records = records};
    const char *why;
    int overflow;

    memcpy(b.magic, magic, sizeof b.magic);
    for (int i = 0; i < list->n; i++) {
        if (!vxf_finite(list->item[i].type, data[i], vxf_count(&list->item[i]) * each))
            return reason("%s would hold a number that is not finite", list->item[i].name);
        b.bytes += vxf_pad(vxf_bytes(&list->item[i], &overflow) * (uint64_t)each);
    }
    b.hash = vxf_payload_hash(list, each, data);
    b.head = vxf_block_head_hash(&b);
    why = vxf_write_all(s->file, &b, sizeof b);
    for (int i = 0; i < list->n && !why; i++)
        why = vxf_write_padded(s->file, data[i], vxf_bytes(&list->item[i], &overflow) * (uint64_t)each);
    s->bytes += sizeof b + b.bytes;
    s->blocks++;
    if (!why && fflush(s->file) != 0)
        why = reason("write error: %s", strerror(errno));
    return why;
}

const char *vxf_stream_block(struct vxf_stream *s, int64_t records, const void *const *data)
{
    s->records += records;
    return records ? write_block(s, VXF_BLOCK_MAGIC, &s->out->series, records, records, data) : NULL;
}

const char *vxf_stream_end(struct vxf_stream *s, const void *const *data)
{
    const char *why = write_block(s, VXF_END_MAGIC, &s->out->tail, 1, s->records, data);

    if (!why && s->file != stdout && fseek(s->file, offsetof(struct vxf_preamble, size), SEEK_SET) == 0 &&
        fwrite(&s->bytes, sizeof s->bytes, 1, s->file) != 1)
        why = reason("write error: %s", strerror(errno));
    return why;
}
