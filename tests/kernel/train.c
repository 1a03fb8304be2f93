/* The train in the time step: frames of a curve, momentum, gyroscopic moments, weights.  The coach of the Manchester benchmarks. */
#include "tools/integrate/train.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"

static const double curve_x[2] = {0, 40}, curvature[2] = {1 / 760.0, 0};

struct fixture {
    struct veh vehicle;
    struct alignment alignment;
    struct train train;
    struct wheel_output none[8];
};

static void set_up(struct fixture *f, double speed)
{
    memset(f, 0, sizeof *f);
    ok(!rig_vehicle(&f->vehicle, RIG_COACH, NULL, 0) && !alignment_new(&f->alignment, 2, curve_x, curvature) && !train_new(&f->train, &f->vehicle, speed, 1e-4),
       "the coach, at %g m/s", speed);
}

static void tear_down(struct fixture *f)
{
    train_free(&f->train);
    alignment_free(&f->alignment);
    veh_free(&f->vehicle);
}

static double largest(const double *a, const double *b, int64_t n)
{
    double most = 0;

    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

/* At rest every body but the wheelsets is in balance, and these press their static loads down. */
static void rest(void)
{
    struct fixture f;
    double worst = 0, load = 0;

    set_up(&f, 20);
    train_locate(&f.train, &f.alignment, -100);
    train_accelerate(&f.train, f.none);
    for (int64_t k = 0; k < 18; k++)
        worst = fmax(worst, fabs(f.train.f[k]));
    for (int64_t i = 0; i < f.vehicle.wheelsets; i++)
        load = fmax(load, fabs(f.train.f[6 * f.vehicle.wheelset[i] + VEH_Z] - f.vehicle.wheel_load[2 * i] - f.vehicle.wheel_load[2 * i + 1]));
    near(worst, 0, 1e-7, "carbody and bogies rest on their springs");
    near(load, 0, 1e-7, "wheelsets press their static loads down");
    tear_down(&f);
}

/* The train as one rigid body along a tangent of the curve, turning with it: the same forces as at rest.  Half way into a curve, and where
 * the train lies across its beginning. */
static void rigid_motion(double s)
{
    struct fixture f;
    double v = 22, rest_force[42];

    set_up(&f, v);
    struct train *t = &f.train;
    train_locate(t, &f.alignment, -100);
    train_accelerate(t, f.none);
    memcpy(rest_force, t->f, sizeof rest_force);
    train_locate(t, &f.alignment, s);
    struct alignment_point p = alignment_at(&f.alignment, s + t->middle);
    for (int64_t i = 0; i < f.vehicle.bodies; i++) {
        double ahead = f.vehicle.cg[3 * i] - t->middle;
        t->q[6 * i + VEH_Y] = p.offset + p.heading * ahead;
        t->q[6 * i + VEH_YAW] = p.heading;
        t->v[6 * i + VEH_Y] = p.heading * v + p.curvature * v * ahead;
        t->v[6 * i + VEH_YAW] = p.curvature * v;
    }
    train_accelerate(t, f.none);
    for (int64_t i = 0; i < f.vehicle.wheelsets; i++) /* what turning does to a spinning wheelset is not the couplings' */
        t->f[6 * f.vehicle.wheelset[i] + VEH_ROLL] -=
            f.vehicle.inertia[3 * f.vehicle.wheelset[i] + 1] * -v / f.vehicle.radius[i] * p.curvature * v;
    printf("# heading %.3f rad, largest force %.1e N\n", p.heading, largest(t->f, rest_force, 42));
    near(largest(t->f, rest_force, 42), 0, 1e-6, "a train stiff along a tangent feels no coupling");
    tear_down(&f);
}

/* The train as one rigid body rolled with the plane of the rails, at s, and turning with it: forces as at rest but for the parts of the
 * weights.  Cant rises from 10 m to 40 m; the coach lies across that or beyond. */
static void rolled(double s)
{
    static const double cant_x[2] = {10, 40}, cant[2] = {0, 0.15};
    struct fixture f;
    double v = 22, rest_force[42], g;

    set_up(&f, v);
    struct train *t = &f.train;
    alignment_raise(&f.alignment, 2, cant_x, cant, 1.5);
    f.alignment.n = 0;
    g = f.vehicle.gravity;
    train_locate(t, &f.alignment, -100);
    train_accelerate(t, f.none);
    memcpy(rest_force, t->f, sizeof rest_force);
    train_locate(t, &f.alignment, s);
    struct alignment_point p = alignment_at(&f.alignment, s + t->middle);
    for (int64_t i = 0; i < f.vehicle.bodies; i++) {
        double angle = t->line[i].cant, weight = f.vehicle.mass[i] * g;
        t->q[6 * i + VEH_Y] = -p.cant * f.vehicle.cg[3 * i + 2];
        t->q[6 * i + VEH_ROLL] = p.cant;
        t->v[6 * i + VEH_Y] = -p.twist * v * f.vehicle.cg[3 * i + 2];
        t->v[6 * i + VEH_ROLL] = p.twist * v;
        rest_force[6 * i + VEH_Y] += weight * sin(angle);
        rest_force[6 * i + VEH_Z] += weight * (cos(angle) - 1);
    }
    train_accelerate(t, f.none);
    for (int64_t i = 0; i < f.vehicle.wheelsets; i++) /* what rolling does to a spinning wheelset is not the couplings' */
        t->f[6 * f.vehicle.wheelset[i] + VEH_YAW] +=
            f.vehicle.inertia[3 * f.vehicle.wheelset[i] + 1] * -v / f.vehicle.radius[i] * p.twist * v;
    printf("# cant %.4f rad, twist %.4f rad/m, largest force %.1e N\n", p.cant, p.twist, largest(t->f, rest_force, 42));
    near(largest(t->f, rest_force, 42), 0, 1e-6, "a train stiff on the plane of the rails feels no coupling");
    tear_down(&f);
}

/* At tan(cant) = v^2 curvature/g accelerometers feel nothing sideways and g/cos(cant) downwards. */
static void equilibrium(void)
{
    static const double at[1] = {-1000};
    struct fixture f;
    double v = 22, R = 760, g = 9.81, side = 0, down = 0;
    const double cant[1] = {1.5 * sin(atan(v * v / (R * g)))};

    set_up(&f, v);
    struct train *t = &f.train;
    alignment_raise(&f.alignment, 1, at, cant, 1.5);
    train_locate(t, &f.alignment, 30);
    for (int64_t i = 0; i < f.vehicle.bodies; i++) {
        double a[6];
        t->a[6 * i + VEH_Y] = v * v / R; /* of the frame; against it the body does not move */
        t->a[6 * i + VEH_Z] = 0;
        train_felt(t, i, a);
        side = fmax(side, fabs(a[VEH_Y]));
        down = fmax(down, fabs(g - a[VEH_Z] - g / cos(t->line[i].cant)));
    }
    near(side, 0, 1e-14, "at the equilibrium cant nothing is felt sideways");
    near(down, 0, 1e-14, "and g/cos(cant) downwards");
    tear_down(&f);
}

/* Bodies that follow the centre line have no displacement in their own frames. */
static void frames(void)
{
    struct fixture f;
    double v = 22, s = 30, q[6], rate[6], worst = 0;

    set_up(&f, v);
    struct train *t = &f.train;
    train_locate(t, &f.alignment, s);
    for (int64_t i = 0; i < f.vehicle.bodies; i++) {
        struct alignment_point p = alignment_at(&f.alignment, s + f.vehicle.cg[3 * i]);
        t->q[6 * i + VEH_Y] = p.offset;
        t->q[6 * i + VEH_YAW] = p.heading;
        t->v[6 * i + VEH_Y] = p.heading * v;
        t->v[6 * i + VEH_YAW] = p.curvature * v;
        train_in_frame(t, i, q, rate);
        for (int k = 0; k < 6; k++)
            worst = fmax(worst, fabs(q[k]) + fabs(rate[k]));
    }
    near(worst, 0, 1e-14, "a body on the centre line is at rest in its frame");

    /* Radial wheelsets, a straight carbody: springs of a bogie are bent by half the 3.37 mrad between its wheelsets. */
    train_accelerate(t, f.none);
    double yaw = 1.28 / 760, k = 31391e3;
    near(t->f[6 * f.vehicle.wheelset[0] + VEH_YAW], -2 * k * yaw, 0.02 * 2 * k * yaw, "a radial wheelset is turned back by its bogie");
    near(t->f[6 * f.vehicle.wheelset[1] + VEH_YAW], 2 * k * yaw, 0.02 * 2 * k * yaw, "the one behind it the other way");
    tear_down(&f);
}

/* Any motion: forces sum to the weight, moments about one axis to that of the weights and of the turning spins. */
static void momentum(void)
{
    struct fixture f;
    double v = 22, F[3] = {0}, M[3] = {0}, weight = 0, turned[3] = {0};
    unsigned seed = 11;

    set_up(&f, v);
    struct train *t = &f.train;
    train_locate(t, &f.alignment, -100); /* on the straight, so positions need no frames */
    for (int64_t k = 0; k < t->dofs; k++) {
        t->q[k] = (k % 6 < 3 ? 0.01 : 0.005) * rig_draw(&seed);
        t->v[k] = 0.1 * rig_draw(&seed);
    }
    train_accelerate(t, f.none);
    for (int64_t i = 0; i < f.vehicle.bodies; i++) {
        double r[3], *force = t->f + 6 * i, m = f.vehicle.mass[i] * f.vehicle.gravity;
        for (int k = 0; k < 3; k++) {
            r[k] = f.vehicle.cg[3 * i + k] + t->q[6 * i + k];
            F[k] += force[k];
        }
        for (int k = 0; k < 3; k++)
            M[k] += r[(k + 1) % 3] * force[(k + 2) % 3] - r[(k + 2) % 3] * force[(k + 1) % 3] + force[3 + k];
        weight += m;
        turned[0] += r[1] * m;
        turned[1] -= r[0] * m;
    }
    for (int64_t i = 0; i < f.vehicle.wheelsets; i++) {
        int64_t b = f.vehicle.wheelset[i];
        double H = f.vehicle.inertia[3 * b + 1] * (t->v[6 * b + VEH_PITCH] - v / f.vehicle.radius[i]);
        turned[0] += H * t->v[6 * b + VEH_YAW];
        turned[2] -= H * t->v[6 * b + VEH_ROLL];
    }
    near(F[0], 0, 1e-6, "longitudinal forces cancel");
    near(F[1], 0, 1e-6, "lateral forces cancel");
    near(F[2], weight, 1e-6, "vertical forces leave the weight");
    near(M[0], turned[0], 1e-5, "moments about x leave those of weights and spins");
    near(M[2], turned[2], 1e-5, "about z those of the spins");
    tear_down(&f);
}

/* The momentum of a wheelset's spin points to the left.  Turning to the right turns it forwards, which takes a moment about +x; without
 * one the wheelset rolls to the left, outwards.  Roll and yaw exchange energy without loss. */
static void gyroscope(void)
{
    struct fixture f;
    double v = 30, J, H;

    set_up(&f, v);
    struct train *t = &f.train;
    int64_t b = f.vehicle.wheelset[0], r = 6 * b + VEH_ROLL, y = 6 * b + VEH_YAW;
    J = f.vehicle.inertia[3 * b + 1];
    H = -J * v / 0.46;
    train_locate(t, &f.alignment, -100);
    train_accelerate(t, f.none);
    double roll = t->a[r], yaw = t->a[y];
    t->v[y] = 0.01;
    t->v[6 * 1 + VEH_YAW] = 0.01; /* the bogie with it, so that no damper acts on its yaw */
    train_accelerate(t, f.none);
    near((t->a[r] - roll) * f.vehicle.inertia[3 * b], 0.01 * H, 1e-6, "turning right rolls a spinning wheelset to the left");
    t->v[y] = t->v[6 * 1 + VEH_YAW] = 0;
    t->v[r] = 0.02;
    double damper = -2 * 4e3 * 0.02; /* of the two primary springs, at 1 m */
    train_accelerate(t, f.none);
    near((t->a[y] - yaw) * f.vehicle.inertia[3 * b + 2], -0.02 * H, 1e-6, "rolling to the right yaws it to the right");
    near((t->a[r] - roll) * f.vehicle.inertia[3 * b], damper, 1e-6, "and only the dampers slow the roll");
    tear_down(&f);
}

/* Forces and moments of wheels on their wheelset, which does not move along x. */
static void wheels(void)
{
    struct fixture f;
    struct wheel_output w[8];

    set_up(&f, 20);
    struct train *t = &f.train;
    int64_t b = f.vehicle.wheelset[2];
    memset(w, 0, sizeof w);
    train_locate(t, &f.alignment, -100);
    train_accelerate(t, w);
    double before[6];
    memcpy(before, t->a + 6 * b, sizeof before);
    for (int k = 0; k < 3; k++) {
        w[4].force[k] = 100 + k;
        w[5].force[k] = 10 + k;
        w[4].moment[k] = 1 + k;
        w[5].moment[k] = 20 + k;
    }
    train_accelerate(t, w);
    const double *m = f.vehicle.inertia + 3 * b, *a = t->a + 6 * b;
    near(a[VEH_X], 0, 0, "along x a wheelset follows its station");
    near((a[VEH_Y] - before[VEH_Y]) * f.vehicle.mass[b], 101 + 11, 1e-9, "lateral forces of both wheels");
    near((a[VEH_Z] - before[VEH_Z]) * f.vehicle.mass[b], 102 + 12, 1e-9, "vertical ones");
    near((a[VEH_ROLL] - before[VEH_ROLL]) * m[0], 21, 1e-9, "moments about x");
    near((a[VEH_PITCH] - before[VEH_PITCH]) * m[1], 23, 1e-9, "about the axle");
    near((a[VEH_YAW] - before[VEH_YAW]) * m[2], 25, 1e-9, "about z");
    tear_down(&f);
}

/* J of the coach's bodies and springs about rest. */
static double stored(const struct train *t)
{
    const int64_t n = t->dofs;
    const double *K = t->vehicle->K;
    double E = 0;

    for (int64_t k = 0; k < n; k++) {
        E += t->inverse[k] > 0 ? 0.5 * t->v[k] * t->v[k] / t->inverse[k] : 0;
        for (int64_t l = 0; l < n; l++)
            E += 0.5 * t->q[k] * K[k * n + l] * t->q[l];
    }
    return E;
}

/* The coach without dampers on held wheelsets, its carbody let go y and z m off its place, for 100 s in steps of 1 ms by average
 * acceleration: the largest departure of its energy, over that. */
static double let_go(double y, double z)
{
    static double none[42 * 42];
    struct fixture f;
    double begun, worst = 0;

    set_up(&f, 20);
    struct train *t = &f.train;
    f.vehicle.damping = none;
    f.vehicle.C = none;
    t->h = 1e-3;
    for (int64_t i = 0; i < f.vehicle.wheelsets; i++)
        memset(t->inverse + 6 * f.vehicle.wheelset[i], 0, 6 * sizeof *t->inverse);
    ok(!train_imply(t), "average acceleration");
    train_locate(t, &f.alignment, -100);
    t->q[VEH_Y] = y;
    t->q[VEH_Z] = z;
    train_accelerate(t, f.none);
    memcpy(t->before, t->a, (size_t)t->dofs * sizeof *t->a);
    begun = stored(t);
    for (int64_t n = 0; n < 100000; n++) {
        double move;
        train_advance(t);
        do {
            train_force(t, f.none);
            move = train_correct(t);
        } while (move > 1e-18);
        worst = fmax(worst, fabs(stored(t) / begun - 1));
    }
    tear_down(&f);
    return worst;
}

/* In bounce nothing turns, and springs are linear.  Sideways the bodies roll, and springs turn with them: what they store then differs from
 * the linear measure by a share of the roll, so it does so by half as much where the coach is let go half as far off. */
static void energy(void)
{
    const double bounce = let_go(0, 1e-3), sway = let_go(1e-4, 1e-4), half = let_go(5e-5, 5e-5);

    ok(bounce < 1e-9, "the energy of a coach in bounce stays over 100 s (%.1e)", bounce);
    near(sway / half, 2, 0.02, "that of one that sways is as far off as its springs turn");
    ok(sway < 3e-4, "which is little (%.1e)", sway);
}

int main(void)
{
    rest();
    energy();
    rigid_motion(30);
    rigid_motion(15);
    rigid_motion(200);
    rolled(30);
    rolled(25);
    rolled(200);
    equilibrium();
    frames();
    momentum();
    gyroscope();
    wheels();
    return done();
}
