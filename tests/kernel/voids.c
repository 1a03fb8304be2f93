/* Track on ballast that only pushes: statics against a dense half track solved by trying every set of touching sleepers, the condition of
 * equilibrium with random gaps and loads, limits of the gap, and the time integration, which comes to the same rest.  Run from the root. */
#include "tests/kernel/tap.h"

#include <stdlib.h>
#include <string.h>

#include "tests/kernel/random.h"
#include "tests/kernel/table1.h"
#include "tools/integrate/way.h"
#include "tools/track/equilibrium.h"

enum { SLEEPERS = 9, HALF = 3 * SLEEPERS, VOIDS = 3, FIRST = 3 };     /* voids under sleepers 4 to 6 */

static const double g = EQUILIBRIUM_GRAVITY;

/* ---- one rail and half of each sleeper, dense, by hand ---- */

struct half { double K[HALF][HALF], f[HALF]; };

/* Unknowns w, slope dw/dx and z of each sleeper; Table 1. */
static void fill(struct half *h, const double *gap, unsigned touching, double load)
{
    const double EI = 6.11e6, L = 0.6, pad = 300e6, ballast = 140e6;
    const double beam[4][4] = {{12, 6 * L, -12, 6 * L}, {6 * L, 4 * L * L, -6 * L, 2 * L * L},
                               {-12, -6 * L, 12, -6 * L}, {6 * L, 2 * L * L, -6 * L, 4 * L * L}};

    memset(h, 0, sizeof *h);
    for (int i = 0; i < SLEEPERS; i++) {
        const int w = 3 * i, z = w + 2, empty = i >= FIRST && i < FIRST + VOIDS;
        for (int a = 0; a < 4 && i + 1 < SLEEPERS; a++)
            for (int b = 0; b < 4; b++)
                h->K[w + (a > 1 ? 3 + a - 2 : a)][w + (b > 1 ? 3 + b - 2 : b)] += EI / (L * L * L) * beam[a][b];
        h->K[w][w] += pad;
        h->K[z][z] += pad;
        h->K[w][z] -= pad;
        h->K[z][w] -= pad;
        h->f[w] = 36 * g;
        h->f[z] = 190 * g;
        if (!empty || (touching >> (i - FIRST) & 1)) {
            h->K[z][z] += ballast;
            h->f[z] += ballast * (empty ? gap[i - FIRST] : 0);
        }
    }
    h->f[3 * (SLEEPERS / 2)] += load;
}

/* Gauss with partial pivoting; the solution is in f. */
static void eliminate(struct half *h)
{
    for (int j = 0; j < HALF; j++) {
        int best = j;
        for (int i = j + 1; i < HALF; i++)
            best = fabs(h->K[i][j]) > fabs(h->K[best][j]) ? i : best;
        for (int k = 0; k < HALF; k++) {
            const double swap = h->K[j][k];
            h->K[j][k] = h->K[best][k];
            h->K[best][k] = swap;
        }
        const double swap = h->f[j];
        h->f[j] = h->f[best];
        h->f[best] = swap;
        for (int i = 0; i < HALF; i++) {
            const double m = i == j ? 0 : h->K[i][j] / h->K[j][j];
            for (int k = j; k < HALF; k++)
                h->K[i][k] -= m * h->K[j][k];
            h->f[i] -= m * h->f[j];
        }
    }
    for (int j = 0; j < HALF; j++)
        h->f[j] /= h->K[j][j];
}

/* The one set for which every touching sleeper is beyond its gap and no other is; how many there are. */
static int enumerate(struct half *best, const double *gap, double load)
{
    int found = 0;

    for (unsigned set = 0; set < 1u << VOIDS; set++) {
        struct half h;
        int fits = 1;
        fill(&h, gap, set, load);
        eliminate(&h);
        for (int i = 0; i < VOIDS; i++)
            fits &= (h.f[3 * (FIRST + i) + 2] > gap[i]) == (int)(set >> i & 1);
        if (fits) {
            *best = h;
            found++;
        }
    }
    return found;
}

static const char *build_short(struct trk *t, const double *gap)
{
    char text[200];
    const char *const set[] = {"from=0", "length=5.4", text};

    snprintf(text, sizeof text, "ballast.gap={number: [3, 4, 5, 6, 7], value: [0, %.17g, %.17g, %.17g, 0]}", gap[0], gap[1], gap[2]);
    return table1(t, set, 3);
}

static void against_enumeration(void)
{
    double worst = 0;
    int unique = 1, touching = 0;

    for (int k = 0; k < 40; k++) {
        const double load = 60e3 * random_number(), most = pow(10, -5 + 3 * random_number());
        const double gap[VOIDS] = {most * random_number(), most * random_number(), most * random_number()};
        struct equilibrium e;
        struct half h;
        struct trk t;
        unique &= enumerate(&h, gap, load) == 1;
        if (build_short(&t, gap) || equilibrium_new(&e, &t, g)) {
            ok(0, "a short track with voids");
            return;
        }
        double *f = calloc((size_t)t.dofs, sizeof *f), *u = calloc((size_t)t.dofs, sizeof *u);
        memcpy(f, e.weight, (size_t)t.dofs * sizeof *f);
        for (int rail = 0; rail < TRK_RAILS; rail++)
            f[trk_rail_dof(&t, rail, SLEEPERS / 2)] += load;
        if (equilibrium_find(&e, f, u))
            worst = HUGE_VAL;
        for (int i = 0; i < SLEEPERS; i++) {
            worst = fmax(worst, fabs(u[t.node_dof[i]] - h.f[3 * i]));
            worst = fmax(worst, fabs(u[t.sleeper_dof[i]] - h.f[3 * i + 2]));
        }
        for (int i = 0; i < VOIDS; i++)
            touching += h.f[3 * (FIRST + i) + 2] > gap[i];
        free(f);
        free(u);
        equilibrium_free(&e);
        trk_free(&t);
    }
    ok(unique, "one set of touching sleepers fits, of all that are possible");
    ok(touching > 20 && touching < 100, "some of 120 voids close (%d)", touching);
    near(worst, 0, 1e-13, "and it is the one found, deflections in m");
}

/* ---- the condition, on tracks of every kind of gap ---- */

/* N: the most that K u + ballast differs from f; the matrices of t are those with `state`. */
static double unbalanced(const struct trk *t, const double *f, const double *u)
{
    const int64_t n = t->sleepers;
    double *r = calloc((size_t)t->dofs, sizeof *r), most = 0;
    struct trk bare = *t;
    int64_t open[TRK_BALLAST * 64];

    for (int64_t i = 0; i < TRK_BALLAST * n; i++)
        open[i] = TRK_OPEN;
    bare.ballast_state = open;
    bare.store = NULL;
    if (!r || assemble_track(&bare))
        return HUGE_VAL;
    for (int64_t j = 0; j < t->dofs; j++) {
        r[j] -= f[j];
        for (int64_t p = bare.Ap[j]; p < bare.Ap[j + 1]; p++)
            r[bare.Ai[p]] += bare.Kx[p] * u[j];
    }
    for (int64_t i = 0; i < TRK_BALLAST * n; i++) {
        const int64_t z = t->sleeper_dof[i % n];
        const double e = u[z] + t->ballast_y[i] * u[z + 1];
        const double F = t->ballast_k[i] * (t->ballast_state[i] == TRK_BONDED ? e : fmax(e - t->ballast_gap[i], 0));
        r[z] += F;
        r[z + 1] += F * t->ballast_y[i];
    }
    for (int64_t j = 0; j < t->dofs; j++)
        most = fmax(most, fabs(r[j]));
    free(r);
    trk_free(&bare);
    return most;
}

/* Whether spring i is an outer one of the sleeper without railpads: on its middle alone it would balance. */
static int loose_sleeper(const struct trk *t, int64_t i)
{
    return t->sleeper_number[i % t->sleepers] == -4 && i / t->sleepers != 1;
}

static void condition(void)
{
    static const char *const set[] = {"ballast.tension=false", "ballast.left.stiffness=60e6",
                                      "ballast.right.stiffness={station: [0, 3], value: [20e6, 200e6]}",
                                      "railpad.missing=[{sleepers: [[3, 5]], rail: left}, {sleepers: [[-4, -4]]}]"};
    double worst = 0;
    struct trk t;

    if (!ok(!table1(&t, set, 4), "ballast without tension, springs of their own, railpads missing"))
        return;
    double *f = calloc((size_t)t.dofs, sizeof *f), *u = calloc((size_t)t.dofs, sizeof *u);
    double *gap = calloc(TRK_BALLAST * (size_t)t.sleepers, sizeof *gap);
    for (int k = 0; k < 600; k++) {
        struct equilibrium e;
        for (int64_t i = 0; i < TRK_BALLAST * t.sleepers; i++)
            gap[i] = loose_sleeper(&t, i) || random_number() < 0.5 ? 0 : pow(10, -5 + 2.5 * random_number());
        t.ballast_gap = gap;
        if (equilibrium_new(&e, &t, g)) {
            worst = HUGE_VAL;
            break;
        }
        memcpy(f, e.weight, (size_t)t.dofs * sizeof *f);
        for (int axle = 0; axle < 4; axle++)
            f[trk_rail_dof(&t, axle % 2, (int64_t)(random_number() * 49))] += 150e3 * (random_number() - 0.2);
        worst = fmax(worst, equilibrium_find(&e, f, u) ? HUGE_VAL : unbalanced(&t, f, u));
        equilibrium_free(&e);
    }
    near(worst, 0, 1e-5, "600 random beds and loads, uplift too: N or N m left over");
    free(f);
    free(u);
    free(gap);
    trk_free(&t);
}

/* ---- in time ---- */

/* A track let go from the unloaded state comes to the rest of statics: largest difference of sleepers, m. */
static void comes_to_rest(void)
{
    static const char *const set[] = {"ballast.gap={number: [-3, 0, 3], value: [0, 0.3e-3, 0]}", "ballast.tension=false"};
    struct equilibrium e;
    struct trk t;
    struct way w;
    double worst = 0, most = 0;

    if (!ok(!table1(&t, set, 2) && !equilibrium_new(&e, &t, g) && !way_new(&w, &t, g, 1e-4, WAY_EXPLICIT), "a dip of the ballast"))
        return;
    double *u = calloc((size_t)t.dofs, sizeof *u);
    way_set(&w, u);
    way_move(&w);
    for (int k = 0; k < 20000; k++) {
        way_advance(&w);
        way_move(&w);
    }
    way_finish(&w);
    for (int64_t i = 0; i < t.sleepers; i++) {
        worst = fmax(worst, fabs(w.z[i] - e.rest[t.sleeper_dof[i]]));
        most = fmax(most, e.rest[t.sleeper_dof[i]]);
    }
    ok(most > 50e-6 && most < 300e-6, "sleepers hang there, %.3g mm deep", most * 1e3);
    near(worst, 0, 1e-9, "let go, it comes to the rest of statics in 2 s: m");
    free(u);
    way_free(&w);
    equilibrium_free(&e);
    trk_free(&t);
}

/* A sleeper without railpads falls through its gap: m g (gap + d) = k d^2/2 at its lowest. */
static void falls(void)
{
    static const char *const set[] = {"ballast.gap={number: [4, 5, 6], value: [0, 0.01, 0]}", "ballast.damping=0",
                                      "railpad.missing=[{sleepers: [[5, 5]]}]"};
    const double m = 380, k = 280e6, gap = 0.01, d = m * g / k * (1 + sqrt(1 + 2 * gap * k / (m * g)));
    double lowest = 0, highest = HUGE_VAL;
    int landed = 0;
    struct trk t;
    struct way w;

    if (!ok(!table1(&t, set, 3) && !way_new(&w, &t, g, 1e-5, WAY_EXPLICIT), "a sleeper above a void, without railpads"))
        return;
    double *u = calloc((size_t)t.dofs, sizeof *u);
    int64_t i = 0;
    while (t.sleeper_number[i] != 5)
        i++;
    way_set(&w, u);
    way_move(&w);
    for (int n = 0; n < 10000; n++) {
        way_advance(&w);
        way_move(&w);
        way_finish(&w);
        lowest = fmax(lowest, w.z[i]);
        landed |= w.z[i] > gap;
        highest = landed ? fmin(highest, w.z[i]) : highest;
    }
    near(lowest / (gap + d), 1, 1e-3, "lowest point over that of energy");
    near(highest, 0, 2e-4, "and back to where it was, m");
    free(u);
    way_free(&w);
    trk_free(&t);
}

int main(void)
{
    against_enumeration();
    condition();
    comes_to_rest();
    falls();
    return done();
}
