/* The nominal turnout 60E1-R760-1:15: its plan against closed forms and published offsets, its bodies against the plan, and the path
 * of a rigid S1002 over both routes. */
#include "tests/kernel/tap.h"

#include "tools/profile/gauge.h"
#include "tools/profile/turnout.h"
#include "tools/profile/zones.h"

static struct prof_text text;          /* of the turnout */
static struct section rail, wheel;
static struct plan plan;

static void shape_make(const char *path, struct section *s, double spacing)
{
    struct prof_text t;
    struct points p;

    ok(!prof_text_read(&t, path, NULL, 0, NULL) && !zones_points(t.zones.n, t.zones.item, t.symmetric, 1e-4, &p) &&
       !section_make(s, &p, &(struct section_options){t.part == PROF_WHEEL, 0, 0.014, 0.003, spacing}), "%s", path);
    points_free(&p);
    prof_text_free(&t);
}

/* Distances along and across the straight track as a drawing gives them: x of the diverging running edge, y of it. */
static double edge_station(double x)
{
    return plan.radius * asin(x / (plan.radius + plan.gauge / 2));
}

static void test_plan(void)
{
    /* x m, separation mm of the running edges across the straight track, R = 760 m, gauge 1435 mm. */
    static const double edges[][2] = {{45.974, -44.5}, {46.048, -40}, {46.377, -20}, {46.703, 0}, {46.866, 10}, {47.027, 20},
                                      {47.189, 30}, {47.349, 40}, {47.509, 50}, {47.828, 70}, {48.144, 90}};
    static const double offsets[][2] = {{1, 0.7}, {2, 2.6}, {3, 5.9}, {4, 10.5}, {5, 16.4}, {6, 23.7}, {8, 42.1}, {10, 65.8},
                                        {12, 94.7}, {15, 148}, {20, 263}, {25, 411}, {30, 592}, {40, 1053}};
    double worst = 0, phi = 2 * atan(sqrt(plan.gauge / (2 * plan.radius)));

    near(plan.radius * plan.angle, 50.592, 1e-3, "the arc is 50.592 m long");
    near(plan.radius * tan(plan.angle / 2), 25.3052, 1e-4, "tangent length 25.305 m, as the drawing's 25 305 mm");
    near(plan_separation_station(&plan, 0), plan.radius * phi, 1e-9, "edges meet at R phi, tan^2(phi/2) = gauge/2R");
    near((plan.radius + plan.gauge / 2) * sin(phi), 46.703, 1e-3, "the mathematical point is at x = 46.703 m of the straight track");
    near(tan(phi), 1 / 16.26, 1e-5, "where the edges cross at 1:16.26");
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++)
        worst = fmax(worst, fabs(1e3 * plan_separation(&plan, edge_station(edges[i][0])) - edges[i][1]));
    near(worst, 0, 0.25, "separations of the edges within 0.25 mm of the table, rounded to mm in x");
    worst = 0;
    for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++)
        worst = fmax(worst, (fabs(1e3 * plan_stock(&plan, offsets[i][0]) - offsets[i][1]) - (i < 9 ? 0.06 : 0.6)) / offsets[i][1]);
    /* Beyond the rounding of the table: across the curve instead of across the straight, 1/cos(s/R). */
    near(worst, 0, 2.5e-3, "offsets of the stock rail as tabulated, to the rounding and 1/cos(s/R)");
    near(plan_stock(&plan, -3), 0, 0, "before the front the stock rail is the running rail");
}

/* Both routes see the same crossing: at the same place of the ground the separations differ by second order only. */
static void test_routes(void)
{
    struct plan through = plan;
    double worst = 0;

    through.diverging = 0;
    near(plan_separation_station(&through, 0), 46.703, 1e-3, "through route: the point at 46.703 m");
    for (double s = 0; s < 54; s += 0.5) {
        /* The diverging edge in ground axes, from the closed form. */
        double r = plan.radius + plan.gauge / 2, x = r * sin(s / plan.radius);
        double y = plan.radius - r * cos(s / plan.radius) - plan.gauge / 2;
        if (s < plan.radius * plan.angle)
            worst = fmax(worst, fabs(plan_separation(&through, x) - y));
    }
    near(worst, 0, 1e-12, "through route: the nose's edge is the circle R + gauge/2");
    near(plan_stock(&through, 10), 100 / (2 * (plan.radius - plan.gauge / 2)), 1e-5, "through route: its stock rail is the curved one");
    near(plan_stock(&through, 60) - plan_stock(&through, 59), 1 / 15.0, 1e-12, "straight at 1:15 behind the arc");
}

/* First and last y at which an outline is at most this deep. */
static void span(const struct outline *o, double depth, double *from, double *to)
{
    *from = *to = NAN;
    for (int64_t i = 0; i < o->n; i++)
        if (o->z[i] <= depth) {
            if (isnan(*from))
                *from = o->y[i];
            *to = o->y[i];
        }
}

static double top_of(const struct outline *o)
{
    double top = INFINITY;
    for (int64_t i = 0; i < o->n; i++)
        top = fmin(top, o->z[i]);
    return top;
}

static void body_at(int body, double s, struct outline *o)
{
    const char *why = turnout_body(&text.turnout, &plan, &rail, text.smoothing, text.spacing, body, s, o);
    if (why)
        ok(0, "body %d at %g m: %s", body, s, why);
}

/* The blade is as thick as the stock rail has left, its running edge where the gauge is measured, and never in the stock rail. */
static void test_blade(void)
{
    double edge = 0, thickness = 0, clearance = INFINITY, before = INFINITY, rises = 0;

    for (double s = 2; s < 10; s += 0.5) {
        struct outline blade, stock;
        double from, to, top, stock_from, stock_to;
        body_at(TURNOUT_SWITCH, s, &blade);
        body_at(TURNOUT_STOCK, s, &stock);
        span(&blade, 0.0142, &from, &to);
        if (s > 5)
            edge = fmax(edge, fabs(from - rail.gauge_face));
        span(&stock, blade.z[blade.n - 1], &stock_from, &stock_to);
        thickness = fmax(thickness, fabs(blade.y[blade.n - 1] - (rail.gauge_face + plan_stock(&plan, s))));
        clearance = fmin(clearance, stock_from - blade.y[blade.n - 1]);
        top = top_of(&blade);
        rises += top > before + 1e-5;
        before = top;
        outline_free(&blade);
        outline_free(&stock);
    }
    near(edge, 0, 2e-4, "blade: running edge at the gauge face, 14 mm below the top");
    near(thickness, 0, 4e-4, "blade: as thick as the stock rail's offset");
    ok(clearance > -2e-4, "blade: does not enter the stock rail (%.3f mm)", 1e3 * clearance);
    near(rises, 0, 0, "blade: its top only rises from the tip on");
}

static void test_nose(void)
{
    double worst = 0, edge = 0, before = INFINITY, sinks = 0;

    for (double w = 0.012; w < 0.075; w += 0.003) {
        struct outline nose;
        double s = plan_separation_station(&plan, w), from, to, top;
        body_at(TURNOUT_NOSE, s, &nose);
        span(&nose, 0.0142, &from, &to);
        worst = fmax(worst, w < 0.0719 ? fabs(to - from - w) : 0);
        edge = fmax(edge, fabs(from - rail.gauge_face));
        top = top_of(&nose);
        sinks += top > before + 1e-5;
        before = top;
        outline_free(&nose);
    }
    near(worst, 0, 4e-4, "nose: as wide as the edges are apart, 14 mm below the top");
    near(edge, 0, 2e-4, "nose: right edge at the gauge face");
    near(sinks, 0, 0, "nose: its top only rises");
    near(before, 0, 1e-7, "nose: the plain rail in the end");
}

static int mirrored(const struct prof *l, const struct prof *r)
{
    int same = l->polys == r->polys && l->points == r->points && l->sections == r->sections && l->position == -r->position;

    for (int64_t i = 0; same && i < l->polys; i++)
        for (int64_t a = l->poly_first[i], b = l->poly_first[i + 1] - 1; b >= l->poly_first[i]; a++, b--)
            same &= l->y[a] == -r->y[b] && l->z[a] == r->z[b] && l->slope[a] == -r->slope[b] && l->curvature[a] == r->curvature[b] &&
                    l->fall[a] == r->fall[b];
    return same;
}

static void side_make(int hand, char side, struct prof *p)
{
    struct set set;
    struct turnout_text t = text.turnout;

    t.hand = hand;
    t.check.body = 1;
    *p = (struct prof){.position = 0.75};
    const char *why = turnout_sections(&t, text.gauge, text.smoothing, text.spacing, side, &rail, &set);
    ok(!why && !set_prof(&set, side, p), "%s-hand, side %c: %d sections%s%s", hand == TURNOUT_RIGHT ? "right" : "left", side, (int)set.sections,
       why ? ", " : "", why ? why : "");
    set_free(&set);
}

/* A left-hand turnout is the mirror image of a right-hand one, bit for bit, side by side. */
static void test_mirror(void)
{
    struct prof right[2], left[2];

    ok(turnout_switch_side(&text.turnout) == 'l', "a right-hand turnout has switch rail and nose on the left when diverging");
    for (int k = 0; k < 2; k++) {
        side_make(TURNOUT_RIGHT, k ? 'r' : 'l', &right[k]);
        side_make(TURNOUT_LEFT, k ? 'l' : 'r', &left[k]);
    }
    ok(mirrored(&right[0], &left[0]), "the sides of switch and crossing: y and slope change sign, z, curvature and fall stay");
    ok(mirrored(&left[1], &right[1]), "the sides of the check rail");
    ok(right[0].sections >= 30 && right[0].station[0] == 0 && right[0].station[right[0].sections - 1] == 54.2, "from 0 to 54.2 m");
    for (int k = 0; k < 2; k++) {
        prof_free(&right[k]);
        prof_free(&left[k]);
    }
}

/* The other side: one plain rail, and where it is a body the check rail in sections of its own. */
static void test_check_rail(void)
{
    const struct yaml_nums *f = &text.turnout.check.flangeway;
    double point = plan_separation_station(&plan, 0), worst = 0, gap = 0, fall = 0;
    struct set far;
    struct prof r;

    turnout_sections(&text.turnout, text.gauge, text.smoothing, text.spacing, 'r', &rail, &far);
    ok(far.sections == 1 && far.polys == 1, "unless the check rail is a body the right side has one section of one rail");
    set_free(&far);
    side_make(TURNOUT_RIGHT, 'r', &r);
    ok(r.bodies == 2 && r.sections > f->n / 2 + 2, "the check rail stands in %d of %d sections", (int)(r.polys - r.sections), (int)r.sections);
    for (int64_t i = 0; i < r.polys; i++) {
        double s = r.station[r.poly_section[i]];
        int64_t j = r.poly_first[i], last = r.poly_first[i + 1] - 1;
        if (r.poly_body[i] != 1)
            continue;
        while (j < last && r.z[j] < 0.014)
            j++;
        double y = r.y[j - 1] + (r.y[j] - r.y[j - 1]) * (0.014 - r.z[j - 1]) / (r.z[j] - r.z[j - 1]), x = s - point;
        double straight = fabs(x) < 1 ? rail.gauge_face - y - 0.040 : 0;
        worst = fmax(worst, fabs(straight));
        gap = fmax(gap, rail.gauge_face - y);
        fall = fmax(fall, fabs(x) < 1 ? fabs(r.fall[last]) : 0);
        if (i == r.polys - 2 || s == point + f->x[0])
            near(rail.gauge_face - y, 0.065, 1e-9, "its flare opens to 65 mm");
        ok(r.z[r.poly_first[i]] == -0.020 && r.slope[last] <= 60 && r.slope[last] > 19, "at %.2f m 20 mm above the rail, its face steep", s);
    }
    near(worst, 0, 1e-9, "beside the nose its flangeway is 40 mm: 1395 mm to the nose's running edge");
    near(fall, 0, 0, "there it does not fall");
    prof_free(&r);
}

/* Nose and flangeway are the same steel on both routes: as wide at the same distance from the mathematical point, one mirrored in the other. */
static void test_steel(void)
{
    struct plan through = plan;
    double worst = 0, wing = 0, shape = 0, middle;
    struct outline nose;

    through.diverging = 0;
    double point = plan_separation_station(&plan, 0), other = plan_separation_station(&through, 0);
    for (double x = -0.7; x < 1.5; x += 0.1) {
        worst = fmax(worst, fabs(plan_separation(&plan, point + x) - plan_separation(&through, other + x)));
        wing = fmax(wing, fabs(turnout_wing(&text.turnout, &plan, point + x) - turnout_wing(&text.turnout, &through, other + x)));
    }
    ok(worst < 2e-4 && wing < 2e-4, "through and diverging: nose within %.3f mm, wing within %.3f mm of one another", 1e3 * worst, 1e3 * wing);
    body_at(TURNOUT_NOSE, plan_separation_station(&plan, 0.030), &nose);
    middle = rail.gauge_face + 0.015;
    for (int64_t i = 0; i < nose.n; i++)
        if (fabs(nose.slope[i]) < 3)
            for (int64_t j = 1; j < nose.n; j++)
                if (nose.y[j - 1] <= 2 * middle - nose.y[i] && nose.y[j] > 2 * middle - nose.y[i]) {
                    double t = (2 * middle - nose.y[i] - nose.y[j - 1]) / (nose.y[j] - nose.y[j - 1]);
                    shape = fmax(shape, fabs(nose.z[j - 1] + t * (nose.z[j] - nose.z[j - 1]) - nose.z[i]));
                }
    ok(shape < 5e-6, "the nose 30 mm wide is its own mirror image to %.1f um", 1e6 * shape);
    outline_free(&nose);
}

static double height_at(const struct outline *o, double y)
{
    int64_t lo = 0, hi = o->n - 1;
    if (y < o->y[0] || y > o->y[hi])
        return INFINITY;
    while (hi - lo > 1) {
        int64_t middle = (lo + hi) / 2;
        *(o->y[middle] <= y ? &lo : &hi) = middle;
    }
    return o->z[lo] + (o->z[hi] - o->z[lo]) * (y - o->y[lo]) / (o->y[hi] - o->y[lo]);
}

/* z of the running circle of a centred rigid wheel, and the body that carries it. */
static double wheel_height(double s, int *carrier)
{
    double least = INFINITY, offset = gauge_wheel_position(1.360, 0.070) - gauge_rail_position(rail.gauge_face, 1.435);

    for (int body = 0; body < TURNOUT_BODIES; body++) {
        struct outline o;
        body_at(body, s, &o);
        for (int64_t i = 0; i < o.n; i++) {
            double z = o.z[i] - height_at(&wheel.outline, o.y[i] - offset);
            if (isfinite(z) && z < least) {
                least = z;
                *carrier = body;
            }
        }
        outline_free(&o);
    }
    return least;
}

static void test_path(const char *route)
{
    int carrier = 0, before = 0, changes = 0;
    double low = -INFINITY, high = INFINITY, at[4] = {0};

    for (double s = 0; s <= 54.2; s += s > 45 && s < 49 ? 0.02 : 0.1) {
        double z = wheel_height(s, &carrier);
        if (carrier != before && changes < 4)
            at[changes++] = s;
        before = carrier;
        low = fmax(low, z);
        high = fmin(high, z);
    }
    ok(changes == 2, "%s: the wheel changes rails twice: onto the switch rail, onto the nose", route);
    ok(at[0] > 4 && at[0] < 8, "onto the switch rail at %.1f m, a blade %.0f mm thick", at[0], 1e3 * plan_stock(&plan, at[0]));
    ok(at[1] > 46.8 && at[1] < 47.4, "onto the nose at %.2f m, %.0f mm wide", at[1], 1e3 * plan_separation(&plan, at[1]));
    ok(low < 0.002 && high > -0.002, "the path stays within 2 mm: %.2f to %.2f mm", 1e3 * high, 1e3 * low);
}

int main(void)
{
    shape_make("data/profiles/60E1.yaml", &rail, 2e-4);
    shape_make("data/profiles/S1002.yaml", &wheel, 2e-4);
    ok(!prof_text_read(&text, "data/turnouts/60E1-R760-1-15.yaml", NULL, 0, NULL), "the turnout's input");
    plan = turnout_plan(&text.turnout, text.gauge);
    test_plan();
    test_routes();
    test_blade();
    test_nose();
    test_mirror();
    test_check_rail();
    test_steel();
    test_path("diverging");
    plan.diverging = 0;
    test_path("through");
    section_free(&rail);
    section_free(&wheel);
    prof_text_free(&text);
    return done();
}
