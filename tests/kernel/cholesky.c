/* Static load on a uniform track: stiffness, the loads of seats and pads against an independent program, equilibrium, closed forms. */
#include "tools/track/cholesky.h"

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/track/seat.h"

/* 50 sleepers, both rails loaded above a sleeper next to the middle. */
static struct seat seat_of(const char *const *set, int sets, int at, int excite, double load)
{
    struct trk t;
    struct point p;
    struct seat s[TRK_RAILS] = {{NAN, NAN, NAN, 0}, {NAN, NAN, NAN, 0}};

    if (table1(&t, set, sets) == NULL) {
        point_at(&p, &t, point_station(&t, at, 0));
        const char *why = seat_load(s, &t, &p, excite, load);
        if (why)
            printf("# %s\n", why);
    }
    trk_free(&t);
    return s[point_rail(excite)];
}

/* Seat force (kN) and pad compression (mm) under a wheel of 93.2 and of 110.4 kN; ballast and pad in MN/m. */
static void seats(void)
{
    static const struct { int ballast, pad; double wheel[2][2]; } row[] = {
        {50, 150, {{30.7, 0.205}, {36.3, 0.242}}},  {50, 15, {{25.0, 1.67}, {29.6, 1.97}}},
        {400, 150, {{43.1, 0.288}, {51.1, 0.341}}}, {400, 33, {{32.9, 0.997}, {39.0, 1.18}}},
        {400, 15, {{27.6, 1.84}, {32.7, 2.18}}},    {3000, 150, {{48.2, 0.321}, {57.1, 0.381}}},
        {3000, 33, {{34.0, 1.03}, {40.2, 1.22}}},   {3000, 15, {{28.0, 1.87}, {33.2, 2.21}}}};

    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++)
        for (int w = 0; w < 2; w++) {
            char ballast[64], pad[64];
            const char *set[] = {ballast, pad};
            snprintf(ballast, sizeof ballast, "ballast.stiffness=%de6", row[k].ballast);
            snprintf(pad, sizeof pad, "railpad.stiffness=%de6", row[k].pad);
            struct seat s = seat_of(set, 2, AT_SLEEPER, EXCITE_BOTH, w ? 110.4e3 : 93.2e3);
            const double *want = row[k].wheel[w];
            ok(fabs(s.force / (want[0] * 1e3) - 1) < 0.02 && fabs(s.compression / (want[1] * 1e-3) - 1) < 0.02,
               "ballast %d, pad %d MN/m, %s kN: %.1f kN, %.3f mm for %.1f kN, %.3f mm", row[k].ballast, row[k].pad, w ? "110.4" : "93.2",
               s.force / 1e3, s.compression * 1e3, want[0], want[1]);
        }
}

static void stiffness(void)
{
    const double k = 1 / seat_of(NULL, 0, AT_SLEEPER, EXCITE_BOTH, 1).deflection;

    near(k / 200.9e6, 1, 0.01, "static stiffness at a rail over a sleeper 200.9 MN/m");
    near(seat_of(NULL, 0, AT_SLEEPER, EXCITE_LEFT, 1).deflection, seat_of(NULL, 0, AT_SLEEPER, EXCITE_RIGHT, 1).deflection, 1e-22,
         "left and right are alike");
    near(1 / seat_of(NULL, 0, AT_MIDSPAN, EXCITE_BOTH, 1).deflection * 5.09835e-9, 1, 0.002,
         "halfway 5.09835e-9 m/N, the exact beam on discrete supports");
    const char *finer[] = {"rail.elements_per_bay=5"};
    near(seat_of(finer, 1, AT_MIDSPAN, EXCITE_BOTH, 1).deflection, seat_of(NULL, 0, AT_MIDSPAN, EXCITE_BOTH, 1).deflection, 1e-19,
         "one element with its compliance is as exact as five");
}

/* Upward forces of the ballast balance the load, and their moments about the middle its moment. */
static void equilibrium(void)
{
    static double u[300];
    struct trk t;
    struct cholesky s;
    double force = 0, moment = 0, f = 1000;

    ok(table1(&t, NULL, 0) == NULL && cholesky_new(&s, &t) == NULL, "factors");
    u[t.node_dof[20]] = f;
    ok(cholesky_solve(&s, u, u) == NULL, "solves in place");
    for (int64_t k = 0; k < t.sleepers; k++)
        for (int b = 0; b < TRK_BALLAST; b++) {
            const int64_t z = t.sleeper_dof[k];
            double part = t.ballast_k[b * t.sleepers + k] * (u[z] + t.ballast_y[b * t.sleepers + k] * u[z + 1]);
            force += part;
            moment += part * t.ballast_y[b * t.sleepers + k];
        }
    near(force, f, 1e-9, "the ballast carries the load");
    near(moment, f * -0.75, 1e-9, "on the side of the rail it is on");
    cholesky_free(&s);
    trk_free(&t);
}

static void refusals(void)
{
    const char *set[] = {"ballast.stiffness=1e-20"};
    struct trk t;
    struct cholesky s;

    ok(table1(&t, set, 1) == NULL && cholesky_new(&s, &t) != NULL, "a track that nothing carries is refused");
    cholesky_free(&s);
    trk_free(&t);
}

int main(void)
{
    stiffness();
    seats();
    equilibrium();
    refusals();
    return done();
}
