/* Everything per step runs over arrays of `stride` numbers: elements along a rail, pads, ballast, accelerations. */
#include "tools/integrate/lumped.h"
#include "formats/reason.h"
#include "tools/contact/clones.h"
#include "tools/integrate/arrays.h"
#include "tools/integrate/two_step.h"
#include "tools/track/rails.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LANES = 8 };

/* ---- setting up ---- */

static void place_arrays(struct lumped *l, struct arrays *a)
{
    const int64_t n = l->stride, all = LUMPED_PARTS * n;

    l->u = arrays_take(a, all);
    l->v = arrays_take(a, all);
    l->a = arrays_take(a, all);
    l->before = arrays_take(a, all);
    l->inverse = arrays_take(a, all);
    for (int s = 0; s < 2; s++) {
        l->pad[s] = arrays_take(a, n);
        l->k12[s] = arrays_take(a, n);
        l->k6[s] = arrays_take(a, n);
        l->k4[s] = arrays_take(a, n);
        l->taper_6[s] = arrays_take(a, n);
        l->taper_near[s] = arrays_take(a, n);
        l->taper_far[s] = arrays_take(a, n);
        l->shear[s] = arrays_take(a, n + LANES);
        l->near[s] = arrays_take(a, n + LANES);
        l->far[s] = arrays_take(a, n + LANES);
        l->pad_k[s] = arrays_take(a, n);
        l->pad_c[s] = arrays_take(a, n);
        l->arm[s] = arrays_take(a, n);
    }
    for (int s = 0; s < 3; s++) {
        l->ballast[s] = arrays_take(a, n);
        l->ballast_k[s] = arrays_take(a, n);
        l->ballast_c[s] = arrays_take(a, n);
        l->ballast_y[s] = arrays_take(a, n);
        l->gap[s] = arrays_take(a, n);
        l->floor[s] = arrays_take(a, n);
    }
}

/* K = [w -c1 -w -c2; . n c1 f; . . w c2; . . . m]: what is alike at both ends into k12, k6, k4, the rest into the taper. */
static void set_tapered(struct lumped *l, int s, int64_t i)
{
    double K[4][4];

    beam_stiffness(&l->beam[s][i], K);
    l->k12[s][i] = K[0][0];
    l->k6[s][i] = -0.5 * (K[0][1] + K[0][3]);
    l->k4[s][i] = 2 * K[1][3];
    l->taper_6[s][i] = -0.5 * (K[0][1] - K[0][3]);
    l->taper_near[s][i] = K[1][1] - 2 * K[1][3];
    l->taper_far[s][i] = K[3][3] - 2 * K[1][3];
    l->tapered[s] = 1;
}

static void set_rail(struct lumped *l, int s)
{
    const struct trk *t = l->track;
    double *w = l->inverse + (s ? LUMPED_WR : LUMPED_WL) * l->stride;
    double *p = l->inverse + (s ? LUMPED_TR : LUMPED_TL) * l->stride;

    for (int64_t i = 0; i < l->n; i++) {
        w[i] = 1 / t->rail_mass[s * l->n + i];
        p[i] = 1 / t->rail_inertia[s * l->n + i];
    }
    for (int64_t i = 0; i + 1 < l->n; i++) {
        const struct beam b = l->beam[s][i] = rails_beam(t, s, i);
        const double EI = b.bending, L = b.length;
        if (!(EI > 0))
            set_tapered(l, s, i);
        else {
            l->k12[s][i] = 12 * EI / (L * L * L);
            l->k6[s][i] = 6 * EI / (L * L);
            l->k4[s][i] = 4 * EI / L;
        }
    }
}

/* The explicit scheme's rails: mass at the nodes alone, Euler-Bernoulli, a node above every sleeper. */
static int is_lumped(const struct trk *t)
{
    int same = t->nodes == t->sleepers && t->nodes >= 2;

    for (int64_t k = 0; k < TRK_RAILS * (t->nodes - 1); k++)
        same &= t->rail_density[k] <= 0 && t->rail_rotary[k] <= 0 && t->rail_shear[k] <= 0;
    for (int64_t k = 0; k < TRK_RAILS * t->nodes; k++)
        same &= t->rail_mass[k] > 0 && t->rail_inertia[k] > 0;
    return same;
}

static void set_sleepers(struct lumped *l)
{
    const struct trk *t = l->track;

    for (int64_t i = 0; i < l->n; i++) {
        l->inverse[LUMPED_Z * l->stride + i] = 1 / t->sleeper_mass[i];
        l->inverse[LUMPED_ROLL * l->stride + i] = 1 / t->sleeper_inertia[i];
        for (int s = 0; s < 2; s++) {
            l->pad_k[s][i] = t->pad_k[s * l->n + i];
            l->pad_c[s][i] = t->pad_c[s * l->n + i];
            l->arm[s][i] = trk_pad_arm(t, s, i);
        }
        for (int s = 0; s < 3; s++) {
            l->ballast_k[s][i] = t->ballast_k[s * l->n + i];
            l->ballast_c[s][i] = t->ballast_c[s * l->n + i];
            l->ballast_y[s][i] = t->ballast_y[s * l->n + i];
            l->gap[s][i] = t->ballast_gap[s * l->n + i];
            const int bonded = t->ballast_state[s * l->n + i] == TRK_BONDED;
            l->floor[s][i] = bonded ? -HUGE_VAL : 0;
            l->pushes[s] |= !bonded;
        }
    }
}

const char *lumped_new(struct lumped *l, const struct trk *t, double gravity)
{
    struct arrays a = {0};

    *l = (struct lumped){.track = t, .n = t->sleepers, .gravity = gravity};
    l->stride = (t->sleepers + LANES - 1) / LANES * LANES;
    if (trk_is_spatial(t))
        return "the explicit scheme does not move rails sideways: dofs: vertical, or the implicit one";
    if (!is_lumped(t))
        return "the explicit scheme wants lumped Euler-Bernoulli rails with one rail node above every sleeper: mass_model: lumped, beam: euler, "
               "elements_per_bay: 1";
    place_arrays(l, &a);
    if (!(l->store = calloc(a.used + LANES, sizeof *l->store)))
        return REASON_MEMORY;
    a.base = l->store + (LANES - (uintptr_t)l->store / sizeof *l->store % LANES) % LANES; /* a vector lies in one line of the cache */
    a.used = 0;
    place_arrays(l, &a);
    l->beam[0] = calloc(2 * (size_t)l->n, sizeof *l->beam[0]);
    if (!l->beam[0]) {
        lumped_free(l);
        return REASON_MEMORY;
    }
    l->beam[1] = l->beam[0] + l->n;
    for (int s = 0; s < 2; s++)
        set_rail(l, s);
    set_sleepers(l);
    return NULL;
}

void lumped_free(struct lumped *l)
{
    free(l->store);
    free(l->beam[0]);
    *l = (struct lumped){0};
}

void lumped_set(struct lumped *l, const double *u)
{
    const struct trk *t = l->track;

    memset(l->v, 0, (size_t)(LUMPED_PARTS * l->stride) * sizeof *l->v);
    for (int64_t i = 0; i < t->nodes; i++)
        for (int part = LUMPED_WL; part <= LUMPED_TR; part++)
            l->u[part * l->stride + i] = u[t->node_dof[i] + part];
    for (int64_t i = 0; i < t->sleepers; i++)
        for (int part = LUMPED_Z; part <= LUMPED_ROLL; part++)
            l->u[part * l->stride + i] = u[t->sleeper_dof[i] + part - LUMPED_Z];
}

void lumped_state(const struct lumped *l, const double *state, double *x)
{
    const struct trk *t = l->track;

    for (int64_t i = 0; i < t->nodes; i++)
        for (int part = LUMPED_WL; part <= LUMPED_TR; part++)
            x[t->node_dof[i] + part] = state[part * l->stride + i];
    for (int64_t i = 0; i < t->sleepers; i++)
        for (int part = LUMPED_Z; part <= LUMPED_ROLL; part++)
            x[t->sleeper_dof[i] + part - LUMPED_Z] = state[part * l->stride + i];
}

/* ---- accelerations ---- */

/* End forces of the elements, with the elongation w1 - w2 and the pitches t1, t2 (K of beam.h):
 *   shear = 12 EI/L^3 (w1 - w2) - 6 EI/L^2 (t1 + t2)
 *   near  = -6 EI/L^2 (w1 - w2) + EI/L (4 t1 + 2 t2),  far = ... + EI/L (2 t1 + 4 t2) */
CLONES static void bend(int64_t n, const double *restrict w, const double *restrict t, const double *restrict k12,
                        const double *restrict k6, const double *restrict k4, double *restrict shear,
                        double *restrict near, double *restrict far)
{
    for (int64_t i = 0; i < n - 1; i++) {
        double d = w[i] - w[i + 1];
        shear[i] = k12[i] * d - k6[i] * (t[i] + t[i + 1]);
        near[i] = k4[i] * (t[i] + 0.5 * t[i + 1]) - k6[i] * d;
        far[i] = k4[i] * (0.5 * t[i] + t[i + 1]) - k6[i] * d;
    }
}

/* What an element has beside that where its stiffness varies. */
CLONES static void bend_tapered(int64_t n, const double *restrict w, const double *restrict t, const double *restrict k6,
                                const double *restrict k_near, const double *restrict k_far, double *restrict shear,
                                double *restrict near, double *restrict far)
{
    for (int64_t i = 0; i < n - 1; i++) {
        double d = w[i] - w[i + 1];
        shear[i] -= k6[i] * (t[i] - t[i + 1]);
        near[i] += k_near[i] * t[i] - k6[i] * d;
        far[i] += k_far[i] * t[i + 1] + k6[i] * d;
    }
}

/* Force of a spring and damper between w and a sleeper's point z + y roll. */
CLONES static void compress(int64_t n, const double *restrict w, const double *restrict vw, const double *restrict z,
                            const double *restrict vz, const double *restrict r, const double *restrict vr,
                            const double *restrict y, const double *restrict k, const double *restrict c,
                            double *restrict F)
{
    for (int64_t i = 0; i < n; i++)
        F[i] = k[i] * (w[i] - z[i] - y[i] * r[i]) + c[i] * (vw[i] - vz[i] - y[i] * vr[i]);
}

CLONES static void settle(int64_t n, const double *restrict z, const double *restrict vz, const double *restrict r,
                          const double *restrict vr, const double *restrict y, const double *restrict k,
                          const double *restrict c, double *restrict F)
{
    for (int64_t i = 0; i < n; i++)
        F[i] = k[i] * (z[i] + y[i] * r[i]) + c[i] * (vz[i] + y[i] * vr[i]);
}

/* The same where some ballast only pushes: beyond its gap k (e - gap) + c e', which never pulls. */
CLONES static void settle_pushing(int64_t n, const double *restrict z, const double *restrict vz, const double *restrict r,
                                  const double *restrict vr, const double *restrict y, const double *restrict k,
                                  const double *restrict c, const double *restrict gap, const double *restrict least, double *restrict F)
{
    for (int64_t i = 0; i < n; i++) {
        double e = z[i] + y[i] * r[i], f = k[i] * (e - gap[i]) + c[i] * (vz[i] + y[i] * vr[i]);
        f = f > least[i] ? f : least[i];
        F[i] = e > gap[i] + least[i] ? f : 0;
    }
}

/* m a_w = shear behind - shear ahead - pad + m g;   J a_t = -near ahead - far behind. */
CLONES static void rail_acceleration(int64_t n, const double *restrict shear, const double *restrict near,
                                     const double *restrict far, const double *restrict pad,
                                     const double *restrict inverse_m, const double *restrict inverse_J, double g,
                                     double *restrict aw, double *restrict at)
{
    for (int64_t i = 0; i < n; i++) {
        aw[i] = (shear[i - 1] - shear[i] - pad[i]) * inverse_m[i] + g;
        at[i] = -(near[i] + far[i - 1]) * inverse_J[i];
    }
}

CLONES static void sleeper_acceleration(int64_t n, const double *restrict pl, const double *restrict pr,
                                        const double *restrict yl, const double *restrict yr,
                                        const double *restrict b0, const double *restrict b1, const double *restrict b2,
                                        const double *restrict y0, const double *restrict y1, const double *restrict y2,
                                        const double *restrict inverse_m, const double *restrict inverse_J, double g,
                                        double *restrict az, double *restrict ar)
{
    for (int64_t i = 0; i < n; i++) {
        az[i] = (pl[i] + pr[i] - b0[i] - b1[i] - b2[i]) * inverse_m[i] + g;
        ar[i] = (yl[i] * pl[i] + yr[i] * pr[i] - y0[i] * b0[i] - y1[i] * b1[i] - y2[i] * b2[i]) * inverse_J[i];
    }
}

/* All of nodes and sleepers from i to before `to`; elements before i have been done. */
static void accelerate(struct lumped *l, int64_t i, int64_t to)
{
    const int64_t k = l->stride, n = to - i, elements = to < l->n ? n + 1 : n;     /* nodes that elements from i on stand on */
    const double *z = l->u + LUMPED_Z * k + i, *r = l->u + LUMPED_ROLL * k + i;
    const double *vz = l->v + LUMPED_Z * k + i, *vr = l->v + LUMPED_ROLL * k + i;

    for (int s = 0; s < 2; s++) {
        const int64_t w = (s ? LUMPED_WR : LUMPED_WL) * k + i, t = (s ? LUMPED_TR : LUMPED_TL) * k + i;
        double *shear = l->shear[s] + LANES + i, *near = l->near[s] + LANES + i, *far = l->far[s] + LANES + i;
        bend(elements, l->u + w, l->u + t, l->k12[s] + i, l->k6[s] + i, l->k4[s] + i, shear, near, far);
        if (l->tapered[s])
            bend_tapered(elements, l->u + w, l->u + t, l->taper_6[s] + i, l->taper_near[s] + i, l->taper_far[s] + i, shear, near, far);
        compress(n, l->u + w, l->v + w, z, vz, r, vr, l->arm[s] + i, l->pad_k[s] + i, l->pad_c[s] + i, l->pad[s] + i);
        rail_acceleration(n, shear, near, far, l->pad[s] + i, l->inverse + w, l->inverse + t, l->gravity, l->a + w, l->a + t);
    }
    for (int s = 0; s < 3; s++)
        if (l->pushes[s])
            settle_pushing(n, z, vz, r, vr, l->ballast_y[s] + i, l->ballast_k[s] + i, l->ballast_c[s] + i, l->gap[s] + i, l->floor[s] + i,
                           l->ballast[s] + i);
        else
            settle(n, z, vz, r, vr, l->ballast_y[s] + i, l->ballast_k[s] + i, l->ballast_c[s] + i, l->ballast[s] + i);
    sleeper_acceleration(n, l->pad[0] + i, l->pad[1] + i, l->arm[0] + i, l->arm[1] + i, l->ballast[0] + i, l->ballast[1] + i,
                         l->ballast[2] + i, l->ballast_y[0] + i, l->ballast_y[1] + i, l->ballast_y[2] + i,
                         l->inverse + LUMPED_Z * k + i, l->inverse + LUMPED_ROLL * k + i, l->gravity, l->a + LUMPED_Z * k + i,
                         l->a + LUMPED_ROLL * k + i);
}

void lumped_accelerate(struct lumped *l)
{
    accelerate(l, 0, l->n);
}

/* Block by block, so that what has just moved is still in the first level of the cache: 40 arrays of BLOCK numbers.  The motion is ahead by one
 * vector, of which the last element of a block needs a node. */
enum { BLOCK = 64 };

void lumped_step(struct lumped *l, double h)
{
    const int64_t k = l->stride;
    int64_t moved = 0;

    for (int64_t i = 0; i < l->n; i += BLOCK) {
        const int64_t to = i + BLOCK < l->n ? i + BLOCK : l->n, ahead = i + BLOCK + LANES < k ? i + BLOCK + LANES : k;
        for (int64_t part = moved; part < LUMPED_PARTS * k; part += k)
            two_step(ahead - moved, h, l->u + part, l->v + part, l->a + part, l->before + part);
        moved = ahead;
        accelerate(l, i, to);
    }
}

/* ---- wheels ---- */

double lumped_sample(const struct lumped *l, int rail, const struct wheel_place *p, const double f[4], const double *state)
{
    const double *w = state + (rail ? LUMPED_WR : LUMPED_WL) * l->stride + p->node;
    const double *t = state + (rail ? LUMPED_TR : LUMPED_TL) * l->stride + p->node;

    return f[0] * w[0] + f[1] * t[0] + f[2] * w[1] + f[3] * t[1];
}

/* The shares of the force at the ends, and off the element's own end moments those of its held ends. */
void lumped_load(struct lumped *l, int rail, const struct wheel_place *p, double F)
{
    int64_t w = (rail ? LUMPED_WR : LUMPED_WL) * l->stride + p->node;
    int64_t t = (rail ? LUMPED_TR : LUMPED_TL) * l->stride + p->node;

    l->a[w] += F * p->shape[0] * l->inverse[w];
    l->a[t] += F * p->shape[1] * l->inverse[t];
    l->a[w + 1] += F * p->shape[2] * l->inverse[w + 1];
    l->a[t + 1] += F * p->shape[3] * l->inverse[t + 1];
    l->near[rail][LANES + p->node] -= F * p->shape[1];
    l->far[rail][LANES + p->node] -= F * p->shape[3];
}

CLONES static void mean_moment(int64_t n, const double *restrict near, const double *restrict far, double *restrict m)
{
    for (int64_t i = 0; i < n; i++)
        m[i] = 0.5 * (far[i - 1] - near[i]);
}

/* M = -EI w'' is positive where the rail sags, so near = EI w'' = -M and far = -EI w'' = M.  The element behind a node and the one
 * ahead differ by the node's inertia: the mean is taken. */
void lumped_moment(const struct lumped *l, int rail, double *m)
{
    const double *near = l->near[rail] + LANES, *far = l->far[rail] + LANES;

    mean_moment(l->n, near, far, m);
    m[0] = -near[0];
    m[l->n - 1] = far[l->n - 2];
}

/* ---- stability ---- */

enum { POWER_ITERATIONS = 400 };

/* x <- M^-1 K x, scaled: the factor tends to the square of the highest frequency.  M^-1 K is similar to a symmetric
 * matrix, so the quotient with M as weight is that of Rayleigh and converges as the square of the vector does. */
double lumped_highest(struct lumped *l)
{
    size_t n = (size_t)(LUMPED_PARTS * l->stride);
    double lambda = 0, g = l->gravity;
    int pushes[3];

    memcpy(pushes, l->pushes, sizeof pushes);
    memset(l->pushes, 0, sizeof pushes);
    l->gravity = 0;
    memset(l->v, 0, n * sizeof *l->v);
    for (size_t i = 0; i < n; i++)
        l->u[i] = l->inverse[i] > 0 ? (i % 2 ? -1.0 : 1.0) / (1.0 + (double)(i % 7)) : 0;
    for (int k = 0; k < POWER_ITERATIONS; k++) {
        double xx = 0, xy = 0, yy = 0;
        lumped_accelerate(l);
        for (size_t i = 0; i < n; i++)
            if (l->inverse[i] > 0) {
                xx += l->u[i] * l->u[i] / l->inverse[i];
                xy -= l->u[i] * l->a[i] / l->inverse[i];
                yy += l->a[i] * l->a[i];
            }
        lambda = xy / xx;
        for (size_t i = 0; i < n; i++)
            l->u[i] = -l->a[i] / sqrt(yy);
    }
    memset(l->u, 0, n * sizeof *l->u);
    memset(l->a, 0, n * sizeof *l->a);
    l->gravity = g;
    memcpy(l->pushes, pushes, sizeof pushes);
    return sqrt(lambda);
}
