/* A damper on a spring: complex stiffness, relaxation, steps of any length, and a damper that blows off. */
#include "tools/vehicle/maxwell.h"

#include <complex.h>

#include "tests/kernel/tap.h"

static const double K = 8.82e6, RATE[2] = {0, 1}, FORCE[2] = {0, 2.4525e6};       /* N/m; c = 2.4525e6 N s/m */

/* Amplitude and phase of the force under e = sin(omega t), against k i omega c/(k + i omega c). */
static double wrong_stiffness(double omega, int steps)
{
    double complex is = 0, should = K*(I*omega*FORCE[1])/(K + I*omega*FORCE[1]);
    double h = 2*M_PI/omega/steps, F = 0;

    for (int i = 0; i < 40*steps; i++) {
        F = maxwell_step(F, sin(omega*h*(i + 1)) - sin(omega*h*i), h, K, 2, RATE, FORCE);
        if (i >= 39*steps)
            is += 2.0/steps*F*(sin(omega*h*(i + 1)) + I*cos(omega*h*(i + 1)));
    }
    return cabs(is - should)/cabs(should);
}

static void test_stiffness(void)
{
    static const double hz[] = {0.05, 0.5, 5};

    for (int k = 0; k < 3; k++)
        ok(wrong_stiffness(2*M_PI*hz[k], 2000) < 1e-4, "at %g Hz the complex stiffness, to %.1e", hz[k], wrong_stiffness(2*M_PI*hz[k], 2000));
    double order = log2(wrong_stiffness(2*M_PI*0.5, 100)/wrong_stiffness(2*M_PI*0.5, 200));
    near(order, 2, 0.1, "of second order in the step");
}

static void test_relaxation(void)
{
    double fine = 1e3, coarse = 1e3, tau = FORCE[1]/K;

    for (int i = 0; i < 1000; i++)
        fine = maxwell_step(fine, 0, 1e-4, K, 2, RATE, FORCE);
    coarse = maxwell_step(coarse, 0, 0.1, K, 2, RATE, FORCE);
    near(fine, 1e3*exp(-0.1/tau), 1e-9, "held, it relaxes by exp(-k t/c)");
    near(coarse, fine, 1e-9, "in one step as in a thousand");
    near(maxwell_step(0, 1e-3*1000*tau, 1000*tau, K, 2, RATE, FORCE), 1e-3*FORCE[1], 1e-6, "drawn at a rate for long, the force of the damper");
    near(maxwell_step(0, 1e-3, 1e-9, K, 2, RATE, FORCE), 1e-3*K, 1e-2, "drawn at once, that of the spring");
}

/* Blows off: 2.4525e6 N s/m to 4 mm/s, a hundredth beyond.  Against the same element in steps of a thousandth, by its rate equation. */
static void test_knee(void)
{
    static const double rate[3] = {0, 0.004, 0.2}, force[3] = {0, 9810, 14617};
    double F = 0, G = 0, most = 0, largest = 0, h = 1e-3;
    int small = 1000;

    for (int i = 0; i < 2000; i++) {
        double before = 0.02*sin(8*h*i), after = 0.02*sin(8*h*(i + 1));
        F = maxwell_step(F, after - before, h, K, 3, rate, force);
        for (int k = 0; k < small; k++) {
            double size = fabs(G), v = size < force[1] ? size*rate[1]/force[1]
                                                       : rate[1] + (size - force[1])*(rate[2] - rate[1])/(force[2] - force[1]);
            G += h/small*K*((after - before)/h - copysign(v, G));
        }
        most = fmax(most, fabs(F - G));
        largest = fmax(largest, fabs(G));
    }
    ok(most < 1e-4*largest, "through a knee and back, the rate equation in steps of 1e-6 s to %.2g of %.0f N", most, largest);
    near(maxwell_step(-12000, 0.2, 1, K, 3, rate, force), 14617, 1e-6, "from one side of the table to the other in one step");
    near(maxwell_step(12000, -0.2, 1, K, 3, rate, force), -14617, 1e-6, "and back");
}

/* Random pulls: what goes in, less what the spring holds, is never negative. */
static void test_energy(void)
{
    static const double rate[3] = {0, 0.004, 0.2}, force[3] = {0, 9810, 14617};
    unsigned seed = 1;
    double F = 0, lost = 0, least = 0;

    for (int i = 0; i < 100000; i++) {
        seed = seed*1664525u + 1013904223u;
        double de = 1e-4*((double)(seed >> 8)/8388608.0 - 1), before = F;
        F = maxwell_step(F, de, 1e-3, K, 3, rate, force);
        double work = 0.5*(before + F)*de;
        lost += work - (F*F - before*before)/(2*K);
        least = fmin(least, lost);
    }
    ok(least >= 0 && lost > 0, "over random motion it takes energy and gives none: %.3g J", lost);
}

int main(void)
{
    test_stiffness();
    test_relaxation();
    test_knee();
    test_energy();
    return done();
}
