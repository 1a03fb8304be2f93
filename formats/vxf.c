/* Element types, sizes, hashes and look-ups: what reading and writing share. */
#include "formats/vxf_disk.h"

#include <stddef.h>
#include <string.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

static const struct {
    const char *name;
    size_t size;
} types[VXF_TYPES] = {
    [VXF_F64] = {"f64", 8}, [VXF_F32] = {"f32", 4}, [VXF_I64] = {"i64", 8},
    [VXF_I32] = {"i32", 4}, [VXF_U8] = {"u8", 1},   [VXF_C128] = {"c128", 16},
};

size_t vxf_type_size(enum vxf_type type)
{
    return types[type].size;
}

const char *vxf_type_name(enum vxf_type type)
{
    return types[type].name;
}

uint64_t vxf_hash(const void *data, size_t n)
{
    return XXH64(data, n, 0);
}

uint64_t vxf_header_hash(const struct vxf_preamble *p, const char *text)
{
    XXH64_state_t state;

    XXH64_reset(&state, 0);
    XXH64_update(&state, p, offsetof(struct vxf_preamble, size));
    XXH64_update(&state, text, p->header);
    return XXH64_digest(&state);
}

uint64_t vxf_block_head_hash(const struct vxf_block *b)
{
    return vxf_hash(b, offsetof(struct vxf_block, head));
}

int64_t vxf_count(const struct vxf_array *a)
{
    int64_t n = 1;

    for (int i = 0; i < a->ndim; i++)
        n *= a->dim[i];
    return n;
}

uint64_t vxf_bytes(const struct vxf_array *a, int *overflow)
{
    uint64_t n = types[a->type].size;

    *overflow = 0;
    for (int i = 0; i < a->ndim; i++)
        if (a->dim[i] < 0 || __builtin_mul_overflow(n, (uint64_t)a->dim[i], &n) || n > INT64_MAX / 2) {
            *overflow = 1;
            return 0;
        }
    return n;
}

void vxf_dims_text(const struct vxf_array *a, char *text, size_t size)
{
    size_t used = 0;

    snprintf(text, size, "scalar");
    for (int i = 0; i < a->ndim && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%lld", i ? "x" : "", (long long)a->dim[i]);
}

const struct vxf_array *vxf_find(const struct vxf_list *list, const char *name)
{
    for (int i = 0; i < list->n; i++)
        if (strcmp(list->item[i].name, name) == 0)
            return &list->item[i];
    return NULL;
}

uint64_t vxf_payload_hash(const struct vxf_list *l, int64_t records, const void *const *data)
{
    static const unsigned char zero[VXF_ALIGN];
    XXH64_state_t state;
    int overflow;

    XXH64_reset(&state, 0);
    for (int i = 0; i < l->n; i++) {
        const uint64_t bytes = vxf_bytes(&l->item[i], &overflow) * (uint64_t)records;
        XXH64_update(&state, data[i], bytes);
        XXH64_update(&state, zero, vxf_pad(bytes) - bytes);
    }
    return XXH64_digest(&state);
}

/* 0 x is 0 or, where x is not finite, NaN, which every sum keeps.  Eight sums, so that they go in lanes. */
enum { SUMS = 8 };

static int finite_doubles(const double *x, int64_t n)
{
    double sum[SUMS] = {0};
    int64_t i = 0;

    for (; i + SUMS <= n; i += SUMS)
        for (int k = 0; k < SUMS; k++)
            sum[k] += 0 * x[i + k];
    for (; i < n; i++)
        sum[0] += 0 * x[i];
    for (int k = 1; k < SUMS; k++)
        sum[0] += sum[k];
    return sum[0] == 0;
}

static int finite_floats(const float *x, int64_t n)
{
    float sum[SUMS] = {0};
    int64_t i = 0;

    for (; i + SUMS <= n; i += SUMS)
        for (int k = 0; k < SUMS; k++)
            sum[k] += 0 * x[i + k];
    for (; i < n; i++)
        sum[0] += 0 * x[i];
    for (int k = 1; k < SUMS; k++)
        sum[0] += sum[k];
    return sum[0] == 0;
}

int vxf_finite(enum vxf_type type, const void *data, int64_t n)
{
    switch (type) {
    case VXF_F64:
        return finite_doubles(data, n);
    case VXF_C128:
        return finite_doubles(data, 2 * n);
    case VXF_F32:
        return finite_floats(data, n);
    default:
        return 1;
    }
}

int vxf_is_history(const char *line)
{
    static const char *const history[] = {"SOFTWARE= ", "CMD= ", "INPUT= "};

    for (size_t k = 0; k < sizeof history / sizeof *history; k++)
        if (strncmp(line, history[k], strlen(history[k])) == 0)
            return 1;
    return 0;
}

/* The ARRAY lines carry the hashes of the arrays; the blocks of a stream carry their own, its tail is hashed here. */
uint64_t vxf_content(const struct vxf *f)
{
    XXH64_state_t state;
    int overflow;

    XXH64_reset(&state, 0);
    XXH64_update(&state, f->kind, strlen(f->kind));
    for (const char *line = f->header, *end; *line; line = end + 1) {
        end = strchr(line, '\n');
        if (!vxf_is_history(line))
            XXH64_update(&state, line, (size_t)(end + 1 - line));
    }
    for (int i = 0; i < f->blocks; i++) {
        const struct vxf_block *b = (const void *)(f->base + f->block[i]);
        XXH64_update(&state, &b->hash, sizeof b->hash);
    }
    for (int i = 0; i < f->tail.n && f->complete; i++)
        XXH64_update(&state, f->tail.item[i].data, vxf_bytes(&f->tail.item[i], &overflow));
    return XXH64_digest(&state);
}
