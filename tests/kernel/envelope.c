/* What a rigid S1002 finds on its way through the nominal turnouts 60E1-R760-1:15 and R300-1:9, on both routes and over the play of its
 * wheelset: nothing in the way of its flange, a blade that hides beneath the stock rail, wheels carried over where a blade is strong.
 *
 * Right side: u > 0 moves the wheel to the field side, its flange towards the rail.  Sections in two dimensions, without yaw. */
#include "tests/kernel/tap.h"

#include "tools/profile/gauge.h"
#include "tools/profile/turnout.h"
#include "tools/profile/zones.h"

enum { US = 5 };
static const double u_of[US] = {-5e-3, -2.5e-3, 0, 2.5e-3, 5e-3};      /* m; the check rail leaves 2.5 mm towards the nose */

static struct prof_text text;          /* of the turnout */
static struct section rail, wheel;
static struct plan plan;

static void shape_make(const char *path, struct section *s)
{
    struct prof_text t;
    struct points p;

    ok(!prof_text_read(&t, path, NULL, 0, NULL) && !zones_points(t.zones.n, t.zones.item, t.symmetric, 1e-4, &p) &&
       !section_make(s, &p, &(struct section_options){t.part == PROF_WHEEL, 0, 0.014, 0.003, 2e-4}), "%s", path);
    points_free(&p);
    prof_text_free(&t);
}

static double height_at(const struct outline *o, double y)
{
    int64_t lo = 0, hi = o->n - 1;

    while (hi - lo > 1) {
        int64_t middle = (lo + hi) / 2;
        *(o->y[middle] <= y ? &lo : &hi) = middle;
    }
    return o->z[lo] + (o->z[hi] - o->z[lo]) * (y - o->y[lo]) / (o->y[hi] - o->y[lo]);
}

/* Heights of the running circle on each body, INFINITY where it lies beside the wheel, wheel displaced by u. */
static void heights(double s, double u, double height[TURNOUT_BODIES])
{
    double offset = gauge_wheel_position(1.360, 0.070) - gauge_rail_position(rail.gauge_face, text.gauge) + u;

    for (int body = 0; body < TURNOUT_BODIES; body++) {
        struct outline o;
        const char *why = turnout_body(&text.turnout, &plan, &rail, text.smoothing, text.spacing, body, s, &o);
        if (why)
            ok(0, "body %d at %g m: %s", body, s, why);
        height[body] = INFINITY;
        for (int64_t i = 0; i < o.n; i++)
            if (o.y[i] - offset >= wheel.outline.y[0] && o.y[i] - offset <= wheel.outline.y[wheel.outline.n - 1])
                height[body] = fmin(height[body], o.z[i] - height_at(&wheel.outline, o.y[i] - offset));
        outline_free(&o);
    }
}

static int carrier(const double height[TURNOUT_BODIES])
{
    int body = 0;

    for (int k = 1; k < TURNOUT_BODIES; k++)
        body = height[k] < height[body] ? k : body;
    return body;
}

/* Half a millimetre beneath what carries the wheel is out of reach: no approach is as deep. */
static void test_tip(const char *route)
{
    double least = INFINITY, tip = text.turnout.blade.tip, end = tip * sqrt(3);      /* three times as thick */

    for (double s = tip + 0.01; s < end; s += (end - tip) / 8)
        for (int k = 0; k < US; k++) {
            double height[TURNOUT_BODIES];
            heights(s, u_of[k], height);
            least = fmin(least, height[TURNOUT_SWITCH] - height[TURNOUT_STOCK]);
        }
    ok(least > 5e-4, "%s: up to %.1f mm thick the blade keeps %.1f mm below the wheel", route, 1e3 * plan_stock(&plan, end), 1e3 * least);
}

/* From the stock rail onto the switch rail. */
static void test_transfer(const char *route)
{
    for (int k = 0; k < US - 1; k++) {
        double s = text.turnout.blade.tip, height[TURNOUT_BODIES], before = NAN, drop = 0;
        int changes = 0, last = TURNOUT_STOCK;
        double at = NAN, step = text.turnout.blade.tip / 30;
        for (; plan_stock(&plan, s) < 0.08; s += step) {
            heights(s, u_of[k], height);
            int now = carrier(height);
            double z = height[now];
            at = now != last ? s : at;
            changes += now != last;
            last = now;
            drop = isnan(before) ? 0 : fmax(drop, fabs(z - before));
            before = z;
        }
        ok(changes == 1 && plan_stock(&plan, at) > 0.018 && plan_stock(&plan, at) < 0.032 && drop < 6e-4,
           "%s, u = %g mm: onto a blade %.1f mm thick at %.2f m, in steps of %.0f mm never by more than %.2f mm", route, 1e3 * u_of[k],
           1e3 * plan_stock(&plan, at), at, 1e3 * step, 1e3 * drop);
    }
}

/* Beside the plain rail under the same wheel. */
static void test_way(const char *route)
{
    double plain[US], height[TURNOUT_BODIES], point = plan_separation_station(&plan, 0);

    for (int k = 0; k < US; k++) {
        heights(-1, u_of[k], height);
        plain[k] = height[TURNOUT_STOCK];
    }
    for (int k = 0; k < US; k++) {
        double high = 0, low = 0, at = NAN;
        for (double s = 0; s < text.turnout.length; s += s > point - 1 && s < point + 1.5 ? 0.02 : s < 0.2 * text.turnout.length ? 0.1 : 0.5) {
            if (s > point - 1 && s < point + 1.5 && u_of[k] > 0.0025)
                continue;
            heights(s, u_of[k], height);
            double z = height[carrier(height)] - plain[k];
            at = z < high ? s : at;
            high = fmin(high, z);
            low = fmax(low, z);
        }
        ok(high > -1.3e-3 && low < 2e-3, "%s, u = %g mm: lifted by %.2f mm at most, at %.2f m, let down by %.2f mm", route, 1e3 * u_of[k], -1e3 * high,
           at, 1e3 * low);
    }
}

/* Between nose and wing rail stays the flange's way; at its end it is wider. */
static void test_flangeway(const char *route)
{
    double point = plan_separation_station(&plan, 0), end = point + text.turnout.wing.end, least = INFINITY, widest = 0;

    for (int k = 0; k <= 50; k++) {
        double s = point + (end - point) * k / 50, way = turnout_wing(&text.turnout, &plan, s) - plan_separation(&plan, s);
        least = fmin(least, way);
        widest = fmax(widest, way);
    }
    near(least, text.turnout.wing.flangeway, 1e-12, "the flangeway along the nose");
    ok(fabs(widest - text.turnout.wing.opening) < 1e-9, "%s: opens to %.1f mm at the wing rail's end", route, 1e3 * widest);
}

static void test_turnout(const char *path)
{
    static const char *const routes[] = {"diverging", "through"};

    ok(!prof_text_read(&text, path, NULL, 0, NULL), "%s", path);
    for (int through = 0; through < 2; through++) {
        text.turnout.route = through ? TURNOUT_THROUGH : TURNOUT_DIVERGING;
        plan = turnout_plan(&text.turnout, text.gauge);
        test_tip(routes[through]);
        test_transfer(routes[through]);
        test_way(routes[through]);
        test_flangeway(routes[through]);
    }
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
