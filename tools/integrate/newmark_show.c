/* What the end of an implicit step shows: rates, motion and forces of rails and sleepers, losses and bending moments. */
#include "tools/integrate/newmark.h"
#include "tools/contact/clones.h"

CLONES static void find_rates(int64_t n, double h, const double *restrict u, const double *restrict u0, double *restrict v, double *restrict a)
{
    const double q = 2 / h;

    for (int64_t i = 0; i < n; i++) {
        double v1 = q * (u[i] - u0[i]) - v[i];
        a[i] = q * (v1 - v[i]) - a[i];
        v[i] = v1;
    }
}

static void show_rail(struct newmark *m, int s)
{
    const struct trk *t = m->track;

    for (int64_t i = 0; i < t->nodes; i++) {
        int64_t k = trk_rail_dof(m->track, s, i);
        m->w[s][i] = m->u[k];
        m->pitch[s][i] = m->u[k + 1];
        m->wa[s][i] = m->a[k];
    }
}

/* Rows t1 and t2 of K, whose w2 is less w1 (rigid displacement bends nothing), on [w1 t1 w2 t2], less the moments of held ends. */
CLONES static void bend_elements(int64_t n, const double *restrict w, const double *restrict t, const double *restrict k10,
                        const double *restrict k11, const double *restrict k13, const double *restrict k30, const double *restrict k33,
                        const double *restrict near_held, const double *restrict far_held, double *restrict near, double *restrict far)
{
    for (int64_t i = 0; i < n - 1; i++) {
        double d = w[i] - w[i + 1];
        near[i] = k10[i] * d + k11[i] * t[i] + k13[i] * t[i + 1] - near_held[i];
        far[i] = k30[i] * d + k13[i] * t[i] + k33[i] * t[i + 1] - far_held[i];
    }
}

static void show_sleepers(struct newmark *m)
{
    const struct trk *t = m->track;
    const int64_t n = t->sleepers;

    for (int64_t i = 0; i < n; i++) {
        int64_t k = t->sleeper_dof[i];
        const double z = m->u[k], r = m->u[k + 1], vz = m->v[k], vr = m->v[k + 1];
        m->z[i] = z;
        m->roll[i] = r;
        m->za[i] = m->a[k];
        for (int s = 0; s < 2; s++) {
            int64_t w = trk_rail_dof(t, s, t->sleeper_node[i]);
            double y = m->arm[s][i];
            m->seat[s][i] = m->u[w];
            m->pad[s][i] = t->pad_k[s * n + i] * (m->u[w] - z - y * r) + t->pad_c[s * n + i] * (m->v[w] - vz - y * vr);
        }
        for (int s = 0; s < TRK_BALLAST; s++) {
            double y = t->ballast_y[s * n + i];
            const int in_K = t->ballast_state[s * n + i] != TRK_OPEN;
            m->ballast[s][i] = in_K * (t->ballast_k[s * n + i] * (z + y * r) + t->ballast_c[s * n + i] * (vz + y * vr)) - m->relief.P[s][i];
        }
    }
}

void newmark_finish(struct newmark *m)
{
    if (m->solved)
        find_rates(m->n, m->h, m->u, m->u0, m->v, m->a);
    m->solved = 0;
    for (int s = 0; s < 2; s++) {
        show_rail(m, s);
        bend_elements(m->track->nodes, m->w[s], m->pitch[s], m->bend[s][0], m->bend[s][1], m->bend[s][2], m->bend[s][3], m->bend[s][4],
                      m->near_held[s], m->far_held[s], m->near[s], m->far[s]);
    }
    show_sleepers(m);
}

/* e' C e/h, e the motion of the step. */
static double lose_all(struct newmark *m)
{
    double sum = 0;

    for (int64_t i = 0; i < m->n; i++) {
        m->moved[i] = m->u[i] - m->u0[i];
        m->displaced[i] = 0;
    }
    banded_multiply(&m->C, m->moved, m->displaced);
    for (int64_t i = 0; i < m->n; i++)
        sum += m->moved[i] * m->displaced[i];
    return sum / m->h;
}

/* c e^2/h, e the extension of the step. */
void newmark_lose(struct newmark *m, double *lost)
{
    if (trk_is_spatial(m->track)) {
        *lost += lose_all(m);
        return;
    }
    const struct trk *t = m->track;
    const int64_t n = t->sleepers;

    for (int64_t i = 0; i < n; i++) {
        const int64_t k = t->sleeper_dof[i];
        const double z = m->u[k] - m->u0[k], r = m->u[k + 1] - m->u0[k + 1];
        double sum = 0;
        for (int s = 0; s < 2; s++) {
            const int64_t w = trk_rail_dof(t, s, t->sleeper_node[i]);
            const double e = m->u[w] - m->u0[w] - z - m->arm[s][i] * r;
            sum += t->pad_c[s * n + i] * e * e;
        }
        for (int s = 0; s < TRK_BALLAST; s++) {
            const double e = z + t->ballast_y[s * n + i] * r;
            sum += t->ballast_c[s * n + i] * e * e;
        }
        lost[i] += sum / m->h;
    }
}

/* M = -EI w'' is positive where the rail sags: near = EI w'', far = -EI w''.  The elements behind a node and ahead of it differ by the
 * inertia of the node and of their own: the mean is taken. */
void newmark_moment(const struct newmark *m, int rail, double *moment)
{
    const double *near = m->near[rail], *far = m->far[rail];
    const int64_t n = m->track->nodes;

    moment[0] = -near[0];
    moment[n - 1] = far[n - 2];
    for (int64_t i = 1; i + 1 < n; i++)
        moment[i] = 0.5 * (far[i - 1] - near[i]);
}
