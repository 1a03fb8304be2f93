#include "tools/track/pattern.h"

#include <stdlib.h>

#include "formats/reason.h"

const char *pattern_new(struct pattern *p, int64_t dofs, int64_t half)
{
    *p = (struct pattern){.dofs = dofs, .half = half};
    p->mark = calloc((size_t)dofs, (size_t)(2 * half + 1));
    return p->mark ? NULL : REASON_MEMORY;
}

void pattern_free(struct pattern *p)
{
    free(p->mark);
    *p = (struct pattern){0};
}

void pattern_mark(struct pattern *p, int64_t i, int64_t j)
{
    p->mark[j * (2 * p->half + 1) + i - j + p->half] = 1;
}

int64_t pattern_count(const struct pattern *p)
{
    int64_t n = 0;

    for (int64_t k = 0; k < p->dofs * (2 * p->half + 1); k++)
        n += p->mark[k];
    return n;
}

void pattern_list(const struct pattern *p, int64_t *Ap, int64_t *Ai)
{
    const int64_t width = 2 * p->half + 1;
    int64_t n = 0;

    for (int64_t j = 0; j < p->dofs; j++) {
        Ap[j] = n;
        for (int64_t k = 0; k < width; k++)
            if (p->mark[j * width + k])
                Ai[n++] = j + k - p->half;
    }
    Ap[p->dofs] = n;
}
