/* The published shapes S1002 and 60E1: continuous at the borders of their zones, and the dimensions the standards name. */
#include "tests/kernel/tap.h"

#include <stdlib.h>

#include "formats/prof_text.h"
#include "tools/profile/section.h"
#include "tools/profile/zones.h"

static double step_of(const struct prof_text *t, int slope)
{
    const struct prof_zone *z = t->zones.item;
    double worst = 0;

    for (int64_t i = 1; i < t->zones.n; i++) {
        double y = z[i].from;
        worst = fmax(worst, slope ? fabs(atan(zone_slope(&z[i], y)) - atan(zone_slope(&z[i - 1], y)))
                                  : fabs(zone_height(&z[i], y) - zone_height(&z[i - 1], y)));
    }
    return worst;
}

/* Height of an outline at y, and the first y from the left where it is as deep as z. */
static double outline_height(const struct outline *o, double y)
{
    int64_t i = 1;
    while (i < o->n - 1 && o->y[i] < y)
        i++;
    return o->z[i - 1] + (o->z[i] - o->z[i - 1]) * (y - o->y[i - 1]) / (o->y[i] - o->y[i - 1]);
}

static const char *section_of(const struct prof_text *t, struct section *s)
{
    struct section_options o = {t->part == PROF_WHEEL, t->cant, t->gauge_depth, t->smoothing, t->spacing};
    struct points p;
    const char *why = zones_points(t->zones.n, t->zones.item, t->symmetric, t->spacing, &p);

    if (!why)
        why = section_make(s, &p, &o);
    points_free(&p);
    return why;
}

/* Greatest distance of an outline from the zones it was made of, along the normal, over from < y < to. */
static double departure(const struct prof_text *t, const struct outline *o, double from, double to)
{
    double worst = 0;

    for (int64_t i = 0; i < o->n; i++) {
        const struct prof_zone *z = t->zones.item;
        if (o->y[i] <= from || o->y[i] >= to)
            continue;
        while (o->y[i] > z->to)
            z++;
        worst = fmax(worst, fabs(o->z[i] - zone_height(z, o->y[i])) / hypot(1, o->slope[i]));
    }
    return worst;
}

static void test_s1002(void)
{
    struct prof_text t;
    struct section s;
    double lowest = 0;

    ok(!prof_text_read(&t, "data/profiles/S1002.yaml", NULL, 0, NULL) && !section_of(&t, &s), "S1002 can be read");
    near(step_of(&t, 0), 0, 2e-7, "S1002: zones meet within 0.2 um");
    near(step_of(&t, 1), 0, 1e-5, "S1002: zones meet at the same angle within 1e-5 rad");
    for (int64_t i = 0; i < s.outline.n; i++)
        lowest = fmax(lowest, s.outline.z[i]);
    near(outline_height(&s.outline, 0), 0, 1e-9, "S1002: zero at the running circle");
    near(lowest, 0.028, 2e-6, "S1002: flange 28 mm high");
    /* The thickness is measured 10 mm below the running circle, from the flange back at -70. */
    double face = -0.0375;
    for (int k = 0; k < 50; k++)
        face -= (outline_height(&s.outline, face) - 0.010) / -2.7;
    near(face + 0.070, 0.0325, 2e-5, "S1002: flange 32.5 mm thick");
    near(atan(zone_slope((struct prof_zone *)t.zones.item + 3, -0.039)), -70 * M_PI / 180, 1e-4, "S1002: flange at 70 degrees");
    near(departure(&t, &s.outline, -0.0695, 0.060), 0, 3e-6, "S1002: the smoothed curve departs less than 3 um, but at the flange back");
    near(outline_height(&s.outline, 0.060), -2.6357e-3, 1e-6, "S1002: field end of the published table");
    section_free(&s);
    prof_text_free(&t);
}

static void test_60e1(void)
{
    struct prof_text t;
    struct section s;

    ok(!prof_text_read(&t, "data/profiles/60E1.yaml", NULL, 0, NULL) && !section_of(&t, &s), "60E1 can be read");
    near(step_of(&t, 0), 0, 5e-9, "60E1: zones meet within 5 nm");
    near(step_of(&t, 1), 0, 5e-4, "60E1: zones meet at the same angle within 0.5 mrad");
    near(zone_height((struct prof_zone *)t.zones.item + 2, 0.036), 14.3e-3, 5e-6, "60E1: 72 mm wide 14.3 mm below the top");
    near(s.residual.worst, 0, 1e-5, "60E1: the smoothed curve departs less than 10 um from the arcs");
    double even = 0, falls = 0;
    for (int64_t i = 0; i < s.outline.n; i++) {
        int64_t j = s.outline.n - 1 - i;
        even = fmax(even, fabs(s.outline.y[i] + s.outline.y[j]) + fabs(s.outline.z[i] - s.outline.z[j]));
        falls += i && s.outline.y[i] <= s.outline.y[i - 1];
    }
    /* Of two points nearly the same at a border the first goes on: 5 nm apart, and not mirrored. */
    near(even, 0, 5e-9, "60E1: symmetric");
    near(falls, 0, 0, "60E1: y increases strictly");
    ok(s.outline.z[0] > 0.016, "60E1: the gauge face goes deeper than 16 mm");
    section_free(&s);
    prof_text_free(&t);
}

int main(void)
{
    test_s1002();
    test_60e1();
    return done();
}
