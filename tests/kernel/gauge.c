/* Where rails and wheels stand: 60E1 upright at 753.5 mm, wheels at 750 mm; inclination; the overhang falls away. */
#include "tests/kernel/tap.h"

#include "formats/prof_text.h"
#include "tools/profile/cant.h"
#include "tools/profile/gauge.h"
#include "tools/profile/section.h"
#include "tools/profile/zones.h"

static void rail_make(struct section *s, double cant)
{
    struct prof_text t;
    struct points p;

    prof_text_read(&t, "data/profiles/60E1.yaml", NULL, 0, NULL);
    zones_points(t.zones.n, t.zones.item, 1, t.spacing, &p);
    ok(!section_make(s, &p, &(struct section_options){0, cant, 0.014, t.smoothing, t.spacing}), "60E1 with cant %g", cant);
    points_free(&p);
    prof_text_free(&t);
}

static void test_upright(void)
{
    struct section s;
    double deeper;

    rail_make(&s, 0);
    near(gauge_rail_position(s.gauge_face, 1.435), 0.7535, 5e-5, "60E1 stands upright with its centre at 753.5 mm");
    /* The arc R 13 round (23.016030, 14.949147) mm at 14 mm. */
    near(s.gauge_face, -(23.016030 + sqrt(169 - 0.949147 * 0.949147)) * 1e-3, 4e-6, "gauge face on the published arc");
    ok(gauge_face(&s.outline, 0.035, &deeper) != NULL, "a gauge measured below the end of the rail is refused");
    section_free(&s);
}

/* Inclined 1:40: the highest point is where the crown has slope 1/40, at R 300 / 40 on the field side. */
static void test_inclined(void)
{
    struct section s;
    int64_t top = 0;

    rail_make(&s, 0.025);
    for (int64_t i = 0; i < s.outline.n; i++)
        if (s.outline.z[i] < s.outline.z[top])
            top = i;
    near(s.outline.y[top], 300e-3 * 0.025, 6e-5, "1:40: the highest point lies 7.5 mm to the field side");
    near(s.outline.z[top], 0, 0, "1:40: heights count from it");
    ok(s.outline.z[0] > 0.016 && s.outline.slope[0] < 0, "1:40: the gauge face remains");
    section_free(&s);
    rail_make(&s, 0.06);
    near(s.outline.y[0], (-23.016030e-3 + 0.06 * 14.949147e-3) / hypot(1, 0.06) - 0.013, 6e-6,
         "1:16.7: the face overhangs and is cut at its innermost point, on the arc R 13");
    section_free(&s);
}

static void test_rotation(void)
{
    double y[] = {0, 0.03, -0.03}, z[] = {0.04, 0.0, 0.0}, angle = atan(0.05);

    cant_rotate(3, y, z, 0.05);
    near(y[0], 0.04 * sin(angle), 1e-15, "the foot goes to the field side");
    near(z[2], 0.03 * sin(angle), 1e-15, "the gauge side goes down");
    near(hypot(y[1], z[1]), 0.03, 1e-15, "lengths stay");
}

int main(void)
{
    test_upright();
    test_inclined();
    test_rotation();
    near(gauge_wheel_position(1.360, 0.070), 0.750, 1e-12, "running circles at 750 mm");
    return done();
}
