/* Everything per step runs over arrays of `stride` numbers: elements along a rail, pads, ballast, accelerations. */
#include "tools/integrate/lumped.h"
#include "tools/contact/clones.h"
#include "tools/integrate/two_step.h"

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
        double *shear = l->shear[s] + LUMPED_LANES + i, *near = l->near[s] + LUMPED_LANES + i, *far = l->far[s] + LUMPED_LANES + i;
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
        const int64_t to = i + BLOCK < l->n ? i + BLOCK : l->n, ahead = i + BLOCK + LUMPED_LANES < k ? i + BLOCK + LUMPED_LANES : k;
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
    l->near[rail][LUMPED_LANES + p->node] -= F * p->shape[1];
    l->far[rail][LUMPED_LANES + p->node] -= F * p->shape[3];
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
    const double *near = l->near[rail] + LUMPED_LANES, *far = l->far[rail] + LUMPED_LANES;

    mean_moment(l->n, near, far, m);
    m[0] = -near[0];
    m[l->n - 1] = far[l->n - 2];
}
