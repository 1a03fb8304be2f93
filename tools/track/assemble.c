/* Beam elements between the rail nodes, a spring and damper from each rail to each sleeper (railpad), three from each sleeper to
 * the ground (ballast), masses at the nodes and along the elements.  A spring of stiffness k and extension e = d.u gives K += k d d'.
 *
 * z down, y to the right: the point y of a sleeper goes down by z + y roll. */
#include "tools/track/assemble.h"

#include <math.h>

#include "formats/reason.h"
#include "tools/track/assemble_spatial.h"
#include "tools/track/matrix.h"
#include "tools/track/rails.h"

static const double GUIDE = 1e6;       /* Hz, natural frequency of what is held, beyond all that a track is asked for */

/* Entries: 2 x 2 at each node and rail and 2 x 4 to the next node, 2 x 2 of each sleeper and 2 x 2 to each rail. */
static int64_t count_entries(const struct trk *t)
{
    return TRK_RAILS * (4 * t->nodes + 8 * (t->nodes - 1)) + (4 + 4 * TRK_RAILS) * t->sleepers;
}

/* Degrees of freedom that column w or t of a rail at node i meets, increasing; sleeper is -1 where w has none. */
static int64_t put_rail_column(const struct trk *t, int64_t i, int rail, int64_t sleeper, int64_t *Ai)
{
    int64_t n = 0;

    for (int64_t j = i - 1; j <= i + 1; j++) {
        if (j < 0 || j >= t->nodes)
            continue;
        Ai[n++] = t->node_dof[j] + 2 * rail;
        Ai[n++] = t->node_dof[j] + 2 * rail + 1;
        if (j == i && sleeper >= 0) {
            Ai[n++] = t->sleeper_dof[sleeper];
            Ai[n++] = t->sleeper_dof[sleeper] + 1;
        }
    }
    return n;
}

static void fill_pattern(const struct trk *t, int64_t *Ap, int64_t *Ai)
{
    int64_t column = 0, p = 0;

    for (int64_t i = 0, k = 0; i < t->nodes; i++) {
        int64_t sleeper = k < t->sleepers && t->sleeper_node[k] == i ? k++ : -1;
        for (int c = 0; c < 2 * TRK_RAILS; c++) {                  /* wl tl wr tr: only w meets the sleeper */
            Ap[column++] = p;
            p += put_rail_column(t, i, c / 2, c % 2 ? -1 : sleeper, Ai + p);
        }
        for (int c = 0; c < 2 && sleeper >= 0; c++) {              /* z roll */
            Ap[column++] = p;
            Ai[p++] = t->node_dof[i];
            Ai[p++] = t->node_dof[i] + 2;
            Ai[p++] = t->sleeper_dof[sleeper];
            Ai[p++] = t->sleeper_dof[sleeper] + 1;
        }
    }
    Ap[column] = p;
}

static void add_element(const struct trk *t, const struct matrix *X, int rail, int64_t i, double x[4][4])
{
    const int64_t near = t->node_dof[i] + 2 * rail, far = t->node_dof[i + 1] + 2 * rail;
    const int64_t dof[4] = {near, near + 1, far, far + 1};

    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++)
            matrix_add(X, dof[a], dof[b], x[a][b]);
}

static void add_beams(const struct trk *t, const struct matrix *K, const struct matrix *M)
{
    for (int rail = 0; rail < TRK_RAILS; rail++)
        for (int64_t i = 0; i < t->nodes - 1; i++) {
            const struct beam b = rails_beam(t, rail, i);
            double x[4][4];
            beam_stiffness(&b, x);
            add_element(t, K, rail, i, x);
            if (b.mass > 0 || b.rotary > 0) {
                beam_mass(&b, x);
                add_element(t, M, rail, i, x);
            }
        }
}

/* A sleeper that cannot roll has no inertia in roll. */
static int rolls(const struct trk *t, int64_t sleeper)
{
    return t->sleeper_inertia[sleeper] > 0;
}

void assemble_ballast(const struct trk *t, double *x, int64_t spring, double k)
{
    const int64_t s = spring % t->sleepers, z = t->sleeper_dof[s];

    matrix_add_spring(&(struct matrix){NULL, t->Ap, t->Ai, x}, k, 2, (int64_t[]){z, z + 1},
                      (double[]){1, rolls(t, s) ? t->ballast_y[spring] : 0});
}

/* pad [2][sleepers] and ballast [3][sleepers]: stiffness for K, damping for C.  Ballast that does not touch has no part. */
static void add_supports(const struct trk *t, const struct matrix *X, const double *pad, const double *ballast)
{
    for (int64_t s = 0; s < t->sleepers; s++) {
        const int64_t z = t->sleeper_dof[s], roll = z + 1;
        for (int rail = 0; rail < TRK_RAILS; rail++) {
            const double arm = rolls(t, s) ? trk_pad_arm(t, rail, s) : 0;
            matrix_add_spring(X, pad[rail * t->sleepers + s], 3, (int64_t[]){t->node_dof[t->sleeper_node[s]] + 2 * rail, z, roll},
                              (double[]){1, -1, -arm});                   /* e = w - (z + arm roll) */
        }
        for (int b = 0; b < TRK_BALLAST; b++)
            if (t->ballast_state[b * t->sleepers + s] != TRK_OPEN)
                assemble_ballast(t, X->x, b * t->sleepers + s, ballast[b * t->sleepers + s]);
    }
}

static void hold_dof(const struct matrix *K, const struct matrix *M, int64_t dof, double stiffness)
{
    matrix_add(K, dof, dof, stiffness);
    matrix_add(M, dof, dof, stiffness / ((2 * M_PI * GUIDE) * (2 * M_PI * GUIDE)));
}

/* Of a moving mass, a single node of each rail, what must not turn stands alone in its row: no force reaches it. */
static void hold(const struct trk *t, const struct matrix *K, const struct matrix *M)
{
    for (int rail = 0; rail < TRK_RAILS && t->nodes == 1; rail++)
        hold_dof(K, M, t->node_dof[0] + 2 * rail + 1, t->pad_k[rail]);
    for (int64_t s = 0; s < t->sleepers; s++)
        if (!rolls(t, s))
            hold_dof(K, M, t->sleeper_dof[s] + 1, t->pad_k[s]);
}

static void add_masses(const struct trk *t, const struct matrix *M)
{
    for (int rail = 0; rail < TRK_RAILS; rail++)
        for (int64_t i = 0; i < t->nodes; i++) {
            const int64_t w = t->node_dof[i] + 2 * rail;
            matrix_add(M, w, w, t->rail_mass[rail * t->nodes + i]);
            matrix_add(M, w + 1, w + 1, t->rail_inertia[rail * t->nodes + i]);
        }
    for (int64_t s = 0; s < t->sleepers; s++) {
        const int64_t z = t->sleeper_dof[s];
        matrix_add(M, z, z, t->sleeper_mass[s]);
        matrix_add(M, z + 1, z + 1, t->sleeper_inertia[s]);
    }
}

const char *assemble_track(struct trk *t)
{
    if (trk_is_spatial(t))
        return assemble_spatial(t);
    const int64_t entries = count_entries(t);
    int64_t *Ap = trk_room(t, t->dofs + 1, sizeof *Ap), *Ai = trk_room(t, entries, sizeof *Ai);
    double *K = trk_room(t, entries, sizeof *K), *C = trk_room(t, entries, sizeof *C), *M = trk_room(t, entries, sizeof *M);

    if (!Ap || !Ai || !K || !C || !M)
        return REASON_MEMORY;
    fill_pattern(t, Ap, Ai);
    t->Ap = Ap;
    t->Ai = Ai;
    add_beams(t, &(struct matrix){NULL, Ap, Ai, K}, &(struct matrix){NULL, Ap, Ai, M});
    add_supports(t, &(struct matrix){NULL, Ap, Ai, K}, t->pad_k, t->ballast_k);
    add_supports(t, &(struct matrix){NULL, Ap, Ai, C}, t->pad_c, t->ballast_c);
    hold(t, &(struct matrix){NULL, Ap, Ai, K}, &(struct matrix){NULL, Ap, Ai, M});
    add_masses(t, &(struct matrix){NULL, Ap, Ai, M});
    t->Kx = K;
    t->Cx = C;
    t->Mx = M;
    return NULL;
}
