/* How fast the rails of the turnout fall along the track: against closed forms where a body only moves, against the heights of sections
 * apart where it is machined, and over the step of the differences. */
#include "tests/kernel/tap.h"

#include "tools/profile/fall.h"
#include "tools/profile/turnout.h"
#include "tools/profile/zones.h"

#define H 1e-3               /* m, step of the differences */

static struct prof_text text;
static struct section rail;
static struct plan plan;

static void rail_make(void)
{
    struct prof_text t;
    struct points p;

    ok(!prof_text_read(&t, "data/profiles/60E1.yaml", NULL, 0, NULL) && !zones_points(t.zones.n, t.zones.item, t.symmetric, 1e-4, &p) &&
       !section_make(&rail, &p, &(struct section_options){0, 0, 0.014, 0.003, 2e-4}), "the rail");
    points_free(&p);
    prof_text_free(&t);
}

static void body_make(int body, double s, double h, struct outline *o)
{
    const char *why = turnout_body(&text.turnout, &plan, &rail, text.smoothing, text.spacing, body, s, o);

    if (!why)
        why = turnout_fall(&text.turnout, &plan, &rail, text.smoothing, text.spacing, body, s, h, o);
    if (why)
        ok(0, "body %d at %g m: %s", body, s, why);
}

/* Change of a distance with s. */
static double rate(double (*distance)(const struct plan *, double), double s)
{
    return (distance(&plan, s + 1e-4) - distance(&plan, s - 1e-4)) / 2e-4;
}

/* Largest fall beside -(dz/dy) dy/ds - up, over what is flatter than `steepest`, and over that slope. */
static double moved_error(const struct outline *o, double speed, double up, double steepest)
{
    double worst = 0;

    for (int64_t i = 0; i < o->n; i++)
        if (fabs(o->slope[i]) < steepest)
            worst = fmax(worst, fabs(o->fall[i] + o->slope[i] * speed + up) / (1 + fabs(o->slope[i])));
    return worst;
}

static void test_stock(void)
{
    double worst = 0, most = 0, form = 0;

    for (double s = 0.5; s < 14; s += 0.5) {
        struct outline o;
        double phi = s / plan.radius, speed = sin(phi) * (1 + plan.gauge / 2 / plan.radius) / pow(cos(phi), 2);
        body_make(TURNOUT_STOCK, s, H, &o);
        worst = fmax(worst, moved_error(&o, speed, 0, 60));
        form = fmax(form, fabs(speed - s / plan.radius) / speed);
        for (int64_t i = 0; i < o.n; i++)
            most = fmax(most, fabs(o.fall[i]));
        outline_free(&o);
    }
    ok(most > 0.3, "stock rail: its gauge side falls by up to %.2f", most);
    near(worst, 0, 2e-6, "stock rail: -(dz/dy) dy/ds of its curve, over 1 + |dz/dy|");
    near(form, 0, 1.5e-3, "which is s/R but for gauge/2R and the second order");
}

static void test_plain(void)
{
    static const struct { int body; double s; } where[] = {{TURNOUT_STOCK, -2}, {TURNOUT_PLAIN, 20}, {TURNOUT_SWITCH, 20}, {TURNOUT_SWITCH, 45},
                                                           {TURNOUT_NOSE, 50}};
    for (size_t k = 0; k < sizeof where / sizeof *where; k++) {
        struct outline o;
        double worst = 0;
        body_make(where[k].body, where[k].s, H, &o);
        for (int64_t i = 0; i < o.n; i++)
            worst = fmax(worst, fabs(o.fall[i]));
        ok(o.n && worst == 0, "body %d at %g m does not fall", where[k].body, where[k].s);
        outline_free(&o);
    }
}

/* The slope where chords over a and b meet, as Fritsch and Butland (1984) weigh them: 1/m is a mean of theirs. */
static double weighed(double a, double before, double b, double after)
{
    double share = (a + 2 * b) / (3 * (a + b));

    return 1 / (share / before + (1 - share) / after);
}

/* Slope of the cubic over a chord, at share t of it, between the slopes of its ends. */
static double cubic_slope(double chord, double begin, double end, double t)
{
    return 6 * t * (1 - t) * chord + (1 - t) * (1 - 3 * t) * begin + t * (3 * t - 2) * end;
}

/* Machined in full, the wing rail moves as a whole, and rises as its table says: 1.12 mm over 56 mm, 0.18 mm over 24 mm, level. */
static void test_wing(void)
{
    static const double distances[] = {0.040, 0.050, 0.065, 0.075};
    double first = 0.00112 / 0.056, second = 0.00018 / 0.024, middle = weighed(0.056, first, 0.024, second);

    for (size_t k = 0; k < sizeof distances / sizeof *distances; k++) {
        struct outline o;
        double s = plan_separation_station(&plan, distances[k] - text.turnout.wing.flangeway), speed = rate(plan_separation, s);
        double d = distances[k], error[3];
        double up = speed * (d < 0.056 ? cubic_slope(first, 0, middle, d / 0.056) : cubic_slope(second, middle, 0, (d - 0.056) / 0.024));
        body_make(TURNOUT_SWITCH, s, H, &o);
        near(moved_error(&o, speed, up, 20), 0, 5e-6, "wing rail machined in full: -(dz/dy + dr/dy) dy/ds, over 1 + |dz/dy|");
        outline_free(&o);
        for (int i = 0; i < 3; i++) {
            body_make(TURNOUT_SWITCH, s, 0.008 / (1 << i), &o);
            error[i] = moved_error(&o, speed, up, 0.4);
            outline_free(&o);
        }
        ok(fabs(log2(error[0] / error[1]) - 2) < 0.1 && fabs(log2(error[1] / error[2]) - 2) < 0.1,
           "of second order in the step: %.2e, %.2e, %.2e at 8, 4, 2 mm", error[0], error[1], error[2]);
    }
}

/* On the gauge side of its ridge a nose keeps its flank; its crown rises with its table, less what the ridge climbs the head's crown. */
static void test_nose(void)
{
    double s = plan_separation_station(&plan, 0.030), speed = rate(plan_separation, s), flank = 0, field = 0, crown = 0;
    double middle = rail.gauge_face + 0.015, slope = 0, up, table = 0.00080 / 0.007;
    double begin = weighed(0.006, 0.00080 / 0.006, 0.007, table), end = weighed(0.007, table, 0.006, 0.00045 / 0.006);
    struct outline o;
    int flanks = 0, fields = 0, crowns = 0;

    for (int64_t i = 1; i < rail.outline.n && rail.outline.y[i - 1] < middle; i++) {
        double t = (middle - rail.outline.y[i - 1]) / (rail.outline.y[i] - rail.outline.y[i - 1]);
        slope = (1 - t) * rail.outline.slope[i - 1] + t * rail.outline.slope[i];
    }
    up = speed * (cubic_slope(table, begin, end, 0.001 / 0.007) + slope / 2);
    body_make(TURNOUT_NOSE, s, H, &o);
    for (int64_t i = 0; i < o.n; i++) {
        if (o.y[i] < middle && o.z[i] > 0.018)
            flank = fmax(flank, fabs(o.fall[i])), flanks++;
        if (o.y[i] > middle && o.z[i] > 0.018)
            field = fmax(field, fabs(o.fall[i] / (-o.slope[i] * speed) - 1)), fields++;
        if (o.y[i] > middle - 0.0055 && o.y[i] < middle - 0.004)
            crown = fmax(crown, fabs(o.fall[i] + up)), crowns++;
    }
    ok(flanks && fields && crowns, "%d, %d and %d points of flank, field side and crown", flanks, fields, crowns);
    near(flank, 0, 1e-3, "nose: its running edge does not fall");
    near(field, 0, 0.02, "nose: its other side moves away by dw/ds");
    ok(crown < 1e-4, "nose: its crown rises by %.2f mrad, as its table and the head's crown say (%.3f mrad beside)", 1e3 * up, 1e3 * crown);
    outline_free(&o);
}

/* Over a length the falls add up to the difference in height: Simpson's rule over sixteen parts. */
static void test_sum(int body, double from, double to, const char *name)
{
    enum { PARTS = 16 };
    struct outline o[PARTS + 1];
    double worst = 0, most = 0;
    int64_t points = 0;

    for (int k = 0; k <= PARTS; k++)
        body_make(body, from + (to - from) * k / PARTS, H, &o[k]);
    for (int64_t i = 0; i < o[0].n; i++) {
        double y = o[0].y[i], sum = 0, last = NAN;
        int inside = fabs(o[0].slope[i]) < 1;
        for (int k = 0; k <= PARTS && inside; k++) {
            int64_t j = 1;
            while (j < o[k].n - 1 && o[k].y[j] < y)
                j++;
            double t = (y - o[k].y[j - 1]) / (o[k].y[j] - o[k].y[j - 1]);
            inside = t >= 0 && t <= 1 && fabs(o[k].slope[j]) < 1;
            last = o[k].z[j - 1] + t * (o[k].z[j] - o[k].z[j - 1]);
            sum += (k == 0 || k == PARTS ? 1 : k % 2 ? 4 : 2) * (o[k].fall[j - 1] + t * (o[k].fall[j] - o[k].fall[j - 1]));
        }
        if (!inside)
            continue;
        points++;
        most = fmax(most, fabs(last - o[0].z[i]));
        worst = fmax(worst, fabs(sum * (to - from) / (3 * PARTS) - (last - o[0].z[i])));
    }
    ok(points > 20 && worst < 0.025 * most, "%s, %g to %g m: falls add up to within %.1f um of up to %.0f um (%d points)", name, from, to,
       1e6 * worst, 1e6 * most, (int)points);
    for (int k = 0; k <= PARTS; k++)
        outline_free(&o[k]);
}

/* One-sided at the ends of a body, and where neither neighbour reaches that of the nearest point. */
static void test_ends(void)
{
    double y[] = {0, 1, 2, 3}, z[] = {0, 0.4, 0.8, 1.2}, slope[] = {0.4, 0.4, 0.4, 0.4}, none[4] = {0}, fall[4] = {0};
    double raised[] = {-0.5, -0.1, 0.3, 0.7}, lowered[] = {0.25, 0.65, 1.05, 1.45};
    struct outline o = {4, y, z, slope, none, fall}, before = {4, y, raised, slope, none, none}, after = {2, y + 1, lowered + 1, slope, none, none};

    fall_between(&before, &after, 0.5, &o);
    near(fall[0], 1, 1e-15, "only behind: one-sided");
    near(fall[1], 0.75, 1e-15, "both: central");
    near(fall[3], 1, 1e-15, "only behind again");
    before.n = 0;
    fall_between(&before, &after, 0.5, &o);
    ok(fabs(fall[1] - 0.5) < 1e-15 && fabs(fall[2] - 0.5) < 1e-15 && fall[0] == fall[1] && fall[3] == fall[2], "beside what is known: as the nearest point");
    after.n = 0;
    fall_between(&before, &after, 0.5, &o);
    near(fall[2], 0, 0, "alone: none");
}

int main(void)
{
    rail_make();
    ok(!prof_text_read(&text, "data/turnouts/60E1-R760-1-15.yaml", NULL, 0, NULL), "the turnout's input");
    plan = turnout_plan(&text.turnout, text.gauge);
    test_ends();
    test_stock();
    test_plain();
    test_wing();
    test_nose();
    test_sum(TURNOUT_SWITCH, 3.6, 3.9, "blade");
    test_sum(TURNOUT_SWITCH, 5.0, 5.4, "blade");
    test_sum(TURNOUT_SWITCH, 46.1, 46.4, "wing rail");
    test_sum(TURNOUT_NOSE, 47.0, 47.1, "nose");
    section_free(&rail);
    prof_text_free(&text);
    return done();
}
