/* Opening a container: everything is checked before anything is believed.
 *
 * The order matters: sizes against the file before reading, products for overflow before multiplying, hashes before
 * use.  A file that passes can be pointed into without another look. */
#include "formats/reason.h"
#include "formats/vxf_disk.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- bytes ---- */

static const char *slurp(struct vxf *f, int fd)
{
    size_t room = 0;

    for (;;) {
        if (f->size == room) {
            unsigned char *more = realloc(f->base, room = room ? 2 * room : 1 << 16);
            if (!more)
                return REASON_MEMORY;
            f->base = more;
        }
        ssize_t n = read(fd, f->base + f->size, room - f->size);
        if (n == 0)
            return NULL;
        if (n < 0 && errno != EINTR)
            return strerror(errno);
        f->size += n > 0 ? (size_t)n : 0;
        if (f->size >= 8 && memcmp(f->base, VXF_MAGIC, 4) != 0)
            return "not a Veksel file";
    }
}

static const char *map_or_slurp(struct vxf *f, const char *path)
{
    const char *why = NULL;
    struct stat st;
    int fd = strcmp(path, "-") == 0 ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);

    if (fd < 0)
        return strerror(errno);
    if (fstat(fd, &st) == 0 && S_ISREG(st.st_mode) && fd != STDIN_FILENO) {
        void *p = st.st_size > 0 ? mmap(NULL, (size_t)st.st_size, PROT_READ, MAP_PRIVATE, fd, 0) : MAP_FAILED;
        if (p != MAP_FAILED) {
            f->base = p;
            f->size = (size_t)st.st_size;
            f->mapped = 1;
        } else
            why = st.st_size > 0 ? strerror(errno) : "empty file";
    } else
        why = slurp(f, fd);
    if (fd != STDIN_FILENO)
        close(fd);
    return why;
}

/* ---- data ---- */

static int all_zero(const unsigned char *p, uint64_t n)
{
    while (n && *p == 0)
        p++, n--;
    return n == 0;
}

/* The data of a at byte `at` of the file; *end is the next 64-byte boundary behind it. */
static const char *place(const struct vxf *f, struct vxf_array *a, uint64_t at, uint64_t *end)
{
    int overflow;
    uint64_t bytes = vxf_bytes(a, &overflow);

    if (overflow || bytes > f->size || at > f->size || vxf_pad(bytes) > f->size - at)
        return reason("truncated: array %s does not fit in the file", a->name);
    a->data = f->base + at;
    *end = at + vxf_pad(bytes);
    if (!all_zero(f->base + at + bytes, *end - at - bytes))
        return reason("damaged: padding after array %s is not zero", a->name);
    return NULL;
}

static const char *place_arrays(struct vxf *f, uint64_t *end)
{
    uint64_t start = *end;

    for (int i = 0; i < f->array.n; i++) {
        struct vxf_array *a = &f->array.item[i];
        int overflow;
        const char *why;
        if (a->offset != *end - start)
            return reason("damaged: array %s is not where it belongs", a->name);
        if ((why = place(f, a, *end, end)))
            return why;
        if (vxf_hash(a->data, vxf_bytes(a, &overflow)) != a->hash)
            return reason("damaged: the hash of array %s differs", a->name);
    }
    return NULL;
}

/* Bytes of n records of all series, each padded to 64; 0 with *overflow set where that is more than the file. */
static uint64_t payload(const struct vxf *f, int64_t n, int *overflow)
{
    uint64_t sum = 0;

    *overflow = n <= 0;
    for (int i = 0; i < f->series.n && !*overflow; i++) {
        uint64_t bytes = vxf_bytes(&f->series.item[i], overflow);
        *overflow = *overflow || __builtin_mul_overflow(bytes, (uint64_t)n, &bytes) || bytes > f->size;
        sum += *overflow ? 0 : vxf_pad(bytes);
    }
    return *overflow ? 0 : sum;
}

static const char *place_tail(struct vxf *f, uint64_t at, uint64_t end)
{
    for (int i = 0; i < f->tail.n; i++) {
        const char *why = place(f, &f->tail.item[i], at, &at);
        if (why)
            return why;
    }
    f->complete = 1;
    return at == end ? NULL : "damaged end block";
}

/* One block at *at: the end block sets complete.  *whole is 0 where the file ends inside the block. */
static const char *place_block(struct vxf *f, uint64_t *at, int *whole)
{
    const struct vxf_block *b = (const void *)(f->base + *at);
    uint64_t next;
    size_t *more;
    int last, overflow;

    *whole = f->size - *at >= sizeof *b;
    if (!*whole)
        return NULL;
    last = memcmp(b->magic, VXF_END_MAGIC, sizeof b->magic) == 0;
    if ((!last && memcmp(b->magic, VXF_BLOCK_MAGIC, sizeof b->magic) != 0) || vxf_block_head_hash(b) != b->head ||
        b->index != (uint64_t)f->blocks || b->zero[0] || b->zero[1])
        return reason("damaged: head of block %d", f->blocks);
    *whole = b->bytes <= f->size - *at - sizeof *b;
    if (!*whole)
        return NULL;
    if (vxf_hash(b + 1, b->bytes) != b->hash)
        return reason("damaged: the hash of block %d differs", f->blocks);
    next = *at + sizeof *b + b->bytes;
    if (last) {
        if (b->records != f->records)
            return "damaged: records are missing";
        *at = next;
        return place_tail(f, next - b->bytes, next);
    }
    if (payload(f, b->records, &overflow) != b->bytes || overflow ||
        __builtin_add_overflow(f->records, b->records, &f->records))
        return reason("damaged: block %d has another size than its records", f->blocks);
    if (!(more = realloc(f->block, (size_t)(f->blocks + 1) * sizeof *more)))
        return REASON_MEMORY;
    f->block = more;
    f->block[f->blocks++] = *at;
    *at = next;
    return NULL;
}

/* A stream without its end block is what a run leaves when killed: whole blocks count, the rest is dropped. */
static const char *place_blocks(struct vxf *f, uint64_t *at, int finished)
{
    const char *why = NULL;
    int whole = 1;

    while (!why && whole && !f->complete && *at < f->size)
        why = place_block(f, at, &whole);
    if (!why && finished && !f->complete)
        why = "damaged: the end block is missing";
    if (!f->complete)
        *at = f->size;
    return why;
}

const char *vxf_check(struct vxf *f)
{
    struct vxf_preamble p;
    const char *why;
    uint64_t end;

    if (f->size >= sizeof p)
        memcpy(&p, f->base, sizeof p);
    if ((why = vxf_check_preamble(f, &p)) || (why = vxf_parse_header(f, &p)))
        return why;
    end = sizeof p + vxf_pad(p.header);
    if (end > f->size || !all_zero(f->base + sizeof p + p.header, end - sizeof p - p.header))
        return "damaged: padding after the header";
    if ((why = place_arrays(f, &end)))
        return why;
    if (f->stream)
        why = place_blocks(f, &end, p.size != 0);
    else if (p.size == 0)
        why = "damaged preamble";
    else
        f->complete = 1;
    if (!why && end != f->size)
        why = "longer than it should be";
    return why;
}

const char *vxf_open(struct vxf *f, const char *path)
{
    const char *why;

    memset(f, 0, sizeof *f);
    why = map_or_slurp(f, path);
    if (!why)
        why = vxf_check(f);
    if (why)
        vxf_close(f);
    return why;
}

void vxf_close(struct vxf *f)
{
    if (f->mapped)
        munmap(f->base, f->size);
    else
        free(f->base);
    for (int i = 0; f->joined && i < f->series.n; i++)
        free(f->joined[i]);
    free(f->joined);
    free(f->block);
    free(f->header);
    free(f->array.item);
    free(f->series.item);
    free(f->tail.item);
    memset(f, 0, sizeof *f);
}
