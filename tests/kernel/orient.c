/* Which way round a shape is, its kinks, the inclination of a rail and the measures of a flange, on shapes whose truth is known. */
#include "tests/kernel/tap.h"

#include <stdlib.h>
#include <string.h>

#include "tools/profile/dimensions.h"
#include "tools/profile/kinks.h"
#include "tools/profile/orient.h"
#include "tools/profile/section.h"

static const struct shape_kind fixed = {"", "fixed", 0, 1, 0, 0, 1, 0}, loose = {"", "loose", 0, 1, 1, 1, 0, 1};

static void shape_add(struct shape *s, double y, double z)
{
    static int64_t room;
    room = s->points.n ? room : 0;
    points_add(&s->points, &room, y, z, 1);
}

/* A rail head 72 mm wide: a crown of 300 mm, corners of 13 mm, faces 1:20, inclined by `cant`; worn by `worn` (m) at its gauge corner;
 * the field side ends `field` below the top.  y to the right, z down. */
static void rail_make(struct shape *s, double cant, double worn, double field)
{
    double c = cos(atan(cant)), w = sin(atan(cant));

    *s = (struct shape){.kind = &loose};
    for (int i = -400; i <= 400; i++) {
        double u = i / 400.0 * 0.06, a = fabs(u), z;
        if (a < 0.022)
            z = 0.3 - sqrt(0.09 - a * a);
        else if (a < 0.034)
            z = 0.3 - sqrt(0.09 - 0.022 * 0.022) + (a - 0.022) * 0.0735 + 13 * (a - 0.022) * (a - 0.022) * 4;
        else
            z = 0.0093 + (a - 0.034) * 1.2;
        z += u < -0.005 ? worn * fmin(1, (-0.005 - u) / 0.02) : 0;
        if (u > 0 && z > field)
            break;
        shape_add(s, u * c + z * w, z * c - u * w);
    }
}

/* A wheel: an elliptic flange 28 mm high and 30 mm wide, its face a straight line from 12 mm to 1 mm, tread 1:40 from y = -34 to 60 mm. */
static void wheel_make(struct shape *s)
{
    *s = (struct shape){.kind = &loose};
    for (int i = 0; i < 60; i++)
        shape_add(s, -0.0544 - 0.015 * cos(M_PI * (i + 0.5) / 60), 0.012 + 0.016 * sin(M_PI * (i + 0.5) / 60));
    for (int i = 1; i < 20; i++)
        shape_add(s, -0.0394 + 0.0054 * i / 20, 0.012 - 0.011 * i / 20);
    for (int i = 0; i <= 200; i++)
        shape_add(s, -0.034 + 0.094 * i / 200, 0.001 - 0.094 / 40 * i / 200);
}

static void shape_turn(struct shape *s, double y, double z, double shift)
{
    for (int64_t i = 0; i < s->points.n; i++) {
        s->points.y[i] = y * (s->points.y[i] + shift);
        s->points.z[i] *= z;
    }
}

static struct prof_text text_of(enum prof_part part)
{
    return (struct prof_text){.part = part, .gauge_depth = 0.014, .flange_back = 0.070};
}

static void test_wheel(void)
{
    struct prof_text t = text_of(PROF_WHEEL);
    struct shape s;
    struct orient o;

    for (int turn = 0; turn < 4; turn++) {
        wheel_make(&s);
        shape_turn(&s, turn & 1 ? -1 : 1, turn & 2 ? -1 : 1, 0);
        const char *why = orient_shape(&s, &t, &o);
        ok(!why && o.mirror_y == (turn & 1) && o.mirror_z == turn >> 1, "wheel, turn %d: the flange shows it", turn);
        shape_free(&s);
    }
    wheel_make(&s);
    shape_turn(&s, 1, 1, 0.070);
    ok(!orient_shape(&s, &t, &o), "y from the flange back");
    near(o.shift_y, -0.070, 1e-15, "moved to the running circle");
    shape_free(&s);
    wheel_make(&s);
    shape_turn(&s, 1, 1, 0.030);
    const char *why = orient_shape(&s, &t, &o);
    ok(why && strstr(why, "state shift_y"), "another origin: %s", why ? why : "read");
    shape_free(&s);
    wheel_make(&s);
    s.kind = &fixed;
    shape_turn(&s, -1, 1, 0);
    why = orient_shape(&s, &t, &o);
    ok(why && strstr(why, "state mirror_y"), "a kind's rule contradicted: %s", why ? why : "read");
    shape_free(&s);
    s = (struct shape){.kind = &loose};
    for (int i = 0; i < 50; i++)
        shape_add(&s, 1e-3 * i, 0);
    why = orient_shape(&s, &t, &o);
    ok(why && strstr(why, "state mirror_z"), "a flat wheel: %s", why ? why : "read");
    shape_free(&s);
}

static void rail_case(double worn, double field, double y, double z, int usual_y, const char *says, const char *what)
{
    struct prof_text t = text_of(PROF_RAIL);
    struct shape_kind k = loose;
    struct shape s;
    struct orient o;

    rail_make(&s, 0, worn, field);
    k.y_to_centre = usual_y;
    s.kind = &k;
    shape_turn(&s, y, z, 0);
    const char *why = orient_shape(&s, &t, &o);
    if (says)
        ok(why && strstr(why, says), "%s: %s", what, why ? why : "read");
    else
        ok(!why && o.mirror_z == (z < 0) && (worn + field >= 0.05 || o.mirror_y == (y < 0)), "%s: %s", what, why ? why : o.by_y);
    shape_free(&s);
}

static void test_rail(void)
{
    rail_case(0, 0.010, 1, 1, 1, NULL, "one side reaches the gauge depth");
    rail_case(0, 0.010, -1, -1, 0, NULL, "the same turned round");
    rail_case(0, 0.050, -1, -1, 1, NULL, "both sides alike");
    rail_case(0.004, 0.045, -1, -1, 1, NULL, "worn where its kind has the gauge side");
    rail_case(0.004, 0.045, 1, -1, 1, "state mirror_y", "worn on the other side");
    rail_case(0.0003, 0.045, -1, -1, 1, "state mirror_y", "a little worn there");
}

static void test_stated(void)
{
    struct prof_text t = text_of(PROF_RAIL);
    struct shape s;
    struct orient o;

    t.mirror_y = PROF_MIRROR_YES;
    t.mirror_z = PROF_MIRROR_NO;
    rail_make(&s, 0, 0.0003, 0.045);
    ok(!orient_shape(&s, &t, &o) && o.mirror_y && !o.mirror_z && strcmp(o.by_y, "stated") == 0, "what is stated counts");
    shape_free(&s);
    rail_make(&s, 0, 0, 0.05);
    for (int64_t i = 0; i < s.points.n; i++)
        s.points.z[i] = -s.points.z[i];
    const char *why = orient_shape(&s, &t, &o);
    ok(why && strstr(why, "a groove"), "a groove stays refused: %s", why ? why : "read");
    shape_free(&s);
}

static void test_cant(void)
{
    static const double cants[] = {0, 0.025, 0.05, -0.025};
    struct section_options o = {0, 0, 0.014, 0, 1e-4};
    struct section s;
    struct shape shape;

    for (int i = 0; i < 4; i++) {
        rail_make(&shape, cants[i], 0, 0.05);
        const char *why = section_make(&s, &shape.points, &o);
        near(why ? NAN : s.cant, cants[i], 2e-5, "inclination found");
        section_free(&s);
        shape_free(&shape);
    }
}

static void test_flange(void)
{
    struct section_options o = {1, 0, 0.014, 1e-3, 1e-4};
    struct section s;
    struct shape shape;
    struct dimensions c;

    wheel_make(&shape);
    ok(!section_make(&s, &shape.points, &o), "a wheel");
    double z0 = 0.001 - 0.034 / 40;                     /* at the running circle */
    double face = -0.0394 + 0.0054 * (0.002 - z0) / 0.011, above = -0.0544 + 0.015 * sqrt(1 - pow(0.014 / 0.016, 2));
    dimensions_wheel(&s.outline, 0.070, &c);
    near(c.flange_height, 0.028 - z0, 5e-6, "Sh");
    near(c.flange_thickness, 0.070 + face, 5e-5, "Sd");
    near(c.flange_slope, face - above, 5e-5, "qR");
    section_free(&s);
    shape_free(&shape);
}

static void test_kinks(void)
{
    static const double turns[] = {0.4, 0.6, -0.9};
    struct kinks k;
    struct shape s;

    for (int i = 0; i < 3; i++) {
        s = (struct shape){.kind = &loose};
        for (int j = -100; j <= 100; j++)
            shape_add(&s, 1e-4 * j, j < 0 ? 0 : 1e-4 * j * tan(turns[i]));
        kinks_find(&s.points, &k);
        ok(k.n == (fabs(turns[i]) > KINK_TURN), "a turn of %.1f rad: %lld kinks", turns[i], (long long)k.n);
        if (k.n) {
            near(k.turn[0], turns[i], 1e-9, "its angle");
            near(k.y[0], 0, 1e-12, "its place");
        }
        shape_free(&s);
    }
    s = (struct shape){.kind = &loose};
    for (int j = -140; j <= 140; j++)
        shape_add(&s, 5e-3 * sin(j / 100.0), 5e-3 * (1 - cos(j / 100.0)));
    kinks_find(&s.points, &k);
    ok(k.n == 0, "a radius of 5 mm is no kink");
    shape_free(&s);
}

int main(void)
{
    test_wheel();
    test_rail();
    test_stated();
    test_cant();
    test_flange();
    test_kinks();
    return done();
}
