/* Numbers of a passage: the balance of a train made by hand, extremes gathered by zone. */
#include "tools/post/balance.h"
#include "tools/post/zones.h"

#include <string.h>

#include "tests/kernel/tap.h"

enum { BODIES = 2, DOFS = 6 };  /* a carbody over one wheelset */

/* One record.  The carbody stands y to the right and is pushed by a = v^2/R in a curve to the right; h is its height. */
struct train {
    double station[1], Q[2], Y[2], Mx[2];
    double q[BODIES * DOFS], v[BODIES * DOFS], a[BODIES * DOFS], offset[BODIES], heading[BODIES];
    double mass[BODIES], inertia[3 * BODIES], cg[3 * BODIES], radius[1], wheelset_x[1], curve_x[1], curvature[1];
    int64_t wheelset[1];
    struct run run;
};

static const double g = 9.81, m = 30e3, mw = 1800, h = 1.8, r0 = 0.46, J = 112, speed = 20, R = 400, b = 0.75;

static void make(struct train *t, double y, double curvature)
{
    double a = speed * speed * curvature, W = (m + mw) * g;
    double spin = -speed / r0, yaw = speed * curvature;
    /* about the track axis at rail level: y m g - h m a - r0 mw a + J spin yaw = b (Qr - Ql) */
    double moment = y * m * g - h * m * a - r0 * mw * a + J * spin * yaw;

    memset(t, 0, sizeof *t);
    t->mass[0] = m;
    t->mass[1] = mw;
    t->inertia[4] = J;
    t->cg[2] = -h;
    t->cg[5] = -r0;
    t->radius[0] = r0;
    t->wheelset[0] = 1;
    t->curvature[0] = curvature;
    t->station[0] = 10;
    t->q[1] = y;
    t->a[1] = t->a[DOFS + 1] = a;
    t->Q[0] = 0.5 * W - 0.5 * moment / b;
    t->Q[1] = 0.5 * W + 0.5 * moment / b;
    t->Y[0] = -(m + mw) * a;
    t->Mx[0] = -b * t->Q[0];
    t->Mx[1] = b * t->Q[1];
    t->run = (struct run){.speed = speed, .gravity = g, .wheelsets = 1, .bodies = BODIES, .curves = 1, .records = 1, .mass = t->mass,
                          .inertia = t->inertia, .cg = t->cg, .radius = t->radius, .wheelset = t->wheelset, .wheelset_x = t->wheelset_x,
                          .curve_x = t->curve_x, .curvature = t->curvature};
    t->run.channel[RUN_STATION] = t->station;
    t->run.channel[RUN_Q] = t->Q;
    t->run.channel[RUN_Y] = t->Y;
    t->run.channel[RUN_MX] = t->Mx;
    t->run.channel[RUN_BODY_Q] = t->q;
    t->run.channel[RUN_BODY_V] = t->v;
    t->run.channel[RUN_BODY_A] = t->a;
    t->run.channel[RUN_BODY_OFFSET] = t->offset;
    t->run.channel[RUN_BODY_HEADING] = t->heading;
}

static struct balance find(const struct train *t)
{
    struct balance found;
    const char *why = balance_find(&t->run, -1e6, 1e6, &found);

    ok(!why && found.samples == 1, "%s", why ? why : "one sample");
    return found;
}

static void in_balance(double y, double curvature)
{
    struct train t;

    make(&t, y, curvature);
    struct balance f = find(&t);
    near(f.weight, (m + mw) * g, 1e-9, "the weight");
    near(f.vertical, 0, 1e-9, "Q balances it");
    near(f.lateral, 0, 1e-9, "Y balances the curve");
    near(f.roll, 0, 1e-6, "and the moments");
    near(f.mean_q[0], t.Q[0], 1e-9, "Q of the left");
    near(f.mean_q[1], t.Q[1], 1e-9, "of the right");
    near(f.mean_y, t.Y[0] + t.Y[1], 1e-9, "sum of Y");
    near(f.transfer, 0.5 * (t.Q[0] - t.Q[1]), 1e-9, "load moved to the left");
    near(f.expected, f.transfer, 1e-6, "as the moments of the bodies say");
}

/* What the equations do not say shows as a residual of its size. */
static void out_of_balance(void)
{
    struct train t;

    make(&t, 0.01, 1 / R);
    t.Q[0] += 7;
    t.Mx[0] -= 7 * b;
    t.Y[1] += 3;
    struct balance f = find(&t);
    near(f.vertical, 7, 1e-9, "7 N too much of Q");
    near(f.lateral, 3, 1e-9, "3 N of Y");
    near(f.roll, 7 * b, 1e-6, "and their moment");
    make(&t, 0.01, 1 / R);
    t.a[2] = -0.5; /* upwards: the wheels press harder */
    near(find(&t).vertical, 0.5 * m, 1e-6, "an acceleration without its force");
    make(&t, 0, 0);
    t.inertia[0] = 5e4;
    t.a[3] = 0.1;
    near(find(&t).roll, 5e3, 1e-6, "a roll acceleration without its moment");
    make(&t, 0, 0);
    t.v[DOFS + 5] = 0.01;
    near(find(&t).roll, J * speed / r0 * 0.01, 1e-9, "a yawing spin without its moment");
    ok(balance_find(&t.run, 11, 12, &f) != NULL, "no sample in the window is told");
    t.run.channel[RUN_Q] = NULL;
    ok(balance_find(&t.run, 0, 20, &f) != NULL, "no wheels recorded is told");
}

/* The frame of a wheelset d ahead of the carbody's lies d^2/2R to its right, and its load acts there. */
static void offsets(void)
{
    struct train t;
    double d = 9.5;

    make(&t, d * d / (2 * R), 0); /* the carbody above its wheelset */
    t.cg[3] = d;
    t.heading[0] = 0.1;
    t.heading[1] = 0.1 + d / R;
    t.offset[0] = 3;
    t.offset[1] = 3 + 0.1 * d + d * d / (2 * R);
    t.Q[0] = t.Q[1] = 0.5 * (m + mw) * g;
    t.Mx[0] = -b * t.Q[0];
    t.Mx[1] = b * t.Q[1];
    struct balance f = find(&t);
    near(f.roll, 0, 1e-6, "a load above its wheelset moves none, wherever its frame is");
    near(f.expected, 0, 1e-6, "nor should it");
}

static void zones(void)
{
    enum { SLEEPERS = 4 };
    static const char name[2][32] = {"switch", "crossing"};
    static const int64_t number[SLEEPERS] = {-1, 0, 1, 2}, zone_of[2 * SLEEPERS] = {0, 1, 1, 2, 0, 0, 1, 1};
    static const double Q[2 * SLEEPERS] = {9, 2, 3, 4, 5, 8, 7, 1}, Y[2 * SLEEPERS] = {1, 1, 1, 1, 1, 1, 1, 1};
    static const double pad[2 * SLEEPERS] = {1, 2, 3, 4, 5, 6, 7, 8}, squeeze[2 * SLEEPERS] = {0};
    static const double ballast[3 * SLEEPERS] = {1, 1, 1, 1, 2, 2, 9, 2, 1, 3, 1, 1};
    struct run r = {.sleepers = SLEEPERS, .zones = 2, .zone_name = name, .sleeper_number = number, .pad_zone = zone_of};
    struct zone z[3];

    ok(zones_find(&r, z) != NULL, "extremes of a run that is not complete are not there");
    r.complete = 1;
    r.extreme[RUN_SLEEPER_MAX_Q] = Q;
    r.extreme[RUN_SLEEPER_MAX_Y] = Y;
    r.extreme[RUN_MAX_PAD] = pad;
    r.extreme[RUN_MAX_PAD_COMPRESSION] = squeeze;
    r.extreme[RUN_MAX_BALLAST] = ballast;
    ok(zones_find(&r, z) == NULL, "gathered by zone");
    ok(z[0].sleepers == 3 && z[1].sleepers == 4 && z[2].sleepers == 1, "seats of both rails are counted");
    ok(z[0].Q.value == 9 && z[0].Q.sleeper == -1, "in no zone: 9 at sleeper -1 of the left rail");
    ok(z[1].Q.value == 7 && z[1].Q.sleeper == 1, "in the switch: 7 at sleeper 1 of the right rail");
    ok(z[1].pad.value == 8 && z[1].pad.sleeper == 2, "pads likewise");
    ok(z[2].Q.value == 4 && z[2].pad.value == 4, "one seat alone");
    ok(z[1].ballast.value == 9 && z[1].ballast.sleeper == 1, "ballast: the largest of left, middle and right");
    ok(strcmp(z[2].name, "crossing") == 0 && strcmp(z[0].name, "no zone") == 0, "by name");
}

int main(void)
{
    in_balance(0, 0);
    in_balance(0.03, 0);
    in_balance(0.03, 1 / R);
    in_balance(-0.01, -1 / R);
    out_of_balance();
    offsets();
    zones();
    return done();
}
