/* Long bearers: what a load on each railpad brings to the ballast.  Run from the root.
 *
 * A bearer of length 2.6 m + d reaches d further than a sleeper to one side, so that the rails stand d/2 off its middle.  Rigid, on three
 * equal springs at -a, 0 and a, with P on each railpad: the middle spring carries 2P/3, the outer ones 2P/3 +- P d/(2a), for the moment P d
 * of the loads about the middle is theirs alone. */
#include "tests/kernel/tap.h"

#include <stdlib.h>

#include "formats/trk_text.h"
#include "tools/track/assemble.h"
#include "tools/track/cholesky.h"
#include "tools/track/layout.h"

#define DIVERGING "data/tracks/60E1-R760-1-15-diverging.yaml"
#define THROUGH "data/tracks/60E1-R760-1-15-through.yaml"
/* N m2: rails that take no load to the neighbours, so that P stays on its railpad. */
#define LIMP "rail.left.bending_stiffness=1e-5", "rail.right.bending_stiffness=1e-5"

static const double PLAIN = 2.6;               /* m, length of a sleeper of one track */
static const double EDGE = 0.35;               /* m, outer ballast from the ends */
static const double RADIUS = 760;              /* m */

static const char *load_track(struct trk *t, const char *path, const char *const *set, int sets)
{
    struct trk_text in;

    *t = (struct trk){0};
    const char *why = trk_text_read(&in, path, (char *const *)set, sets, NULL);
    if (why)
        return why;
    why = layout_track(t, &in);
    trk_text_free(&in);
    return why ? why : assemble_track(t);
}

static int64_t sleeper_at(const struct trk *t, double x)
{
    int64_t best = 0;

    for (int64_t k = 1; k < t->sleepers; k++)
        if (fabs(t->sleeper_x[k] - x) < fabs(t->sleeper_x[best] - x))
            best = k;
    return best;
}

/* Forces (of P, up) of the ballast left, middle and right of sleeper s under P on both rails above it; the whole track is solved. */
static int ballast(const struct trk *t, int64_t s, double force[TRK_BALLAST])
{
    struct cholesky solver;
    double *u = calloc((size_t)t->dofs, sizeof *u);
    const int64_t w = t->node_dof[t->sleeper_node[s]], z = t->sleeper_dof[s];
    int failed = !u || cholesky_new(&solver, t) != NULL;

    if (!failed) {
        u[w] = u[w + 2] = 1;
        failed = cholesky_solve(&solver, u, u) != NULL;
        cholesky_free(&solver);
    }
    for (int b = 0; b < TRK_BALLAST && !failed; b++)
        force[b] = t->ballast_k[b * t->sleepers + s] * (u[z] + t->ballast_y[b * t->sleepers + s] * u[z + 1]);
    free(u);
    return failed;
}

/* Every bearer of the track of this file against the closed form; side is -1 where they reach to the left of the rails. */
static void all_bearers(const char *path, const char *name, int side)
{
    const char *set[] = {LIMP};
    struct trk t;
    double worst = 0, force[TRK_BALLAST] = {0}, middle = 0;
    int failed = 0;

    if (!ok(!load_track(&t, path, set, 2), "%s: the track builds", name))
        return;
    for (int64_t s = 0; s < t.sleepers; s += t.sleeper_number[s] > 0 && t.sleeper_number[s] < 93 ? 1 : 20) {
        const double a = t.ballast_y[2 * t.sleepers + s], d = 2 * t.sleeper_y[s] * side;
        failed |= ballast(&t, s, force);
        worst = fmax(worst, fabs(force[0] - (2.0 / 3 + side * d / (2 * a))));
        worst = fmax(worst, fabs(force[2] - (2.0 / 3 - side * d / (2 * a))));
        middle = fmax(middle, fabs(force[1] - 2.0 / 3));
    }
    ok(!failed && worst < 1e-9, "%s: outer ballast 2P/3 +- P d/(2a) under every bearer and plain sleeper (within %.1e P)", name, worst);
    ok(middle < 1e-9, "%s: middle ballast 2P/3 under each of them (within %.1e P)", name, middle);
    trk_free(&t);
}

/* At 47.7 m under the crossing the shipped bearer: d straight between knots ten bearers apart and, in the through route, at right angles to
 * the straight rather than to the arc, is 2 or 4 mm more than the arc has there, worth 0.4 and 0.7 mP. */
static void crossing(const char *path, const char *name, int near_side, int far_side)
{
    const char *set[] = {LIMP};
    struct trk t;
    double force[TRK_BALLAST] = {NAN, NAN, NAN};

    if (!ok(!load_track(&t, path, set, 2), "%s: the track builds", name))
        return;
    const int64_t s = sleeper_at(&t, 47.7);
    ok(t.sleeper_number[s] == 80 && !ballast(&t, s, force), "%s: sleeper 80 stands at 47.7 m", name);
    near(2 * t.ballast_y[2 * t.sleepers + s] + 2 * EDGE - PLAIN - 2 * fabs(t.sleeper_y[s]), 0, 5e-4, "its length is 2.6 m + d");
    near(force[near_side], 1.107, 1e-3, "the side towards which the rails stand carries 1.107 P");
    near(force[far_side], 0.226, 1e-3, "the other side 0.226 P");
    near(force[1], 0.667, 5e-4, "the middle 0.667 P");
    trk_free(&t);
}

/* The divergence of the arc itself at 47.7 m, R (1 - cos(s/R)), to the last digit that is given. */
static void arc(int side)
{
    const double d = RADIUS * (1 - cos(47.7 / RADIUS)), a = (PLAIN + d) / 2 - EDGE;
    char length[64], centre[64];
    const char *set[] = {LIMP, "from=-3", "length=6", length, centre};
    struct trk t;
    double force[TRK_BALLAST] = {NAN, NAN, NAN};

    snprintf(length, sizeof length, "sleeper.length=%.17g", PLAIN + d);
    snprintf(centre, sizeof centre, "sleeper.centre=%.17g", side * d / 2);
    if (!ok(!load_track(&t, "data/tracks/thesis-straight.yaml", set, 6), "a track of bearers with d = %.4f m, %s, builds", d,
            side < 0 ? "diverging" : "through"))
        return;
    ok(!ballast(&t, 5, force), "it carries a load");
    near(force[side < 0 ? 2 : 0], 2.0 / 3 + d / (2 * a), 1e-9, "the near side carries 2P/3 + P d/(2a)");
    near(force[side < 0 ? 2 : 0], 1.107, 5e-4, "which is 1.107 P");
    near(force[side < 0 ? 0 : 2], 2.0 / 3 - d / (2 * a), 1e-9, "the far side 2P/3 - P d/(2a)");
    near(force[side < 0 ? 0 : 2], 0.226, 5e-4, "which is 0.226 P");
    near(force[1], 2.0 / 3, 1e-9, "the middle 2P/3");
    trk_free(&t);
}

int main(void)
{
    all_bearers(DIVERGING, "diverging", -1);
    all_bearers(THROUGH, "through", 1);
    crossing(DIVERGING, "diverging", 2, 0);
    crossing(THROUGH, "through", 0, 2);
    arc(-1);
    arc(1);
    return done();
}
