/* A wheelset that bounces on Hertz's springs on rails that hardly give, 0.06 % of what the springs do: period by quadrature, small and large,
 * off the rail and back; the decrement of contact damping; order in the step. */
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

enum { CYCLES = 8 };

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
};

/* What a wheelset of mass m under 2 P has stored, its wheels z > 0 pressed in: 4/5 C z^2.5 - 2 P z. */
static double stored(double z, double P)
{
    return 0.8 * RIG_HERTZ_C * pow(fmax(z, 0), 2.5) - 2 * P * z;
}

/* z from `rest` towards `far` at which energy E is stored. */
static double turning_point(double E, double P, double rest, double far)
{
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (rest + far);
        *(stored(middle, P) < E ? &rest : &far) = middle;
    }
    return rest;
}

/* s: the integral of dz/z' both ways, with z = middle + half sin a, by midpoints. */
static double period(double m, double P, double v)
{
    enum { POINTS = 200000 };
    const double rest = pow(P / RIG_HERTZ_C, 2.0 / 3), E = stored(rest, P) + 0.5 * m * v * v;
    const double high = turning_point(E, P, rest, -1), low = turning_point(E, P, rest, 1);
    double sum = 0;

    for (int i = 0; i < POINTS; i++) {
        const double a = M_PI * ((i + 0.5) / POINTS - 0.5), z = 0.5 * (low + high) + 0.5 * (low - high) * sin(a);
        sum += 0.5 * (low - high) * cos(a) / sqrt(2 / m * (E - stored(z, P)));
    }
    return 2 * sum * M_PI / POINTS;
}

struct bounce {
    double period, decrement;  /* s, 1: means over all cycles */
};

/* The wheelset set off downwards at v from rest.  A cycle ends where it comes through its height of rest downwards. */
static const char *bounce(struct fixture *f, double v, double damping, double h, struct bounce *b)
{
    struct passage_options o = rig_options(-4.5, 4.5);
    struct passage p;
    const int64_t k = 6 * f->vehicle.wheelset[0] + VEH_Z;
    double residual, first = 0, speed = 0, last = v;
    int cycles = 0;

    o.scheme = WAY_IMPLICIT;
    o.step = o.law.step = h;
    o.law.hertz_damping = damping;
    const char *why = passage_new(&p, &o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab);
    if (why)
        return why;
    why = passage_start(&p, &residual);
    const double rest = p.train.q[k];
    p.train.v[k] = v;
    while (!why && p.n < p.steps && cycles <= CYCLES) {
        const double z = p.train.q[k] - rest, u = p.train.v[k], t = p.time;
        if ((why = passage_step(&p)) || z > 0 || p.train.q[k] - rest <= 0)
            continue;
        const double part = z / (z - (p.train.q[k] - rest));
        last = u + part * (p.train.v[k] - u);
        if (cycles++ == 0) {
            first = t + part * h;
            speed = last;
        } else {
            b->period = (t + part * h - first) / (cycles - 1);
        }
    }
    b->decrement = log(speed / last) / CYCLES;
    passage_free(&p);
    return why ? why : cycles <= CYCLES ? "it does not come back" : NULL;
}

static void free_bounce(struct fixture *f, double v)
{
    const double want = period(f->vehicle.mass[f->vehicle.wheelset[0]], f->vehicle.wheel_load[0], v);
    double off[3] = {0};
    const char *why = NULL;

    for (int i = 0; i < 3 && !why; i++) {
        struct bounce b = {0};
        why = bounce(f, v, 0, i ? 5e-5 / i : 1e-4, &b);
        off[i] = b.period / want - 1;
    }
    const double order = log2((off[0] - off[1]) / (off[1] - off[2]));
    ok(!why && fabs(off[0]) < 0.01 && fabs(order - 2) < 0.2, "set off at %g m/s: %.2f Hz, off by %.3f, %.3f, %.3f %% at 100, 50, 25 us, order %.2f%s%s", v,
       1 / want, 100 * off[0], 100 * off[1], 100 * off[2], order, why ? ": " : "", why ? why : "");
}

/* Small: damping c = 2 P times that of the law on k = 3 C z^0.5; logarithmic decrement 2 pi D/sqrt(1 - D^2). */
static void damped_bounce(struct fixture *f, double damping)
{
    const double m = f->vehicle.mass[f->vehicle.wheelset[0]], P = f->vehicle.wheel_load[0], k = 3 * RIG_HERTZ_C * cbrt(P / RIG_HERTZ_C);
    const double D = P * damping / sqrt(k * m), want = 2 * M_PI * D / sqrt(1 - D * D);
    double off[3] = {0};
    const char *why = NULL;

    for (int i = 0; i < 3 && !why; i++) {
        struct bounce b = {0};
        why = bounce(f, 1e-4, damping, i ? 5e-5 / i : 1e-4, &b);
        off[i] = b.decrement / want - 1;
    }
    ok(!why && fabs(off[0]) < 0.01 && fabs(off[1] - off[2]) < 0.5 * fabs(off[0] - off[1]),
       "damping %g s/m, %.1f %% of critical: decrement %.4f, off by %.3f, %.3f, %.3f %%%s%s",
       damping, 100 * D, want, 100 * off[0], 100 * off[1], 100 * off[2], why ? ": " : "", why ? why : "");
}

int main(void)
{
    static const char *const rigid[] = {"rail.bending_stiffness=1e12", "railpad.stiffness=1e12", "ballast.stiffness=1e12"};
    static const char *const soft[] = {"coupling.1.stiffness=[31391e3, 3884e3, 1e3]", "coupling.1.damping=[15e3, 2e3, 0]",
                                      "coupling.1.rotation=[1e6, 10e6, 0]"};
    struct fixture f;

    memset(&f, 0, sizeof f);
    const char *why = rig_track(&f.track, RIG_STRAIGHT, rigid, 3), *also = rig_vehicle(&f.vehicle, RIG_WHEELSET, soft, 3);
    if (why || also) {
        ok(0, "%s", why ? why : also);
        return done();
    }
    rig_table(&f.table[0], 'l', 0);
    rig_table(&f.table[1], 'r', 0);
    free_bounce(&f, 1e-3);
    free_bounce(&f, 0.05);
    free_bounce(&f, 0.15);
    damped_bounce(&f, 0.5);
    damped_bounce(&f, 2);
    trk_free(&f.track);
    veh_free(&f.vehicle);
    return done();
}
