/* One wheel on its rail: closed forms of normal force, compliance and creepage, moments, friction, separation. */
#include "tools/integrate/wheel.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"

static const double v = 22;
#define ROW 2e-7 /* relative: a table's rows are f32 */

/* The right wheel over a plane of contact angle g, its running circle `below` metres deeper than first touch, rolling freely. */
static struct wheel_input over_plane(struct rig_table *t, double g, double below)
{
    rig_table(t, 'r', g);
    return (struct wheel_input){.table = &t->ctab, .s = 3, .v = v, .z = below, .spin = -v / 0.46, .radius = 0.46};
}

static struct wheel_law hertz(double friction)
{
    struct wheel_law law = {.normal = WHEEL_HERTZ, .friction = friction, .step = 1e-4};

    fastsim_begin(&law.grid, 20);
    return law;
}

static struct wheel_law linear(void)
{
    struct wheel_law law = hertz(0);

    law.normal = WHEEL_LINEAR;
    law.stiffness = 137e6;
    law.damping = 28e3;
    return law;
}

static struct wheel_output force(const struct wheel_law *law, const struct wheel_input *in, struct wheel_memory *memory)
{
    struct wheel_output out;
    const char *why = wheel_force(law, in, memory, &out);

    if (why)
        ok(0, "%s", why);
    return out;
}

/* Approach along the normal is the vertical one times cos g, and N stands off the vertical by g. */
static void normal_law(double g)
{
    struct rig_table t;
    struct wheel_input in = over_plane(&t, g, 1e-4);
    struct wheel_law law = hertz(0);
    struct wheel_memory memory = {0};
    struct wheel_output o = force(&law, &in, &memory);
    double N = RIG_HERTZ_C * pow(1e-4 * cos(g), 1.5);

    printf("# contact angle %g\n", g);
    near(o.patch[0].N / N, 1, ROW, "N = C d^1.5");
    near(o.Q / N, cos(g), ROW, "Q = N cos g");
    near(o.Y / N, -sin(g), ROW, "Y = -N sin g");
    near(o.force[2], -o.Q, 0, "the wheel feels the opposite");
    near(o.force[1], -o.Y, 0, "sideways too");

    law.hertz_damping = 0.2;
    in.vz = 0.1;
    o = force(&law, &in, &memory);
    near(o.patch[0].N / N, 1 + 0.2 * 0.1 * cos(g), ROW, "damping with the rate of approach");
    in.vz = -100;
    ok(force(&law, &in, &memory).patches == 0, "which does not pull");

    law = linear();
    in.vz = 0.1;
    o = force(&law, &in, &memory);
    near(o.patch[0].N, (137e6 * 1e-4 + 28e3 * 0.1) * cos(g), ROW * o.patch[0].N, "linear law: k d + c d'");
    in.vz = 0;
    in.y = 2e-3; /* u = 2 mm, so the plane lies u tan g deeper */
    o = force(&law, &in, &memory);
    near(o.patch[0].N, 137e6 * fmax(0, 1e-4 - 2e-3 * tan(g)) * cos(g), ROW * o.patch[0].N, "sideways the wheel leaves a plane that falls away");
    in.y = 0;
    in.vy = 0.05;
    o = force(&law, &in, &memory);
    near(o.patch[0].N, (137e6 * 1e-4 - 28e3 * 0.05 * tan(g)) * cos(g), ROW * o.patch[0].N, "and moving so opens it");
}

static void separation(void)
{
    struct rig_table t;
    struct wheel_input in = over_plane(&t, -0.05, -1e-6);
    struct wheel_law law = hertz(0.3);
    struct wheel_memory memory = {.local = 1e-6, .creep_z = 3};
    struct wheel_output o;

    in.compliance = 1.8e-10;
    o = force(&law, &in, &memory);
    o = force(&law, &in, &memory);
    ok(o.patches == 0 && o.Q == 0 && o.Y == 0 && o.T == 0 && o.Mx == 0, "a wheel off its rail has no force");
    ok(o.moment[0] == 0 && o.moment[1] == 0 && o.moment[2] == 0, "and no moment");
    near(memory.local, 0, 1e-15, "and the rail no local deflection");

    in.y = 0.021;
    ok(wheel_force(&law, &in, &memory, &o) != NULL, "beyond the table is a failure");
}

/* What raises the rail lowers the wheel: deflection of the rail, its velocity and slope, a dip; roll at the running circle. */
static void what_moves(void)
{
    struct rig_table t;
    struct wheel_input in = over_plane(&t, 0, 1e-4);
    struct wheel_law law = linear();
    struct wheel_memory memory = {0};
    double N = 137e6 * 1e-4, k = 137e6, c = 28e3;

    in.rail_z = 3e-5;
    near(force(&law, &in, &memory).Q, N - k * 3e-5, 1e-6, "rail deflection");
    in = over_plane(&t, 0, 1e-4);
    in.rail_v = 0.02;
    near(force(&law, &in, &memory).Q, N - c * 0.02, 1e-6, "velocity of the rail");
    in = over_plane(&t, 0, 1e-4);
    in.rail_slope = 1e-3;
    near(force(&law, &in, &memory).Q, N - c * 1e-3 * v, 1e-6, "slope of the rail, along which the wheel comes at v");
    in = over_plane(&t, 0, 1e-4);
    in.dip = 3e-5;
    in.dip_slope = 1e-3;
    near(force(&law, &in, &memory).Q, N - k * 3e-5 - c * 1e-3 * v, 1e-6, "a dip, and its slope");
    in = over_plane(&t, 0.3, 1e-4);
    in.line = 1e-3;
    in.line_slope = 2e-3;
    near(force(&law, &in, &memory).Q, cos(0.3) * cos(0.3) * (N + k * 1e-3 * tan(0.3) + c * 2e-3 * v * tan(0.3)), 1e-3,
         "a rail out of line, and the slope of its line");
    in = over_plane(&t, 0, 1e-4);
    for (int i = 0; i < RIG_US; i++)
        t.row[i][CTAB_HEIGHT_YAW] = 0.02f;
    in.vyaw = 0.1;
    near(force(&law, &in, &memory).Q, N - c * 0.02 * 0.1, 1e-3, "a height that grows with yaw, while the wheelset turns");
    in = over_plane(&t, 0, 1e-4);
    in.roll = 1e-5;
    in.vroll = 1e-2;
    near(force(&law, &in, &memory).Q, N + 0.75 * (k * 1e-5 + c * 1e-2), 1e-6, "roll to the right presses the right wheel down");
    in.roll = 0.004;
    in.y = 0.004 * 0.46;
    in.z = 1e-4 - 0.75 * 0.004;
    in.vroll = 0;
    near(force(&law, &in, &memory).patch[0].rail_y, 0, 1e-15, "u is taken at rail level: y less roll r0");

    in = over_plane(&t, 0.3, 1e-4);
    in.y = 1e-3;
    in.rail_y = 1e-3;
    near(force(&law, &in, &memory).patch[0].N, N * cos(0.3), ROW * N, "a rail that moves with its wheel is no nearer");
    in.vy = in.rail_vy = 0.05;
    near(force(&law, &in, &memory).patch[0].N, N * cos(0.3), ROW * N, "nor comes nearer");
    near(force(&law, &in, &memory).Mx, 0.751 * force(&law, &in, &memory).Q, 1e-6, "but its moment is that of where it stands");
}

/* The compliance of the loaded element is a spring in series: d = compliance Q for whatever law. */
static void compliance(void)
{
    struct rig_table t;
    struct wheel_input in = over_plane(&t, 0.1, 1e-4);
    struct wheel_law law = linear();
    struct wheel_memory memory = {0};
    double s = 1.84e-10, k = 137e6 * cos(0.1) * cos(0.1), low = 0, high = 1e-4, C = RIG_HERTZ_C * pow(cos(0.1), 2.5);

    in.compliance = s;
    law.damping = 0;
    near(force(&law, &in, &memory).Q, 1e-4 / (1 / k + s), 1e-5, "two springs in series");
    near(memory.local, s * 1e-4 / (1 / k + s), 1e-13, "share the deflection");
    near(force(&law, &in, &memory).rail_z, memory.local, 1e-18, "which is the rail's under the wheel");

    law = hertz(0);
    memory = (struct wheel_memory){0};
    for (int i = 0; i < 60; i++) { /* d = s C (reach - d)^1.5 by bisection */
        double d = 0.5 * (low + high);
        *(d < s * C * pow(1e-4 - d, 1.5) ? &low : &high) = d;
    }
    near(force(&law, &in, &memory).Q / (low / s), 1, 1e-8, "Hertz's spring in series");
    near(memory.local, low, ROW * low, "found by Newton's method from rest");

    /* The damper sees the rate of the local deflection too: implicitly, so that a lasting state has no rate. */
    law = linear();
    memory = (struct wheel_memory){0};
    double first = force(&law, &in, &memory).Q, last = 0;
    for (int i = 0; i < 200; i++)
        last = force(&law, &in, &memory).Q;
    near(last, 1e-4 / (1 / k + s), 1e-5, "the damper fades");
    near(first, 1e-4 / (1 / (k + 28e3 / 1e-4 * cos(0.1) * cos(0.1)) + s) * k / (k + 28e3 / 1e-4 * cos(0.1) * cos(0.1)), 5,
         "from a first step that it holds back");
}

/* Creepages of a wheel that rolls freely but for one motion. */
static void creepage(void)
{
    struct rig_table t;
    struct wheel_law law = hertz(0.3);
    struct wheel_memory memory = {0};
    struct wheel_input in = over_plane(&t, 0, 1e-4);
    double sink = 1e-4 / 0.46; /* the contact lies that much nearer to the axle than r0 */
    struct wheel_output o = force(&law, &in, &memory);

    near(o.patch[0].xi, sink, 1e-15, "free rolling, but for the approach");
    ok(o.patch[0].eta == 0 && o.patch[0].phi == 0, "without lateral creep or spin");
    in.spin *= 1.001;
    o = force(&law, &in, &memory);
    near(o.patch[0].xi, sink * 1.001 - 1e-3, 1e-15, "a wheel driven 0.1 % too fast: xi = -1e-3");
    ok(o.T < 0 && o.force[0] > 0, "pushes the rail backwards and itself forwards");
    in = over_plane(&t, 0, 1e-4);
    in.yaw = 2e-3;
    o = force(&law, &in, &memory);
    near(o.patch[0].eta, -2e-3 * (1 - sink), 1e-15, "yawed to the right by 2 mrad: eta = -2e-3");
    ok(o.Y < 0 && o.force[1] > 0, "the wheel moves to the right");
    in.vy = v * 2e-3 * (1 - sink);
    near(force(&law, &in, &memory).patch[0].eta, 0, 1e-15, "until it rolls where it points");
    in = over_plane(&t, 0, 1e-4);
    in.curvature = 1 / 500.0;
    o = force(&law, &in, &memory);
    near(o.patch[0].xi, sink - 0.75 / 500, 1e-15, "in a right curve the inner rail is shorter: xi = -0.75/R");
    near(o.patch[0].phi, 1 / 500.0, 1e-15, "and the wheel turns upon it: phi = 1/R");
    in = over_plane(&t, -0.05, 1e-4);
    o = force(&law, &in, &memory);
    near(o.patch[0].phi, -sin(0.05) / 0.46, ROW, "spin of a cone: sin g/r0");
    in.vyaw = 0.3;
    near(force(&law, &in, &memory).patch[0].phi, -sin(0.05) / 0.46 + 0.3 * cos(0.05) / v, ROW, "and of yawing");
    in = over_plane(&t, 0, 1e-4);
    in.vroll = 0.01;
    o = force(&law, &in, &memory);
    near(o.patch[0].eta, -0.01 * (0.46 - 1e-4) / v, 1e-15, "rolling over to the right moves the contact to the left");
    in = over_plane(&t, 0.3, 1e-4);
    in.vz = 0.02;
    near(force(&law, &in, &memory).patch[0].eta, 0.02 * sin(0.3) / v, ROW, "sinking slides down an inclined plane");
    in.rail_slope = 0.02 / v;
    near(force(&law, &in, &memory).patch[0].eta, 0, 1e-15, "but a wheel that follows a falling rail only rolls");
    in = over_plane(&t, 0.3, 1e-4);
    in.rail_v = 0.02;
    near(force(&law, &in, &memory).patch[0].eta, -0.02 * sin(0.3) / v, ROW, "a sinking rail slides the other way");
    in = over_plane(&t, 0.3, 1e-4);
    in.rail_vy = 0.02;
    near(force(&law, &in, &memory).patch[0].eta, -0.02 * cos(0.3) / v, ROW, "and one that moves to the right is left behind");
}

/* Force and moment about the centre are those of T, N and spin moment at the contact: what r x F leaves points along the normal. */
static void moments(void)
{
    struct rig_table t;
    struct wheel_input in = over_plane(&t, -0.2, 1e-4);
    struct wheel_law law = hertz(0.3);
    struct wheel_memory memory = {0};

    in.y = 1e-3;
    in.vy = 0.01;
    in.spin *= 1.0005;
    struct wheel_output o = force(&law, &in, &memory);
    double y = 0.75 + 1e-3, z = 1e-3 * tan(-0.2), r[3] = {0, y - in.y, z - in.z + 0.46}, *F = o.force;
    double left[3] = {o.moment[0] - (r[1] * F[2] - r[2] * F[1]), o.moment[1] - (r[2] * F[0] - r[0] * F[2]),
                      o.moment[2] - (r[0] * F[1] - r[1] * F[0])};
    const struct wheel_patch *p = &o.patch[0];

    near(left[0], 0, ROW * o.Q, "no moment about x is left");
    ok(fabs(left[2]) > 1e-3, "the spin moment is (%.2f N m)", hypot(left[1], left[2]));
    near(left[1] * cos(-0.2) + left[2] * sin(-0.2), 0, ROW * o.Q, "along the normal");
    near(o.Mx, y * o.Q - z * o.Y, ROW * o.Mx, "Mx: moment of Q and Y about the track axis");
    near(o.Q, p->N * cos(-0.2) + p->ty * sin(-0.2), ROW * o.Q, "Q of normal and creep force");
    near(o.Y, -p->N * sin(-0.2) + p->ty * cos(-0.2), ROW * o.Q, "Y of both");
    near(o.T, p->tx, 0, "T of the creep force");

    /* A rail that falls by 1:100 is touched behind the axle, and its normal force still meets it. */
    struct wheel_law smooth = hertz(0);
    memory = (struct wheel_memory){0};
    in = over_plane(&t, 0, 1e-4);
    for (int i = 0; i < RIG_US; i++)
        t.row[i][CTAB_X] = -0.0046f;
    o = force(&smooth, &in, &memory);
    near(o.T, -0.01 * o.Q, 1e-5 * o.Q, "a falling rail is pushed back by its slope");
    near(o.moment[1], 0, ROW * o.Q, "and turns no wheel");

    /* A turned axle takes its moment about itself: (-yaw, 1, roll). */
    memory = (struct wheel_memory){0};
    in = over_plane(&t, 0, 1e-4);
    in.yaw = 3e-3;
    in.spin *= 1.0005;
    o = force(&law, &in, &memory);
    p = &o.patch[0];
    near(o.moment[1], -(0.46 - 1e-4) * (p->tx + in.yaw * p->ty), ROW * o.Q, "moment about a yawed axle, of the creep force alone");
}

/* With much creepage the creep force is mu N against the slip; with little Kalker's linear law holds whatever the friction. */
static void friction(void)
{
    struct rig_table t;
    struct wheel_input in = over_plane(&t, 0, 1e-4);
    struct wheel_law law = hertz(0.3);
    struct wheel_memory memory = {0};
    double most = 0;

    in.vy = 0.05 * v;
    in.spin *= 1.05;
    struct wheel_output o = force(&law, &in, &memory);
    const struct wheel_patch *p = &o.patch[0];
    near(hypot(p->tx, p->ty) / (0.3 * p->N), 1, 1e-3, "sliding: mu N");
    near(atan2(p->ty, p->tx), atan2(p->eta, p->xi), 1e-3, "along the creepage");
    for (double xi = -0.01; xi < 0.01; xi += 1e-3)
        for (double vy = -0.2; vy < 0.2; vy += 0.02) {
            in = over_plane(&t, -0.1, 1e-4);
            in.spin *= 1 + xi;
            in.vy = vy;
            o = force(&law, &in, &memory);
            most = fmax(most, hypot(o.patch[0].tx, o.patch[0].ty) / (0.3 * o.patch[0].N));
        }
    ok(most < 1 + 1e-9 && most > 0.9, "never beyond mu N (%.4f)", most);
    in = over_plane(&t, 0, 1e-4);
    in.vy = 1e-5 * v;
    double low = force(&law, &in, &memory).patch[0].ty;
    law = hertz(0.6);
    near(force(&law, &in, &memory).patch[0].ty / low, 1, 0.01, "small creepage does not feel the friction");
    law = hertz(0);
    o = force(&law, &in, &memory);
    ok(o.T == 0 && o.patch[0].ty == 0, "without friction no creep force");
}

/* A row whose weight is a half carries half; three of them in order of their load. */
static void shares(void)
{
    struct rig_table t;
    struct wheel_law law = hertz(0);
    struct wheel_memory memory = {0};
    struct wheel_input in = over_plane(&t, 0, 1e-4);
    double whole = force(&law, &in, &memory).Q;

    /* The contact is missing at u = 0: at u = 4 mm of 20 the corner that has it weighs a fifth. */
    memcpy(t.row[1], t.row[2], sizeof t.row[1]);
    t.first[2] = 1;
    t.first[3] = 2;
    t.ctab.rows = 2;
    t.branch[0][0] = 0;
    in.y = 4e-3;
    struct wheel_output o = force(&law, &in, &memory);
    near(o.Q / whole, 0.2, 1e-12, "a contact that fades out carries its share");
    near(o.patch[0].N, o.Q, 1e-9, "and tells that");
}

/* 141 MN/m and 30 kN s/m before 5000 MN/m: 137.1 MN/m and 28.4 kN s/m. */
static void condensed(void)
{
    struct wheel_law law = {0};

    wheel_condense(&law, 141e6, 30e3, 5000e6);
    near(law.stiffness, 137.13e6, 5e3, "springs in series");
    near(law.damping, 28.38e3, 5, "and the damper's share of their give, squared");
}

int main(void)
{
    normal_law(0);
    normal_law(-0.05);
    normal_law(1.1);
    separation();
    what_moves();
    compliance();
    creepage();
    moments();
    friction();
    shares();
    condensed();
    return done();
}
