/* A track and a contact table turned half way round: twice is as before, matrices keep their work, contacts their places. */
#include "tools/track/turn.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/contact/lookup.h"

static double apart(int64_t n, const double *a, const double *b)
{
    double worst = 0;

    for (int64_t i = 0; i < n && a && b; i++)
        worst = fmax(worst, fabs(a[i] - b[i]));
    return (a == NULL) != (b == NULL) ? HUGE_VAL : worst;
}

static double matrices_apart(const struct trk *a, const struct trk *b)
{
    const int64_t n = a->Ap[a->dofs];

    for (int64_t i = 0; i < n; i++)
        if (a->Ai[i] != b->Ai[i])
            return HUGE_VAL;
    return apart(n, a->Kx, b->Kx) + apart(n, a->Cx, b->Cx) + apart(n, a->Mx, b->Mx);
}

/* Greatest difference of all numbers along the track. */
static double tracks_apart(const struct trk *a, const struct trk *b)
{
    const int64_t n = a->nodes, s = a->sleepers, c = a->check_nodes;
    double worst = apart(n, a->x, b->x) + apart(2 * a->knots, a->bending, b->bending) + apart(a->knots, a->bending_x, b->bending_x) +
                   apart(2 * n, a->rail_mass, b->rail_mass) + apart(2 * n, a->rail_inertia, b->rail_inertia) +
                   apart(2 * (n - 1), a->rail_density, b->rail_density) + apart(s, a->sleeper_x, b->sleeper_x) +
                   apart(s, a->sleeper_mass, b->sleeper_mass) + apart(s, a->sleeper_y, b->sleeper_y) + apart(2 * s, a->pad_k, b->pad_k) +
                   apart(2 * s, a->pad_c, b->pad_c) + apart(3 * s, a->ballast_k, b->ballast_k) + apart(3 * s, a->ballast_y, b->ballast_y) +
                   apart(a->checks, a->check_x, b->check_x) + apart(a->checks, a->check_play, b->check_play) +
                   apart(a->cants, a->cant_x, b->cant_x) + apart(a->cants, a->cant, b->cant) + apart(s, a->sleeper_yaw, b->sleeper_yaw) +
                   apart(2 * (n - 1), a->rail_torsion, b->rail_torsion) + apart(2 * s, a->pad_lateral_k, b->pad_lateral_k);

    for (int64_t i = 0; i < 2 * s; i++)
        worst += (double)(a->pad_zone[i] != b->pad_zone[i]);
    for (int64_t i = 0; i < s; i++)
        worst += (double)(a->sleeper_node[i] != b->sleeper_node[i] || a->sleeper_dof[i] != b->sleeper_dof[i] || a->sleeper_number[i] != b->sleeper_number[i]);
    for (int64_t i = 0; i < n; i++)
        worst += (double)(a->node_dof[i] != b->node_dof[i]);
    for (int64_t i = 0; i < c; i++)
        worst += (double)(a->check_node[i] != b->check_node[i] || a->check_dof[i] != b->check_dof[i]);
    return worst + (double)(*a->check_rail != *b->check_rail) + matrices_apart(a, b);
}

/* Both rails pushed down by different forces far from each other: what K says of the same shape, written in both tracks. */
static double work(const struct trk *t, int rail, int64_t node, double w, double pitch)
{
    const int64_t at = trk_rail_dof(t, rail, node);
    const double u[2] = {w, pitch};
    double sum = 0;

    for (int k = 0; k < 2; k++)
        for (int64_t p = t->Ap[at + k]; p < t->Ap[at + k + 1]; p++)
            if (t->Ai[p] - at >= 0 && t->Ai[p] - at < 2)
                sum += u[k] * u[t->Ai[p] - at] * t->Kx[p];
    return sum;
}

static void track(const char *what, const char *const *set, int sets)
{
    struct trk t, once, twice;
    const char *why = rig_track(&t, RIG_TURNOUT, set, sets);

    if (why || (why = turn_track(&once, &t)) || (why = turn_track(&twice, &once))) {
        ok(0, "%s: %s", what, why);
        return;
    }
    near(tracks_apart(&t, &twice), 0, 0, what);
    const int64_t node = t.nodes / 3, there = t.nodes - 1 - node;
    near(work(&t, TRK_LEFT, node, 1e-3, 2e-3) /
             work(&once, TRK_RIGHT, there, 1e-3, -2e-3), 1, 1e-15, "the left rail's deflection and pitch, turned, are the right one's");
    ok(once.x[there] == -t.x[node] && once.curvature[0] == -t.curvature[t.curves - 1] && once.curvature[once.curves - 1] == 0,
       "stations and curvature have the opposite sign");
    trk_free(&twice);
    trk_free(&once);
    trk_free(&t);
}

/* A plane under 0.025 rad: u' = -u, so the height stays, its slope and the contact angle turn. */
static void table(void)
{
    struct rig_table left;
    struct contact a[CONTACT_MAX], b[CONTACT_MAX];

    rig_table(&left, 'l', 0.025);
    const struct ctab turned = contact_turn(&left.ctab);
    ok(turned.side == 'r' && turned.wheel_position == -left.ctab.wheel_position, "a left table turned is a right one");
    ok(contact_lookup(&left.ctab, 1, 0.01, 3e-3, 2e-3, a) == 1 && contact_lookup(&turned, -1, 0.01, -3e-3, -2e-3, b) == 1, "one contact in each");
    ok(a->height == b->height && a->height_u == -b->height_u && a->height_yaw == b->height_yaw && a->height_roll == -b->height_roll, "height and slopes");
    ok(a->row[CTAB_ANGLE] == -b->row[CTAB_ANGLE] && a->row[CTAB_RAIL_Y] == -b->row[CTAB_RAIL_Y] && a->row[CTAB_X] == -b->row[CTAB_X] &&
       a->row[CTAB_RADIUS] == b->row[CTAB_RADIUS], "place, angle, radius");
    ok(contact_lookup(&turned, 0, 0, 1, 0, b) == -1, "beyond its ends still");
}

int main(void)
{
    static const char *const spatial[] = {"dofs=spatial"};

    track("turned twice as before", NULL, 0);
    track("a spatial track too", spatial, 1);
    table();
    return done();
}
