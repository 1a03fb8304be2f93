/* The cache of contact tables: keys say all, an entry is whole or refused, what is stale is what was asked for. */
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "formats/cache.h"
#include "tests/kernel/tap.h"

static char folder[] = "/tmp/vx-cache-test.XXXXXX";
static char name[CACHE_NAME], path[PATH_MAX];

static struct cache_key key_of(double step)
{
    struct cache_key k = {0};

    cache_key_put(&k, "revision", "%d", 7);
    cache_key_put(&k, "wheel", "%016llx %s", 0x1234ull, "a wheel");
    cache_key_put(&k, "u-step", "%.17g", step);
    return k;
}

/* A container of this kind with the lines of k at `path`. */
static void write_entry(const char *kind, const struct cache_key *k)
{
    static const double x[5] = {1, 2, 3, 4, 5};
    struct vxf_out o;
    FILE *file = fopen(path, "wb");

    vxf_out_begin(&o, kind);
    cache_put_key(k, &o);
    vxf_put(&o, "x", VXF_F64, "m", 1, (int64_t[]){5}, x);
    ok(!vxf_write(&o, file) && fclose(file) == 0, "an entry of kind %s is written", kind);
    vxf_out_free(&o);
}

static void write_bytes(const unsigned char *byte, size_t n)
{
    FILE *file = fopen(path, "wb");

    fwrite(byte, 1, n, file);
    fclose(file);
}

/* What stands at `path` is found, and refused by the whole check; *header too, where it is refused by that. */
static int is_refused(int *header)
{
    struct vxf f;
    int found = 0, head = 0;
    const char *why = cache_open(&f, folder, name, &found);

    if (!why && found)
        vxf_close(&f);
    const char *also = cache_open_header(&f, folder, name, &head);
    if (!also && head)
        vxf_close(&f);
    *header = also != NULL;
    return found && why;
}

static void test_keys(void)
{
    struct cache_key a = key_of(1e-4), b = key_of(nextafter(1e-4, 1)), c = {0}, d = {0};
    char other[CACHE_NAME];

    ok(!cache_key_name(&a, name) && strlen(name) == CACHE_NAME - 1, "a key has a name (%s)", name);
    cache_key_name(&b, other);
    ok(strcmp(name, other) != 0, "the last bit of a number makes another name");
    for (int i = 0; i < CACHE_TEXT; i++)
        cache_key_put(&c, "option", "%d", i);
    ok(cache_key_name(&c, other) != NULL, "a key that is too long is told (%s)", c.why);
    cache_key_put(&d, "file", "a\nrevision 8");
    ok(cache_key_name(&d, other) != NULL, "so is a newline in a value (%s)", d.why);
}

static void test_whole(void)
{
    struct cache_key k = key_of(1e-4);
    char value[64];
    struct vxf f;
    int found = 1;

    cache_key_name(&k, name);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    ok(!cache_open(&f, folder, name, &found) && !found, "what is not there is not found");
    write_entry("ctab", &k);
    ok(!cache_open(&f, folder, name, &found) && found, "a whole entry is found");
    cache_value(&f, "u-step", value, sizeof value);
    ok(strcmp(value, "0.0001") == 0 || strtod(value, NULL) == 1e-4, "its lines can be read (u-step %s)", value);
    cache_value(&f, "u-max", value, sizeof value);
    ok(strcmp(value, "-") == 0, "a line that is not there is -");
    vxf_close(&f);
    ok(!cache_open_header(&f, folder, name, &found) && found && vxf_find(&f.array, "x") && !vxf_find(&f.array, "x")->data,
       "its header alone: names and shapes without data");
    vxf_close(&f);
}

/* Every length, every bit. */
static void test_damage(void)
{
    unsigned char byte[4096];
    FILE *file = fopen(path, "rb");
    size_t n = fread(byte, 1, sizeof byte - 1, file);
    int whole = 0, wrong = 0, header;

    fclose(file);
    for (size_t i = 0; i < n; i++) {
        write_bytes(byte, i);
        whole += !is_refused(&header);
        wrong += !header;
    }
    ok(whole == 0 && wrong == 0, "cut at each of %zu lengths it is refused, by its header alone too (%d, %d are not)", n, whole, wrong);
    byte[n] = 0;
    write_bytes(byte, n + 1);
    ok(is_refused(&header) && header, "a byte more is refused");
    whole = 0;
    for (size_t i = 0; i < 8 * n; i++) {
        byte[i / 8] ^= (unsigned char)(1 << i % 8);
        write_bytes(byte, n);
        whole += !is_refused(&header);
        byte[i / 8] ^= (unsigned char)(1 << i % 8);
    }
    ok(whole == 0, "with any one of its %zu bits flipped it is refused (%d are not)", 8 * n, whole);
}

static void test_other_things(void)
{
    struct cache_key k = key_of(1e-4), other = key_of(2e-4);
    int header, found = 1;
    struct vxf f;

    write_entry("prof", &k);
    ok(is_refused(&header) && header, "another kind is refused");
    write_entry("ctab", &other);
    ok(is_refused(&header) && header, "the entry of another key is refused");
    unlink(path);
    ok(mkdir(path, 0777) == 0 && is_refused(&header) && header, "a folder in its place is refused");
    rmdir(path);
    ok(mkfifo(path, 0666) == 0 && is_refused(&header) && header, "a named pipe is refused, and not waited for");
    unlink(path);
    ok(symlink(name, path) == 0 && is_refused(&header) && header, "a link to itself is refused");
    unlink(path);
    ok(symlink("nowhere", path) == 0 && !cache_open(&f, folder, name, &found) && !found, "a link to nowhere is no entry");
    unlink(path);
}

static void make(const char *file, int64_t size)
{
    char at[PATH_MAX];

    snprintf(at, sizeof at, "%s/%s", folder, file);
    FILE *to = fopen(at, "wb");
    for (int64_t i = 0; i < size; i++)
        putc('x', to);
    fclose(to);
}

static void test_list(void)
{
    static const char *const file[] = {
        "00000000000000000000000000000001.ctab", "00000000000000000000000000000002.ctab",
        "00000000000000000000000000000001.ctab.a1B2c3", "00000000000000000000000000000001.ctab.a1B2c", "notes.txt",
        "0000000000000000000000000000000g.ctab", "00000000000000000000000000000001.ctab.a1B2c3d", "00000000000000000000000000000001.run",
    };
    struct cache_list l;
    int64_t now = 0;

    for (size_t i = 0; i < sizeof file / sizeof *file; i++)
        make(file[i], 10);
    ok(!cache_list_read(&l, folder), "the folder is read");
    ok(l.n == 3, "entries and temporaries are listed, other files are not (%lld)", (long long)l.n);
    int temporaries = 0;
    for (int64_t i = 0; i < l.n; i++)
        temporaries += l.file[i].temporary;
    ok(temporaries == 1, "one is a temporary");
    ok(!cache_now(folder, &now) && now - l.file[l.n - 1].used >= 0 && now - l.file[l.n - 1].used < 60, "the folder's clock is that of its files");
    cache_list_free(&l);
    ok(!cache_list_read(&l, folder) && l.n == 3, "asking for the time leaves nothing");
    cache_list_free(&l);
    for (size_t i = 0; i < sizeof file / sizeof *file; i++)
        ok(!cache_remove(folder, file[i]) && !cache_remove(folder, file[i]), "removed, and no failure where it is gone: %s", file[i]);
    ok(cache_list_read(&l, "/nonexistent") != NULL, "a folder that is not there is told");
}

/* Which of the files are stale, as a word of 0 and 1. */
static int stale(double age, double size)
{
    struct cache_file file[] = {
        {.size = 100, .used = 1000, .temporary = 1}, {.size = 10, .used = 2000}, {.size = 20, .used = 5000},
        {.size = 30, .used = 6000}, {.size = 100, .used = 9000, .temporary = 1}, {.size = 40, .used = 9990},
    };
    struct cache_list l = {.n = 6, .room = 6, .file = file};
    int word = 0;

    cache_stale(&l, 10000, age, size);
    for (int i = 0; i < 6; i++)
        word = 10 * word + file[i].stale;
    return word;
}

static void test_stale(void)
{
    ok(stale(HUGE_VAL, HUGE_VAL) == 100000, "without limits only the temporary of a killed writer goes");
    ok(stale(4500, HUGE_VAL) == 111000, "by age: what was last used before");
    ok(stale(HUGE_VAL, 70) == 111000, "by size: the longest unused until the rest fits, temporaries not counted");
    ok(stale(HUGE_VAL, 69.5) == 111100, "a byte less takes one more");
    ok(stale(8500, 90) == 110000, "what age removed counts no more");
    ok(stale(0, 0) == 111101, "nothing stays where nothing may, but a writer at work");
}

int main(void)
{
    if (!mkdtemp(folder))
        return 1;
    test_keys();
    test_whole();
    test_damage();
    test_other_things();
    test_list();
    test_stale();
    rmdir(folder);
    return done();
}
