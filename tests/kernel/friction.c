/* Dry friction: the area of its loop, energy, stick without creep, loads that change. */
#include "tools/vehicle/friction.h"

#include <string.h>

#include "tests/kernel/tap.h"

static const double LIMIT = 5e3, STICK = 8e6;       /* mu N, k */

/* Work of one cycle of amplitude A, after one to settle, `steps` a cycle. */
static double loop_area(double A, int steps)
{
    const double k[3] = {0, 0, STICK};
    double F[3] = {0}, area = 0;

    for (int i = 0; i < 2*steps; i++) {
        double de[3] = {0, 0, A*(sin(2*M_PI*(i + 1)/steps) - sin(2*M_PI*i/steps))}, before = F[2];
        friction_step(k, LIMIT, de, F);
        if (i >= steps)
            area -= 0.5*(before + F[2])*de[2];
    }
    return area;
}

static void test_loop(void)
{
    static const double A[] = {1e-3, 3e-3, 10e-3};

    for (int i = 0; i < 3; i++) {
        double should = 4*LIMIT*(A[i] - LIMIT/STICK), is = loop_area(A[i], 2000);
        ok(fabs(is/should - 1) < 1e-2, "%g mm: the loop's area is 4 mu N (A - mu N/k) to %.1e", 1e3*A[i], fabs(is/should - 1));
    }
    near(loop_area(0.5e-3, 2000), 0, 1e-9, "within the stick it takes nothing");
}

static double draw(unsigned *state)
{
    *state = *state*1664525u + 1013904223u;
    return (double)(*state >> 8)/8388608.0 - 1;
}

/* Work against F after each step, less what the springs hold: never falls, with the limit constant or not. */
static void test_energy(void)
{
    static const double k[3] = {0, 8e6, 5e6};

    for (int varies = 0; varies < 2; varies++) {
        unsigned seed = 7;
        double F[3] = {0}, lost = 0, least = 0, over = 0;
        for (int i = 0; i < 200000; i++) {
            double de[3] = {1e-4*draw(&seed), 1e-4*draw(&seed), 1e-4*draw(&seed)}, before[3];
            double limit = varies ? LIMIT*(1 + draw(&seed)) : LIMIT, was = lost;
            memcpy(before, F, sizeof F);
            friction_step(k, limit, de, F);
            for (int j = 1; j < 3; j++)
                lost += -F[j]*de[j] - (F[j]*F[j] - before[j]*before[j])/(2*k[j]);
            least = fmin(least, lost - was);
            over = fmax(over, hypot(F[1], F[2]) - limit);
        }
        ok(least > -1e-9 && lost > 0, "random motion%s: every step takes energy (%.3g J in all, least %.1e)",
           varies ? " under a random load" : "", lost, least);
        ok(over < 1e-9, "the force stays within its limit");
        near(F[0], 0, 0, "an axis without stiffness is free");
    }
}

/* A mass on friction under a constant push, with a little damping: below the limit it comes to rest at push/k and stays. */
static void test_stick(void)
{
    const double k[3] = {STICK, 0, 0}, m = 2000, c = 2e4, h = 1e-4, push = 0.9*LIMIT;
    double F[3] = {0}, x = 0, v = 0, half = 0;

    for (int i = 0; i < 1000000; i++) {
        double f = fmin(1, i*h/0.5)*push;
        v += h/m*(f + F[0] - c*v);
        friction_step(k, LIMIT, (double[3]){h*v, 0, 0}, F);
        x += h*v;
        if (i == 500000)
            half = x;
    }
    near(x, push/STICK, 1e-12, "under 0.9 of its limit it holds at push/k for 100 s");
    near(x - half, 0, 1e-15, "without creep");
}

/* Slides down to rest: a mass with speed v0 stops after m v0^2/(2 mu N), give or take what the stick holds, and does not chatter. */
static void test_stop(void)
{
    const double k[3] = {STICK, 0, 0}, m = 2000, h = 1e-5, v0 = 0.5;
    double F[3] = {0}, x = 0, v = v0, late = 0;

    for (int i = 0; i < 200000; i++) {
        v += h/m*F[0];
        friction_step(k, LIMIT, (double[3]){h*v, 0, 0}, F);
        x += h*v;
        if (i > 100000)
            late = fmax(late, fabs(F[0]));
    }
    near(x, m*v0*v0/(2*LIMIT), 2*LIMIT/STICK, "a body slides m v^2/(2 mu N) and stops");
    ok(late <= LIMIT, "then swings on the stick stiffness within the limit");
}

/* Both axes slide together: the force points against the motion. */
static void test_direction(void)
{
    const double k[3] = {STICK, STICK, 0};
    double F[3] = {0};

    for (int i = 0; i < 1000; i++)
        friction_step(k, LIMIT, (double[3]){3e-5, 4e-5, 0}, F);
    near(F[0], -0.6*LIMIT, 1e-6, "sliding along (3, 4): 0.6 of the limit along x");
    near(F[1], -0.8*LIMIT, 1e-6, "0.8 along y");
    friction_step(k, 0, (double[3]){0}, F);
    near(hypot(F[0], F[1]), 0, 0, "unloaded it lets go");
}

int main(void)
{
    test_loop();
    test_energy();
    test_stick();
    test_stop();
    test_direction();
    return done();
}
