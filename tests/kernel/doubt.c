/* What is doubtful in a vehicle, and how far a sideways push takes its stops: the coach with one number changed at a time. */
#include "tools/vehicle/doubt.h"

#include <math.h>
#include <string.h>

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/vehicle/check.h"

static char words[8][DOUBT_WORDS];

static int64_t doubts_of(const struct veh *v)
{
    struct doubts d = {.room = 8, .words = words};

    memset(words, 0, sizeof words);
    doubt_find(v, &d);
    return d.n;
}

/* The coach as shipped, then with one number at a time changed. */
static void coach(void)
{
    struct veh v;
    double mass[7], inertia[21], load[8];

    ok(rig_vehicle(&v, RIG_COACH, NULL, 0) == NULL, "the coach");
    ok(doubts_of(&v) == 0, "nothing in it is doubtful");
    near(doubt_bounce(&v, 0), sqrt(4 * 430e3 / 32000) / (2 * M_PI), 1e-9, "its carbody alone bounces on four springs");

    memcpy(mass, v.mass, sizeof mass);
    memcpy(inertia, v.inertia, sizeof inertia);
    memcpy(load, v.wheel_load, sizeof load);
    v.mass = mass;
    v.inertia = inertia;
    v.wheel_load = load;
    inertia[0] = inertia[1] + inertia[2];
    doubts_of(&v);
    ok(!strstr(words[0], "no body has"), "a body flat as a sheet is one, though couplings lie off it: %s", words[0]);
    inertia[0] *= 1.01;
    doubts_of(&v);
    ok(strstr(words[0], "no body has these inertias") != NULL, "a little more is none: %s", words[0]);
    inertia[0] = v.mass[0] * 0.0024;
    ok(doubts_of(&v) == 1 && strstr(words[0], "radius of gyration"), "a radius of gyration of 49 mm: %s", words[0]);
    inertia[0] = 56800;
    load[0] += 0.02 * load[1];
    ok(doubts_of(&v) == 1 && strstr(words[0], "more on its left wheel"), "2 per cent more on one wheel: %s", words[0]);
    load[0] = load[1];
    mass[1] = 2.6;
    ok(doubts_of(&v) >= 1 && strstr(words[0], "body bogie1: a mass of 2.6 kg"), "a bogie in t: %s", words[0]);
    veh_free(&v);
}

/* The bump stops of the coach: with springs k between carbody and bogie and all symmetric, the carbody's sway q solves K q = -m a; here twice the
 * push gives twice the way, both ends alike, to the left. */
static void push(void)
{
    struct veh v;
    double one[64], two[64];
    int stops = 0;

    ok(rig_vehicle(&v, RIG_COACH, NULL, 0) == NULL && v.couplings <= 64, "the coach");
    ok(!check_sideways(&v, 1, one) && !check_sideways(&v, 2, two), "pushed by 1 and by 2 m/s2");
    for (int64_t c = 0; c < v.couplings; c++)
        if (v.type[c] == VEH_STOP) {
            stops++;
            ok(one[c] < -0.03 && one[c] > -0.1, "its bump stop moves to the left, %.4f m", one[c]);
            near(two[c], 2 * one[c], 1e-12, "twice as far by twice as much");
        }
    ok(stops == 2, "two stops");
    veh_free(&v);
}

int main(void)
{
    coach();
    push();
    return done();
}
