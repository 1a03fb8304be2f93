/* The container: what is written is read, and nothing else is: truncated, flipped and forged files are refused. */
#include <fcntl.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/vxf_disk.h"
#include "tests/kernel/tap.h"

static char path[] = "/tmp/vxf-test.XXXXXX";

/* A file in memory. */
struct image {
    unsigned char *byte;
    size_t n;
};

static struct image load(void)
{
    struct image m = {0};
    FILE *file = fopen(path, "rb");

    fseek(file, 0, SEEK_END);
    m.n = (size_t)ftell(file);
    rewind(file);
    m.byte = malloc(m.n + 1);
    if (fread(m.byte, 1, m.n, file) != m.n)
        abort();
    fclose(file);
    return m;
}

static void store(const unsigned char *byte, size_t n)
{
    FILE *file = fopen(path, "wb");

    if (fwrite(byte, 1, n, file) != n)
        abort();
    fclose(file);
}

static const char *write_out(const struct vxf_out *o)
{
    FILE *file = fopen(path, "wb");
    const char *why = vxf_write(o, file);

    fclose(file);
    return why;
}

static int says(const char *why, const char *part)
{
    if (why && strstr(why, part))
        return 1;
    printf("# got: %s; should say: %s\n", why ? why : "no failure", part);
    return 0;
}

/* ---- plain files ---- */

static const double f64[6] = {1, -0.0, 1e-308, 3.5, 1e308, -7};
static const float f32[3] = {1.5f, -2, 1e-38f};
static const int64_t i64[2] = {INT64_MIN, INT64_MAX};
static const int32_t i32[1] = {-5};
static const uint8_t u8[5] = "nose";
static const double c128[4] = {1, 2, -3, 4};

static void put_every_type(struct vxf_out *o)
{
    vxf_out_begin(o, "test");
    vxf_put_key(o, "SIDE", "%c", 'l');
    vxf_put(o, "f64", VXF_F64, "m", 2, (int64_t[]){2, 3}, f64);
    vxf_put(o, "f32", VXF_F32, "N/m", 1, (int64_t[]){3}, f32);
    vxf_put(o, "i64", VXF_I64, "1", 1, (int64_t[]){2}, i64);
    vxf_put(o, "i32", VXF_I32, "1", 0, NULL, i32);
    vxf_put(o, "u8", VXF_U8, "text", 6, (int64_t[]){1, 1, 1, 1, 1, 5}, u8);
    vxf_put(o, "c128", VXF_C128, "m/N", 1, (int64_t[]){2}, c128);
    vxf_put(o, "none", VXF_F64, "m", 2, (int64_t[]){0, 4}, NULL);
}

static int same(const struct vxf *f, const char *name, const void *data, size_t n)
{
    const struct vxf_array *a = vxf_find(&f->array, name);

    return a && (uintptr_t)a->data % VXF_ALIGN == 0 && memcmp(a->data, data, n) == 0;
}

static void round_trip(void)
{
    struct vxf_out o;
    struct vxf f;
    int64_t dim[2] = {-1, 3};
    const void *data;
    double value;
    char text[8];

    put_every_type(&o);
    ok(write_out(&o) == NULL && vxf_open(&f, path) == NULL, "every type is written and read");
    ok(f.array.n == 7 && f.complete && !f.stream && strcmp(f.kind, "test") == 0, "seven arrays, complete, of their kind");
    ok(same(&f, "f64", f64, sizeof f64) && same(&f, "f32", f32, sizeof f32) && same(&f, "i64", i64, sizeof i64) &&
       same(&f, "i32", i32, sizeof i32) && same(&f, "u8", u8, sizeof u8) && same(&f, "c128", c128, sizeof c128),
       "the same bits, 64-byte aligned");
    ok(!vxf_get(&f, "f64", VXF_F64, "m", 2, dim, &data) && dim[0] == 2 && memcmp(data, f64, sizeof f64) == 0, "a dim of -1 is filled in");
    ok(says(vxf_get(&f, "f63", VXF_F64, "m", 2, dim, &data), "array f63 is missing"), "a missing array is named");
    ok(says(vxf_get(&f, "f64", VXF_F32, "m", 2, dim, &data), "is f64, should be f32"), "another type is refused");
    ok(says(vxf_get(&f, "f64", VXF_F64, "mm", 2, dim, &data), "has unit m, should have mm"), "another unit is refused");
    ok(says(vxf_get(&f, "f64", VXF_F64, "m", 1, dim, &data), "has 2 dims"), "another number of dims is refused");
    ok(says(vxf_get(&f, "f64", VXF_F64, "m", 2, (int64_t[]){2, 4}, &data), "dim 2 is 3, should be 4"), "another dim is refused");
    ok(says(vxf_is(&f, "trk"), ".test file where a .trk"), "another kind is refused");
    ok(!vxf_key(&f, "SIDE", text, sizeof text) && strcmp(text, "l") == 0, "a key is read");
    ok(says(vxf_number(&f, "SIDE", &value), "is not a number"), "a key that is no number is refused");
    ok(says(vxf_key(&f, "SIDEX", text, sizeof text), "is missing"), "a missing key is named");
    vxf_close(&f);
    vxf_out_free(&o);
}

/* ---- what the writer refuses ---- */

static const char *put_one(const char *name, const char *unit, enum vxf_type type, int ndim, const int64_t *dim, const void *data)
{
    static char why[256];
    struct vxf_out o;

    vxf_out_begin(&o, "test");
    vxf_put(&o, "first", VXF_I32, "1", 0, NULL, i32);
    vxf_put(&o, name, type, unit, ndim, dim, data);
    snprintf(why, sizeof why, "%s", o.why ? o.why : "");
    vxf_out_free(&o);
    return *why ? why : NULL;
}

static void refusals_of_the_writer(void)
{
    const double bad[2] = {1, NAN}, endless[2] = {-INFINITY, 1};
    const float badf[1] = {NAN};
    const int64_t seven[7] = {1, 1, 1, 1, 1, 1, 1}, huge[2] = {INT64_MAX / 2, 4}, negative[1] = {-1}, two[1] = {2}, one[1] = {1};
    struct vxf_out o;

    ok(says(put_one("x", "m", VXF_F64, 1, two, bad), "not finite"), "NaN in f64 is refused");
    ok(says(put_one("x", "m", VXF_F64, 1, two, endless), "not finite"), "infinity in f64 is refused");
    ok(says(put_one("x", "m", VXF_F32, 1, one, badf), "not finite"), "NaN in f32 is refused");
    ok(says(put_one("x", "m", VXF_C128, 1, one, bad), "not finite"), "NaN in an imaginary part is refused");
    ok(!put_one("x", "m", VXF_I64, 1, two, bad), "bits of NaN are a whole number like any other");
    ok(says(put_one("first", "m", VXF_I32, 0, NULL, i32), "twice"), "a name cannot stand twice");
    ok(says(put_one("a b", "m", VXF_I32, 0, NULL, i32), "BUG"), "a name with a blank is refused");
    ok(says(put_one("", "m", VXF_I32, 0, NULL, i32), "BUG"), "an empty name is refused");
    ok(says(put_one("x", "N m", VXF_I32, 0, NULL, i32), "BUG"), "a unit with a blank is refused");
    ok(says(put_one("x", "", VXF_I32, 0, NULL, i32), "BUG"), "an empty unit is refused");
    ok(says(put_one("a-name-of-thirty-two-characters-", "m", VXF_I32, 0, NULL, i32), "BUG"), "a name too long is refused, not cut");
    ok(says(put_one("x", "m", VXF_I32, 7, seven, i32), "BUG"), "seven dims are refused");
    ok(says(put_one("x", "m", VXF_F64, 2, huge, f64), "too large"), "dims whose product overflows are refused");
    ok(says(put_one("x", "m", VXF_F64, 1, negative, f64), "too large"), "a negative dim is refused");
    vxf_out_begin(&o, "test");
    vxf_put_tail(&o, "t", VXF_F64, "m", 0, NULL);
    ok(says(write_out(&o), "tail without a series"), "a tail needs a series");
    vxf_out_free(&o);
}

/* ---- streams ---- */

static const double time_[5] = {0, 1, 2, 3, 4};
static const float force[10] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};

/* Five records in blocks of 2, 0, 1 and 2. */
static const char *write_stream(void)
{
    const double largest[3] = {7, 8, 9};
    const int64_t records[4] = {2, 0, 1, 2};
    struct vxf_out o;
    struct vxf_stream s;
    FILE *file = fopen(path, "wb");
    const char *why;
    int64_t at = 0;

    vxf_out_begin(&o, "run");
    vxf_put(&o, "x", VXF_F64, "m", 1, (int64_t[]){2}, f64);
    vxf_put_series(&o, "time", VXF_F64, "s", 0, NULL);
    vxf_put_series(&o, "force", VXF_F32, "N", 1, (int64_t[]){2});
    vxf_put_tail(&o, "largest", VXF_F64, "N", 1, (int64_t[]){3});
    why = vxf_stream_begin(&s, &o, file);
    for (int b = 0; b < 4 && !why; at += records[b++])
        why = vxf_stream_block(&s, records[b], (const void *[]){time_ + at, force + 2 * at});
    if (!why)
        why = vxf_stream_end(&s, (const void *[]){largest});
    fclose(file);
    vxf_out_free(&o);
    return why;
}

static void stream(void)
{
    struct vxf f;
    struct vxf_list all;
    const void *t, *q, *largest;
    char one[] = "force", two[] = "largest", none[] = "farce", *names[] = {one, two};

    ok(write_stream() == NULL && vxf_open(&f, path) == NULL, "a stream is written and read");
    ok(f.complete && f.records == 5 && f.blocks == 3, "five records in three blocks, complete");
    ok(!vxf_get_series(&f, "time", VXF_F64, "s", 0, NULL, &t) && memcmp(t, time_, sizeof time_) == 0, "time, joined from its blocks");
    ok(!vxf_get_series(&f, "force", VXF_F32, "N", 1, (int64_t[]){2}, &q) && memcmp(q, force, sizeof force) == 0, "a series with dims");
    ok(!vxf_get_tail(&f, "largest", VXF_F64, "N", 1, (int64_t[]){3}, &largest) && ((const double *)largest)[2] == 9, "the tail");
    ok(!vxf_select(&f, 0, NULL, &all) && all.n == 4 && strcmp(all.item[2].name, "force") == 0 && all.item[2].ndim == 2 &&
       all.item[2].dim[0] == 5 && all.item[2].dim[1] == 2, "all arrays as one list, records as first dim");
    free(all.item);
    ok(!vxf_select(&f, 2, names, &all) && all.n == 2 && all.item[0].data == q && all.item[1].data == largest, "a choice of them in its order");
    free(all.item);
    names[0] = none;
    ok(says(vxf_select(&f, 2, names, &all), "no array farce") && !all.item, "a choice of what is not there");
    vxf_close(&f);
}

/* The stream as a pipe gives it: the size in the preamble is unknown. */
static struct image unfinished(void)
{
    struct image m;

    write_stream();
    m = load();
    memset(m.byte + offsetof(struct vxf_preamble, size), 0, 8);
    return m;
}

/* ---- damage ---- */

static void truncation(const char *what, const struct image *m)
{
    int read = 0;

    for (size_t n = 0; n < m->n; n++) {
        struct vxf f;
        store(m->byte, n);
        if (!vxf_open(&f, path)) {
            read++;
            vxf_close(&f);
        }
    }
    ok(read == 0, "%s cut at any of %zu lengths is refused (%d were read)", what, m->n, read);
}

/* The first records and no others; the tail is not there. */
static int is_beginning(struct vxf *f)
{
    const void *t, *q, *tail;

    return !f->complete && f->records <= 5 && !vxf_get_series(f, "time", VXF_F64, "s", 0, NULL, &t) &&
           memcmp(t, time_, (size_t)f->records * 8) == 0 && !vxf_get_series(f, "force", VXF_F32, "N", 1, (int64_t[]){2}, &q) &&
           memcmp(q, force, (size_t)f->records * 8) == 0 &&
           says(vxf_get_tail(f, "largest", VXF_F64, "N", 1, (int64_t[]){3}, &tail), "not complete");
}

static void killed_run(const struct image *m)
{
    int wrong = 0, seen[6] = {0};
    size_t first = 0;

    for (size_t n = 0; n < m->n; n++) {
        struct vxf f;
        store(m->byte, n);
        const char *why = vxf_open(&f, path);
        if (why && first)
            wrong++;
        if (why)
            continue;
        first = first ? first : n;
        wrong += !is_beginning(&f);
        seen[f.records]++;
        vxf_close(&f);
    }
    ok(first && !wrong, "a run killed at any byte after its head is readable, not complete (%d wrong)", wrong);
    ok(seen[0] && seen[2] && seen[3] && seen[5] && !seen[1] && !seen[4], "every finished block counts, no half one does");
}

/* Hash of kind, header and data as they are in memory: vxf_content would take the header's word for the data. */
static uint64_t data_of(struct vxf *f)
{
    struct vxf_list all;
    uint64_t hash[32] = {vxf_hash(f->kind, sizeof f->kind), vxf_hash(f->header, strlen(f->header))};

    if (vxf_select(f, 0, NULL, &all) || all.n > 30)
        return 0;
    for (int i = 0; i < all.n; i++)
        hash[i + 2] = vxf_hash(all.item[i].data, (size_t)vxf_count(&all.item[i]) * vxf_type_size(all.item[i].type));
    free(all.item);
    return vxf_hash(hash, sizeof hash);
}

/* Every single bit of the file turned is refused, padding too; but for the one bit that makes the size of a stream 0, unknown, or right. */
static void bits(const char *what, const struct image *m)
{
    struct vxf f;
    uint64_t data;
    int other = 0, alike = 0, fd = open(path, O_WRONLY);

    store(m->byte, m->n);
    if (!ok(!vxf_open(&f, path), "%s is readable to begin with", what))
        return;
    data = data_of(&f);
    vxf_close(&f);
    for (size_t i = 0; i < 8 * m->n; i++) {
        unsigned char turned = (unsigned char)(m->byte[i / 8] ^ 1 << i % 8);
        if (pwrite(fd, &turned, 1, (off_t)(i / 8)) != 1)
            abort();
        if (!vxf_open(&f, path)) {
            if (data_of(&f) == data && f.complete)
                alike++;
            else
                other++;
            vxf_close(&f);
        }
        if (pwrite(fd, &m->byte[i / 8], 1, (off_t)(i / 8)) != 1)
            abort();
    }
    close(fd);
    ok(other == 0 && alike <= 1, "%s with any one of %zu bits turned is refused (%d gave other data, %d the same)", what, 8 * m->n, other,
       alike);
}

static void junk(const char *what, const struct image *m)
{
    struct vxf f;
    unsigned char *more = calloc(m->n + 64, 1);

    memcpy(more, m->byte, m->n);
    store(more, m->n + 64);
    ok(vxf_open(&f, path) != NULL, "%s with 64 zero bytes behind it is refused", what);
    store(more, m->n + 1);
    ok(vxf_open(&f, path) != NULL, "%s with a zero byte behind it is refused", what);
    free(more);
}

static void damage(void)
{
    struct vxf_out o;
    struct image m;

    put_every_type(&o);
    write_out(&o);
    vxf_out_free(&o);
    m = load();
    truncation("a file", &m);
    bits("a file", &m);
    junk("a file", &m);
    free(m.byte);

    write_stream();
    m = load();
    truncation("a finished stream", &m);
    bits("a finished stream", &m);
    junk("a finished stream", &m);
    free(m.byte);

    m = unfinished();
    killed_run(&m);
    bits("a stream of unknown size", &m);
    free(m.byte);
}

/* ---- forged files: every hash is right ---- */

static const char *forged_header(const char *header, size_t payload)
{
    struct vxf_preamble p = {.magic = VXF_MAGIC, .order = VXF_ORDER, .version = VXF_VERSION, .kind = "test"};
    size_t head = sizeof p + vxf_pad(strlen(header));
    unsigned char *all = calloc(head + payload + 1, 1);
    struct vxf f;
    const char *why;

    p.header = strlen(header);
    p.size = head + payload;
    p.hash = vxf_header_hash(&p, header);
    memcpy(all, &p, sizeof p);
    memcpy(all + sizeof p, header, strlen(header));
    store(all, head + payload);
    free(all);
    why = vxf_open(&f, path);
    if (!why)
        vxf_close(&f);
    return why;
}

static void forged(void)
{
    ok(says(forged_header("ARRAY= a f64 4611686018427387904x4 m 0 0\n", 64), "too large"), "dims that overflow");
    ok(says(forged_header("ARRAY= a f64 1000000 m 0 0\n", 64), "truncated"), "an array larger than the file");
    ok(says(forged_header("ARRAY= a f64 99999999999999999999 m 0 0\n", 64), "bad dims"), "a dim beyond 64 bits");
    ok(says(forged_header("ARRAY= a f64 -1 m 0 0\n", 64), "bad dims"), "a negative dim");
    ok(says(forged_header("ARRAY= a f64 1x m 0 0\n", 64), "bad dims"), "a dim left out");
    ok(says(forged_header("ARRAY= a f64 1x1x1x1x1x1x1 m 0 0\n", 64), "bad dims"), "seven dims");
    ok(says(forged_header("ARRAY= a f16 1 m 0 0\n", 64), "unknown element type"), "an unknown type");
    ok(says(forged_header("ARRAY= a f64 1 m 64 0\n", 128), "not where it belongs"), "an array at another place");
    ok(says(forged_header("ARRAY= a f64 1 m 0 0 more\n", 64), "junk"), "more words than there should be");
    ok(says(forged_header("ARRAY= a f64 1\n", 64), "not complete"), "fewer words than there should be");
    ok(says(forged_header("SERIES= a f64 1 m\nTAIL= a f64 1 m\n", 0), "twice"), "one name for a series and a tail");
    ok(says(forged_header("TAIL= a f64 1 m\n", 0), "tail without a series"), "a tail without a series");
    ok(says(forged_header("KEY= a\033[2J\n", 0), "damaged header"), "a control character in the header");
    ok(says(forged_header("KEY= a", 0), "damaged header"), "a last line that does not end");
}

/* Series without elements could claim any number of records. */
static void forged_records(void)
{
    struct vxf_out o;
    struct vxf_stream s;
    struct vxf f;
    struct vxf_block b = {.magic = VXF_BLOCK_MAGIC, .records = INT64_MAX};
    FILE *file = fopen(path, "wb");

    vxf_out_begin(&o, "run");
    vxf_put_series(&o, "nothing", VXF_F64, "m", 1, (int64_t[]){0});
    vxf_stream_begin(&s, &o, file);
    b.hash = vxf_hash(NULL, 0);
    b.head = vxf_block_head_hash(&b);
    fwrite(&b, sizeof b, 1, file);
    b.index = 1;
    b.head = vxf_block_head_hash(&b);
    fwrite(&b, sizeof b, 1, file);
    fclose(file);
    vxf_out_free(&o);
    ok(says(vxf_open(&f, path), "damaged"), "records that overflow");
}

/* NaN that another writer put into a file is refused when asked for. */
static void forged_nan(void)
{
    const double bad[2] = {1, NAN};
    struct vxf_out o;
    struct vxf_preamble p;
    struct image m;
    struct vxf f;
    const void *data;

    vxf_out_begin(&o, "test");
    vxf_put(&o, "x", VXF_I64, "m", 1, (int64_t[]){2}, bad);
    write_out(&o);
    vxf_out_free(&o);
    m = load();
    memcpy(strstr((char *)m.byte + sizeof p, "i64"), "f64", 3);
    memcpy(&p, m.byte, sizeof p);
    p.hash = vxf_header_hash(&p, (char *)m.byte + sizeof p);
    memcpy(m.byte, &p, sizeof p);
    store(m.byte, m.n);
    free(m.byte);
    ok(!vxf_open(&f, path) && says(vxf_get(&f, "x", VXF_F64, "m", 1, (int64_t[]){2}, &data), "not a finite number at 1"),
       "NaN is refused, with its place");
    vxf_close(&f);
}

/* ---- content and history ---- */

static uint64_t content_of(const char *side, const char *unit, double x, const char *command)
{
    struct vxf_out o;
    struct vxf f;
    uint64_t content = 0;

    vxf_out_begin(&o, "test");
    vxf_put_key(&o, "CMD", "%s", command);
    vxf_put_key(&o, "SIDE", "%s", side);
    vxf_put(&o, "x", VXF_F64, unit, 0, NULL, &x);
    write_out(&o);
    if (!vxf_open(&f, path)) {
        content = vxf_content(&f);
        vxf_close(&f);
    }
    vxf_out_free(&o);
    return content;
}

static void content(void)
{
    uint64_t a = content_of("l", "m", 1, "vxtool one");

    ok(a && a == content_of("l", "m", 1, "vxtool two"), "the content does not depend on the history");
    ok(a != content_of("r", "m", 1, "vxtool one"), "it depends on the keys");
    ok(a != content_of("l", "mm", 1, "vxtool one"), "on units");
    ok(a != content_of("l", "m", 2, "vxtool one"), "and on data");
}

static void history(void)
{
    struct vxf_out o;
    struct vxf f, g;
    int length;

    content_of("l", "m", 1, "vxtool one\ntwo");
    if (vxf_open(&f, path))
        abort();
    vxf_out_begin(&o, "next");
    vxf_put_input(&o, &f);
    vxf_put_input(&o, &f);
    vxf_close(&f);
    write_out(&o);
    vxf_out_free(&o);
    if (vxf_open(&g, path))
        abort();
    const char *line = vxf_line(&g, "CMD", 0, &length);
    ok(line && strncmp(line, "vxtool one two", (size_t)length) == 0, "a newline in a value becomes a space");
    ok(!vxf_line(&g, "CMD", 1, &length) && vxf_line(&g, "INPUT", 1, &length), "a command that came by two ways stands once, each input has its line");
    vxf_close(&g);
}

static void repeatable(void)
{
    struct image a, b;

    write_stream();
    a = load();
    write_stream();
    b = load();
    ok(a.n == b.n && memcmp(a.byte, b.byte, a.n) == 0, "the same data give the same bytes");
    free(a.byte);
    free(b.byte);
}

int main(void)
{
    close(mkstemp(path));
    round_trip();
    refusals_of_the_writer();
    stream();
    damage();
    forged();
    forged_records();
    forged_nan();
    content();
    history();
    repeatable();
    unlink(path);
    return done();
}
