#include "tools/integrate/newmark.h"
#include "formats/reason.h"
#include "tools/contact/clones.h"
#include "tools/integrate/arrays.h"
#include "tools/track/rails.h"

#include <stdlib.h>
#include <string.h>

enum { RELIEFS_MOST = 40 };
#define RELIEF_TOLERANCE 1e-3 /* N */

/* ---- setting up ---- */

static void place_arrays(struct newmark *m, struct arrays *a)
{
    const int64_t n = m->n + BANDED_PAD, nodes = m->track->nodes, sleepers = m->track->sleepers;
    double **state[] = {&m->weight, &m->u, &m->v, &m->a, &m->u0, &m->f, &m->displaced, &m->moved};

    for (size_t k = 0; k < sizeof state / sizeof *state; k++)
        *state[k] = arrays_take(a, n);
    m->Z = arrays_take(a, m->n * (m->beyond + 1));
    for (int s = 0; s < 2; s++) {
        double **node[] = {&m->near[s], &m->far[s], &m->near_held[s], &m->far_held[s], &m->pitch[s], &m->w[s], &m->wa[s]};
        for (size_t k = 0; k < sizeof node / sizeof *node; k++)
            *node[k] = arrays_take(a, nodes);
        for (int k = 0; k < 5; k++)
            m->bend[s][k] = arrays_take(a, nodes);
        m->seat[s] = arrays_take(a, sleepers);
        m->arm[s] = arrays_take(a, sleepers);
        m->pad[s] = arrays_take(a, sleepers);
    }
    for (int s = 0; s < TRK_BALLAST; s++)
        m->ballast[s] = arrays_take(a, sleepers);
    m->z = arrays_take(a, sleepers);
    m->roll = arrays_take(a, sleepers);
    m->za = arrays_take(a, sleepers);
}

static const char *allocate(struct newmark *m)
{
    struct arrays a = {0};

    place_arrays(m, &a);
    if (!(a.base = m->store = calloc(a.used, sizeof *m->store)))
        return REASON_MEMORY;
    a.used = 0;
    place_arrays(m, &a);
    m->beam[0] = calloc(2 * (size_t)m->track->nodes, sizeof *m->beam[0]);
    m->beam[1] = m->beam[0] ? m->beam[0] + m->track->nodes : NULL;
    return m->beam[0] ? NULL : REASON_MEMORY;
}

static void set_elements(struct newmark *m)
{
    for (int s = 0; s < 2; s++)
        for (int64_t i = 0; i + 1 < m->track->nodes; i++) {
            double K[4][4];
            m->beam[s][i] = rails_beam(m->track, s, i);
            beam_stiffness(&m->beam[s][i], K);
            m->bend[s][0][i] = K[1][0];
            m->bend[s][1][i] = K[1][1];
            m->bend[s][2][i] = K[1][3];
            m->bend[s][3][i] = K[3][0];
            m->bend[s][4][i] = K[3][3];
        }
    for (int s = 0; s < 2; s++)
        for (int64_t i = 0; i < m->track->sleepers; i++)
            m->arm[s][i] = trk_pad_arm(m->track, s, i);
}

/* M e g, e going down with all of the track. */
static void set_weight(struct newmark *m, double gravity)
{
    const struct trk *t = m->track;
    double *e = m->displaced;

    for (int64_t i = 0; i < t->nodes; i++)
        e[trk_rail_dof(t, TRK_LEFT, i)] = e[trk_rail_dof(t, TRK_RIGHT, i)] = gravity;
    for (int64_t i = 0; i < t->check_nodes; i++)
        e[t->check_dof[i]] = gravity;
    for (int64_t i = 0; i < t->sleepers; i++)
        e[t->sleeper_dof[i]] = gravity;
    banded_multiply(&m->M, e, m->weight);
}

static const char *assemble(struct newmark *m)
{
    const struct trk *t = m->track;
    const double h = m->h;
    const int64_t half[3] = {banded_half(t->dofs, t->Ap, t->Ai, t->Kx), banded_half(t->dofs, t->Ap, t->Ai, t->Cx),
                             banded_half(t->dofs, t->Ap, t->Ai, t->Mx)};
    const int64_t most = half[0] > half[1] ? half[0] : half[1];
    const char *why = banded_new(&m->S, t->dofs, most > half[2] ? most : half[2]);

    if (why || (why = banded_new(&m->C, t->dofs, half[1])) || (why = banded_new(&m->M, t->dofs, half[2])))
        return why;
    banded_add(&m->M, 1, t->Ap, t->Ai, t->Mx);
    banded_add(&m->C, 1, t->Ap, t->Ai, t->Cx);
    banded_add(&m->S, 1, t->Ap, t->Ai, t->Kx);
    banded_add(&m->S, 2 / h, t->Ap, t->Ai, t->Cx);
    banded_add(&m->S, 4 / (h * h), t->Ap, t->Ai, t->Mx);
    return banded_factor(&m->S);
}

/* The widest distance between degrees of freedom at the two ends of an element. */
static int element_span(const struct trk *t)
{
    int64_t most = 0;

    for (int64_t i = 0; i + 1 < t->nodes; i++) {
        int64_t span = trk_rail_dof(t, TRK_RIGHT, i + 1) + t->rail_dofs - 1 - t->node_dof[i];
        most = span > most ? span : most;
    }
    return (int)most;
}

const char *newmark_new(struct newmark *m, const struct trk *t, double gravity, double step)
{
    const char *why;

    *m = (struct newmark){.track = t, .n = t->dofs, .h = step};
    why = assemble(m);
    m->beyond = element_span(t) > m->S.half ? element_span(t) : m->S.half;
    if (!why)
        why = allocate(m);
    if (!why)
        why = relief_new(&m->relief, t);
    if (why) {
        newmark_free(m);
        return why;
    }
    banded_inverse(&m->S, m->beyond, m->Z);
    set_elements(m);
    set_weight(m, gravity);
    return NULL;
}

void newmark_free(struct newmark *m)
{
    banded_free(&m->S);
    banded_free(&m->C);
    banded_free(&m->M);
    relief_free(&m->relief);
    free(m->store);
    free(m->beam[0]);
    *m = (struct newmark){0};
}

void newmark_set(struct newmark *m, const double *u)
{
    const size_t size = (size_t)m->n * sizeof *u;

    memcpy(m->u, u, size);
    memset(m->v, 0, size);
    memset(m->a, 0, size);
    memset(m->f, 0, size);
    m->solved = 0;
    relief_seek(&m->relief, m->track, m->h, m->u, m->u, m->v, m->f);
    m->relief.change = 0; /* at rest it is what it is */
}

/* ---- the step ---- */

/* What M and C multiply, of the state before. */
CLONES static void combine_states(int64_t n, double h, const double *restrict u, const double *restrict v, const double *restrict a,
                           double *restrict u0, double *restrict displaced, double *restrict moved)
{
    const double q = 2 / h;

    for (int64_t i = 0; i < n; i++) {
        double y = q * u[i] + v[i];
        displaced[i] = q * (y + v[i]) + a[i];
        moved[i] = y;
        u0[i] = u[i];
    }
}

void newmark_advance(struct newmark *m)
{
    combine_states(m->n, m->h, m->u, m->v, m->a, m->u0, m->displaced, m->moved);
    memcpy(m->u, m->weight, (size_t)m->n * sizeof *m->u);
    banded_multiply(&m->M, m->displaced, m->u);
    banded_multiply(&m->C, m->moved, m->u);
    memset(m->f, 0, (size_t)m->n * sizeof *m->f);
    relief_load(&m->relief, m->track, m->f);
    m->solved = 0;
    for (int s = 0; s < 2; s++) {
        memset(m->near_held[s], 0, (size_t)m->track->nodes * sizeof *m->near_held[s]);
        memset(m->far_held[s], 0, (size_t)m->track->nodes * sizeof *m->far_held[s]);
    }
}

static int64_t first_dof(const struct newmark *m, int rail, int64_t node)
{
    return trk_rail_dof(m->track, rail, node);
}

void newmark_load(struct newmark *m, int rail, const struct wheel_place *p, double F)
{
    for (int k = 0; k < 4; k++)
        m->f[first_dof(m, rail, p->node + k / 2) + k % 2] += F * p->shape[k];
    m->near_held[rail][p->node] += F * p->shape[1];
    m->far_held[rail][p->node] += F * p->shape[3];
}

CLONES static void add_loads(int64_t n, const double *restrict x, double *restrict y)
{
    for (int64_t i = 0; i < n; i++)
        y[i] += x[i];
}

/* S is linear: what is loaded later is solved for alone and added. */
static void solve_loads(struct newmark *m)
{
    if (m->solved) {
        banded_solve(&m->S, m->f);
        add_loads(m->n, m->f, m->u);
    } else {
        add_loads(m->n, m->f, m->u);
        banded_solve(&m->S, m->u);
    }
    memset(m->f, 0, (size_t)m->n * sizeof *m->f);
    m->solved = 1;
}

void newmark_move(struct newmark *m)
{
    solve_loads(m);
    for (int k = 0; k < RELIEFS_MOST && m->relief.any; k++) {
        relief_seek(&m->relief, m->track, m->h, m->u, m->u0, m->v, m->f);
        if (m->relief.change <= RELIEF_TOLERANCE)
            break;
        solve_loads(m);
    }
}

double newmark_unrest(const struct newmark *m)
{
    return m->relief.change <= RELIEF_TOLERANCE ? 0 : m->relief.change;
}

CLONES static void find_rates(int64_t n, double h, const double *restrict u, const double *restrict u0, double *restrict v, double *restrict a)
{
    const double q = 2 / h;

    for (int64_t i = 0; i < n; i++) {
        double v1 = q * (u[i] - u0[i]) - v[i];
        a[i] = q * (v1 - v[i]) - a[i];
        v[i] = v1;
    }
}

/* ---- what is shown ---- */

static void show_rail(struct newmark *m, int s)
{
    const struct trk *t = m->track;

    for (int64_t i = 0; i < t->nodes; i++) {
        int64_t k = first_dof(m, s, i);
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
            int64_t w = first_dof(m, s, t->sleeper_node[i]);
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
            const int64_t w = first_dof(m, s, t->sleeper_node[i]);
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

/* ---- under a wheel ---- */

double newmark_sample(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4], const double *state)
{
    const double *near = state + first_dof(m, rail, p->node), *far = state + first_dof(m, rail, p->node + 1);

    return f[0] * near[0] + f[1] * near[1] + f[2] * far[0] + f[3] * far[1];
}

double newmark_moved(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4])
{
    return newmark_sample(m, rail, p, f, m->u) - newmark_sample(m, rail, p, f, m->u0);
}

double newmark_rate(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4])
{
    const double v0 = newmark_sample(m, rail, p, f, m->v);

    return m->solved ? 2 / m->h * newmark_moved(m, rail, p, f) - v0 : v0;
}

double newmark_speed(const struct newmark *m, const struct direction *d)
{
    const double v0 = direction_sample(d, m->v);

    return m->solved ? 2 / m->h * (direction_sample(d, m->u) - direction_sample(d, m->u0)) - v0 : v0;
}

double newmark_give(const struct newmark *m, const struct wheel_place *p, int to, const double f[4], int from)
{
    const int width = m->beyond + 1;
    double sum = 0;

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            int64_t a = first_dof(m, to, p->node + i / 2) + i % 2, b = first_dof(m, from, p->node + j / 2) + j % 2;
            sum += f[i] * p->shape[j] * (a < b ? m->Z[a * width + b - a] : m->Z[b * width + a - b]);
        }
    return sum;
}
