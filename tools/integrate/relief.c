#include "tools/integrate/relief.h"
#include "formats/reason.h"

#include <math.h>
#include <stdlib.h>

const char *relief_new(struct relief *r, const struct trk *t)
{
    *r = (struct relief){0};
    for (int64_t k = 0; k < TRK_BALLAST * t->sleepers; k++)
        r->any |= t->ballast_state[k] != TRK_BONDED;
    r->P[0] = calloc((size_t)(TRK_BALLAST * t->sleepers), sizeof *r->P[0]);
    if (!r->P[0])
        return REASON_MEMORY;
    for (int s = 1; s < TRK_BALLAST; s++)
        r->P[s] = r->P[0] + s * t->sleepers;
    return NULL;
}

void relief_free(struct relief *r)
{
    free(r->P[0]);
    *r = (struct relief){0};
}

static void add(const struct trk *t, int s, int64_t i, double F, double *f)
{
    f[t->sleeper_dof[i]] += F;
    f[t->sleeper_dof[i] + 1] += F * t->ballast_y[s * t->sleepers + i];
}

void relief_load(const struct relief *r, const struct trk *t, double *f)
{
    for (int s = 0; r->any && s < TRK_BALLAST; s++)
        for (int64_t i = 0; i < t->sleepers; i++)
            add(t, s, i, r->P[s][i], f);
}

/* z + y roll of spring s of sleeper i */
static double point(const struct trk *t, int s, int64_t i, const double *x)
{
    return x[t->sleeper_dof[i]] + t->ballast_y[s * t->sleepers + i] * x[t->sleeper_dof[i] + 1];
}

/* P of that spring. */
static double seek(const struct trk *t, int s, int64_t i, double e, double rate)
{
    const int64_t j = s * t->sleepers + i;
    const double k = t->ballast_k[j], c = t->ballast_c[j], gap = t->ballast_gap[j];
    const double linear = t->ballast_state[j] == TRK_OPEN ? 0 : k * e + c * rate;

    return t->ballast_state[j] == TRK_BONDED ? 0 : linear - (e > gap ? fmax(k * (e - gap) + c * rate, 0) : 0);
}

void relief_seek(struct relief *r, const struct trk *t, double h, const double *u, const double *u0, const double *v0, double *f)
{
    r->change = 0;
    for (int s = 0; r->any && s < TRK_BALLAST; s++)
        for (int64_t i = 0; i < t->sleepers; i++) {
            const double e = point(t, s, i, u), rate = 2 / h * (e - point(t, s, i, u0)) - point(t, s, i, v0);
            const double P = seek(t, s, i, e, rate), more = P - r->P[s][i];
            r->P[s][i] = P;
            r->change = fmax(r->change, fabs(more));
            add(t, s, i, more, f);
        }
}
