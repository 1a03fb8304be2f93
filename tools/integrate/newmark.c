#include "tools/integrate/newmark.h"
#include "tools/contact/clones.h"

#include <string.h>

enum { RELIEFS_MOST = 40 };
#define RELIEF_TOLERANCE 1e-3 /* N */

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

void newmark_load(struct newmark *m, int rail, const struct wheel_place *p, double F)
{
    for (int k = 0; k < 4; k++)
        m->f[trk_rail_dof(m->track, rail, p->node + k / 2) + k % 2] += F * p->shape[k];
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

/* ---- under a wheel ---- */

double newmark_sample(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4], const double *state)
{
    const double *near = state + trk_rail_dof(m->track, rail, p->node), *far = state + trk_rail_dof(m->track, rail, p->node + 1);

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
            int64_t a = trk_rail_dof(m->track, to, p->node + i / 2) + i % 2, b = trk_rail_dof(m->track, from, p->node + j / 2) + j % 2;
            sum += f[i] * p->shape[j] * (a < b ? m->Z[a * width + b - a] : m->Z[b * width + a - b]);
        }
    return sum;
}
