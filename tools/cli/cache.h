/* The cache of contact tables, formats/cache.h, in the folder that the environment names: VX_CACHE; none where it is unset or empty. */
#ifndef VX_CLI_CACHE_H
#define VX_CLI_CACHE_H

#include "formats/cache.h"
#include "formats/ctab.h"
#include "tools/cli/cli.h"

struct cli_cache {
    const char *folder;          /* NULL: no cache */
    struct cache_key key;
    char name[CACHE_NAME];
    int damaged;                 /* the entry found, which is to be replaced */
    struct vxf entry;            /* what a table found points into: vxf_close when done */
};

/* The table of this wheel on this rail by the program's options, into t; 0 where it must be made.  Each option counts by name and value,
 * but for those that name the profiles, which count by content, and the output.  A damaged entry is told and counts as none. */
int cli_cache_find(struct cli_cache *c, const struct cli_option *option, int revision, const struct vxf *wheel, const struct vxf *rail,
                   struct ctab *t);

/* Keeps the table made, where no other program has done so meanwhile; a failure is told, and that is all. */
void cli_cache_keep(struct cli_cache *c, const struct ctab *t);

/* What --cache-list, --cache-verify and --cache-prune ask for. */
struct cli_cache_care {
    int list, verify;
    const char *prune;           /* days=N,size=GB */
};
void cli_cache_care(const struct cli_cache_care *care);

#endif
