/* What moves a wheel: closed forms of every shape, slopes against differences, both rails as EN 13848-1 has them, the spectrum's variance. */
#include <math.h>
#include <stdlib.h>

#include "tests/kernel/tap.h"
#include "tools/integrate/excitation.h"

static struct excitation_at find(const struct excitation *e, double s, int side)
{
    struct excitation_at at;

    excitation_find(e, s, 0, side, 0.46, &at);
    return at;
}

/* Largest difference of z_slope and y_slope from central differences of z and y over from..to, but at the kinks. */
static double slope_error(const struct excitation *e, double from, double to)
{
    const double h = 1e-6;
    double worst = 0;

    for (int k = 0; k < 1000; k++) {
        const double s = from + (to - from) * (k + 0.37) / 1000;
        for (int side = 0; side < 2; side++) {
            const struct excitation_at a = find(e, s - h, side), b = find(e, s + h, side), m = find(e, s, side);
            worst = fmax(worst, fabs((b.z - a.z) / (2 * h) - m.z_slope));
            worst = fmax(worst, fabs((b.y - a.y) / (2 * h) - m.y_slope));
        }
    }
    return worst;
}

static void dips(void)
{
    const struct case_dip dip[] = {{1, 2, 1e-3, CASE_BOTH}, {5, 1, 2e-3, CASE_LEFT}};
    struct excitation e;

    ok(excitation_new(&e, &(struct excitation_options){.dips = 2, .dip = dip}) == NULL, "two dips");
    near(find(&e, 2, 1).z, 1e-3, 1e-18, "a dip is as deep as said in its middle");
    near(find(&e, 1.5, 0).z, 0.5e-3, 1e-18, "half as deep at a quarter");
    near(find(&e, 1, 0).z + find(&e, 3, 0).z + find(&e, 0, 0).z, 0, 0, "and nothing outside");
    ok(find(&e, 5.5, 0).z > 1.9e-3 && find(&e, 5.5, 1).z == 0, "a dip of the left rail is there alone");
    near(slope_error(&e, 0, 7), 0, 1e-8, "slopes are those of the heights");
    excitation_free(&e);
}

static void joints(void)
{
    const struct case_joint joint = {10, 1, 2e-3, CASE_RIGHT};
    struct excitation e;

    ok(excitation_new(&e, &(struct excitation_options){.joints = 1, .joint = &joint}) == NULL, "a joint");
    near(find(&e, 10, 1).z, 2e-3, 1e-18, "the gap lies at the depth");
    near(find(&e, 10 + 1e-12, 1).z_slope - find(&e, 10 - 1e-12, 1).z_slope, -4 * 2e-3 / 0.5, 1e-9, "under an angle of 4 depth/half length");
    near(find(&e, 10.25, 1).z, 0.5e-3, 1e-18, "a quarter of the depth half way out");
    ok(find(&e, 10, 0).z == 0, "and not on the other rail");
    near(slope_error(&e, 9.4, 10.6), 0, 1e-8, "slopes are those of the heights");
    excitation_free(&e);
}

static void flats(void)
{
    const double turn = 2 * acos(-1) * 0.46, l = 0.05, chord = l * l / (8 * 0.46);
    struct case_flat flat = {1, CASE_LEFT, CASE_FRESH, l, 3};
    struct excitation e;
    struct excitation_at other;

    ok(excitation_new(&e, &(struct excitation_options){.flats = 1, .flat = &flat}) == NULL, "a flat");
    for (int shape = CASE_FRESH; shape <= CASE_WORN; shape++) {
        flat.shape = shape;
        const double depth = shape == CASE_FRESH ? chord : chord / 2;
        near(find(&e, 3, 0).z, depth, 1e-12, shape == CASE_FRESH ? "fresh: the wheel falls by the depth of its chord" : "worn: by half of it");
        near(find(&e, 3 + 7 * turn, 0).z, depth, 1e-12, "and again every turn");
        near(find(&e, 3 + turn / 2, 0).z + find(&e, 3 + l / 2, 0).z + find(&e, 3, 1).z, 0, 1e-17, "not between, nor on the other wheel");
        near(slope_error(&e, 3 - l, 3 + 2 * turn), 0, 1e-6, "slopes are those of the heights");
    }
    excitation_find(&e, 3, 1, 0, 0.46, &other);
    ok(other.z == 0, "nor of the next wheelset");
    /* Tipping over its edge the centre of the wheel goes round it: height r cos(a0 - x/r), a0 half the angle of the chord. */
    flat.shape = CASE_FRESH;
    near(find(&e, 3 - 0.01, 0).z, 0.46 * (1 - cos((l / 2 - 0.01) / 0.46)), 1e-7, "and falls on the circle about its edge");
    excitation_free(&e);
}

enum { KNOTS = 400 };

/* Sines of 4 m to 7 m of each quantity every 0.25 m. */
static void measured(void)
{
    static double x[KNOTS], value[IRREGULARITY_QUANTITIES][KNOTS];
    const double amplitude[] = {3e-3, 2e-3, 4e-3, 1e-3};
    const struct irregularity m = {KNOTS, x, {value[0], value[1], value[2], value[3]}, 0};
    const struct excitation_options o = {.measured = &m, .scale = 2, .from = 0, .to = 99, .fade = 5};
    double worst[4] = {0};
    struct excitation e;

    for (int i = 0; i < KNOTS; i++) {
        x[i] = 0.25 * i;
        for (int k = 0; k < IRREGULARITY_QUANTITIES; k++)
            value[k][i] = amplitude[k] * sin(2 * acos(-1) * x[i] / (4 + k));
    }
    ok(excitation_new(&e, &o) == NULL, "a measured irregularity");
    for (double s = 10.03; s < 90; s += 0.1) {
        const struct excitation_at l = find(&e, s, 0), r = find(&e, s, 1);
        const double got[] = {(l.z + r.z) / 2, (l.y + r.y) / 2, r.z - l.z, r.y - l.y};
        for (int k = 0; k < 4; k++)
            worst[k] = fmax(worst[k], fabs(got[k] - 2 * amplitude[k] * sin(2 * acos(-1) * s / (4 + k))) / (2 * amplitude[k]));
    }
    for (int k = 0; k < 4; k++)
        near(worst[k], 0, 2e-4, irregularity_name[k]);
    near(slope_error(&e, 0.5, 98), 0, 1e-8, "slopes are those of height and line, also where it fades in");
    ok(find(&e, 0, 0).z == 0 && find(&e, 0, 1).y == 0 && find(&e, -5, 0).z == 0, "nothing at the start and before it");
    excitation_free(&e);
    ok(excitation_new(&e, &(struct excitation_options){.measured = &m, .scale = 1, .from = 0, .to = 101, .fade = 5}) != NULL,
       "one that ends before the run does is refused");
}

/* Integral of the density from 2 pi/longest to 2 pi/shortest, midpoints. */
static double variance(enum spectrum_level level, int quantity, double shortest, double longest)
{
    const double from = 2 * acos(-1) / longest, to = 2 * acos(-1) / shortest, dW = (to - from) / 100000;
    double sum = 0;

    for (int i = 0; i < 100000; i++)
        sum += spectrum_density(level, (enum irregularity_quantity)quantity, from + (i + 0.5) * dW) * dW;
    return sum;
}

/* Of Wc^2/((W^2 + Wr^2)(W^2 + Wc^2)), by parts of the fraction. */
static double level_integral(double shortest, double longest)
{
    const double c = 0.8246, r = 0.0206, from = 2 * acos(-1) / longest, to = 2 * acos(-1) / shortest;

    return c * c / (c * c - r * r) * ((atan(to / r) - atan(from / r)) / r - (atan(to / c) - atan(from / c)) / c);
}

enum { POINTS = 400000 };

static void spectrum(void)
{
    static double f[POINTS], g[POINTS], slope[POINTS];
    struct spectrum_waves waves = {SPECTRUM_HIGH, 3, 25, 2000, 1};

    near(variance(SPECTRUM_LOW, IRREGULARITY_LEVEL, 3, 25) / (4.032e-7 * level_integral(3, 25)), 1, 1e-6, "longitudinal level, low");
    near(variance(SPECTRUM_HIGH, IRREGULARITY_LEVEL, 3, 25) / (1.08e-6 * level_integral(3, 25)), 1, 1e-6, "and high");
    near(1e3 * sqrt(1.08e-6 * level_integral(3, 25)), 1.61, 0.005, "of 3 to 25 m, high, mm");
    for (int quantity = 0; quantity < IRREGULARITY_QUANTITIES; quantity++) {
        double square = 0, sum = 0, cross = 0, jump = 0;
        spectrum_series(&waves, (enum irregularity_quantity)quantity, -60, 0.00625, POINTS, f, slope);
        waves.seed = 2;
        spectrum_series(&waves, (enum irregularity_quantity)quantity, -60, 0.00625, POINTS, g, slope);
        waves.seed = 1;
        for (int i = 0; i < POINTS; i++) {
            sum += f[i];
            square += f[i] * f[i];
            cross += f[i] * g[i];
        }
        for (int i = 1; i + 1 < POINTS; i++)
            jump = fmax(jump, fabs((g[i + 1] - g[i - 1]) / 0.0125 - slope[i]));
        near(square / POINTS / variance(SPECTRUM_HIGH, quantity, 3, 25), 1, 0.01, irregularity_name[quantity]);
        near(sum / POINTS, 0, 2e-5, "with mean 0");
        near(cross / square, 0, 0.3, "two seeds have nothing to do with each other");
        near(jump, 0, 1e-7, "slopes are those of the series");
    }
}

int main(void)
{
    dips();
    joints();
    flats();
    measured();
    spectrum();
    return done();
}
