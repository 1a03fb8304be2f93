/* Patches in planes of any slope: Hertz's where the gap is his parabola, whatever the slope; marks of hollow, flat and double gaps. */
#include "tools/contact/patch.h"

#include "tests/kernel/tap.h"

#define STEP 1e-4
#define A 1.1                /* 1/m */
#define LOAD 80e3
enum { N = 1201 };

static double y[N], z[N], slope[N], k[N], along[N], bend[N], work[2 * N];
static double store[2][GAP_ARRAYS][2 * N];
static struct strip_law law;

/* Gaps over t (m) from the contact, with their slopes. */
struct shape { double gap, slope; };

static struct shape parabola(double t) { return (struct shape){20 * t * t, 40 * t}; }

/* Like the parabola near by, flatter further away. */
static struct shape flatter(double t)
{
    double q = 1 + t * t / 5e-6;
    return (struct shape){20 * t * t / q, 40 * t / (q * q)};
}

/* The parabola, and another 9 mm away, 10 um higher. */
static struct shape twice(double t)
{
    double far = t - 9e-3, other = 20 * far * far + 10e-6;
    return 20 * t * t < other ? parabola(t) : (struct shape){other, 40 * far};
}

/* The curve at `over` times gap above a plane of slope angle phi through the origin, on the grid. */
static struct gap_curve curve(int i, struct shape (*gap)(double), double over, double phi)
{
    double c = cos(phi), s = sin(phi);

    for (int j = 0; j < N; j++) {
        double t = 0.015 * (2.0 * j / (N - 1) - 1) + 1.7e-6;
        struct shape g = gap(t);
        y[j] = t * c + over * g.gap * s;
        z[j] = t * s - over * g.gap * c;
        slope[j] = (s - over * g.slope * c) / (c + over * g.slope * s);
        bend[j] = over > 0 ? 2 * A * (c + slope[j] * s) : 0;
    }
    struct gap_curve o = {.z = store[i][0], .slope = store[i][1], .k = store[i][2], .along = store[i][3], .along_y = store[i][4],
                          .bend = store[i][5], .bend_y = store[i][6], .at = store[i][7], .reach = store[i][8]};
    gap_tabulate(&(struct gap_line){N, y, z, slope, k, along, bend}, STEP, &o);
    return o;
}

struct result { double shape; struct hertz hertz; struct strip_patch all; };

static struct result result(struct shape (*gap)(double), double phi)
{
    struct gap_curve rail = curve(0, gap, 0, phi), wheel = curve(1, gap, 1, phi);
    const struct gap_search search = {.step = STEP, .apart = 4e-3, .work = work};
    const struct gap_pair pair = {&rail, &wheel, 0, STEP};
    static struct strip strip[PATCH_STRIPS];
    struct gap_minimum m[3];
    struct result r = {0};

    if (gap_minima(&search, &rail, &wheel, 0, 0, m, 3) < 1 || fabs(m[0].y) > 1e-5)
        return (struct result){.shape = (double)NAN};
    hertz_contact(A, 20, 82e9, 0.28, &r.hertz);
    r.shape = patch_deviation(&pair, m, 20, &r.hertz, LOAD);
    patch_strips(&pair, m, 20, &r.hertz, LOAD, &law, PATCH_ALL, strip, &r.all);
    patch_hertz(&pair, m, 20, LOAD, &law, &r.hertz);
    return r;
}

int main(void)
{
    struct hertz h;
    double approach, worst[4] = {0};

    strip_law(82e9, 0.28, &law);
    hertz_contact(A, 20, 82e9, 0.28, &h);
    approach = pow(LOAD / h.C, 2.0 / 3);
    for (int i = -6; i <= 6; i++) {
        struct result r = result(parabola, 0.2 * i);
        worst[0] = fmax(worst[0], r.shape);
        worst[1] = fmax(worst[1], fabs(r.hertz.C / h.C - 1));
        worst[3] = fmax(worst[3], fmax(fabs(r.hertz.a1 / h.a1 - 1), fabs(r.hertz.b1 / h.b1 - 1)));
        worst[2] = fmax(worst[2], fabs(r.all.approach / approach - 1));
        ok(r.all.parts == 1, "slope angle %g rad: one part", 0.2 * i);
    }
    ok(worst[0] < 0.005, "a parabola is not marked at any slope (%.2g)", worst[0]);
    ok(worst[1] < 1.5e-3, "48 strips give it Hertz's stiffness (%.2g)", worst[1]);
    ok(worst[3] < 5e-3, "and semi-axes, up to 1.2 rad, where the grid's nodes are wider apart than strips (%.2g)", worst[3]);
    ok(worst[2] < 1e-3, "400 strips its approach (%.2g)", worst[2]);

    struct result flat = result(flatter, 0.4), level = result(flatter, 0);
    ok(flat.shape > 0.1 && fabs(flat.shape / level.shape - 1) < 0.05, "a flatter gap is marked, whatever its slope (%.2f, %.2f)", flat.shape, level.shape);
    ok(flat.hertz.b1 > 1.03 * h.b1, "and its ellipse is wider (%.3f)", flat.hertz.b1 / h.b1);

    struct result two = result(twice, 0.1);
    ok(two.shape > 0.5 && two.all.parts == 2, "a second part within the approach is marked (%.2f)", two.shape);
    ok(two.all.approach < 0.8 * approach, "and carries its share: the approach falls to %.2f", two.all.approach / approach);
    ok(fabs(two.hertz.C / h.C - 1) < 2e-3, "but a contact's own part is Hertz's (%.2g)", two.hertz.C / h.C - 1);
    return done();
}
