/* Static stiffness along a track and the bowl under axles: symmetry, superposition, equilibrium, the beam on a continuous support. */
#include "tools/receptance/stiffness.h"

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/track/seat.h"

enum { STATIONS = 61 };

static const double LOAD = 93.2e3;

static void stations(double from, double step, double x[STATIONS])
{
    for (int i = 0; i < STATIONS; i++)
        x[i] = from + i * step;
}

static void along(const struct trk *t)
{
    double x[STATIONS], k[STATIONS][STIFFNESS_N], sides = 0, period = 0;
    struct point p;
    struct seat s[TRK_RAILS];

    stations(-0.6, 0.02, x);
    if (!ok(stiffness_along(t, 0, STATIONS, x, k[0]) == NULL, "stiffness at 61 stations of two bays"))
        return;
    for (int i = 0; i < STATIONS; i++) {
        sides = fmax(sides, fabs(k[i][STIFFNESS_LEFT] / k[i][STIFFNESS_RIGHT] - 1));
        sides = fmax(sides, fabs(k[i][STIFFNESS_LEFT_OF_BOTH] / k[i][STIFFNESS_RIGHT_OF_BOTH] - 1));
        if (i + 30 < STATIONS)
            period = fmax(period, fabs(k[i][STIFFNESS_LEFT] / k[i + 30][STIFFNESS_LEFT] - 1));
    }
    near(sides, 0, 1e-9, "a straight track has two alike sides");
    near(period, 0, 1e-5, "its stiffness returns with every bay");
    for (int excite = EXCITE_LEFT; excite <= EXCITE_BOTH; excite++) {
        point_at(&p, t, x[11]);
        const double got = k[11][excite == EXCITE_BOTH ? STIFFNESS_LEFT_OF_BOTH : excite];
        ok(seat_load(s, t, &p, excite, 1) == NULL && fabs(got * s[point_rail(excite)].deflection - 1) < 1e-12, "as one load says, %.4g N/m", got);
    }
}

/* w = F b / 2k exp(-bx)(cos bx + sin bx), b^4 = k/4EI, on a rail whose pads and ballast are made continuous. */
static double winkler(double x)
{
    const double EI = 6.11e6, k = 1 / (1 / 300e6 + 1 / 140e6) / 0.6, b = pow(k / (4 * EI), 0.25);

    return LOAD * b / (2 * k) * exp(-b * fabs(x)) * (cos(b * fabs(x)) + sin(b * fabs(x)));
}

static void bowl(const struct trk *t)
{
    const double axle[2] = {-1.25, 1.25};
    double x[STATIONS], w[STATIONS][2], one[2][STATIONS][2], sum = 0, continuous = 0;

    stations(-3, 0.1, x);
    if (!ok(stiffness_bowl(t, EXCITE_BOTH, LOAD, 2, axle, STATIONS, x, w[0]) == NULL &&
                stiffness_bowl(t, EXCITE_BOTH, LOAD, 1, &axle[0], STATIONS, x, one[0][0]) == NULL &&
                stiffness_bowl(t, EXCITE_BOTH, LOAD, 1, &axle[1], STATIONS, x, one[1][0]) == NULL, "two axles of a bogie"))
        return;
    for (int i = 0; i < STATIONS; i++) {
        sum = fmax(sum, fabs(w[i][0] - one[0][i][0] - one[1][i][0]));
        continuous = fmax(continuous, fabs(w[i][1] - winkler(x[i] + 1.25) - winkler(x[i] - 1.25)));
    }
    near(sum, 0, 1e-15, "their bowls add up");
    ok(continuous < 0.04 * winkler(0), "the bowl is that of a beam on a continuous support within 4 %% of its depth (%.1f %%)",
       100 * continuous / winkler(0));
}

int main(void)
{
    struct trk t;
    const char *why = table1(&t, NULL, 0);

    if (!ok(why == NULL, "the track of Table 1 builds%s%s", why ? ": " : "", why ? why : ""))
        return done();
    along(&t);
    bowl(&t);
    trk_free(&t);
    return done();
}
