/* The cache of contact tables: a folder of .ctab files, each named by what it was computed from.
 *
 * The key is a list of lines "name value": hashes of the profiles' content, options, revision of the kernels.  Its 128-bit xxh3 in
 * hexadecimal and ".ctab" is the name of the entry, and the entry's header holds the lines as "CACHE= name value", so that it says itself
 * what its name must be.  An entry has no history: who makes it anew makes the same bytes.
 *
 * Entries are written as NAME.XXXXXX, flushed and renamed, so that folders may be shared by programs and by machines without locks: a
 * reader finds an entry whole or not at all.  The time of a file is that of its last use. */
#ifndef VX_FORMATS_CACHE_H
#define VX_FORMATS_CACHE_H

#include "formats/vxf.h"

enum {
    CACHE_NAME = 32 + sizeof ".ctab",                     /* bytes of an entry's name */
    CACHE_FILE = CACHE_NAME + sizeof ".XXXXXX" - 1,       /* of its temporary's */
    CACHE_TEXT = 2048
};

struct cache_key {
    char text[CACHE_TEXT];    /* lines "name value" */
    size_t length;
    const char *why;          /* first failure of a put, told by cache_key_name */
};

/* Adds a line. */
void cache_key_put(struct cache_key *k, const char *name, const char *format, ...) VX_PRINTF(3, 4);
/* The entry's name into name[CACHE_NAME]. */
const char *cache_key_name(const struct cache_key *k, char *name);
/* The lines into the header of an entry. */
void cache_put_key(const struct cache_key *k, struct vxf_out *o);
/* The value of a line, from the header of an entry, into value[size]; "-" where there is none. */
void cache_value(const struct vxf *f, const char *name, char *value, size_t size);

/* Opens the entry and checks all of it, its own key too.  *found is 0 where there is none (and NULL is returned). */
const char *cache_open(struct vxf *f, const char *folder, const char *name, int *found);
/* Only its header; the key is checked. */
const char *cache_open_header(struct vxf *f, const char *folder, const char *name, int *found);
/* The entry was used now, where the folder's owner lets us say so. */
void cache_touch(const char *folder, const char *name);

struct cache_file {
    char name[CACHE_FILE];
    int temporary;            /* of a writer, at work or killed */
    int64_t size;             /* bytes */
    int64_t used;             /* s since 1970, by the clock of the folder's machine */
    int stale;                /* set by cache_stale */
};

struct cache_list {
    int64_t n, room;
    struct cache_file *file;  /* [n], the longest unused first */
};

/* Entries and temporaries; other files of the folder are no part of the cache. */
const char *cache_list_read(struct cache_list *l, const char *folder);
void cache_list_free(struct cache_list *l);

#define CACHE_TEMPORARY_AGE 3600      /* s: a writer takes seconds */

/* Marks what may go: entries last used before now - age (s), then the longest unused until the rest has at most `size` bytes,
 * and temporaries older than CACHE_TEMPORARY_AGE. */
void cache_stale(struct cache_list *l, int64_t now, double age, double size);

/* The time by the clock that stamps the folder's files, which need not be that of this machine. */
const char *cache_now(const char *folder, int64_t *now);
const char *cache_remove(const char *folder, const char *name);

#endif
