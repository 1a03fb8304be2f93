/* Surfaces between sections: a head that moves, against the exact one; bodies that begin and end; ends that grow. */
#include "tests/kernel/tap.h"

#include <stdlib.h>
#include <string.h>

#include "tools/profile/measured.h"

#define SPACING 2e-4     /* m */
#define TOP 0.02         /* m, half width of the level top */
#define EDGE 0.008       /* m, radius of its edges */
#define FLANK 0.02       /* m, below them */

static struct measured_options options = {.smoothing = 1e-3, .spacing = SPACING};

/* A head at y0, z0: flank, edge, level top, edge, flank, then `ledge` (m) outwards at the foot; points 0.25 mm apart. */
static void head_add(struct points *p, int64_t *room, double y0, double z0, double ledge)
{
    double quarter = EDGE * M_PI / 2, length = 2 * (FLANK + quarter + TOP) + ledge, foot = 2 * (FLANK + quarter + TOP);
    int64_t n = (int64_t)ceil(length / 2.5e-4);

    for (int64_t i = 0; i <= n; i++) {
        double s = length * (double)i / (double)n, m = fabs(fmin(s, foot) - foot / 2), side = s < foot / 2 ? -1 : 1, y, z;
        double a = fmin(fmax((m - TOP) / EDGE, 0), M_PI / 2);
        y = fmin(m, TOP) + EDGE * sin(a);
        z = EDGE * (1 - cos(a)) + fmax(m - TOP - quarter, 0);
        if (points_add(p, room, y0 + side * y + fmax(s - foot, 0), z0 + z, 1))
            exit(1);
    }
}

static void section_add(struct measured *m, double station, struct points *p)
{
    const char *why = measured_add(m, station, p, NULL, options.smoothing);

    if (why)
        ok(0, "section at %g m: %s", station, why);
    points_free(p);
}

/* How a right wing rail goes: away, and up. */
static double path_y(double s, double *slope)
{
    *slope = 0.05 + 0.1 * s;
    return 0.05 * s + 0.05 * s * s;
}

static double path_z(double s, double *slope)
{
    *slope = -0.02 - 0.01 * cos(4 * s);
    return -0.02 * s - 0.0025 * sin(4 * s);
}

static struct measured moving(double step)
{
    struct measured m = {0};
    double unused;

    for (int64_t i = 0; i <= lrint(1 / step); i++) {
        struct points p = {0};
        int64_t room = 0;
        head_add(&p, &room, path_y((double)i * step, &unused), path_z((double)i * step, &unused), 0);
        section_add(&m, (double)i * step, &p);
    }
    ok(!measured_join(&m, 0.02, "rail") && m.bodies == 1, "sections every %g m make one body", step);
    return m;
}

/* z at y by a cubic, and its fall; NAN beyond. */
static double outline_at(const struct outline *o, double y, double *fall)
{
    for (int64_t i = 1; i < o->n; i++)
        if (o->y[i - 1] <= y && y < o->y[i]) {
            double h = o->y[i] - o->y[i - 1], t = (y - o->y[i - 1]) / h, u = 1 - t;
            *fall = u * o->fall[i - 1] + t * o->fall[i];
            return u * u * (1 + 2 * t) * o->z[i - 1] + t * t * (1 + 2 * u) * o->z[i] + h * t * u * (u * o->slope[i - 1] - t * o->slope[i]);
        }
    return NAN;
}

static void outline_make(const struct loft *l, double s, struct outline *o)
{
    const char *why = loft_outline(l, s, SPACING, options.smoothing / 2, o);

    if (why)
        ok(0, "outline at %g m: %s", s, why);
}

/* Greatest errors of height and fall at mid-stations, where the surface is less than 1:1 steep. */
static void moving_errors(double step, double *height, double *fall)
{
    struct measured m = moving(step), still = {0};
    struct points p = {0};
    struct outline o, shape;
    int64_t room = 0;

    head_add(&p, &room, 0, 0, 0);
    section_add(&still, 0, &p);
    ok(!measured_join(&still, 0.02, "rail"), "the head itself");
    outline_make(&still.body[0], 0, &shape);
    *height = *fall = 0;
    for (double s = 2.5 * step; s < 1 - 2 * step; s += step) {
        double ys, zs, got, unused, y0 = path_y(s, &ys), z0 = path_z(s, &zs);
        outline_make(&m.body[0], s, &o);
        for (double y = -0.024; y < 0.024; y += 1e-3) {
            double z = outline_at(&o, y0 + y, &got), slope = (outline_at(&shape, y + 1e-5, &unused) - outline_at(&shape, y - 1e-5, &unused)) / 2e-5;
            *height = fmax(*height, fabs(z - z0 - outline_at(&shape, y, &unused)));
            *fall = fmax(*fall, fabs(got - zs + slope * ys));
        }
        outline_free(&o);
    }
    outline_free(&shape);
    measured_free(&m);
    measured_free(&still);
}

static void test_order(void)
{
    double height[2], fall[2];

    moving_errors(0.1, &height[0], &fall[0]);
    moving_errors(0.05, &height[1], &fall[1]);
    ok(height[0] < 1e-4 && height[0] / height[1] > 6, "height between sections: %.2g um off, %.2g um at half the distance", 1e6 * height[0],
       1e6 * height[1]);
    ok(fall[0] < 0.015 && fall[0] / fall[1] > 3, "fall: %.2g mm/m off, %.2g mm/m at half the distance", 1e3 * fall[0], 1e3 * fall[1]);
}

/* fall is dz/dx of the surface itself. */
static void test_fall(void)
{
    struct measured m = moving(0.025);
    double worst = 0, dx = 1e-3;      /* far enough for the points of the outlines not to show */

    for (double s = 0.03; s < 0.97; s += 0.047) {
        struct outline before, at, after;
        double fall, unused, slope, y0 = path_y(s, &slope);
        outline_make(&m.body[0], s - dx, &before);
        outline_make(&m.body[0], s, &at);
        outline_make(&m.body[0], s + dx, &after);
        for (double y = y0 - 0.024; y < y0 + 0.024; y += 1e-3) {
            outline_at(&at, y, &fall);
            worst = fmax(worst, fabs(fall - (outline_at(&after, y, &unused) - outline_at(&before, y, &unused)) / (2 * dx)));
        }
        outline_free(&before);
        outline_free(&at);
        outline_free(&after);
    }
    ok(worst < 1e-3, "fall against differences of the surface at fixed y: %.2g mm/m", 1e3 * worst);
    measured_free(&m);
}

/* A second head from 0.3 to 0.6 m beside the first, as a nose. */
static void test_bodies(void)
{
    struct measured m = {0};
    struct set set;

    for (int64_t i = 0; i <= 10; i++) {
        struct points p = {0};
        int64_t room = 0;
        if (i >= 3 && i <= 6)
            head_add(&p, &room, -0.1, 0.001 * (double)(6 - i), 0);
        head_add(&p, &room, 0.01 * (double)i, 0, 0);
        section_add(&m, 0.1 * (double)i, &p);
    }
    ok(!measured_join(&m, 0.02, "rail"), "two heads side by side");
    if (!ok(m.bodies == 2, "%lld bodies", (long long)m.bodies))
        return;
    ok(strcmp(m.body[0].name, "rail") == 0 && strcmp(m.body[1].name, "rail 2") == 0, "called %s and %s", m.body[0].name, m.body[1].name);
    near(m.body[1].section[0].station, 0.3, 1e-12, "the second begins where it is seen first");
    near(m.body[1].section[m.body[1].n - 1].station, 0.6, 1e-12, "and ends where it is seen last");
    options.every = 0.02;
    ok(!measured_set(&m, 1, &options, &set), "a set");
    ok(set.sections == 51 && set.polys == 51 + 16, "%lld sections, %lld outlines", (long long)set.sections, (long long)set.polys);
    options.every = 0;
    set_free(&set);
    measured_free(&m);
}

/* Between a section and one that reaches 40 mm further the head itself stays as it is. */
static void test_growth(void)
{
    struct measured m = {0};
    double worst = 0, fall, unused;

    for (int64_t i = 0; i < 6; i++) {
        struct points p = {0};
        int64_t room = 0;
        head_add(&p, &room, 0, 0, i < 3 ? 0 : 0.04);
        section_add(&m, 0.02 * (double)i, &p);
    }
    ok(!measured_join(&m, 0.05, "rail") && m.bodies == 1, "one body, whose end grows");
    struct outline at, between;
    outline_make(&m.body[0], 0.02, &at);
    outline_make(&m.body[0], 0.05, &between);
    for (double y = -0.025; y < 0.025; y += 1e-3) {
        worst = fmax(worst, fabs(outline_at(&between, y, &fall) - outline_at(&at, y, &unused)));
        worst = fmax(worst, fabs(fall));
    }
    ok(worst < 3e-6, "the head between them is off by %.2g um, its fall at most as many um/m", 1e6 * worst);
    outline_free(&at);
    outline_free(&between);
    measured_free(&m);
}

/* Heights 0 0 1 1 mm: between them nothing higher or lower. */
static void test_overshoot(void)
{
    struct measured m = {0};
    double least = 0, most = 0, fall;

    for (int64_t i = 0; i < 4; i++) {
        struct points p = {0};
        int64_t room = 0;
        head_add(&p, &room, 0, i < 2 ? 0 : -1e-3, 0);
        section_add(&m, 0.1 * (double)i, &p);
    }
    ok(!measured_join(&m, 0.02, "rail"), "a step");
    for (double s = 0; s <= 0.3; s += 0.005) {
        struct outline o;
        outline_make(&m.body[0], s, &o);
        double z = outline_at(&o, 0, &fall);
        least = fmin(least, z);
        most = fmax(most, z);
        outline_free(&o);
    }
    ok(least > -1e-3 - 1.01e-5 && most < 1.01e-5, "no overshoot by more than 10 um: from %.6f to %.6f mm", 1e3 * least, 1e3 * most);
    measured_free(&m);
}

int main(void)
{
    test_order();
    test_fall();
    test_bodies();
    test_growth();
    test_overshoot();
    return done();
}
