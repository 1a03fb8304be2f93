/* Couplings: what moves rigidly feels no spring, pairs cancel about any axis, work is conserved, stops follow their table. */
#include "tools/vehicle/couplings.h"

#include <stdlib.h>
#include <string.h>

#include "tests/kernel/tap.h"

enum { BODIES = 3, N = VEH_DOFS*BODIES };   /* frame, carbody, wheelset */

/* A carbody on a frame on a wheelset: springs off centre, with turning stiffness, and a stop.  The centres of gravity stand where
 * the moments of the preloads balance: 2 x 5000 N on the frame, 2 x 5500 N below it. */
static const struct vehicle {
    double cg[3*BODIES];
    int64_t type[5], ends[10], bearing[5], axis[5], first[6], wheelset[1];
    double point[15], stiffness[30], damping[30], preload[15], knot_at[3], knot_force[3], lever[5];
} store = {
    .cg = {0.5, 0, -0.6, -0.05, 0, -1.8, 0, 0, -0.46},
    .type = {VEH_BUSHING, VEH_BUSHING, VEH_BUSHING, VEH_BUSHING, VEH_STOP},
    .ends = {0, 1, 0, 1, 2, 0, 2, 0, 0, 1},
    .bearing = {-1, -1, 0, 0, -1},
    .axis = {0, 0, 0, 0, VEH_Y},
    .first = {0, 0, 0, 0, 0, 3},
    .wheelset = {2},
    .point = {0.3, 1, -0.9, -0.4, -1, -0.8, 0, 1, -0.46, 0, -1, -0.46, 0.1, 0, -0.65},
    .stiffness = {160e3, 160e3, 430e3, 10e3, 0, 0,  160e3, 160e3, 430e3, 10e3, 5e3, 0,
                  3e6, 4e6, 1e6, 0, 0, 0,  3e6, 4e6, 1e6, 0, 0, 0},
    .damping = {0, 32e3, 20e3, 0, 0, 0,  0, 32e3, 20e3, 100, 0, 200,  15e3, 2e3, 4e3, 0, 0, 0,  15e3, 2e3, 4e3, 0, 0, 0},
    .preload = {0, 0, 5000,  0, 0, 5000,  0, 0, 5500,  0, 0, 5500},
    .knot_at = {0.025, 0.03, 0.035},
    .knot_force = {0, 600, 1760},
};

static struct veh vehicle(const struct vehicle *s)
{
    return (struct veh){.bodies = BODIES, .couplings = 5, .wheelsets = 1, .knots = 3, .cg = s->cg, .type = s->type, .ends = s->ends,
                        .bearing = s->bearing, .point = s->point, .end = s->point, .stiffness = s->stiffness, .damping = s->damping,
                        .preload = s->preload, .axis = s->axis, .lever = s->lever, .knot_first = s->first, .knot_at = s->knot_at,
                        .knot_force = s->knot_force, .wheelset = s->wheelset};
}

/* Repeatable numbers within -1..1. */
static double draw(unsigned *state)
{
    *state = *state*1664525u + 1013904223u;
    return (double)(*state >> 8)/8388608.0 - 1;
}

static void draw_all(double *q, double length, double angle, unsigned seed)
{
    for (int i = 0; i < N; i++)
        q[i] = (i%VEH_DOFS < VEH_ROLL ? length : angle)*draw(&seed);
}

static double largest(const double *f, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(f[i]));
    return most;
}

/* All bodies move as one: shift s and turn t about the origin of the track axes. */
static void move_rigidly(const struct veh *v, const double s[3], const double t[3], double *q)
{
    for (int64_t i = 0; i < v->bodies; i++) {
        const double *c = &v->cg[3*i];
        double *p = q + VEH_DOFS*i;
        p[0] = s[0] + t[1]*c[2] - t[2]*c[1];
        p[1] = s[1] + t[2]*c[0] - t[0]*c[2];
        p[2] = s[2] + t[0]*c[1] - t[1]*c[0];
        memcpy(p + VEH_ROLL, t, 3*sizeof *t);
    }
}

static void test_rigid_motion(void)
{
    static const double zero[3] = {0}, shift[3] = {0.02, -0.03, 0.01}, turn[3] = {0.01, 0, 0.03};
    struct vehicle s = store;
    struct veh v = vehicle(&s);
    double q[N], qd[N] = {0}, f[N] = {0}, rest[N] = {0};

    move_rigidly(&v, zero, zero, q);
    couplings_force(&v, NULL, q, qd, rest);
    move_rigidly(&v, shift, zero, q);
    couplings_force(&v, NULL, q, qd, f);
    for (int i = 0; i < N; i++)
        f[i] -= rest[i];
    ok(largest(f, N) < 1e-10, "shifted as one, also to the side, a loaded vehicle carries what it carries at rest");

    memset(s.preload, 0, sizeof s.preload);
    memset(f, 0, sizeof f);
    move_rigidly(&v, shift, turn, q);
    move_rigidly(&v, shift, turn, qd);
    couplings_force(&v, NULL, q, qd, f);
    ok(largest(f, N) < 1e-8, "shifted, rolled and yawed as one, and moving so, an unloaded one feels nothing");
}

/* Force and moment about `about` of all couplings on all bodies. */
static void sum_forces(const struct veh *v, const double *q, const double *f, const double about[3], double sum[6])
{
    memset(sum, 0, 6*sizeof *sum);
    for (int64_t i = 0; i < v->bodies; i++) {
        const double *F = f + VEH_DOFS*i;
        double r[3];
        for (int k = 0; k < 3; k++)
            r[k] = v->cg[3*i + k] + q[VEH_DOFS*i + k] - about[k];
        for (int k = 0; k < 3; k++) {
            sum[k] += F[k];
            sum[3 + k] += F[VEH_ROLL + k] + r[(k + 1)%3]*F[(k + 2)%3] - r[(k + 2)%3]*F[(k + 1)%3];
        }
    }
}

static void test_pairs(void)
{
    static const double places[2][3] = {{0, 0, 0}, {-7, 3, 2}};
    struct veh v = vehicle(&store);
    double q[N], qd[N], f[N] = {0}, sum[6];

    draw_all(q, 0.1, 0.1, 1);
    draw_all(qd, 1, 1, 2);
    couplings_force(&v, NULL, q, qd, f);
    for (int k = 0; k < 2; k++) {
        sum_forces(&v, q, f, places[k], sum);
        ok(largest(sum, 6) < 1e-12*largest(f, N), "forces and moments cancel about (%g, %g, %g) at 0.1 m and 0.1 rad", places[k][0],
           places[k][1], places[k][2]);
    }
}

static void test_spin(void)
{
    struct veh v = vehicle(&store);
    double q[N], qd[N], f[N] = {0}, g[N] = {0};

    draw_all(q, 0.01, 0.01, 3);
    draw_all(qd, 1, 1, 4);
    couplings_force(&v, NULL, q, qd, f);
    q[2*VEH_DOFS + VEH_PITCH] += 100;
    qd[2*VEH_DOFS + VEH_PITCH] += 100;
    couplings_force(&v, NULL, q, qd, g);
    ok(!memcmp(f, g, sizeof f), "the spin of a wheelset changes no force");
}

/* Work on all bodies around a closed loop of this size, by the midpoint rule, over the work of its first quarter.  A potential would give
 * zero; small angles leave a part that shrinks with the square of the loop. */
static double loop_work(double size)
{
    enum { STEPS = 2000 };
    struct vehicle s = store;
    struct veh v = vehicle(&s);
    double a[N], b[N], q[N], qd[N] = {0}, work = 0, quarter = 0;

    draw_all(a, size, size, 5);
    draw_all(b, size, size, 6);
    a[2*VEH_DOFS + VEH_PITCH] = b[2*VEH_DOFS + VEH_PITCH] = 0;
    for (int i = 0; i < STEPS; i++) {
        double w = 2*M_PI*(i + 0.5)/STEPS, f[N] = {0};
        for (int k = 0; k < N; k++)
            q[k] = a[k]*(1 - cos(w)) + b[k]*sin(w);
        couplings_force(&v, NULL, q, qd, f);
        for (int k = 0; k < N; k++)
            work += f[k]*(a[k]*sin(w) + b[k]*cos(w))*2*M_PI/STEPS;
        if (i < STEPS/4)
            quarter = work;
    }
    return fabs(work/quarter);
}

static void test_work(void)
{
    double coarse = loop_work(2e-3), fine = loop_work(1e-3);

    ok(coarse < 1e-4, "a closed loop of 2 mm and 2 mrad gives back its work to %.1e of what a quarter takes", coarse);
    ok(fine < 0.3*coarse, "half the loop, a quarter of that share or less: %.1e", fine);
}

static void test_damping(void)
{
    struct vehicle s = store;
    struct veh v = vehicle(&s);
    double q[N] = {0}, qd[N], power = 0, f[N] = {0};

    memset(s.preload, 0, sizeof s.preload);
    draw_all(qd, 1, 1, 7);
    qd[2*VEH_DOFS + VEH_PITCH] = 0;
    couplings_force(&v, NULL, q, qd, f);
    for (int i = 0; i < N; i++)
        power += f[i]*qd[i];
    ok(power < 0, "dampers take energy out: %.3g W", power);
}

static void test_sway(void)
{
    struct vehicle s = store;
    struct veh v = vehicle(&s);
    double q[N] = {0}, qd[N] = {0}, f[N] = {0}, rest[N] = {0};

    memset(s.stiffness, 0, sizeof s.stiffness);
    couplings_force(&v, NULL, q, qd, rest);
    q[VEH_DOFS + VEH_Y] = 0.01;
    couplings_force(&v, NULL, q, qd, f);
    near(f[VEH_DOFS + VEH_ROLL] - rest[VEH_DOFS + VEH_ROLL], 0.5*0.01*10000, 1e-9,
         "half of preload times lateral displacement rolls the carbody outwards");
    near(f[VEH_ROLL] - rest[VEH_ROLL], 0.5*0.01*10000, 1e-9, "and half of it the frame");
}

/* A frame and a carbody yawed alike by 0.02 rad, and 1 mm apart along the yawed x axis: the force lies along it too, although
 * kx and ky differ. */
static void test_axes(void)
{
    static const double zero[3] = {0}, yaw[3] = {0, 0, 0.02};
    struct vehicle s = store;
    double q[N], qd[N] = {0}, f[N] = {0};

    memset(s.preload, 0, sizeof s.preload);
    s.stiffness[0] = s.stiffness[6] = 1e6;
    struct veh v = vehicle(&s);
    move_rigidly(&v, zero, yaw, q);
    q[VEH_DOFS] += 1e-3*cos(0.02);
    q[VEH_DOFS + VEH_Y] += 1e-3*sin(0.02);
    couplings_force(&v, NULL, q, qd, f);
    near(f[VEH_DOFS + VEH_Y]/f[VEH_DOFS], tan(0.02), 0.02*0.02, "springs turn with the bodies they join");
}

static void test_stop(void)
{
    struct veh v = vehicle(&store);
    double q[N] = {0}, qd[N] = {0}, f[N] = {0}, g[N] = {0};

    near(couplings_stop(&v, 4, 0.0249), 0, 0, "a stop is silent within its clearance");
    near(couplings_stop(&v, 4, 0.0275), 300, 1e-9, "straight between knots");
    near(couplings_stop(&v, 4, -0.035), -1760, 1e-9, "odd");
    near(couplings_stop(&v, 4, 0.040), 2920, 1e-9, "beyond its table the last slope goes on");
    q[VEH_DOFS + VEH_Y] = 0.035;
    couplings_force(&v, NULL, q, qd, f);
    v.couplings = 4;
    couplings_force(&v, NULL, q, qd, g);
    near(f[VEH_DOFS + VEH_Y] - g[VEH_DOFS + VEH_Y], -1760, 1e-9, "the carbody is pushed back");
    near(f[VEH_Y] - g[VEH_Y], 1760, 1e-9, "and the frame pushed away");
}

int main(void)
{
    test_rigid_motion();
    test_pairs();
    test_spin();
    test_work();
    test_damping();
    test_sway();
    test_axes();
    test_stop();
    return done();
}
