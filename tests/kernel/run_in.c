/* The run-in of forces whose settling is known. */
#include <math.h>

#include "tests/kernel/tap.h"
#include "tools/integrate/run_in.h"

/* 50 kN with 1 kN of sleeper passing and a swing of a kN that falls to 1/e in l m. */
static double settled(double a, double l)
{
    struct run_in r;

    run_in_begin(&r, -15, 0.6, 50e3, -10);
    for (double s = -10; s < 60; s += 0.002)
        run_in_step(&r, s, 50e3 + 1e3 * cos(2 * acos(-1) * s / 0.6) + a * exp(-(s + 10) / l) * cos(2 * acos(-1) * s / 7));
    return r.settled;
}

int main(void)
{
    near(settled(0, 1), -9, 1e-9, "what repeats from the start has settled in the second whole bay");
    /* From bay to bay the swing changes by 2 sin(pi 0.6/7) = 0.533 of its size at most: 50 N are left of a kN by then after ln(10.7) l. */
    double at = settled(1e3, 4);
    ok(at > -10 + 4 * 1.3 && at < -10 + 4 * 2.6, "a swing has when its changes fall below 0.1 %% of the load (%.2f m)", at);
    ok(settled(1e3, 8) > at + 4, "and later where it dies more slowly");
    ok(isnan(settled(1e3, 1e4)), "and not at all where it hardly does");
    return done();
}
