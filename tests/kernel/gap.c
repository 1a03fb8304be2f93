/* Gap search: circle on plane, circle in a groove, two circles: closed forms; merging, ends, capacity. */
#include "tools/contact/gap.h"

#include "tests/kernel/tap.h"

#define STEP 1e-4
enum { N = 2001 };

static double y[N], z[N], slope[N], k[N], along[N], bend[N], work[2 * N];
static double store[2][GAP_ARRAYS][2 * N];
static const struct gap_search search = {.step = STEP, .apart = 4e-3, .work = work};

/* The first n points of the arrays above, tabulated into curve i. */
static struct gap_curve curve(int i, int n)
{
    for (int j = 0; j < n; j++)
        bend[j] = 2;
    struct gap_curve c = {.z = store[i][0], .slope = store[i][1], .k = store[i][2], .along = store[i][3], .along_y = store[i][4],
                          .bend = store[i][5], .bend_y = store[i][6], .at = store[i][7], .reach = store[i][8]};

    gap_tabulate(&(struct gap_line){n, y, z, slope, k, along, bend}, STEP, &c);
    return c;
}

/* Tabulates z = c -+ sqrt(R^2 - (y - at)^2) over at +- half, sampled at odd places, into curve i. */
static struct gap_curve arc(int i, double at, double bottom, double R, int sign, double half)
{
    int n = 801;
    for (int j = 0; j < n; j++) {
        double d = half * (2.0 * j / (n - 1) - 1), root = sqrt(R * R - d * d);
        y[j] = at + d;
        z[j] = bottom + sign * (root - R);
        slope[j] = -sign * d / root;
        k[j] = -sign / R;
    }
    return curve(i, n);
}

/* A wheel of transverse radius r over a rail arc whose top is at 0, both centred; they touch on the line of centres. */
static void two_circles(const char *what, double rail_radius, int rail_sign, double r, double offset)
{
    struct gap_curve rail = arc(0, 1.23e-5, 0, rail_radius, rail_sign, 0.03);
    struct gap_curve wheel = arc(1, 1.23e-5 + offset, 0, r, 1, 0.0303);
    struct gap_minimum m[4];
    char text[128];

    for (int shift = -20; shift <= 20; shift += 20) {
        double d = offset + shift * STEP;
        /* The rail's centre lies R below its top (R < 0 in a groove), the wheel's r above its lowest point. */
        double R = -rail_sign * rail_radius, reach = R + r, touch = reach - (reach > 0 ? 1 : -1) * sqrt(reach * reach - d * d);
        int n = gap_minima(&search, &rail, &wheel, shift, 0, m, 4);
        snprintf(text, sizeof text, "%s, shifted %d nodes: one minimum", what, shift);
        if (!ok(n == 1, "%s", text))
            continue;
        snprintf(text, sizeof text, "%s, shifted %d nodes: height", what, shift);
        near(m[0].gap, touch, 1e-11, text);
        snprintf(text, sizeof text, "%s, shifted %d nodes: place", what, shift);
        near(m[0].y, 1.23e-5 + R * d / reach, 2e-8, text);
        snprintf(text, sizeof text, "%s, shifted %d nodes: slope at the common tangent", what, shift);
        near(m[0].slope, d / reach / sqrt(1 - d * d / (reach * reach)), 1e-7, text);
        ok(fabs(m[0].rail_k * R - 1) < 1e-12 && fabs(m[0].wheel_k * r + 1) < 1e-12, "curvatures are handed through");
    }
}

int main(void)
{
    struct gap_minimum m[12];

    two_circles("circle on circle", 0.3, -1, 0.4, 0);
    two_circles("circle on small circle", 0.08, -1, 0.1, 3.37e-3);
    two_circles("circle in groove", 0.1, 1, 0.08, 0.411e-3);

    struct gap_curve plane = arc(0, 0, 0, 1e9, -1, 0.03), wheel = arc(1, 0, 0, 0.1, 1, 0.02);
    int n = gap_minima(&search, &plane, &wheel, 37, 0, m, 4);
    ok(n == 1 && fabs(m[0].y - 37 * STEP) < 1e-9 && fabs(m[0].gap) < 1e-12, "circle on plane: touches below its centre");
    const struct gap_pair both = {&plane, &wheel, 37, STEP};
    struct gap_place at;
    double c = sqrt(0.01 - 3.33e-3 * 3.33e-3);
    ok(gap_at(&both, 7.03e-3, &at) && fabs(at.gap - (0.1 - c)) < 1e-11 && fabs(at.slope - 3.33e-3 / c) < 1e-8,
       "between the nodes the gap is that to the circle");
    ok(!gap_at(&both, 0.0238, &at) && !gap_at(&both, -0.031, &at), "beyond a curve there is none");

    /* Rail z = h (1 - cos(2 pi y/L)): crests at multiples of L, the wheel nearly flat. */
    for (int pass = 0; pass < 2; pass++) {
        double L = pass ? 3e-3 : 6e-3, h = 1e-4;
        for (int j = 0; j < 601; j++) {
            double x = (j - 300) * 5e-5;
            y[j] = x;
            z[j] = h * (1 - cos(2 * M_PI * x / L));
            slope[j] = h * 2 * M_PI / L * sin(2 * M_PI * x / L);
            k[j] = 0;
        }
        struct gap_curve rail = curve(0, 601);
        wheel = arc(1, 0, 0, 30, 1, 0.02);
        n = gap_minima(&search, &rail, &wheel, 0, 0, m, 12);
        if (pass)
            ok(n < 11, "crests 3 mm apart are joined (%d of 11)", n);
        else
            ok(n == 5 && fabs(m[2].y) < 1e-9 && fabs(m[1].y + m[3].y) < 1e-9, "crests 6 mm apart: each a minimum");
        if (!pass) {
            n = gap_minima(&search, &rail, &wheel, 0, 0, m, 2);
            ok(n == 2 && (fabs(m[0].y) < 1e-9 || fabs(m[1].y) < 1e-9), "room for two: the lowest stay");
        }
    }

    /* A rail that ends left of the wheel's lowest point. */
    struct gap_curve rail = arc(0, -0.02, 0, 1e9, -1, 0.01);
    wheel = arc(1, 0, 0, 0.1, 1, 0.03);
    ok(gap_minima(&search, &rail, &wheel, 0, GAP_LEFT_END, m, 4) == 0, "an end that does not count gives no contact");
    n = gap_minima(&search, &rail, &wheel, 0, GAP_RIGHT_END, m, 4);
    ok(n == 1 && m[0].end, "an end that counts gives one");
    near(m[0].y, -0.01, 1e-12, "at the end");
    near(m[0].gap, 0.1 - sqrt(0.01 - 1e-4), 1e-12, "as high as the wheel is there");
    near(m[0].slope, 0.01 / sqrt(0.01 - 1e-4), 1e-9, "with the wheel's slope");

    ok(gap_minima(&search, &rail, &wheel, 900, 3, m, 4) == 0, "a wheel beside the rail touches nothing");

    /* A polyline that turns back, as a folded silhouette: the lowest piece is kept. */
    static const double fold[4][3] = {{0, 0, -0.5}, {2e-3, -1e-3, -0.5}, {1e-3, 0, 0.5}, {3e-3, 1e-3, 0.5}};
    for (int sign = 1; sign >= -1; sign -= 2) {
        for (int j = 0; j < 4; j++)
            y[j] = fold[j][0], z[j] = sign * fold[j][1], slope[j] = sign * fold[j][2];
        rail = curve(0, 4);
        if (sign > 0)
            ok(rail.n == 31 && fabs(rail.z[15] - 0.25e-3) < 1e-12 && fabs(rail.z[5] + 0.25e-3) < 1e-12, "a fold keeps its lowest branch");
        else
            ok(rail.n == 31 && fabs(rail.z[15] - 0.75e-3) < 1e-12 && fabs(rail.z[25] + 0.75e-3) < 1e-12, "whichever piece comes first");
    }
    return done();
}
