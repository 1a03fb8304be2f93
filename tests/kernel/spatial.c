/* A spatial track: rigid motions without force, closed forms of rails sideways and in twist, reciprocity, passivity, and the vertical track
 * within it. */
#include "tests/kernel/tap.h"

#include <complex.h>
#include <stdlib.h>
#include <string.h>

#include "tests/kernel/random.h"
#include "tests/kernel/straight.h"
#include "tests/kernel/table1.h"
#include "tools/receptance/direct.h"
#include "tools/receptance/modes.h"
#include "tools/receptance/place.h"
#include "tools/track/cholesky.h"

enum { MODES = 4 };

static const double EPS = 1e-12;
static const double FREQUENCY[] = {0, 20, 113, 396, 700, 1500};   /* Hz */

enum { FREQUENCIES = sizeof FREQUENCY / sizeof *FREQUENCY };

static int build(struct trk *t, const char *what, const char *const *set)
{
    int n = 0;

    while (set && set[n])
        n++;
    const char *why = straight(t, set, n);
    return ok(why == NULL, "%s builds%s%s", what, why ? ": " : "", why ? why : "");
}

/* ---- rigid motions ---- */

/* y = f X u */
static void multiply(const struct trk *t, const double *X, const double *u, double *y)
{
    memset(y, 0, (size_t)t->dofs * sizeof *y);
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            y[t->Ai[p]] += X[p] * u[j];
}

static double largest(int64_t n, const double *x)
{
    double most = 0;

    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* A body at (x, y) across and h above the sleepers' centres, moved by d down, s aside, and turned by roll, pitch and yaw about their line. */
struct rigid { const char *name; double down, aside, roll, pitch, yaw; };

static void put_rail(double *u, const struct rigid *r, double x, double y, double h)
{
    u[TRK_W] = r->down + y * r->roll - x * r->pitch;
    u[TRK_PITCH] = r->pitch;
    u[TRK_Y] = r->aside + h * r->roll + x * r->yaw;
    u[TRK_YAW] = r->yaw;
    u[TRK_TWIST] = r->roll;
}

static void put_all(const struct trk *t, const struct rigid *r, double *u)
{
    const double h = *t->sleeper_seat + *t->rail_foot;

    for (int64_t i = 0; i < t->nodes; i++)
        for (int rail = 0; rail < TRK_RAILS; rail++)
            put_rail(&u[trk_rail_dof(t, rail, i)], r, t->x[i], (rail - 0.5) * t->rail_spacing, h);
    for (int64_t i = 0; i < t->check_nodes; i++)
        put_rail(&u[t->check_dof[i]], r, t->x[t->check_node[i]], *t->check_y, *t->sleeper_seat + *t->check_foot);
    for (int64_t s = 0; s < t->sleepers; s++) {
        double *sleeper = &u[t->sleeper_dof[s]];
        sleeper[TRK_Z] = r->down + t->sleeper_y[s] * r->roll - t->sleeper_x[s] * r->pitch;
        sleeper[TRK_ROLL] = r->roll;
        sleeper[TRK_SLEEPER_Y] = r->aside + t->sleeper_x[s] * r->yaw;
        sleeper[TRK_SLEEPER_YAW] = r->yaw;
    }
}

/* What the running surface and the check rail do at x, by their shares. */
static void surfaces(const struct trk *t, const struct rigid *r, const double *u, double x)
{
    struct place p;
    int64_t dof[POINT_LATERAL];
    double share[POINT_LATERAL], held, head = 0, check = 0;
    const double h = *t->sleeper_seat + *t->rail_foot + *t->rail_head, hc = *t->sleeper_seat + *t->check_foot + *t->check_head;

    place_find_lateral(&p, t, PLACE_LEFT, AT_STATION, x);
    for (int k = 0; k < p.dofs; k++)
        head += p.share[k] * u[p.dof[k]];
    ok(point_check(t, x, *t->check_head, dof, share, &held), "the check rail runs there");
    for (int k = 0; k < POINT_LATERAL; k++)
        check += share[k] * u[dof[k]];
    ok(fabs(head - (r->aside + h * r->roll + x * r->yaw)) < EPS && fabs(check - (r->aside + hc * r->roll + x * r->yaw)) < EPS,
       "%s: running surface and check rail go with it sideways", r->name);
}

static void rigid_motions(const char *model)
{
    static const struct rigid motion[] = {{"lifting", 1, 0, 0, 0, 0}, {"pushing aside", 0, 1, 0, 0, 0}, {"rolling", 0, 0, 1, 0, 0},
                                          {"pitching", 0, 0, 0, 1, 0}, {"yawing", 0, 0, 0, 0, 1}};
    const char *set[] = {"ballast.stiffness=1e-20", "ballast.lateral_stiffness=1e-20", "ballast.longitudinal_stiffness=1e-20",
                         "rail.elements_per_bay=2", "sleeper.centre={number: [-2, 3], value: [0.1, -0.3]}", model, NULL};
    struct trk t;

    if (!build(&t, "a track on no ballast", set))
        return;
    double *u = calloc(2 * (size_t)t.dofs, sizeof *u), *f = u + t.dofs;
    const double scale = largest(t.Ap[t.dofs], t.Kx);
    for (size_t k = 0; k < sizeof motion / sizeof *motion; k++) {
        put_all(&t, &motion[k], u);
        multiply(&t, t.Kx, u, f);
        ok(largest(t.dofs, f) < 10 * EPS * scale, "%s it needs no force (%.1e of %.1e)", motion[k].name, largest(t.dofs, f), scale);
        surfaces(&t, &motion[k], u, 0.37);
    }
    put_all(&t, &motion[1], u);
    multiply(&t, t.Mx, u, f);
    double weight = 0;
    for (int64_t j = 0; j < t.dofs; j++)
        weight += u[j] * f[j];
    near(weight, 2 * 60 * 7.2 + 12 * 380 + 33 * 3.0, 1e-9, "and the mass that goes aside is all there is");
    free(u);
    trk_free(&t);
}

/* A railpad that has a length holds the pitch of the rail on a sleeper that does not pitch, and nothing else. */
static void pad_length(void)
{
    static const struct rigid yaw = {"yawing", 0, 0, 0, 0, 1}, pitch = {"pitching", 0, 0, 0, 1, 0};
    const char *set[] = {"ballast.stiffness=1e-20", "ballast.lateral_stiffness=1e-20", "ballast.longitudinal_stiffness=1e-20",
                         "railpad.length=0.1", NULL};
    struct trk t;

    if (!build(&t, "a track on railpads of some length", set))
        return;
    double *u = calloc(2 * (size_t)t.dofs, sizeof *u), *f = u + t.dofs;
    put_all(&t, &yaw, u);
    multiply(&t, t.Kx, u, f);
    ok(largest(t.dofs, f) < 10 * EPS * largest(t.Ap[t.dofs], t.Kx), "yawing needs no force still");
    put_all(&t, &pitch, u);
    multiply(&t, t.Kx, u, f);
    near(f[trk_rail_dof(&t, TRK_RIGHT, 3) + TRK_PITCH], 300e6 * 0.01 / 12, 1e-3, "pitching the moment k l^2/12 of each railpad");
    free(u);
    trk_free(&t);
}

/* ---- closed forms ---- */

static double static_lateral(const struct trk *t, double x)
{
    struct cholesky s;
    struct place p;
    double *u = calloc((size_t)t->dofs, sizeof *u), y = NAN;

    place_find_lateral(&p, t, PLACE_RIGHT, AT_STATION, x);
    for (int k = 0; k < p.dofs; k++)
        u[p.dof[k]] += p.share[k];
    if (cholesky_new(&s, t) == NULL) {
        y = place_held(&p, &p, t);
        if (cholesky_solve(&s, u, u) == NULL)
            for (int k = 0; k < p.dofs; k++)
                y += p.share[k] * u[p.dof[k]];
        cholesky_free(&s);
    }
    free(u);
    return y;
}

static double static_check(const struct trk *t, double x)
{
    struct cholesky s;
    int64_t dof[POINT_LATERAL];
    double share[POINT_LATERAL], *u = calloc((size_t)t->dofs, sizeof *u), y = NAN, held;

    if (point_check(t, x, *t->check_head, dof, share, &held) && cholesky_new(&s, t) == NULL) {
        for (int k = 0; k < POINT_LATERAL; k++)
            u[dof[k]] += share[k];
        y = held;
        if (cholesky_solve(&s, u, u) == NULL)
            for (int k = 0; k < POINT_LATERAL; k++)
                y += share[k] * u[dof[k]];
        cholesky_free(&s);
    }
    free(u);
    return y;
}

/* Halfway between two sleepers what the element gives with held ends is what a node there would. */
static void between(void)
{
    const char *one[] = {"rail.beam=timoshenko", NULL}, *two[] = {"rail.beam=timoshenko", "rail.elements_per_bay=2", NULL};
    struct trk coarse, fine;
    int64_t dof[POINT_LATERAL];
    double share[POINT_LATERAL], held;

    if (!build(&coarse, "one element a bay", one) || !build(&fine, "and two", two))
        return;
    near(static_lateral(&coarse, 0) / static_lateral(&fine, 0), 1, 1e-11, "push a rail halfway alike");
    near(static_check(&coarse, 0) / static_check(&fine, 0), 1, 1e-11, "and the check rail");
    ok(!point_check(&fine, 1.6, 0, dof, share, &held) && point_check(&fine, 1.49, 0, dof, share, &held), "which ends at its last sleeper");
    trk_free(&coarse);
    trk_free(&fine);
}

/* Railpads every h = 0.1 m, sideways s N/m2 and in tilt q N under the centroid, on sleepers held by 1e12: the infinite beam on Winkler's
 * foundation gives 1/(8 EI b^3), b^4 = s/4EI; the shaft on springs, cosh a = 1 + q h^2/2GJ, above one h/(2 GJ sinh a). */
static void winkler(void)
{
    const char *held[] = {"from=-15", "length=30", "sleeper.spacing=0.1", "ballast.stiffness=1e12", "ballast.lateral_stiffness=1e12",
                          "rail.foot_depth=1e-9", "sleeper.seat_height=0", "railpad.lateral_stiffness=1e6", "railpad.stiffness=25e6",
                          "rail.head_height=1e-9", NULL};
    const double EI = 1.076e6, GJ = 1.51e5, h = 0.1, s = 1e6 / h, b = pow(s / (4 * EI), 0.25), q = 25e6 * 0.15 * 0.15 / 12 / h, head = 0.0911;
    const double bend = 1 / (8 * EI * b * b * b), twist = h / (2 * GJ * sinh(acosh(1 + q * h * h / (2 * GJ))));
    struct trk t;

    if (!build(&t, "a rail in a bed", held))
        return;
    near(static_lateral(&t, 0.05) / bend, 1, 1e-4, "pushed at its centroid it gives 1/(8 EI b^3)");
    trk_free(&t);
    held[9] = "rail.head_height=0.0911";
    if (!build(&t, "with its head", held))
        return;
    near(static_lateral(&t, 0.05) / (bend + head * head * twist), 1, 1e-4, "pushed at its head it also twists as a shaft on springs");
    trk_free(&t);
}

/* Of the modes nearest to f the one in which the end of the check rail moves so, Hz. */
static double check_mode(const struct trk *t, double f, int part)
{
    struct mod m;
    double best = NAN;

    if (modes_track(&m, t, MODES, f) != NULL)
        return NAN;
    for (int64_t k = 0; k < m.n; k++) {
        const double *x = m.shape + k * m.dofs;
        const double most = largest(m.dofs, x);
        if (fabs(x[t->check_dof[0] + part]) > 0.3 * most && !(fabs(m.frequency[k] - f) > fabs(best - f)))
            best = m.frequency[k];
    }
    mod_free(&m);
    return best;
}

/* The check rail on fastenings that are nothing: a free beam of 3 m. */
static void free_beam(void)
{
    const char *set[] = {"check_rail.1.beam.stiffness=1e-3", "rail.elements_per_bay=4", "rail.mass_model=consistent",
                         "check_rail.1.beam.damping=0", NULL};
    const double L = 3.0, one = 4.730040744862704 / L, root = one * one / (2 * M_PI);
    const double lateral = root * sqrt(2.7e5 / 33), vertical = root * sqrt(6.3e5 / 33), torsion = sqrt(1.6e5 / 0.0338) / (2 * L);
    struct trk t;

    if (!build(&t, "a check rail on nothing", set))
        return;
    near(check_mode(&t, 1.01 * lateral, TRK_Y) / lateral, 1, 1e-5, "bends sideways, free, with 4.73^2 sqrt(EI/m)/(2 pi L^2)");
    near(check_mode(&t, 1.01 * vertical, TRK_W) / vertical, 1, 1e-5, "and vertically");
    for (int n = 1; n <= 3; n++) {
        const double kh = n * M_PI / 20, finite = sqrt(6 * (1 - cos(kh)) / (2 + cos(kh))) / kh;      /* 20 elements: 1 + (kh)^2/24 */
        near(check_mode(&t, 1.0001 * finite * n * torsion, TRK_TWIST) / (n * torsion * finite), 1, 1e-6, "twists with n/(2L) sqrt(GJ/rho Ip)");
    }
    trk_free(&t);
}

/* Rails pinned sideways above each sleeper: one half wave a bay. */
static void pinned(void)
{
    const char *set[] = {"railpad.lateral_stiffness=1e12", "ballast.lateral_stiffness=1e12", "rail.foot_depth=1e-9", "rail.mass_model=consistent",
                         "rail.elements_per_bay=8", NULL, NULL};
    const double L = 0.6, q = M_PI / L, EI = 1.076e6, m = 60, kGA = 2.49e8, rho = 0.0402;
    const double A = rho * m / kGA, B = m + rho * q * q + m * EI * q * q / kGA, C = EI * q * q * q * q;
    const double timoshenko = sqrt((B - sqrt(B * B - 4 * A * C)) / (2 * A)) / (2 * M_PI), euler = M_PI / (2 * L * L) * sqrt(EI / m);
    struct trk t;
    struct mod modes;

    for (int shears = 0; shears < 2; shears++) {
        const double want = shears ? timoshenko : euler;
        double best = 0;
        set[5] = shears ? "rail.beam=timoshenko" : NULL;
        if (!build(&t, shears ? "a Timoshenko rail pinned sideways" : "an Euler-Bernoulli rail pinned sideways", set))
            return;
        if (modes_track(&modes, &t, 8, want) == NULL)
            for (int64_t k = 0; k < modes.n; k++)
                if (strncmp(modes.name[k], "lateral", 7) == 0 && fabs(modes.frequency[k] - want) < fabs(best - want))
                    best = modes.frequency[k];
        near(best, want, 1e-3 * want, "has its pinned-pinned frequency");
        mod_free(&modes);
        trk_free(&t);
    }
}

/* ---- receptance ---- */

static double complex response(struct direct *d, const struct place *force, const struct place *motion, double *u)
{
    double complex H = 0;

    memset(u, 0, 2 * (size_t)d->track->dofs * sizeof *u);
    for (int k = 0; k < force->dofs; k++)
        u[2 * force->dof[k]] += force->share[k];
    if (direct_solve(d, u))
        return NAN;
    for (int k = 0; k < motion->dofs; k++)
        H += motion->share[k] * (u[2 * motion->dof[k]] + u[2 * motion->dof[k] + 1] * I);
    return H;
}

/* H_ij = H_ji between rails, sleepers, down and aside, and -Im f.u > 0 for any forces f. */
static void pairs(const char *model)
{
    const char *set[] = {"sleeper.centre={number: [-2, 3], value: [0.1, -0.3]}", "rail.left.lateral_bending_stiffness=2e6", "railpad.length=0.1", model,
                         NULL};
    struct trk t;
    struct direct d;
    struct place p[4];
    double worst = 0, most = 0, gain = 0, least = 1e300;

    if (!build(&t, model, set) || !ok(direct_new(&d, &t) == NULL, "and can be solved"))
        return;
    double *u = calloc(4 * (size_t)t.dofs, sizeof *u), *f = u + 2 * t.dofs;
    place_find(&p[0], &t, PLACE_LEFT, AT_STATION, -1.1);
    place_find_lateral(&p[1], &t, PLACE_RIGHT, AT_STATION, 0.5);
    place_find_lateral(&p[2], &t, PLACE_LEFT, AT_SLEEPER, 1.5);
    place_find_lateral(&p[3], &t, PLACE_SLEEPER, AT_SLEEPER, 0.3);
    for (int k = 0; k < FREQUENCIES; k++) {
        if (direct_factor(&d, 2 * M_PI * FREQUENCY[k] * I))
            worst = NAN;
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < i; j++) {
                const double complex one = response(&d, &p[i], &p[j], u), other = response(&d, &p[j], &p[i], u);
                worst = fmax(worst, cabs(one - other) / cabs(response(&d, &p[i], &p[i], u)));
                gain = fmax(gain, cabs(one) / cabs(response(&d, &p[i], &p[i], u)));
            }
        for (int64_t i = 0; i < 2 * t.dofs; i++)
            f[i] = u[i] = random_number() - 0.5;
        if (direct_solve(&d, u))
            worst = NAN;
        double work = 0;
        for (int64_t i = 0; i < t.dofs; i++)
            work -= f[2 * i] * u[2 * i + 1] - f[2 * i + 1] * u[2 * i];
        most = fmax(most, fabs(work));
        if (FREQUENCY[k] > 0)
            least = fmin(least, work);
    }
    ok(worst < 1e-11, "receptances are reciprocal, within %.1e", worst);
    ok(gain > 1e-4, "down and aside are coupled (%.1e)", gain);
    ok(least > 0, "forces at random do work on it at every frequency (%.1e to %.1e)", least, most);
    free(u);
    direct_free(&d);
    trk_free(&t);
}

/* Loaded down on both rails it is the vertical track. */
static void vertical(const char *model)
{
    const char *spatial[] = {"dofs=spatial", model, "railpad.length=0"}, *plain[] = {model};
    struct trk t[2];
    struct direct d[2];
    struct place p[2];
    double worst = 0;

    if (!ok(table1(&t[0], plain, 1) == NULL && table1(&t[1], spatial, 3) == NULL, "Table 1, vertical and spatial, %s", model))
        return;
    double *u = calloc(2 * (size_t)t[1].dofs, sizeof *u);
    for (int k = 0; k < 2; k++)
        if (direct_new(&d[k], &t[k]))
            worst = NAN;
    for (int at = AT_SLEEPER; at <= AT_MIDSPAN; at++)
        for (int k = 0; k < FREQUENCIES; k++) {
            double complex H[2];
            for (int i = 0; i < 2; i++) {
                place_find(&p[i], &t[i], PLACE_BOTH, at, 0);
                H[i] = direct_factor(&d[i], 2 * M_PI * FREQUENCY[k] * I) ? NAN : response(&d[i], &p[i], &p[i], u);
            }
            worst = fmax(worst, cabs(H[0] - H[1]) / cabs(H[0]));
        }
    ok(worst < 1e-10, "one receptance, both rails loaded, within %.1e", worst);
    free(u);
    for (int k = 0; k < 2; k++) {
        direct_free(&d[k]);
        trk_free(&t[k]);
    }
}

int main(void)
{
    rigid_motions("rail.mass_model=lumped");
    rigid_motions("rail.mass_model=consistent");
    rigid_motions("rail.beam=timoshenko");
    pad_length();
    between();
    winkler();
    free_beam();
    pinned();
    pairs("rail.mass_model=lumped");
    pairs("rail.mass_model=consistent");
    vertical("rail.mass_model=lumped");
    vertical("rail.mass_model=consistent");
    vertical("rail.beam=timoshenko");
    return done();
}
