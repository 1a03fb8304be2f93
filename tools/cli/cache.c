/* The cache of contact tables: found, kept, listed, verified, pruned. */
#include "tools/cli/cache.h"
#include "tools/cli/cli_private.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#define DAY 86400.0      /* s */
#define GIGABYTE 1e9

/* NULL where there is none; what is named must be a folder, for a cache that silently is not there costs hours. */
static const char *folder(void)
{
    const char *path = getenv("VX_CACHE");
    struct stat st;

    if (!path || !*path)
        return NULL;
    if (stat(path, &st) != 0)
        cli_die("VX_CACHE: %s: %s", path, strerror(errno));
    if (!S_ISDIR(st.st_mode))
        cli_die("VX_CACHE: %s: not a folder", path);
    return path;
}

/* ---- one table ---- */

/* An option that is not given counts as none: its value is 0, and no other is left out. */
static void key_option(struct cache_key *k, const struct cli_option *o)
{
    static const char *const elsewhere[] = {"wheel", "rail", "o"};

    for (size_t i = 0; i < sizeof elsewhere / sizeof *elsewhere; i++)
        if (strcmp(o->name, elsewhere[i]) == 0)
            return;
    if (o->type == CLI_NUM && *(double *)o->value != 0)
        cache_key_put(k, o->name, "%.17g", *(double *)o->value);
    else if (o->type == CLI_INT && *(int64_t *)o->value != 0)
        cache_key_put(k, o->name, "%lld", (long long)*(int64_t *)o->value);
    else if (o->type == CLI_TEXT && *(const char **)o->value)
        cache_key_put(k, o->name, "%s", *(const char **)o->value);
    else if (o->type == CLI_CHOICE && *(int *)o->value >= 0)
        cache_key_put(k, o->name, "%s", o->choice[*(int *)o->value]);
    else if (o->type == CLI_FLAG && *(int *)o->value)
        cache_key_put(k, o->name, "given");
    else if (o->type == CLI_LIST)
        for (int i = 0; i < ((struct cli_list *)o->value)->n; i++)
            cache_key_put(k, o->name, "%s", ((struct cli_list *)o->value)->item[i]);
}

static void key_profile(struct cache_key *k, const char *name, const struct vxf *f)
{
    char title[64] = "";

    vxf_key(f, "NAME", title, sizeof title);
    cache_key_put(k, name, "%016llx %s", (unsigned long long)vxf_content(f), title);
}

int cli_cache_find(struct cli_cache *c, const struct cli_option *option, int revision, const struct vxf *wheel, const struct vxf *rail,
                   struct ctab *t)
{
    const char *why;
    int found = 0;

    *c = (struct cli_cache){.folder = folder()};
    if (!c->folder)
        return 0;
    cache_key_put(&c->key, "release", "%s", VX_VERSION);
    cache_key_put(&c->key, "revision", "%d", revision);
    key_profile(&c->key, "wheel", wheel);
    key_profile(&c->key, "rail", rail);
    for (; option->name; option++)
        key_option(&c->key, option);
    cli_check("VX_CACHE", cache_key_name(&c->key, c->name));
    why = cache_open(&c->entry, c->folder, c->name, &found);
    if (found && !why && (why = ctab_read(t, &c->entry)))
        vxf_close(&c->entry);
    c->damaged = !!why;
    if (why)
        cli_note("%s/%s: %s; made anew", c->folder, c->name, why);
    else if (found)
        cache_touch(c->folder, c->name);
    return found && !why;
}

static int is_kept(const struct cli_cache *c)
{
    struct vxf f;
    int found = 0;

    if (c->damaged || cache_open_header(&f, c->folder, c->name, &found) || !found)
        return 0;
    vxf_close(&f);
    return 1;
}

/* The entry has no history: two that keep the same table write the same bytes. */
void cli_cache_keep(struct cli_cache *c, const struct ctab *t)
{
    char path[PATH_MAX];
    struct cli_out out;
    struct vxf_out o;
    const char *why;

    if (!c->folder || is_kept(c))
        return;
    vxf_out_begin(&o, "ctab");
    cache_put_key(&c->key, &o);
    snprintf(path, sizeof path, "%s/%s", c->folder, c->name);
    if (!(why = ctab_put(t, &o)) && !(why = cli_begin_file(&out, path))) {
        why = vxf_write(&o, out.file);
        why = cli_end_file(&out, why);
    }
    vxf_out_free(&o);
    if (why)
        cli_note("%s: %s; the table is not kept in the cache", path, why);
}

/* ---- all of them ---- */

static void print_time(int64_t used)
{
    time_t at = (time_t)used;
    char text[32] = "-";
    struct tm tm;

    if (gmtime_r(&at, &tm))
        strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &tm);
    printf(" %20s", text);
}

static long long dim(const struct vxf *f, const char *name)
{
    const struct vxf_array *a = vxf_find(&f->array, name);

    return a && a->ndim == 1 ? (long long)a->dim[0] : 0;
}

static const char *title(const char *profile)
{
    return strlen(profile) > 17 ? profile + 17 : "?";         /* behind the hash */
}

static void print_entry(const struct vxf *f)
{
    char side[8] = "-", yaw[16] = "-", u_max[32], wheel[128], rail[128];

    vxf_key(f, "SIDE", side, sizeof side);
    vxf_key(f, "YAW_METHOD", yaw, sizeof yaw);
    cache_value(f, "u-max", u_max, sizeof u_max);
    cache_value(f, "wheel", wheel, sizeof wheel);
    cache_value(f, "rail", rail, sizeof rail);
    printf(" %4s %10s %11lld %7lld -%-8.6g %8.6g  %s on %s\n", side, yaw, dim(f, "station"), dim(f, "yaw"), strtod(u_max, NULL),
           strtod(u_max, NULL), title(wheel), title(rail));
}

static void list(const char *path, const struct cache_list *l)
{
    printf("%-37s %12s %20s %4s %10s %11s %7s %9s %8s  %s\n", "file", "size[B]", "last_use", "side", "yaw_method", "stations[1]", "yaws[1]",
           "u_min[m]", "u_max[m]", "profiles");
    for (int64_t i = 0; i < l->n; i++) {
        const struct cache_file *file = &l->file[i];
        struct vxf f;
        int found = 0;
        const char *why = file->temporary ? "being written, or left by a writer that was killed" : cache_open_header(&f, path, file->name, &found);
        if (!found && !why)
            continue;
        printf("%-37s %12lld", file->name, (long long)file->size);
        print_time(file->used);
        if (why) {
            printf("  %s\n", why);
            continue;
        }
        print_entry(&f);
        vxf_close(&f);
    }
}

static void verify(const char *path, const struct cache_list *l)
{
    int entries = 0, damaged = 0;

    for (int64_t i = 0; i < l->n; i++) {
        struct vxf f;
        struct ctab t;
        int found = 0;
        const char *why = l->file[i].temporary ? NULL : cache_open(&f, path, l->file[i].name, &found);
        if (found && !why) {
            why = ctab_read(&t, &f);
            vxf_close(&f);
        }
        entries += found;
        damaged += !!why;
        if (why)
            printf("%s: %s\n", l->file[i].name, why);
    }
    printf("%d entries, %d damaged\n", entries, damaged);
    if (damaged) {
        cli_end();
        cli_die("%s: %d of %d entries damaged", path, damaged, entries);
    }
}

static void prune(const char *path, struct cache_list *l, const char *what)
{
    double days = HUGE_VAL, size = HUGE_VAL, left = 0, removed = 0;
    const struct cli_item item[] = {{"days", &days, 0, 1e5, 0}, {"size", &size, 0, 1e6, 0}};
    int64_t now = 0;

    cli_items("cache-prune", what, item, 2);
    cli_check(path, cache_now(path, &now));
    cache_stale(l, now, days * DAY, size * GIGABYTE);
    for (int64_t i = 0; i < l->n; i++) {
        const struct cache_file *file = &l->file[i];
        const char *why = file->stale ? cache_remove(path, file->name) : NULL;
        if (why)
            cli_note("%s/%s: %s", path, file->name, why);
        if (file->stale && !why)
            printf("%s %lld\n", file->name, (long long)file->size);
        *(file->stale && !why ? &removed : &left) += (double)file->size;
    }
    printf("%.0f bytes removed, %.0f left\n", removed, left);
}

void cli_cache_care(const struct cli_cache_care *care)
{
    const char *path = folder();
    struct cache_list l;

    if (!path)
        cli_die("VX_CACHE is not set: there is no cache");
    cli_check(path, cache_list_read(&l, path));
    if (care->list)
        list(path, &l);
    else if (care->verify)
        verify(path, &l);
    else
        prune(path, &l, care->prune);
    cache_list_free(&l);
}
