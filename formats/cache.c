/* Keys, entries and the folder of the cache of contact tables. */
#include "formats/cache.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "formats/reason.h"

#define HEX "0123456789abcdef"
#define LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"     /* of mkstemp */

/* ---- keys ---- */

static void add_line(struct cache_key *k, const char *line, size_t n)
{
    if (n + 2 > sizeof k->text - k->length) {
        k->why = reason("the key of the cache is longer than %d bytes", CACHE_TEXT);
        return;
    }
    memcpy(k->text + k->length, line, n);
    k->length += n;
    k->text[k->length++] = '\n';
    k->text[k->length] = 0;
}

void cache_key_put(struct cache_key *k, const char *name, const char *format, ...)
{
    char line[CACHE_TEXT];
    int n = snprintf(line, sizeof line, "%s ", name), m;
    va_list ap;

    va_start(ap, format);
    m = vsnprintf(line + n, sizeof line - (size_t)n, format, ap);
    va_end(ap);
    for (const char *p = line; *p; p++)
        if (iscntrl((unsigned char)*p))
            k->why = reason("%s holds a control character", name);
    add_line(k, line, (size_t)(n + m));
}

const char *cache_key_name(const struct cache_key *k, char *name)
{
    XXH128_hash_t hash = XXH3_128bits(k->text, k->length);

    snprintf(name, CACHE_NAME, "%016llx%016llx.ctab", (unsigned long long)hash.high64, (unsigned long long)hash.low64);
    return k->why;
}

void cache_put_key(const struct cache_key *k, struct vxf_out *o)
{
    for (const char *line = k->text, *end; *line; line = end + 1) {
        end = strchr(line, '\n');
        vxf_put_key(o, "CACHE", "%.*s", (int)(end - line), line);
    }
}

void cache_value(const struct vxf *f, const char *name, char *value, size_t size)
{
    size_t n = strlen(name);
    const char *line;
    int length;

    snprintf(value, size, "-");
    for (int i = 0; (line = vxf_line(f, "CACHE", i, &length)); i++)
        if ((size_t)length > n && strncmp(line, name, n) == 0 && line[n] == ' ')
            snprintf(value, size, "%.*s", length - (int)n - 1, line + n + 1);
}

/* ---- entries ---- */

static const char *check_key(const struct vxf *f, const char *name)
{
    struct cache_key k = {0};
    char own[CACHE_NAME];
    const char *line, *why;
    int length;

    for (int i = 0; (line = vxf_line(f, "CACHE", i, &length)); i++)
        add_line(&k, line, (size_t)length);
    if ((why = cache_key_name(&k, own)))
        return why;
    return strcmp(own, name) == 0 ? NULL : reason("its own key is that of %s", own);
}

static const char *entry_path(char *path, const char *folder, const char *name)
{
    return snprintf(path, PATH_MAX, "%s/%s", folder, name) < PATH_MAX ? NULL : strerror(ENAMETOOLONG);
}

/* O_NONBLOCK: a named pipe in the place of an entry would wait for its writer. */
static const char *open_once(struct vxf *f, const char *path, const char *name, const char *(*read)(struct vxf *, int), int *found)
{
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const char *why;

    *found = fd >= 0 || errno != ENOENT;
    if (fd < 0)
        return *found ? strerror(errno) : NULL;
    why = read(f, fd);
    close(fd);
    if (!why && ((why = vxf_is(f, "ctab")) || (why = check_key(f, name))))
        vxf_close(f);
    return why;
}

/* Over a network, an entry that another machine replaced while it was read is gone: the second look sees the new one. */
static const char *open_entry(struct vxf *f, const char *folder, const char *name, const char *(*read)(struct vxf *, int), int *found)
{
    char path[PATH_MAX];
    const char *why = entry_path(path, folder, name);

    *found = 0;
    if (why || !(why = open_once(f, path, name, read, found)))
        return why;
    return open_once(f, path, name, read, found);
}

const char *cache_open(struct vxf *f, const char *folder, const char *name, int *found)
{
    return open_entry(f, folder, name, vxf_open_fd, found);
}

const char *cache_open_header(struct vxf *f, const char *folder, const char *name, int *found)
{
    return open_entry(f, folder, name, vxf_open_header, found);
}

void cache_touch(const char *folder, const char *name)
{
    char path[PATH_MAX];

    if (!entry_path(path, folder, name))
        utimensat(AT_FDCWD, path, NULL, 0);
}

const char *cache_remove(const char *folder, const char *name)
{
    char path[PATH_MAX];
    const char *why = entry_path(path, folder, name);

    return why ? why : unlink(path) == 0 || errno == ENOENT ? NULL : strerror(errno);
}

const char *cache_now(const char *folder, int64_t *now)
{
    char path[PATH_MAX];
    struct stat st;
    const char *why = entry_path(path, folder, "00000000000000000000000000000000.ctab.XXXXXX");
    int fd = why ? -1 : mkstemp(path);

    if (fd < 0)
        return why ? why : strerror(errno);
    if (fstat(fd, &st) == 0)
        *now = st.st_mtime;
    else
        why = strerror(errno);
    close(fd);
    unlink(path);
    return why;
}

/* ---- the folder ---- */

/* 1 an entry's name, 2 that of a temporary, 0 none. */
static int name_kind(const char *name)
{
    if (strspn(name, HEX) < 32 || strncmp(name + 32, ".ctab", 5) != 0)
        return 0;
    if (!name[37])
        return 1;
    return name[37] == '.' && strspn(name + 38, LETTERS) == 6 && !name[44] ? 2 : 0;
}

static const char *list_add(struct cache_list *l, const char *folder, const char *name, int temporary)
{
    char path[PATH_MAX];
    struct stat st;
    const char *why = entry_path(path, folder, name);

    if (why || lstat(path, &st) != 0)                       /* removed meanwhile */
        return why;
    if (l->n == l->room) {
        struct cache_file *more = realloc(l->file, (size_t)(2 * l->room + 64) * sizeof *more);
        if (!more)
            return REASON_MEMORY;
        l->file = more;
        l->room = 2 * l->room + 64;
    }
    struct cache_file *file = &l->file[l->n++];
    *file = (struct cache_file){.temporary = temporary, .size = st.st_size, .used = st.st_mtime};
    snprintf(file->name, sizeof file->name, "%s", name);
    return NULL;
}

static int by_use(const void *a, const void *b)
{
    const struct cache_file *p = a, *q = b;

    return p->used != q->used ? (p->used > q->used) - (p->used < q->used) : strcmp(p->name, q->name);
}

const char *cache_list_read(struct cache_list *l, const char *folder)
{
    DIR *dir = opendir(folder);
    const struct dirent *item;
    const char *why = NULL;

    *l = (struct cache_list){0};
    if (!dir)
        return strerror(errno);
    while (!why && (errno = 0, item = readdir(dir)))
        if (name_kind(item->d_name))
            why = list_add(l, folder, item->d_name, name_kind(item->d_name) == 2);
    if (!why && errno)
        why = strerror(errno);
    closedir(dir);
    if (why)
        cache_list_free(l);
    else if (l->n)
        qsort(l->file, (size_t)l->n, sizeof *l->file, by_use);
    return why;
}

void cache_list_free(struct cache_list *l)
{
    free(l->file);
    *l = (struct cache_list){0};
}

void cache_stale(struct cache_list *l, int64_t now, double age, double size)
{
    double left = 0;

    for (int64_t i = 0; i < l->n; i++) {
        struct cache_file *f = &l->file[i];
        f->stale = (double)(now - f->used) > (f->temporary ? CACHE_TEMPORARY_AGE : age);
        left += f->temporary || f->stale ? 0 : (double)f->size;
    }
    for (int64_t i = 0; i < l->n && left > size; i++)
        if (!l->file[i].temporary && !l->file[i].stale) {
            l->file[i].stale = 1;
            left -= (double)l->file[i].size;
        }
}
