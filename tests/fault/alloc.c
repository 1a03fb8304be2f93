/* Memory that runs out at each allocation in turn: formats say so, and leave nothing behind.
 *
 * Linked with --wrap for the allocator, so only allocations of Veksel's own sources are counted and fail, not those inside libraries. */
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/cache.h"
#include "formats/export_csv.h"
#include "formats/trk.h"
#include "formats/trk_text.h"
#include "formats/vxf.h"
#include "tests/kernel/tap.h"

void *__real_malloc(size_t n);
void *__real_realloc(void *p, size_t n);
void __real_free(void *p);
void *__wrap_malloc(size_t n);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t n);
char *__wrap_strdup(const char *text);
char *__wrap_strndup(const char *text, size_t n);
void __wrap_free(void *p);

static long left = -1;       /* allocations before one fails; below 0 none does */
static int lasting;          /* all that follow fail too */
static int failed;           /* how many did */
static long live;            /* allocations not yet freed */

static int fails_now(void)
{
    if (left < 0 || (left > 0 && left--))
        return 0;
    left = lasting ? 0 : -1;
    failed++;
    return 1;
}

void *__wrap_malloc(size_t n)
{
    void *p = fails_now() ? NULL : __real_malloc(n);

    live += p != NULL;
    return p;
}

void *__wrap_calloc(size_t n, size_t size)
{
    void *p = size && n > SIZE_MAX / size ? NULL : __wrap_malloc(n * size);

    return p ? memset(p, 0, n * size) : NULL;
}

void *__wrap_realloc(void *p, size_t n)
{
    void *q = fails_now() ? NULL : __real_realloc(p, n);

    live += q && !p;
    return q;
}

char *__wrap_strndup(const char *text, size_t n)
{
    size_t length = strnlen(text, n);
    char *copy = __wrap_malloc(length + 1);

    if (copy) {
        memcpy(copy, text, length);
        copy[length] = 0;
    }
    return copy;
}

char *__wrap_strdup(const char *text)
{
    return __wrap_strndup(text, strlen(text));
}

void __wrap_free(void *p)
{
    live -= p != NULL;
    __real_free(p);
}

/* ---- what is tried ---- */

static char path[] = "/tmp/vxf-alloc.XXXXXX", folder[] = "/tmp/vxf-alloc-cache.XXXXXX";
static const double x[6] = {1, 2, 3, 4, 5, 6};

static const char *write_plain(void)
{
    struct vxf_out o;
    FILE *file = fopen(path, "wb");
    const char *why;

    vxf_out_begin(&o, "test");
    for (int i = 0; i < 20; i++)
        vxf_put_key(&o, "KEY", "%0100d", i);
    vxf_put(&o, "x", VXF_F64, "m", 2, (int64_t[]){2, 3}, x);
    vxf_put(&o, "y", VXF_F64, "m", 1, (int64_t[]){6}, x);
    why = vxf_write(&o, file);
    vxf_out_free(&o);
    fclose(file);
    return why;
}

static const char *write_stream(void)
{
    struct vxf_out o;
    struct vxf_stream s;
    FILE *file = fopen(path, "wb");
    const char *why;

    vxf_out_begin(&o, "run");
    vxf_put_series(&o, "x", VXF_F64, "m", 0, NULL);
    vxf_put_series(&o, "y", VXF_F64, "m", 1, (int64_t[]){2});
    vxf_put_tail(&o, "z", VXF_F64, "m", 0, NULL);
    why = vxf_stream_begin(&s, &o, file);
    for (int b = 0; b < 3 && !why; b++)
        why = vxf_stream_block(&s, 1, (const void *[]){x, x});
    if (!why)
        why = vxf_stream_end(&s, (const void *[]){x});
    vxf_out_free(&o);
    fclose(file);
    return why;
}

static const char *read_all(void)
{
    struct vxf f;
    struct vxf_list all;
    FILE *out = fopen("/dev/null", "wb");
    const char *why = vxf_open(&f, path);

    if (!why) {
        why = vxf_select(&f, 0, NULL, &all);
        if (!why) {
            all.n = 1;
            why = export_csv(&all, out);
            free(all.item);
        }
        vxf_close(&f);
    }
    fclose(out);
    return why;
}

static const char *read_without_mapping(void)
{
    struct vxf f;
    int fd = open(path, O_RDONLY);
    const char *why = vxf_open_fd(&f, fd);

    if (!why) {
        vxf_close(&f);
        why = vxf_open_header(&f, fd);
    }
    if (!why)
        vxf_close(&f);
    close(fd);
    return why;
}

/* Three times, for one allocation serves many entries. */
static const char *list_cache(void)
{
    char entry[sizeof folder + CACHE_NAME];
    struct cache_list l;
    const char *why = NULL;

    snprintf(entry, sizeof entry, "%s/%032d.ctab", folder, 0);
    fclose(fopen(entry, "wb"));
    for (int i = 0; i < 3 && !why; i++) {
        why = cache_list_read(&l, folder);
        cache_list_free(&l);
    }
    unlink(entry);
    return why;
}

static const char *pass_on(void)
{
    struct vxf f;
    struct vxf_out o;
    FILE *file = fopen("/dev/null", "wb");
    const char *why = vxf_open(&f, path);

    if (!why) {
        vxf_out_begin(&o, "next");
        vxf_put_input(&o, &f);
        why = vxf_write(&o, file);
        vxf_out_free(&o);
        vxf_close(&f);
    }
    fclose(file);
    return why;
}

static const char *read_input(void)
{
    static char pad[] = "railpad.stiffness=150e6", zone[] = "rail.bending_stiffness={station: [0, 1], value: [6e6, 7e6]}";
    static char *const set[] = {pad, zone};
    struct trk_text text;
    uint64_t hash;
    const char *why = yaml_read("data/tracks/60E1-R760-1-15-diverging.yaml", &trk_text_schema, set, 2, &text, &hash);

    if (!why)
        yaml_release(&trk_text_schema, &text);
    return why;
}

/* ---- each allocation in turn ---- */

static void try_all(const char *what, const char *(*try)(void))
{
    int silent = 0, leaks = 0, n = 0;

    for (lasting = 0; lasting < 2; lasting++)
        for (n = 0, failed = 1; failed; n++) {
            long before = live;
            failed = 0;
            left = n;
            const char *why = try();
            left = -1;
            silent += failed && !why;
            leaks += live != before;
        }
    ok(n > 2 && silent == 0, "%s: each of %d allocations fails, and it is told (%d are not)", what, n - 1, silent);
    ok(leaks == 0, "%s: and nothing is left behind (%d times)", what, leaks);
    ok(!try(), "%s: with memory it succeeds", what);
}

int main(void)
{
    close(mkstemp(path));
    if (!mkdtemp(folder))
        return 1;
    try_all("writing a file", write_plain);
    try_all("reading it", read_all);
    try_all("reading it without mapping it", read_without_mapping);
    try_all("listing a cache", list_cache);
    try_all("passing its history on", pass_on);
    try_all("writing a stream", write_stream);
    try_all("reading that", read_all);
    try_all("reading an input", read_input);
    unlink(path);
    rmdir(folder);
    return done();
}
