/* Rods, dampers along a line, springs that stiffen: closed forms on one body over a wheelset. */
#include "tests/kernel/rig.h"

#include <stdio.h>
#include <unistd.h>

#include "tests/kernel/tap.h"
#include "tools/vehicle/couplings.h"

/* A frame of 10 t, on two springs of 1 MN/m to 30 kN and 2.5 MN/m beyond, and on what is tried. */
static const char RIG[] =
    "vehicle:\n"
    "  name: rig\n"
    "  body: [{name: frame, mass: 10000, inertia: [9300, 9300, 9300], x: 0, height: 0.6}]\n"
    "  wheelset: [{name: wheelset, mass: 1800, inertia: [1100, 110, 1100], x: 0, radius: 0.46}]\n"
    "  coupling:\n"
    "    - {name: guide, from: wheelset, to: frame, at: [0, 1, 0.46], mirror: true, stiffness: [3e6, 4e6, 0], rotation: [0, 1e7, 0]}\n"
    "  spring:\n"
    "    - {name: nest, from: wheelset, to: frame, at: [0, 1, 0.46], mirror: true, table: [[0, 0], [0.03, 30e3], [0.05, 80e3]]}\n";

enum { FRAME, WHEELSET, N = 12 };

static int build(struct veh *v, const char *what, const char *more)
{
    char path[] = "/tmp/lines.XXXXXX";
    int fd = mkstemp(path);
    FILE *f = fd < 0 ? NULL : fdopen(fd, "w");
    const char *why = f ? NULL : "no file";

    if (f) {
        fprintf(f, "%s%s", RIG, more);
        fclose(f);
        why = rig_vehicle(v, path, NULL, 0);
        unlink(path);
    }
    return ok(!why, "a rig with %s stands: %s", what, why ? why : "yes");
}

/* Force of the last coupling alone on the frame. */
static void last_force(const struct veh *v, struct couplings_memory *m, const double *q, const double *qd, double frame[6])
{
    double all[N] = {0}, others[N] = {0};
    struct veh less = *v;

    less.couplings--;
    couplings_force(&less, NULL, q, qd, others);
    couplings_force(v, m, q, qd, all);
    for (int k = 0; k < 6; k++)
        frame[k] = all[k] - others[k];
}

static void test_bilinear(void)
{
    struct veh v;
    double q[N] = {0}, zero[N] = {0}, f[N] = {0};

    if (!build(&v, "springs alone", ""))
        return;
    double load = 10000*9.81/2, rest = 0.03 + (load - 30e3)/2.5e6;
    near(v.rest[2], rest, 1e-12, "under half of 10 t the inner spring is in: rest by the second slope");
    near(v.preload[3*2 + VEH_Z], load, 1e-6, "with that load");
    near(v.K[N*VEH_Z + VEH_Z], 2*2.5e6, 1e-3, "stiffness at rest is that of both springs");
    q[VEH_Z] = 0.01 - rest;
    couplings_force(&v, NULL, q, zero, f);
    near(f[VEH_Z], -2*1e6*0.01, 1e-6, "10 mm from its free length the outer one is alone");
    q[VEH_Z] = -rest - 0.005;
    memset(f, 0, sizeof f);
    couplings_force(&v, NULL, q, zero, f);
    near(f[VEH_Z], 2*1e6*0.005, 1e-6, "beyond its table the first slope goes on");
    veh_free(&v);
}

/* 0.5 m long, from the axle's middle to a point ahead of and above it on the frame: along n = (0.8, 0, -0.6). */
static void test_rod(void)
{
    struct veh v;
    double q[N] = {0}, qd[N] = {0}, f[6];

    if (!build(&v, "a rod", "  rod: [{name: rod, from: wheelset, to: frame, at: [0, 0, 0.46], end: [0.4, 0, 0.76], stiffness: 8e6, damping: 1e4}]\n"))
        return;
    q[VEH_X] = 1e-6;
    qd[VEH_X] = 0.1;
    last_force(&v, NULL, q, qd, f);
    near(f[VEH_X], -(8e6*1e-6*0.8 + 1e4*0.1*0.8)*0.8, 1e-2, "drawn along x, n.e along n, its part along x");
    near(f[VEH_Z], (8e6*1e-6*0.8 + 1e4*0.1*0.8)*0.6, 1e-2, "and along z");
    near(f[VEH_PITCH], -(8e6*1e-6*0.8 + 1e4*0.1*0.8)*(0.6*0.4 - 0.8*0.16), 1e-2, "and its moment about the frame's centre");
    memset(q, 0, sizeof q);
    memset(qd, 0, sizeof qd);
    q[VEH_Y] = 0.02;
    last_force(&v, NULL, q, qd, f);
    double length = hypot(0.5, 0.02), force = 8e6*(length - 0.5);
    near(f[VEH_Y], -force*0.02/length, 1e-3*force*0.02/length, "20 mm across: as a string of its length, to 1e-3");
    near(f[VEH_X], -force*0.4/length, 1e-3*force*0.4/length, "along x too");
    veh_free(&v);
}

/* A yaw damper on its bushings, from 1 m behind to the frame: at a slow pull a damper, at a sudden one a spring. */
static void test_line_damper(void)
{
    struct veh v;
    struct couplings_memory m;
    double q[N] = {0}, qd[N] = {0}, f[6];

    if (!build(&v, "a damper", "  damper: [{name: yaw, from: wheelset, to: frame, at: [0, 1.3, 0.46], end: [0.7, 1.3, 0.46], axis: line, "
                               "series: 8e6, table: [[0, 0], [0.01, 10e3], [0.3, 15e3]]}]\n") || couplings_memory_new(&m, &v))
        return;
    near(v.C[N*VEH_X + VEH_X], 1e6, 1e-3, "its first slope is in C");
    couplings_keep(&m, 1e-6);
    q[VEH_X] = 1e-4;
    last_force(&v, &m, q, qd, f);
    near(f[VEH_X], -800, 1, "0.1 mm in a microsecond: the spring");
    last_force(&v, &m, q, qd, f);
    near(f[VEH_X], -800, 1, "asked again for the same step, the same");
    for (int i = 0; i < 4000; i++) {
        q[VEH_X] += 0.02*1e-4;
        couplings_keep(&m, 1e-4);
        last_force(&v, &m, q, qd, f);
    }
    near(f[VEH_X], -(10e3 + 5e3*0.01/0.29), 1, "drawn at 20 mm/s: the table beyond its knee");
    couplings_memory_free(&m);
    veh_free(&v);
}

/* Friction under the load of a nest: the limit follows the spring. */
static void test_lenoir(void)
{
    struct veh v;
    struct couplings_memory m;
    double q[N] = {0}, qd[N] = {0}, f[6];

    if (!build(&v, "a link", "  friction: [{name: link, from: wheelset, to: frame, at: [0, 1, 0.46], coefficient: 0.3, spring: nest-r, "
                             "share: 0.364, stiffness: [0, 8e6, 8e6]}]\n") || couplings_memory_new(&m, &v))
        return;
    double nest = 10000*9.81/2;
    couplings_keep(&m, 1e-3);
    for (int i = 0; i < 20; i++) {
        q[VEH_Y] += 1e-3;
        last_force(&v, &m, q, qd, f);
        couplings_keep(&m, 1e-3);
    }
    near(f[VEH_Y], -0.3*0.364*nest, 1e-6, "slid sideways at rest height: mu tan b times the load of the nest");
    q[VEH_Z] = 0.01;
    q[VEH_Y] += 0.1;
    last_force(&v, &m, q, qd, f);
    near(hypot(f[VEH_Y], f[VEH_Z]), 0.3*0.364*(nest + 2.5e4), 1e-6, "10 mm down: of the higher load, in the plane of its faces");
    q[VEH_Z] = -0.1;
    couplings_keep(&m, 1e-3);
    last_force(&v, &m, q, qd, f);
    near(hypot(f[VEH_Y], f[VEH_Z]), 0, 0, "lifted off the spring there is none");
    couplings_memory_free(&m);
    veh_free(&v);
}

int main(void)
{
    test_bilinear();
    test_rod();
    test_line_damper();
    test_lenoir();
    return done();
}
