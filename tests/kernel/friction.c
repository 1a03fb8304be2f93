/* Coefficient of friction: constant, by place, falling with slip. */
#include "tools/creep/friction.h"

#include "tests/kernel/tap.h"

static void test_falling(void)
{
    struct friction f = {0};

    near(friction_of(&f, 0.3, 'l', 0, 0, 0, 2), 0.3, 1e-15, "zeroed, it is constant");
    f.limit = 0.4;
    f.decay = 0.6;
    near(friction_of(&f, 0.55, 'l', 0, 0, 0, 0), 0.55, 1e-15, "without slip it does not fall");
    near(friction_of(&f, 0.55, 'l', 0, 0, 0, 1), 0.55*(0.6*exp(-0.6) + 0.4), 1e-15, "Polach's formula, dry rail, 1 m/s");
    near(friction_of(&f, 0.55, 'l', 0, 0, 0, 100), 0.22, 1e-12, "at large slip the limit is left");
    f.limit = 1;
    near(friction_of(&f, 0.3, 'l', 0, 0, 0, 2), 0.3, 1e-15, "a limit of 1 is constant friction");
}

static void test_places(void)
{
    const struct case_friction rule[] = {
        {CASE_BOTH, -1, 10, 20, 0, 0.1}, {CASE_LEFT, -1, 0, 30, 0.5, 0.2}, {CASE_RIGHT, 2, -1e9, 1e9, 0, 0.4}};
    struct friction f = {.rules = 3, .rule = rule};

    near(friction_of(&f, 0.3, 'l', 9.9, 0, 0, 0), 0.3, 1e-15, "outside all rules the general one");
    near(friction_of(&f, 0.3, 'l', 10, 0, 0, 0), 0.1, 1e-15, "within stations");
    near(friction_of(&f, 0.3, 'l', 15, 0, -0.6, 0), 0.2, 1e-15, "the last that holds wins; steep either way");
    near(friction_of(&f, 0.3, 'r', 15, 0, 0.6, 0), 0.1, 1e-15, "a rule of the left side leaves the right one");
    near(friction_of(&f, 0.3, 'r', 50, 2, 0, 0), 0.4, 1e-15, "a body of one side");
    near(friction_of(&f, 0.3, 'l', 50, 2, 0, 0), 0.3, 1e-15, "and not of the other");
}

int main(void)
{
    test_falling();
    test_places();
    return done();
}
