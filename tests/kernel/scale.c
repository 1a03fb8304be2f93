/* Round numbers on axes, and how they are written. */
#include "tools/draw/scale.h"

#include <string.h>

#include "tests/kernel/tap.h"

static void is(const char *got, const char *want)
{
    if (!ok(strcmp(got, want) == 0, "written \"%s\"", want))
        printf("# got \"%s\"\n", got);
}

static void steps(void)
{
    near(scale_step(100, 5), 20, 1e-12, "100 in at most 5 steps: 20");
    near(scale_step(100, 4), 50, 1e-12, "100 in at most 4 steps: 50");
    near(scale_step(7e-9, 8), 1e-9, 1e-21, "7e-9 in at most 8 steps: 1e-9");
    for (int most = 1; most < 30; most++)
        if (3.7 / scale_step(3.7, most) > most * (1 + 1e-9))
            ok(0, "more than %d steps", most);
}

static void limits(void)
{
    double lo = -3.2, hi = 97, a = 3.8e-10, b = 1.006e-8, c = 5, d = 5;

    scale_widen(&lo, &hi, 0, 0, 6);
    near(lo, -20, 1e-12, "-3.2 .. 97 begins at -20");
    near(hi, 100, 1e-12, "-3.2 .. 97 ends at 100");
    scale_widen(&a, &b, 1, 0, 6);
    near(a, 2e-10, 1e-22, "3.8e-10 on a logarithmic axis: from 2e-10");
    near(b, 2e-8, 1e-20, "1.006e-8 on a logarithmic axis: to 2e-8");
    scale_widen(&c, &d, 0, 0, 4);
    ok(c < 5 && d > 5, "a constant gets room");
}

static void ticks(void)
{
    struct scale s;

    scale_set(&s, 0, 150, 0, 0, 4);
    ok(s.ticks == 4, "0 .. 150 has 4 ticks, not %d", s.ticks);
    is(s.label[3], "150");
    scale_set(&s, -180, 0, 0, 90, 10);
    ok(s.ticks == 3, "a step that is given is kept: -180 -90 0");
    is(s.label[0], "−180");
    scale_set(&s, 20, 1500, 1, 0, 9);
    ok(s.ticks == 6, "20 .. 1500 Hz: 20 50 100 200 500 1000, not %d labels", s.ticks);
    is(s.label[5], "1000");
    ok(s.minors == 12, "with 12 fine lines between, not %d", s.minors);
    scale_set(&s, 1e-10, 1e-7, 1, 0, 6);
    ok(s.ticks == 4, "three decades with little room: powers of ten");
    is(s.label[0], "10⁻¹⁰");
    scale_set(&s, 1e-30, 1e30, 1, 0, 6);
    ok(s.ticks >= 4 && s.ticks <= 8, "sixty decades: not all of them, %d", s.ticks);
}

static void places(void)
{
    struct scale s;

    scale_set(&s, 10, 1000, 1, 0, 5);
    near(scale_place(&s, 100), 0.5, 1e-15, "100 lies halfway from 10 to 1000");
    ok(isnan(scale_place(&s, 0)), "0 has no place on a logarithmic axis");
    scale_set(&s, 5, 10, 0, 0, 5);
    near(scale_place(&s, 12.5), 1.5, 1e-15, "a point beyond the axis lies beyond 1");
}

static void words(void)
{
    char label[SCALE_LABEL];

    scale_format(label, 0.30000000000000004, 0.1, 1);
    is(label, "0.3");
    scale_format(label, -1e-18, 0.1, 1);
    is(label, "0");
    scale_format(label, 2e-9, 1e-9, 5e-9);
    is(label, "2×10⁻⁹");
    scale_format(label, 1e-9, 1e-9, 1e-9);
    is(label, "10⁻⁹");
    scale_format(label, -2.5e6, 5e5, 3e6);
    is(label, "−2.5×10⁶");
    scale_format(label, 99000, 1000, 99000);
    is(label, "99000");
}

int main(void)
{
    steps();
    limits();
    ticks();
    places();
    words();
    return done();
}
