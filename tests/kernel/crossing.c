/* The crossings of the nominal turnouts 60E1-R760-1:15 and R300-1:9: the machined top of their wing rail, and the path of a rigid S1002
 * from the wing rail onto the nose by the project's own contact search.  Lengths along the track and angles go with the angle at which the
 * running edges cross, 1:16.3 and 1:10.2.
 *
 * Right side: u > 0 moves the wheel to the field side, its flange towards the rail. */
#include "tests/kernel/tap.h"

#include "tools/contact/search.h"
#include "tools/profile/gauge.h"
#include "tools/profile/turnout.h"
#include "tools/profile/zones.h"

#define STEP 0.02            /* m, of the stations searched at 1:16.26 */
#define AHEAD 54             /* of the stations, before the mathematical point */
#define SLOPE_OVER 2         /* steps before and behind the transfer over which slopes are taken */

enum { STATIONS = 121 };

static struct prof_text text;          /* of the turnout */
static struct section rail, wheel;
static struct plan plan;
static double point, sharper;          /* m, station of the mathematical point; angle there over that of 1:16.26 */

static void plan_make(void)
{
    plan = turnout_plan(&text.turnout, text.gauge);
    point = plan_separation_station(&plan, 0);
    sharper = 16.26 * (plan_separation(&plan, point + 1e-3) - plan_separation(&plan, point - 1e-3)) / 2e-3;
}

static void shape_make(const char *path, struct section *s)
{
    struct prof_text t;
    struct points p;

    ok(!prof_text_read(&t, path, NULL, 0, NULL) && !zones_points(t.zones.n, t.zones.item, t.symmetric, 1e-4, &p) &&
       !section_make(s, &p, &(struct section_options){t.part == PROF_WHEEL, 0, 0.014, 0.003, 2e-4}), "%s", path);
    points_free(&p);
    prof_text_free(&t);
}

static void wing_make(double share, struct outline *o)
{
    struct head_top top = {text.turnout.wing.level, text.turnout.wing.crown_radius};
    const char *why = head_wing(&rail, share, &top, &(struct head_options){text.turnout.wing.edge_radius, 0.003, 2e-4}, o);

    ok(!why, "a wing rail machined to %.0f %%%s%s", 1e2 * share, why ? ": " : "", why ? why : "");
}

static double height_at(const struct outline *o, double y)
{
    int64_t i = 1;

    while (i < o->n - 1 && o->y[i] < y)
        i++;
    return o->z[i - 1] + (o->z[i] - o->z[i - 1]) * (y - o->y[i - 1]) / (o->y[i] - o->y[i - 1]);
}

/* Between the plain rail and the machined one: convex, no corner sharper than its edge, field side untouched. */
static void test_head(void)
{
    double radius = text.turnout.wing.edge_radius;

    for (int share = 0; share <= 4; share++) {
        struct outline o;
        double falls = 0, sharpest = 0, jump = 0, field = 0, turn = 0;
        wing_make(share / 4.0, &o);
        for (int64_t i = 1; i < o.n; i++) {
            if (fabs(o.slope[i]) < 1)
                falls = fmin(falls, atan(o.slope[i]) - atan(o.slope[i - 1]));
            turn = fmax(turn, atan(o.slope[i]) - atan(o.slope[i - 1]));
            sharpest = fmax(sharpest, o.curvature[i]);
            jump = fmax(jump, fabs(o.curvature[i] - o.curvature[i - 1]));
            if (o.y[i] > 0 && o.slope[i] < 1)
                field = fmax(field, fabs(o.z[i] - height_at(&rail.outline, o.y[i])));
        }
        ok(falls > -1e-3, "its top is convex: its direction turns back by %.2g mrad at most", -1e3 * falls);
        ok(sharpest < 1.15 / radius, "its sharpest radius is %.1f mm", 1e3 / sharpest);
        ok(turn < 0.05 && jump < 0.3 / radius, "in 0.2 mm its direction turns by %.0f mrad and its curvature by %.0f 1/m at most", 1e3 * turn,
           jump);
        near(field, 0, 1e-5, "its field side is the plain rail's");
        if (share == 0)
            for (double y = -0.035; y < 0.035; y += 0.001)
                field = fmax(field, fabs(height_at(&o, y) - height_at(&rail.outline, y)));
        near(field, 0, 1e-5, "unmachined it is the plain rail");
        outline_free(&o);
    }
}

/* Seen from its own edge, the most a wing rail changes in height over `step` along the track. */
static double growth(double step)
{
    struct outline before = {0};
    double most = 0;

    for (double s = point - 0.8 / sharper; s < point + 0.8 / sharper; s += step / sharper) {
        struct outline o;
        double distance = fmax(turnout_wing(&text.turnout, &plan, s), 0);
        if (turnout_body(&text.turnout, &plan, &rail, text.smoothing, text.spacing, TURNOUT_SWITCH, s, &o))
            ok(0, "wing rail at %g m", s);
        outline_shift(&o, -distance, 0);
        for (double y = rail.gauge_face + 0.003; before.n && y < 0.03; y += 5e-4)
            most = fmax(most, fabs(height_at(&o, y) - height_at(&before, y)));
        outline_free(&before);
        before = o;
    }
    outline_free(&before);
    return most;
}

/* No step: over half the length it grows half as much. */
static void test_growth(void)
{
    double whole = growth(0.1), half = growth(0.05), quarter = growth(0.025);

    ok(half < 0.55 * whole && quarter < 0.55 * half, "the wing rail grows by %.2f mm at most in 0.1 m, %.2f mm in half of it, %.2f mm in a quarter",
       1e3 * whole, 1e3 * half, 1e3 * quarter);
}

struct path {
    double wing[STATIONS], nose[STATIONS];      /* m, height of the wheel on either, INFINITY where it does not touch */
    double at[STATIONS];                        /* m, contact on the wing rail behind its edge */
};

static void path_search(const struct search *s, const double *station, int64_t is, double u, struct path *p)
{
    struct search_contact c[SEARCH_MOST];
    int n = search_contacts(s, 0, lrint(u / s->gap.step), c);
    double distance = fmax(turnout_wing(&text.turnout, &plan, station[is]), 0);

    p->wing[is] = p->nose[is] = INFINITY;
    for (int i = 0; i < n; i++) {
        if (c[i].body == TURNOUT_NOSE)
            p->nose[is] = fmin(p->nose[is], c[i].at.gap);
        else if (c[i].at.gap < p->wing[is]) {
            p->wing[is] = c[i].at.gap;
            p->at[is] = c[i].at.y - rail.gauge_face - distance;
        }
    }
}

static void check_path(const char *route, double u, const double *station, const struct path *p)
{
    double low = -INFINITY, high = INFINITY, nearest = INFINITY, farthest = 0, steepest = 0;
    int64_t t = 0;

    while (t < STATIONS - 1 && p->wing[t] <= p->nose[t])
        t++;
    for (int64_t i = 0; i < STATIONS; i++) {
        double z = fmin(p->wing[i], p->nose[i]), distance = turnout_wing(&text.turnout, &plan, station[i]);
        low = fmax(low, z - p->wing[0]);
        high = fmin(high, z - p->wing[0]);
        if (i)
            steepest = fmax(steepest, fabs(z - fmin(p->wing[i - 1], p->nose[i - 1])) / (station[i] - station[i - 1]));
        if (distance > 0.026 && i < t) {
            nearest = fmin(nearest, p->at[i]);
            farthest = fmax(farthest, p->at[i]);
        }
    }
    double width = 1e3 * plan_separation(&plan, station[t]), falls = NAN, rises = NAN;
    if (t > SLOPE_OVER && t < STATIONS - SLOPE_OVER) {
        falls = 1e3 * (p->wing[t - 1] - p->wing[t - 1 - SLOPE_OVER]) / (station[t - 1] - station[t - 1 - SLOPE_OVER]);
        rises = -1e3 * (p->nose[t + SLOPE_OVER] - p->nose[t]) / (station[t + SLOPE_OVER] - station[t]);
    }
    ok(width > 19 && width < 29, "%s, u = %g mm: onto the nose at %.2f m, %.0f mm wide", route, 1e3 * u, station[t], width);
    ok(falls > 3 * sharper && rises > 1.5 * sharper && falls + rises > 5 * sharper && falls + rises < 10.7 * sharper,
       "it falls %.1f mrad, rises %.1f mrad: a kink of %.1f mrad", falls, rises, falls + rises);
    ok(nearest > 0.005 && farthest < 0.0125, "the wing rail carries it %.1f to %.1f mm from its edge", 1e3 * nearest, 1e3 * farthest);
    ok(high > -0.0015 && low < 0.0015, "it rides %.2f mm high to %.2f mm low beside the plain rail", -1e3 * high, 1e3 * low);
    ok(steepest < 8e-3 * sharper, "nowhere steeper than %.1f mrad: it does not drop", 1e3 * steepest);
}

static void test_path(const char *route)
{
    static const char *const wheels[] = {"wheel"};
    static const double us[] = {0.004, 0.0025, 0, -0.0025}, yaw = 0;
    double from = point - AHEAD * STEP / sharper;
    struct turnout_stations range = {from, from + (STATIONS - 1) * STEP / sharper, STEP / sharper};
    struct turnout_text t = text.turnout;
    struct set rails, one = {.bodies = 1, .body = wheels};
    struct prof rp = {.part = 'r', .side = 'r', .position = gauge_rail_position(rail.gauge_face, text.gauge)};
    struct prof wp = {.part = 'w', .side = 'r', .radius = 0.46, .position = gauge_wheel_position(1.360, 0.070)};
    struct outline o;
    struct search s;
    static struct path path[4];

    t.stations = (struct yaml_list){.n = 1, .item = &range};
    int made = !turnout_sections(&t, text.gauge, text.smoothing, text.spacing, turnout_switch_side(&t), &rail, &rails) &&
               !set_prof(&rails, 'r', &rp);
    ok(made && rp.sections == STATIONS, "%s: %d sections", route, (int)rp.sections);
    ok(!outline_new(&o, wheel.outline.n), "the wheel");
    for (int64_t i = 0; i < o.n; i++)
        o.y[i] = wheel.outline.y[i], o.z[i] = wheel.outline.z[i], o.slope[i] = wheel.outline.slope[i],
        o.curvature[i] = wheel.outline.curvature[i];
    ok(!set_section(&one, 0) && !set_body(&one, 0, &o) && !set_prof(&one, 'r', &wp) && !search_begin(&s, &wp, &rp, &yaw, 1, SEARCH_PLANE, 1e-4),
       "the search");
    for (int64_t i = 0; i < rp.sections; i++) {
        search_section(&s, &rp, i);
        for (int k = 0; k < 4; k++)
            path_search(&s, rp.station, i, us[k], &path[k]);
    }
    for (int k = 0; k < 4; k++)
        check_path(route, us[k], rp.station, &path[k]);
    search_free(&s);
    prof_free(&rp);
    prof_free(&wp);
    set_free(&rails);
    set_free(&one);
}

static void test_turnout(const char *path)
{
    ok(!prof_text_read(&text, path, NULL, 0, NULL), "%s", path);
    plan_make();
    test_head();
    test_growth();
    test_path("diverging");
    text.turnout.route = TURNOUT_THROUGH;
    plan_make();
    test_path("through");
    prof_text_free(&text);
}

int main(void)
{
    shape_make("data/profiles/60E1.yaml", &rail);
    shape_make("data/profiles/S1002.yaml", &wheel);
    test_turnout("data/turnouts/60E1-R760-1-15.yaml");
    test_turnout("data/turnouts/60E1-R300-1-9.yaml");
    section_free(&rail);
    section_free(&wheel);
    return done();
}
