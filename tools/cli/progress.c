#include "tools/cli/progress.h"
#include "tools/cli/cli_private.h"

#include <stdio.h>
#include <unistd.h>

void progress_show(struct progress *p, int64_t done, int64_t all, const char *name, double value, const char *unit)
{
    if (!p->shown) {
        p->shown = p->first = done - 1;
        p->began = p->seconds();
    }
    if (p->quiet || (done - p->shown) * 50 < all)
        return;
    p->shown = done;
    if (!isatty(STDERR_FILENO))
        return;
    fprintf(stderr, "\r%s %3.0f %%  %s = %.1f %s  %.0f s left  %s", cli_name, 100.0 * (double)done / (double)all, name, value, unit,
            (p->seconds() - p->began) * (double)(all - done) / (double)(done - p->first), done == all ? "\n" : "");
}
