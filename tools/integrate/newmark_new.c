/* The matrices, arrays and weight of a track in the implicit time step, and its rest. */
#include "tools/integrate/newmark.h"
#include "formats/reason.h"
#include "tools/integrate/arrays.h"
#include "tools/track/rails.h"

#include <stdlib.h>
#include <string.h>

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
