#include "tools/vehicle/couplings_memory.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

const char *couplings_memory_new(struct couplings_memory *m, const struct veh *v)
{
    size_t n = (size_t)v->couplings;

    *m = (struct couplings_memory){.couplings = v->couplings};
    m->before = calloc(2*n + 1, sizeof *m->before);
    if (!m->before)
        return REASON_MEMORY;
    m->now = m->before + n;
    return NULL;
}

void couplings_memory_free(struct couplings_memory *m)
{
    free(m->before);
    *m = (struct couplings_memory){0};
}

void couplings_relax(struct couplings_memory *m)
{
    m->step = 0;
    memset(m->before, 0, 2 * (size_t)m->couplings * sizeof *m->before);
}

void couplings_keep(struct couplings_memory *m, double h)
{
    for (int64_t c = 0; c < m->couplings; c++)
        m->before[c] = m->now[c];
    m->step = h;
}

void couplings_centre(const struct veh *v, struct couplings_memory *m)
{
    m->step = 0;
    for (int64_t c = 0; c < m->couplings; c++) {
        m->before[c] = m->now[c];
        if (v->type[c] == VEH_FRICTION)
            for (int k = 0; k < 3; k++)
                m->before[c].F[k] = 0;
    }
}
