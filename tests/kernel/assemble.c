/* The matrices of a track: symmetry, rigid motion of the unsupported beams, total mass, what supports carry.  Run from the root. */
#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"

#include <string.h>

static const double EPS = 1e-12;

static double entry(const struct trk *t, const double *X, int64_t i, int64_t j)
{
    for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
        if (t->Ai[p] == i)
            return X[p];
    return 0;
}

static void symmetric(const struct trk *t, const double *X, const char *name)
{
    int64_t differ = 0;

    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            differ += X[p] != entry(t, X, j, t->Ai[p]);
    ok(differ == 0, "%s is symmetric, bit for bit", name);
}

/* Largest |K u| over the largest entry of K. */
static double force(const struct trk *t, const double *u)
{
    double f[400] = {0}, most = 0, scale = 0;

    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            f[t->Ai[p]] += t->Kx[p] * u[j];
            scale = fmax(scale, fabs(t->Kx[p]));
        }
    for (int64_t i = 0; i < t->dofs; i++)
        most = fmax(most, fabs(f[i]));
    return most / scale;
}

/* The whole track, rails and sleepers, moved as one body on springs that are nearly nothing: no elastic force may appear. */
static void rigid_motion(void)
{
    struct trk t;
    const char *set[] = {"ballast.stiffness=1e-20"};
    double u[400] = {0};

    if (!ok(table1(&t, set, 1) == NULL, "a track on no ballast builds"))
        return;
    for (int64_t i = 0; i < t.nodes; i++)
        u[t.node_dof[i]] = u[t.node_dof[i] + 2] = 1;
    for (int64_t k = 0; k < t.sleepers; k++)
        u[t.sleeper_dof[k]] = 1;
    near(force(&t, u), 0, EPS, "lifting the unsupported track needs no force");
    for (int64_t i = 0; i < t.nodes; i++) {
        u[t.node_dof[i]] = u[t.node_dof[i] + 2] = -t.x[i];
        u[t.node_dof[i] + 1] = u[t.node_dof[i] + 3] = 1;
    }
    for (int64_t k = 0; k < t.sleepers; k++)
        u[t.sleeper_dof[k]] = -t.sleeper_x[k];
    near(force(&t, u), 0, EPS * 15, "pitching it needs no force");
    memset(u, 0, sizeof u);
    for (int64_t i = 0; i < t.nodes; i++) {
        u[t.node_dof[i]] = -t.rail_spacing / 2;
        u[t.node_dof[i] + 2] = t.rail_spacing / 2;
    }
    for (int64_t k = 0; k < t.sleepers; k++)
        u[t.sleeper_dof[k] + 1] = 1;
    near(force(&t, u), 0, EPS, "rolling it needs no force");
    trk_free(&t);
}

static void masses(const struct trk *t)
{
    double rail = 0, sleeper = 0;

    for (int64_t i = 0; i < t->nodes; i++)
        rail += entry(t, t->Mx, t->node_dof[i], t->node_dof[i]);
    for (int64_t k = 0; k < t->sleepers; k++)
        sleeper += entry(t, t->Mx, t->sleeper_dof[k], t->sleeper_dof[k]);
    near(rail, 60.0 * 30, 1e-9, "a rail weighs 60 kg/m over its length");
    near(t->rail_mass[0], 36, 1e-12, "36 kg at the end node too");
    near(sleeper, 50 * 380, 1e-9, "the sleepers weigh 380 kg each");
    near(entry(t, t->Mx, t->sleeper_dof[7] + 1, t->sleeper_dof[7] + 1), 155.09, 0, "and roll with 155.09 kg m2");
}

static void supports(const struct trk *t)
{
    const int64_t z = t->sleeper_dof[10], w = t->node_dof[10];

    near(entry(t, t->Kx, z, z), 280e6 + 2 * 300e6, 1, "a sleeper is held by ballast and two pads");
    near(entry(t, t->Kx, z + 1, z + 1), 2 * 280e6 / 3 * 0.95 * 0.95 + 2 * 300e6 * 0.75 * 0.75, 10, "in roll by their arms");
    near(entry(t, t->Kx, z, z + 1), 0, 1e-6, "bounce and roll do not mix where the sleeper is centred");
    near(entry(t, t->Kx, w, z + 1), 300e6 * 0.75, 1, "rolling (right side down) opens the left pad");
    near(entry(t, t->Cx, w + 2, z + 1), -50e3 * 0.75, 1e-6, "and closes the right one");
    near(t->sleeper_x[0], -14.7, 1e-12, "the first sleeper stands half a bay in");
    near((double)t->sleeper_number[25], 1, 0, "sleeper 1 is the first one beyond station 0");
    near(t->sleeper_x[25], 0.3, 1e-12, "at 0.3 m");
}

static void finer(void)
{
    struct trk t;
    const char *set[] = {"rail.elements_per_bay=4", "sleeper.centre=-0.5"};

    if (!ok(table1(&t, set, 2) == NULL, "four elements a bay build"))
        return;
    near((double)t.nodes, 4 * 49 + 1, 0, "197 nodes a rail");
    near((double)t.dofs, 4 * 197 + 2 * 50, 0, "888 degrees of freedom");
    double rail = 0;
    for (int64_t i = 0; i < t.nodes; i++)
        rail += t.rail_mass[i];
    near(rail, 1800, 1e-9, "the rail keeps its mass");
    int64_t z = t.sleeper_dof[3];
    near(entry(&t, t.Kx, t.node_dof[12], z + 1), -300e6 * -0.25, 1, "a sleeper shifted 0.5 m left has its left pad 0.25 m out");
    trk_free(&t);
}

static void refusals(void)
{
    struct trk t;
    const char *length[] = {"length=30.3"}, *edge[] = {"ballast.edge=1.4"};

    ok(table1(&t, length, 1) != NULL, "half a bay is refused");
    trk_free(&t);
    ok(table1(&t, edge, 1) != NULL, "ballast springs that cross are refused");
    trk_free(&t);
}

int main(void)
{
    struct trk t;
    const char *why = table1(&t, NULL, 0);

    if (!ok(why == NULL, "the track of Table 1 builds%s%s", why ? ": " : "", why ? why : ""))
        return done();
    symmetric(&t, t.Kx, "K");
    symmetric(&t, t.Cx, "C");
    symmetric(&t, t.Mx, "M");
    masses(&t);
    supports(&t);
    trk_free(&t);
    rigid_motion();
    finer();
    refusals();
    return done();
}
