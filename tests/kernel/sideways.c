/* Rails that yield sideways under each wheel: the static start, and the decay of a displaced rail against its closed form. */
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

static const double M = 60, K = 30e6, C = 150e3; /* kg, N/m, N s/m */

/* A wheelset on rails with these values, without friction, at rest on the track. */
static const char *begin(struct trk *track, struct veh *vehicle, struct rig_table table[2], double h, struct passage *p)
{
    const char *set[] = {"rail.lateral={mass: 60, stiffness: 30e6, damping: 150e3}"};
    struct passage_options o = rig_options(-4.5, 4.5);
    double residual;
    const char *why;

    o.step = o.law.step = h;
    rig_table(&table[0], 'l', 0.025);
    rig_table(&table[1], 'r', -0.025);
    if ((why = rig_track(track, RIG_STRAIGHT, set, 1)) || (why = rig_vehicle(vehicle, RIG_WHEELSET, NULL, 0)) ||
        (why = passage_new(p, &o, track, vehicle, &table[0].ctab, &table[1].ctab)))
        return why;
    return passage_start(p, &residual);
}

/* m y'' + c y' + k y = 0 from y = 1, y' = 0: y = (s1 e^(s2 t) - s2 e^(s1 t))/(s1 - s2), s1, s2 the roots. */
static double decay(double t)
{
    double root = sqrt(C * C - 4 * M * K), s1 = (-C + root) / (2 * M), s2 = (-C - root) / (2 * M);

    return (s1 * exp(s2 * t) - s2 * exp(s1 * t)) / (s1 - s2);
}

/* Error of the left rail's return after 5 ms from 0.1 mm beside its rest, over that. */
static double error_of(double h, int *at_rest)
{
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
    struct passage p;
    const char *why = begin(&track, &vehicle, table, h, &p);

    if (why) {
        ok(0, "%s", why);
        return NAN;
    }
    double rest = p.sideways.y[0], error;
    *at_rest = fabs(K * rest - p.wheel[0].Y) < 1e-3 * fabs(p.wheel[0].Y) && p.wheel[0].Y < -1000 &&
               fabs(p.sideways.y[1] + rest) < 1e-9;
    p.sideways.y[0] += 1e-4;
    why = passage_forces(&p);
    while (!why && p.time < 5e-3 - h / 2)
        why = passage_step(&p);
    error = (p.sideways.y[0] - rest) / 1e-4 - decay(p.time);
    passage_free(&p);
    trk_free(&track);
    veh_free(&vehicle);
    return why ? NAN : error;
}

int main(void)
{
    int at_rest = 0;
    double coarse = error_of(1e-4, &at_rest), fine = error_of(1e-5, &at_rest);

    ok(at_rest, "at the start each rail stands where Y = k y, outwards");
    ok(fabs(fine) < 0.002, "a displaced rail comes back as its closed form, within 0.2 %% at 1e-5 s (%.4f)", fine);
    ok(fabs(coarse) < 0.01, "and within 1 %% at 1e-4 s (%.4f)", coarse);
    ok(fabs(fine) < fabs(coarse), "the smaller step is nearer");
    return done();
}
