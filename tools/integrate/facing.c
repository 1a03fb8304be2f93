#include "tools/integrate/facing.h"

/* Of vectors along x or y and rotations about them. */
static const int turned[RUN_CHANNELS] = {
    [RUN_STATION] = 1, [RUN_Y] = 1, [RUN_T] = 1, [RUN_CHECK] = 1, [RUN_MX] = 1, [RUN_RAIL_Y] = 1, [RUN_CONTACT_Y] = 1, [RUN_CONTACT_WHEEL_Y] = 1,
    [RUN_CONTACT_X] = 1, [RUN_ANGLE] = 1, [RUN_XI] = 1, [RUN_ETA] = 1, [RUN_TX] = 1, [RUN_TY] = 1, [RUN_BODY_OFFSET] = 1, [RUN_SLEEPER_ROLL] = 1,
};
static const int turned_dof[6] = {1, 1, 0, 1, 1, 0};

static int64_t size_of(const struct run *r, enum run_dim dim)
{
    return run_count(r, &(struct run_channel_info){.dim = {dim}});
}

static int is_reversed(enum run_dim dim, int follows)
{
    return dim == RUN_PER_SIDE || dim == RUN_PER_BALLAST || ((dim == RUN_PER_SLEEPER || dim == RUN_PER_NODE) && !follows);
}

/* Where element i goes: a move that undoes itself. */
static int64_t image(const struct run *r, const struct run_channel_info *c, int follows, int64_t i)
{
    int64_t to = 0, stride = 1;
    int n = 0;

    while (n < 4 && c->dim[n] != RUN_END)
        n++;
    while (n-- > 0) {
        const int64_t size = size_of(r, c->dim[n]), at = i % size;
        to += stride * (is_reversed(c->dim[n], follows) ? size - 1 - at : at);
        stride *= size;
        i /= size;
    }
    return to;
}

static void swap(const struct run_channel_info *c, void *x, int64_t i, int64_t j)
{
    if (c->type == VXF_F64) {
        double *d = x, kept = d[i];
        d[i] = d[j];
        d[j] = kept;
    } else {
        float *f = x, kept = f[i];
        f[i] = f[j];
        f[j] = kept;
    }
}

static void negate(const struct run_channel_info *c, void *x, int64_t i)
{
    if (c->type == VXF_F64)
        ((double *)x)[i] = -((double *)x)[i];
    else
        ((float *)x)[i] = -((float *)x)[i];
}

static void reorder(const struct run *r, const struct run_channel_info *c, int follows, void *x)
{
    const int64_t n = run_count(r, c);

    for (int64_t i = 0; i < n; i++) {
        const int64_t j = image(r, c, follows, i);
        if (j > i)
            swap(c, x, i, j);
    }
}

void facing_channel(const struct run *r, enum run_channel c, int follows, void *x)
{
    const struct run_channel_info *info = &run_channels[c];
    const int64_t n = run_count(r, info);
    const int dofs = info->dim[1] == RUN_PER_DOF;

    reorder(r, info, follows, x);
    for (int64_t i = 0; i < n; i++)
        if (dofs ? turned_dof[i % 6] : turned[c])
            negate(info, x, i);
}

void facing_extreme(const struct run *r, enum run_extreme c, int follows, double *x)
{
    const int64_t n = run_count(r, &run_extremes[c]);

    reorder(r, &run_extremes[c], follows, x);
    for (int64_t i = 0; i < n && c == RUN_AT_MAX_Q; i++)
        negate(&run_extremes[c], x, i);
}

void facing_turn(int64_t n, int64_t width, double *v)
{
    for (int64_t i = 0; i < n; i++)
        for (int64_t k = 0; k < 2 && k < width; k++)
            v[width * i + k] = -v[width * i + k];
}
