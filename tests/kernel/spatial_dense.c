/* Receptances of small spatial tracks with random parameters, check rail included, against a calculation that shares no code with the
 * programs: springs and masses as quadratic forms of where points go, slopes dw/dx and dy/dx for the turns, an order of their own, Gauss with
 * partial pivoting.  Lumped Euler-Bernoulli rails, the check rail with its mass along it. */
#include "tests/kernel/tap.h"

#include <complex.h>
#include <string.h>

#include "tests/kernel/random.h"
#include "tests/kernel/straight.h"
#include "tools/receptance/direct.h"

enum { SLEEPERS = 5, BAY = 2, NODES = (SLEEPERS - 1) * BAY + 1, RAILS = 3, DOFS = RAILS * 5 * NODES + 4 * SLEEPERS, TEXT = 400, SETS = 48 };
enum { W, SLOPE, Y, TURN, TWIST };              /* of a rail */
enum { DOWN, ROLL, ASIDE, YAW };                /* of a sleeper */

static const double TOLERANCE = 1e-9;           /* of the largest displacement at that frequency */
static const double FREQUENCY[] = {0, 17, 113, 396, 907};   /* Hz */

/* One track as numbers, SI; rails left, right, check. */
struct sample {
    int bay, first, last;                       /* elements in a bay; sleepers of the check rail */
    double spacing, rail_spacing, edge, seat, pad_width, pad_length, pitch, yaw, polar;
    double mass[RAILS], down[RAILS], aside[RAILS], torsion[RAILS], foot[RAILS], side[RAILS];   /* kg/m, N m2, N m2, N m2, m, m */
    double check_polar, check_k[2], check_c[2];
    double sleeper[SLEEPERS], roll[SLEEPERS], turn[SLEEPERS], length[SLEEPERS], centre[SLEEPERS];
    double pad[2][SLEEPERS], pad_aside[2][SLEEPERS], ballast[2][SLEEPERS], ballast_aside[2][SLEEPERS], ballast_along[2][SLEEPERS];   /* k, c */
};

/* ---- the sample ---- */

/* A factor of 0.4 to 2.5, as often below 1 as above. */
static double near_to(double value)
{
    return value * 0.4 * pow(6.25, random_number());
}

static struct sample random_sample(int bay)
{
    struct sample s = {.bay = bay, .first = 1, .last = SLEEPERS - 2, .spacing = near_to(0.6), .rail_spacing = 1.5, .edge = 0.3,
                       .seat = 0.2 * random_number(), .pad_width = near_to(0.1), .pad_length = near_to(0.1), .pitch = near_to(1.25),
                       .yaw = near_to(1.15), .polar = near_to(0.28), .check_polar = near_to(0.034),
                       .check_k = {near_to(120e6), near_to(60e6)}, .check_c = {near_to(25e3), near_to(15e3)}};

    s.mass[0] = s.mass[1] = near_to(60);
    s.mass[2] = near_to(33);
    s.torsion[0] = s.torsion[1] = near_to(1.5e5);
    s.torsion[2] = near_to(1.6e5);
    s.foot[0] = s.foot[1] = near_to(0.08);
    s.foot[2] = near_to(0.145);
    s.side[0] = -0.75;
    s.side[1] = 0.75;
    s.side[2] = 0.65;
    for (int r = 0; r < RAILS; r++) {
        s.down[r] = near_to(r < 2 ? 6.11e6 : 6.3e5);
        s.aside[r] = near_to(r < 2 ? 1.076e6 : 2.7e5);
    }
    for (int k = 0; k < SLEEPERS; k++) {
        s.sleeper[k] = near_to(380);
        s.roll[k] = near_to(155);
        s.turn[k] = near_to(156);
        s.length[k] = 3 + random_number();
        s.centre[k] = random_number() - 0.5;
        for (int i = 0; i < 2; i++) {
            s.pad[i][k] = near_to(i ? 50e3 : 300e6);
            s.pad_aside[i][k] = near_to(i ? 10e3 : 25e6);
            s.ballast[i][k] = near_to(i ? 120e3 : 280e6);
            s.ballast_aside[i][k] = near_to(i ? 270e3 : 30e6);
            s.ballast_along[i][k] = near_to(i ? 270e3 : 30e6);
        }
    }
    return s;
}

/* ---- the same, as the programs read it ---- */

struct sets { int n; char text[SETS][TEXT]; };

static void set_number(struct sets *sets, const char *key, double value)
{
    snprintf(sets->text[sets->n++], TEXT, "%s=%.17g", key, value);
}

static void set_table(struct sets *sets, const char *key, const double *value)
{
    const double *v = value;

    snprintf(sets->text[sets->n++], TEXT, "%s={number: [1, 2, 3, 4, 5], value: [%.17g, %.17g, %.17g, %.17g, %.17g]}", key, v[0], v[1], v[2], v[3],
             v[4]);
}

static const char *build(struct trk *t, const struct sample *s)
{
    struct sets sets = {0};
    const char *set[SETS];
    const struct { const char *key; double value; } number[] = {
        {"from", 0}, {"length", SLEEPERS * s->spacing}, {"sleeper.spacing", s->spacing}, {"ballast.edge", s->edge}, {"sleeper.seat_height", s->seat},
        {"railpad.width", s->pad_width}, {"railpad.length", s->pad_length}, {"rail.pitch_inertia", s->pitch}, {"rail.yaw_inertia", s->yaw},
        {"rail.polar_inertia", s->polar}, {"rail.mass", s->mass[0]}, {"rail.torsional_stiffness", s->torsion[0]}, {"rail.foot_depth", s->foot[0]},
        {"rail.elements_per_bay", s->bay}, {"check_rail.1.beam.mass", s->mass[2]}, {"check_rail.1.beam.torsional_stiffness", s->torsion[2]},
        {"check_rail.1.beam.foot_depth", s->foot[2]}, {"check_rail.1.beam.polar_inertia", s->check_polar},
        {"check_rail.1.beam.stiffness", s->check_k[0]}, {"check_rail.1.beam.lateral_stiffness", s->check_k[1]},
        {"check_rail.1.beam.damping", s->check_c[0]}, {"check_rail.1.beam.lateral_damping", s->check_c[1]},
        {"check_rail.1.beam.from", s->first * s->spacing}, {"check_rail.1.beam.to", (s->last + 1) * s->spacing},
        {"rail.left.bending_stiffness", s->down[0]}, {"rail.right.bending_stiffness", s->down[1]}, {"check_rail.1.beam.bending_stiffness", s->down[2]},
        {"rail.left.lateral_bending_stiffness", s->aside[0]}, {"rail.right.lateral_bending_stiffness", s->aside[1]},
        {"check_rail.1.beam.lateral_bending_stiffness", s->aside[2]}};
    const struct { const char *key; const double *value; } table[] = {
        {"sleeper.mass", s->sleeper}, {"sleeper.roll_inertia", s->roll}, {"sleeper.yaw_inertia", s->turn}, {"sleeper.length", s->length},
        {"sleeper.centre", s->centre}, {"railpad.stiffness", s->pad[0]}, {"railpad.damping", s->pad[1]},
        {"railpad.lateral_stiffness", s->pad_aside[0]}, {"railpad.lateral_damping", s->pad_aside[1]}, {"ballast.stiffness", s->ballast[0]},
        {"ballast.damping", s->ballast[1]}, {"ballast.lateral_stiffness", s->ballast_aside[0]}, {"ballast.lateral_damping", s->ballast_aside[1]},
        {"ballast.longitudinal_stiffness", s->ballast_along[0]}, {"ballast.longitudinal_damping", s->ballast_along[1]}};

    for (size_t k = 0; k < sizeof number / sizeof *number; k++)
        set_number(&sets, number[k].key, number[k].value);
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        set_table(&sets, table[k].key, table[k].value);
    for (int k = 0; k < sets.n; k++)
        set[k] = sets.text[k];
    return straight(t, set, sets.n);
}

/* ---- the dense calculation ---- */

static int nodes_of(const struct sample *s)
{
    return (SLEEPERS - 1) * s->bay + 1;
}

/* Order: for each rail all w, all slopes, all y and so on; then all sleepers down, all in roll and so on.  Nodes of the check rail where there
 * is none of it stay by themselves, with a unit on the diagonal. */
static int of_rail(int rail, int part, int node)
{
    return (rail * 5 + part) * NODES + node;
}

static int of_sleeper(int part, int k)
{
    return RAILS * 5 * NODES + part * SLEEPERS + k;
}

static int runs(const struct sample *s, int rail, int node)
{
    return rail < 2 || (node >= s->first * s->bay && node <= s->last * s->bay);
}

/* What moves: a sum of displacements times numbers. */
struct form { int n, dof[4]; double by[4]; };

/* A += k form form' */
static void square(double complex A[DOFS][DOFS], double complex k, struct form f)
{
    for (int i = 0; i < f.n; i++)
        for (int j = 0; j < f.n; j++)
            A[f.dof[i]][f.dof[j]] += k * f.by[i] * f.by[j];
}

/* Energy of a cubic between two nodes: EI/2 int v''^2 and, along it, m/2 int v^2. */
static void cubic(double complex A[DOFS][DOFS], int v, int slope, double EI, double complex m, double h)
{
    const int dof[4] = {v, slope, v + 1, slope + 1};
    const double K[4][4] = {{12, 6 * h, -12, 6 * h}, {6 * h, 4 * h * h, -6 * h, 2 * h * h}, {-12, -6 * h, 12, -6 * h}, {6 * h, 2 * h * h, -6 * h, 4 * h * h}};
    const double M[4][4] = {{156, 22 * h, 54, -13 * h}, {22 * h, 4 * h * h, 13 * h, -3 * h * h}, {54, 13 * h, 156, -22 * h},
                            {-13 * h, -3 * h * h, -22 * h, 4 * h * h}};

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            A[dof[i]][dof[j]] += EI / (h * h * h) * K[i][j] + m * h / 420 * M[i][j];
}

static void dense_rail(double complex A[DOFS][DOFS], const struct sample *s, int r, double complex p)
{
    const double h = s->spacing / s->bay, end = s->spacing / 2;
    const int last = nodes_of(s) - 1;

    for (int i = 0; i < NODES; i++) {
        const double length = i == 0 || i == last ? h / 2 + end : h;
        for (int part = 0; part < 5 && (i > last || !runs(s, r, i)); part++)
            A[of_rail(r, part, i)][of_rail(r, part, i)] = 1;
        if (i > last || !runs(s, r, i))
            continue;
        if (r < 2) {
            const double m[5] = {s->mass[r] * length, s->pitch, s->mass[r] * length, s->yaw, s->polar * length};
            for (int part = 0; part < 5; part++)
                square(A, p * p * m[part], (struct form){1, {of_rail(r, part, i)}, {1}});
        }
        if (i == last || !runs(s, r, i + 1))
            continue;
        const double complex m = r < 2 ? 0 : p * p * s->mass[r], turning = r < 2 ? 0 : p * p * s->check_polar;
        const int one = of_rail(r, TWIST, i), two = one + 1;
        cubic(A, of_rail(r, W, i), of_rail(r, SLOPE, i), s->down[r], m, h);
        cubic(A, of_rail(r, Y, i), of_rail(r, TURN, i), s->aside[r], m, h);
        square(A, s->torsion[r] / h + turning * -h / 6, (struct form){2, {one, two}, {1, -1}});
        square(A, turning * h / 2, (struct form){1, {one}, {1}});
        square(A, turning * h / 2, (struct form){1, {two}, {1}});
    }
}

/* The foot of a rail against the seat on sleeper k: where each point goes, in x to the right-handed turns of both bodies. */
static void dense_seat(double complex A[DOFS][DOFS], const struct sample *s, int r, int k, double complex down, double complex aside)
{
    const int i = k * s->bay;
    const double arm = s->side[r] - s->centre[k], width = s->pad_width, length = s->pad_length;

    square(A, down, (struct form){3, {of_rail(r, W, i), of_sleeper(DOWN, k), of_sleeper(ROLL, k)}, {1, -1, -arm}});
    square(A, aside, (struct form){4, {of_rail(r, Y, i), of_rail(r, TWIST, i), of_sleeper(ASIDE, k), of_sleeper(ROLL, k)},
                                   {1, -s->foot[r], -1, -s->seat}});
    square(A, down * width * width / 12, (struct form){2, {of_rail(r, TWIST, i), of_sleeper(ROLL, k)}, {1, -1}});
    square(A, down * length * length / 12, (struct form){1, {of_rail(r, SLOPE, i)}, {1}});
    square(A, aside * length * length / 12, (struct form){2, {of_rail(r, TURN, i), of_sleeper(YAW, k)}, {1, -1}});
}

static void dense_sleeper(double complex A[DOFS][DOFS], const struct sample *s, int k, double complex p)
{
    const double complex third = (s->ballast[0][k] + p * s->ballast[1][k]) / 3;
    const double L = s->length[k], a = L / 2 - s->edge;

    for (int b = -1; b <= 1; b++)
        square(A, third, (struct form){2, {of_sleeper(DOWN, k), of_sleeper(ROLL, k)}, {1, b * a}});
    square(A, p * p * s->sleeper[k], (struct form){1, {of_sleeper(DOWN, k)}, {1}});
    square(A, p * p * s->roll[k], (struct form){1, {of_sleeper(ROLL, k)}, {1}});
    square(A, p * p * s->sleeper[k] + s->ballast_aside[0][k] + p * s->ballast_aside[1][k], (struct form){1, {of_sleeper(ASIDE, k)}, {1}});
    square(A, p * p * s->turn[k] + (s->ballast_along[0][k] + p * s->ballast_along[1][k]) * L * L / 12, (struct form){1, {of_sleeper(YAW, k)}, {1}});
    for (int r = 0; r < 2; r++)
        dense_seat(A, s, r, k, s->pad[0][k] + p * s->pad[1][k], s->pad_aside[0][k] + p * s->pad_aside[1][k]);
    if (k >= s->first && k <= s->last)
        dense_seat(A, s, 2, k, s->check_k[0] + p * s->check_c[0], s->check_k[1] + p * s->check_c[1]);
}

/* A x = b by Gauss with partial pivoting; A and b are used up, b becomes x. */
static void dense_solve(double complex A[DOFS][DOFS], double complex *b)
{
    for (int c = 0; c < DOFS; c++) {
        int best = c;
        for (int i = c + 1; i < DOFS; i++)
            if (cabs(A[i][c]) > cabs(A[best][c]))
                best = i;
        for (int j = c; j < DOFS; j++) {
            const double complex keep = A[c][j];
            A[c][j] = A[best][j];
            A[best][j] = keep;
        }
        const double complex keep = b[c];
        b[c] = b[best];
        b[best] = keep;
        for (int i = c + 1; i < DOFS; i++) {
            const double complex m = A[i][c] / A[c][c];
            for (int j = c; j < DOFS && cabs(m) > 0; j++)
                A[i][j] -= m * A[c][j];
            b[i] -= m * b[c];
        }
    }
    for (int i = DOFS - 1; i >= 0; i--) {
        for (int j = i + 1; j < DOFS; j++)
            b[i] -= A[i][j] * b[j];
        b[i] /= A[i][i];
    }
}

/* ---- one against the other ---- */

/* Where the programs keep a displacement, and its sign there: pitch is -dw/dx. */
static int64_t theirs(const struct sample *s, const struct trk *t, int rail, int part, int node)
{
    return (rail < 2 ? t->node_dof[node] + 5 * rail : t->check_dof[node - s->first * s->bay]) + part;
}

static double sign_of(int part)
{
    return part == SLOPE ? -1 : 1;
}

static double complex of(const double *u, int64_t dof)
{
    return u[2 * dof] + I * u[2 * dof + 1];
}

/* Largest difference of all displacements, of the largest; x is dense, u the program's. */
static double difference(const struct sample *s, const struct trk *t, const double complex *x, const double *u)
{
    double most = 0, largest = 0;

    for (int r = 0; r < RAILS; r++)
        for (int i = 0; i < nodes_of(s); i++)
            for (int part = 0; part < 5 && runs(s, r, i); part++) {
                const double complex mine = x[of_rail(r, part, i)];
                most = fmax(most, cabs(mine - sign_of(part) * of(u, theirs(s, t, r, part, i))));
                largest = fmax(largest, cabs(mine));
            }
    for (int k = 0; k < SLEEPERS; k++)
        for (int part = 0; part < 4; part++)
            most = fmax(most, cabs(x[of_sleeper(part, k)] - of(u, t->sleeper_dof[k] + part)));
    return most / largest;
}

/* 1 N or N m in any direction of any node of a rail; NAN where the program cannot. */
static double compare(const struct sample *s, const struct trk *t, struct direct *d, double frequency)
{
    static double complex A[DOFS][DOFS];
    static double u[2 * DOFS];
    double complex x[DOFS] = {0};
    const double complex p = 2 * M_PI * frequency * I;
    const int r = (int)(2.999 * random_number()), part = (int)(4.999 * random_number()), middle = SLEEPERS / 2 * s->bay;

    memset(A, 0, sizeof A);
    for (int i = 0; i < RAILS; i++)
        dense_rail(A, s, i, p);
    for (int k = 0; k < SLEEPERS; k++)
        dense_sleeper(A, s, k, p);
    x[of_rail(r, part, middle)] = 1;
    dense_solve(A, x);
    memset(u, 0, sizeof u);
    u[2 * theirs(s, t, r, part, middle)] = sign_of(part);
    return direct_factor(d, p) || direct_solve(d, u) ? NAN : difference(s, t, x, u);
}

static double worst_of(const struct sample *s)
{
    struct trk t;
    struct direct d;
    double worst = 0;

    const char *why = build(&t, s);
    if (!why && (t.dofs > DOFS || (why = direct_new(&d, &t))))
        why = why ? why : "more degrees of freedom";
    if (why) {
        printf("# %s\n", why);
        trk_free(&t);
        return NAN;
    }
    for (size_t i = 0; i < sizeof FREQUENCY / sizeof *FREQUENCY && !isnan(worst); i++) {
        const double now = compare(s, &t, &d, FREQUENCY[i]);
        worst = now <= worst ? worst : now;                        /* a NAN stays */
    }
    direct_free(&d);
    trk_free(&t);
    return worst;
}

int main(void)
{
    for (int i = 0; i < 12; i++) {
        const struct sample s = random_sample(1 + i % 2);
        const double worst = worst_of(&s);
        ok(worst < TOLERANCE, "random spatial track %d, %d a bay: within %.1e", i + 1, s.bay, worst);
    }
    return done();
}
