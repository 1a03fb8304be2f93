/* The check rail: play along its flares, one-sided push at rail level, damping, no pull. */
#include "tools/integrate/check_rail.h"

#include <string.h>

#include "tests/kernel/tap.h"

static const double k = 30e6, c = 50e3, x[3] = {43, 45, 48}, play[3] = {0.0225, 0.0025, 0.0025};
static const int64_t rail[2] = {TRK_LEFT, TRK_RIGHT};

/* Beside rail `on`; the wheel of `side` with its wheelset displaced by y at the axle and turned by roll. */
static struct wheel_output push(int on, int side, double s, double y, double roll, double vy)
{
    struct trk t = {.checks = 3, .check_rail = &rail[on], .check_k = &k, .check_c = &c, .check_x = x, .check_play = play};
    struct wheel_input in = {.s = s, .v = 20, .y = y, .roll = roll, .vy = vy, .radius = 0.46, .z = 1e-3};
    struct wheel_output out;

    memset(&out, 0, sizeof out);
    check_rail_add(&t, side, &in, &out);
    return out;
}

static int silent(struct wheel_output o)
{
    return o.check == 0 && o.Y == 0 && o.force[1] == 0 && o.moment[0] == 0;
}

int main(void)
{
    ok(silent(push(1, 1, 46, -0.0024, 0, 0)), "free within the play");
    ok(silent(push(1, 1, 46, 0.01, 0, 0)), "and away from it");
    ok(silent(push(1, 0, 46, -0.01, 0, 0)), "nothing on the other side's wheel");
    ok(silent(push(1, 1, 42.99, -0.01, 0, 0)) && silent(push(1, 1, 48.01, -0.01, 0, 0)), "nothing beyond its ends");

    struct wheel_output o = push(1, 1, 46, -0.0035, 0, 0);
    near(o.force[1], 30e3, 1e-6, "1 mm beyond: 30 kN to the right on the wheelset");
    near(o.Y, -30e3, 1e-6, "on the rails to the left");
    near(o.check, -30e3, 1e-6, "and told as the check rail's");
    near(o.moment[0], -0.459 * 30e3, 1e-6, "at rail level, 0.459 m below the axle: it rolls to the left");
    ok(o.Q == 0 && o.T == 0 && o.Mx == 0 && o.moment[2] == 0, "no other force, and no moment about the track at rail level");

    struct wheel_output m = push(0, 0, 46, 0.0035, 0, 0);
    ok(m.force[1] == -o.force[1] && m.Y == -o.Y && m.moment[0] == -o.moment[0], "beside the left rail the mirror image");
    near(push(1, 1, 46, 0, 0.0035 / 0.46, 0).check, -30e3, 1e-6, "roll moves the wheel at rail level by -roll r0");
    near(push(1, 1, 46, -0.0035, 0, -0.1).check, -35e3, 1e-6, "the damper adds while it closes");
    near(push(1, 1, 46, -0.0035, 0, 10).check, 0, 0, "and does not pull while it opens");

    /* On the flare the play falls by 10 mm a metre, so it closes at 0.2 m/s. */
    near(push(1, 1, 44, -0.0135, 0, 0).check, -(30e6 * 1e-3 + 50e3 * 0.2), 1e-5, "a flare closes on a wheelset that goes straight");

    /* A beam that yields 5 nm/N: k e/(1 + k g). */
    struct trk t = {.checks = 3, .check_rail = &rail[1], .check_k = &k, .check_c = &c, .check_x = x, .check_play = play};
    struct wheel_input in = {.s = 46, .v = 20, .y = -0.0035, .radius = 0.46, .check_give = 5e-9};
    struct wheel_output beam;
    memset(&beam, 0, sizeof beam);
    check_rail_add(&t, TRK_RIGHT, &in, &beam);
    near(beam.check, -30e3 / 1.15, 1e-6, "a beam that yields takes less");
    in.check_y = -1e-3;
    memset(&beam, 0, sizeof beam);
    check_rail_add(&t, TRK_RIGHT, &in, &beam);
    ok(silent(beam), "and one that stands aside nothing");
    return done();
}
