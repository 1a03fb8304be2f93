/* The kind with the most kinetic energy x'Mx: what goes down, pitches or rolls, what goes sideways or yaws, what twists. */
#include "tools/receptance/kind.h"

#include <math.h>
#include <stdio.h>

enum { VERTICAL, LATERAL, TORSION, KINDS };

static const char *const WORD[KINDS] = {"vertical", "lateral", "torsion"};
static const int TOLD_BY[KINDS] = {TRK_W, TRK_Y, TRK_TWIST};
static const int OF_RAIL[TRK_SPATIAL_RAIL] = {VERTICAL, VERTICAL, LATERAL, LATERAL, TORSION};
static const int OF_SLEEPER[TRK_SPATIAL_SLEEPER] = {VERTICAL, VERTICAL, LATERAL, LATERAL};

static const double ALIKE = 0.9;       /* least correlation of the rails in phase */

/* part [of[k]] += x_j (M x)_j of the degrees of freedom j from dof on */
static void add_energy(const struct trk *t, const double *x, int64_t dof, int64_t n, const int *of, double part[KINDS])
{
    for (int64_t k = 0; k < n; k++)
        for (int64_t p = t->Ap[dof + k]; p < t->Ap[dof + k + 1]; p++)
            part[of[k]] += x[dof + k] * t->Mx[p] * x[t->Ai[p]];
}

static int kind_of(const struct trk *t, const double *x)
{
    double part[KINDS] = {0};
    int kind = VERTICAL;

    for (int64_t i = 0; i < t->nodes; i++)
        for (int rail = 0; rail < TRK_RAILS; rail++)
            add_energy(t, x, trk_rail_dof(t, rail, i), t->rail_dofs, OF_RAIL, part);
    for (int64_t i = 0; i < t->check_nodes; i++)
        add_energy(t, x, t->check_dof[i], t->rail_dofs, OF_RAIL, part);
    for (int64_t s = 0; s < t->sleepers; s++)
        add_energy(t, x, t->sleeper_dof[s], t->sleeper_dofs, OF_SLEEPER, part);
    for (int k = 1; k < KINDS; k++)
        if (part[k] > part[kind])
            kind = k;
    return kind;
}

void kind_name(const struct trk *t, const double *x, char name[32])
{
    const int kind = kind_of(t, x), spatial = trk_is_spatial(t);
    double left = 0, right = 0, both = 0;

    for (int64_t i = 0; i < t->nodes; i++) {
        const double l = x[trk_rail_dof(t, TRK_LEFT, i) + TOLD_BY[kind]], r = x[trk_rail_dof(t, TRK_RIGHT, i) + TOLD_BY[kind]];
        left += l * l;
        right += r * r;
        both += l * r;
    }
    const double alike = both / sqrt(left * right);
    const char *phase = alike > ALIKE ? "in phase" : alike < -ALIKE ? "antiphase" : "";
    snprintf(name, 32, "%s%s%s", spatial ? WORD[kind] : "", spatial && *phase ? ", " : "", phase);
}
