/* Rails bend in two planes and twist, each for itself, for the centroid counts as shear centre; railpads, ballast and the levers between
 * them join these to the sleepers.  A spring of stiffness k and extension e = d.u gives K += k d d'.
 *
 * x forward, y to the right, z down, turns right-handed: a point (y, z) off the centroid of what rolls by r moves sideways by -z r and
 * down by y r.  The foot of a rail lies below its centroid, the seat above the sleeper's centre:
 *   y_foot = y - foot twist,   y_seat = y_s + seat roll,   w_seat = z_s + arm roll.
 * A railpad of stiffness k spread over width b and length l also resists tilt, k b^2/12, pitch, k l^2/12, and with its lateral stiffness
 * yaw; what would move lengthwise, and the pitch of a sleeper, is held. */
#include "tools/track/assemble_spatial.h"

#include "formats/reason.h"
#include "tools/track/matrix.h"
#include "tools/track/rails.h"

enum { HALF = 3 * TRK_SPATIAL_RAIL + TRK_SPATIAL_SLEEPER + TRK_SPATIAL_RAIL - 1 };     /* bandwidth: a rail's first and its last dof ahead */

/* An element of a rail: numbers of w at its ends, and what it is made of. */
struct bar {
    int64_t near, far;
    struct beam vertical, lateral;
    double torsion, polar;             /* N m2, kg m */
};

/* What stands on a sleeper: number of w, its place across, foot below its centroid; of its railpad, stiffness or damping. */
struct foot {
    int64_t dof;
    double arm, depth;                 /* m, arm from the sleeper's centre */
    double vertical, lateral;
};

/* x [4][4] of [w t] at either end into the degrees of freedom from `first`; turn is 1 of w and pitch = -dw/dx, -1 of y and yaw = dy/dx. */
static void add_bending(const struct matrix *X, const struct bar *b, int first, double turn, double x[4][4])
{
    const int64_t dof[4] = {b->near + first, b->near + first + 1, b->far + first, b->far + first + 1};
    const double sign[4] = {1, turn, 1, turn};

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            matrix_add(X, dof[i], dof[j], sign[i] * sign[j] * x[i][j]);
}

static void add_bar(const struct matrix *K, const struct matrix *M, const struct bar *b)
{
    const int64_t twist[2] = {b->near + TRK_TWIST, b->far + TRK_TWIST};
    const double L = b->vertical.length, third = b->polar * L / 3;
    double x[4][4];

    beam_stiffness(&b->vertical, x);
    add_bending(K, b, TRK_W, 1, x);
    beam_stiffness(&b->lateral, x);
    add_bending(K, b, TRK_Y, -1, x);
    matrix_add_spring(K, b->torsion / L, 2, twist, (double[]){1, -1});
    if (!(b->vertical.mass > 0))
        return;
    beam_mass(&b->vertical, x);
    add_bending(M, b, TRK_W, 1, x);
    beam_mass(&b->lateral, x);
    add_bending(M, b, TRK_Y, -1, x);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            matrix_add(M, twist[i], twist[j], i == j ? third : third / 2);    /* twist straight between the ends */
}

static struct bar rail_bar(const struct trk *t, int rail, int64_t i)
{
    const int64_t k = rail * (t->nodes - 1) + i;

    return (struct bar){.near = trk_rail_dof(t, rail, i), .far = trk_rail_dof(t, rail, i + 1), .vertical = rails_beam(t, rail, i),
                        .lateral = rails_lateral_beam(t, rail, i), .torsion = t->rail_torsion[k], .polar = t->rail_polar[k]};
}

static struct bar check_bar(const struct trk *t, int64_t i)
{
    const struct beam plane = {.length = t->x[t->check_node[i + 1]] - t->x[t->check_node[i]], .mass = *t->check_density};
    struct bar b = {.near = t->check_dof[i], .far = t->check_dof[i + 1], .vertical = plane, .lateral = plane, .torsion = *t->check_torsion,
                    .polar = *t->check_polar};

    b.vertical.bending = t->check_bending[0];
    b.lateral.bending = t->check_bending[1];
    return b;
}

static void add_bars(const struct trk *t, const struct matrix *K, const struct matrix *M)
{
    for (int rail = 0; rail < TRK_RAILS; rail++)
        for (int64_t i = 0; i < t->nodes - 1; i++) {
            const struct bar b = rail_bar(t, rail, i);
            add_bar(K, M, &b);
        }
    for (int64_t i = 0; i < t->check_nodes - 1; i++) {
        const struct bar b = check_bar(t, i);
        add_bar(K, M, &b);
    }
}

static void add_fastening(const struct trk *t, const struct matrix *X, const struct foot *f, int64_t sleeper)
{
    const int64_t r = f->dof, s = t->sleeper_dof[sleeper];
    const double across = *t->pad_width * *t->pad_width / 12, along = *t->pad_length * *t->pad_length / 12;

    matrix_add_spring(X, f->vertical, 3, (int64_t[]){r + TRK_W, s + TRK_Z, s + TRK_ROLL}, (double[]){1, -1, -f->arm});
    matrix_add_spring(X, f->lateral, 4, (int64_t[]){r + TRK_Y, r + TRK_TWIST, s + TRK_SLEEPER_Y, s + TRK_ROLL},
                      (double[]){1, -f->depth, -1, -*t->sleeper_seat});
    matrix_add_spring(X, f->vertical * across, 2, (int64_t[]){r + TRK_TWIST, s + TRK_ROLL}, (double[]){1, -1});
    matrix_add_spring(X, f->vertical * along, 1, (int64_t[]){r + TRK_PITCH}, (double[]){1});
    matrix_add_spring(X, f->lateral * along, 2, (int64_t[]){r + TRK_YAW, s + TRK_SLEEPER_YAW}, (double[]){1, -1});
}

/* Stiffness for K, damping for C: pad, side [2][sleepers] vertical and lateral, check [2] of the check rail. */
static void add_fastenings(const struct trk *t, const struct matrix *X, const double *pad, const double *side, const double *check)
{
    int64_t c = 0;

    for (int64_t s = 0; s < t->sleepers; s++) {
        for (int rail = 0; rail < TRK_RAILS; rail++) {
            const int64_t k = rail * t->sleepers + s;
            add_fastening(t, X, &(struct foot){trk_rail_dof(t, rail, t->sleeper_node[s]), trk_pad_arm(t, rail, s), *t->rail_foot, pad[k],
                                               side[k]}, s);
        }
        while (c < t->check_nodes && t->check_node[c] < t->sleeper_node[s])
            c++;
        if (c < t->check_nodes && t->check_node[c] == t->sleeper_node[s])
            add_fastening(t, X, &(struct foot){t->check_dof[c], *t->check_y - t->sleeper_y[s], *t->check_foot, check[0], check[1]}, s);
    }
}

/* ballast [3][sleepers], side and yaw [sleepers]: stiffness for K, damping for C.  Ballast that does not touch has no part. */
static void add_ballast(const struct trk *t, const struct matrix *X, const double *ballast, const double *side, const double *yaw)
{
    for (int64_t s = 0; s < t->sleepers; s++) {
        const int64_t z = t->sleeper_dof[s];
        for (int64_t k = s; k < TRK_BALLAST * t->sleepers; k += t->sleepers)
            if (t->ballast_state[k] != TRK_OPEN)
                matrix_add_spring(X, ballast[k], 2, (int64_t[]){z + TRK_Z, z + TRK_ROLL}, (double[]){1, t->ballast_y[k]});
        matrix_add(X, z + TRK_SLEEPER_Y, z + TRK_SLEEPER_Y, side[s]);
        matrix_add(X, z + TRK_SLEEPER_YAW, z + TRK_SLEEPER_YAW, yaw[s]);
    }
}

static void add_masses(const struct trk *t, const struct matrix *M)
{
    for (int rail = 0; rail < TRK_RAILS; rail++)
        for (int64_t i = 0; i < t->nodes; i++) {
            const int64_t w = trk_rail_dof(t, rail, i), k = rail * t->nodes + i;
            const double m[TRK_SPATIAL_RAIL] = {t->rail_mass[k], t->rail_inertia[k], t->rail_mass[k], t->rail_yaw[k], t->rail_twist[k]};
            for (int part = 0; part < TRK_SPATIAL_RAIL; part++)
                matrix_add(M, w + part, w + part, m[part]);
        }
    for (int64_t s = 0; s < t->sleepers; s++) {
        const double m[TRK_SPATIAL_SLEEPER] = {t->sleeper_mass[s], t->sleeper_inertia[s], t->sleeper_mass[s], t->sleeper_yaw[s]};
        for (int part = 0; part < TRK_SPATIAL_SLEEPER; part++)
            matrix_add(M, t->sleeper_dof[s] + part, t->sleeper_dof[s] + part, m[part]);
    }
}

static void add_all(const struct trk *t, const struct matrix *K, const struct matrix *C, const struct matrix *M)
{
    add_bars(t, K, M);
    add_fastenings(t, K, t->pad_k, t->pad_lateral_k, t->check_pad_k);
    add_fastenings(t, C, t->pad_c, t->pad_lateral_c, t->check_pad_c);
    add_ballast(t, K, t->ballast_k, t->ballast_lateral_k, t->ballast_yaw_k);
    add_ballast(t, C, t->ballast_c, t->ballast_lateral_c, t->ballast_yaw_c);
    add_masses(t, M);
}

const char *assemble_spatial(struct trk *t)
{
    struct pattern p;
    const char *why = pattern_new(&p, t->dofs, HALF);

    if (why)
        return why;
    const struct matrix marks = {.pattern = &p};
    add_all(t, &marks, &marks, &marks);
    const int64_t entries = pattern_count(&p);
    int64_t *Ap = trk_room(t, t->dofs + 1, sizeof *Ap), *Ai = trk_room(t, entries, sizeof *Ai);
    double *K = trk_room(t, entries, sizeof *K), *C = trk_room(t, entries, sizeof *C), *M = trk_room(t, entries, sizeof *M);
    if (!Ap || !Ai || !K || !C || !M)
        why = REASON_MEMORY;
    else {
        pattern_list(&p, Ap, Ai);
        add_all(t, &(struct matrix){NULL, Ap, Ai, K}, &(struct matrix){NULL, Ap, Ai, C}, &(struct matrix){NULL, Ap, Ai, M});
    }
    pattern_free(&p);
    t->Ap = Ap;
    t->Ai = Ai;
    t->Kx = K;
    t->Cx = C;
    t->Mx = M;
    return why;
}
