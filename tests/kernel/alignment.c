/* Track centre lines in plan: circles, joints of pieces, the tangent's view of a train. */
#include "tools/integrate/alignment.h"

#include "tests/kernel/tap.h"

static const double x[3] = {0, 50, 80}, curvature[3] = {1 / 760.0, 0, -1 / 500.0};

static void closed_forms(const struct alignment *a)
{
    struct alignment_point p = alignment_at(a, -1e-9), q = alignment_at(a, 30);

    ok(p.curvature == 0 && p.heading == 0 && p.offset == 0, "straight before the first piece");
    near(q.curvature, 1 / 760.0, 0, "curvature of the piece");
    near(q.heading, 30 / 760.0, 1e-16, "heading on a circle: d/R");
    near(q.offset, 30 * 30 / (2 * 760.0), 1e-15, "offset on a circle: d^2/2R, to the right");
    near(q.offset, 760 * (1 - cos(30 / 760.0)), 1e-4, "the circle itself within 0.1 mm, for small angles");
    p = alignment_at(a, 70);
    near(p.heading, 50 / 760.0, 1e-16, "heading holds on the straight behind it");
    near(p.offset, 2500 / 1520.0 + 20 * 50 / 760.0, 1e-14, "and the offset goes on along it");
    p = alignment_at(a, 90);
    near(p.curvature, -1 / 500.0, 0, "the last piece has no end");
    near(p.heading, 50 / 760.0 - 10 / 500.0, 1e-15, "a left curve turns back");
}

/* Heading is the slope of the offset and curvature that of the heading, also through a joint of pieces. */
static void continuity(const struct alignment *a)
{
    double h = 1e-6, step = 0, slope = 0, bend = 0;

    for (double s = -5; s < 100; s += 0.0625) {
        struct alignment_point b = alignment_at(a, s - h), e = alignment_at(a, s + h), m = alignment_at(a, s);
        step = fmax(step, fabs(e.offset - b.offset - 2 * h * m.heading));
        slope = fmax(slope, fabs((e.offset - b.offset) / (2 * h) - m.heading));
        if (s != 0 && s != 50 && s != 80)
            bend = fmax(bend, fabs((e.heading - b.heading) / (2 * h) - m.curvature));
    }
    near(step, 0, 1e-13, "no step at a joint");
    near(slope, 0, 1e-8, "heading is the slope of the offset");
    near(bend, 0, 1e-9, "curvature is the slope of the heading");
}

/* From the tangent in a circle's middle, frames d ahead and d behind lie alike d^2/2R to the right and are turned by +-d/R: the
 * carbody of 19 m between pivots stands 59 mm inside, a bogie of 2.56 m wheelbase has 3.37 mrad between its wheelsets. */
static void train_in_a_circle(const struct alignment *a)
{
    struct alignment_point middle = alignment_at(a, 25), ahead = alignment_at(a, 25 + 9.5), behind = alignment_at(a, 25 - 9.5);
    struct alignment_point front = alignment_at(a, 20 + 1.28), rear = alignment_at(a, 20 - 1.28);

    near(ahead.offset - middle.offset - middle.heading * 9.5, 9.5 * 9.5 / 1520, 1e-14, "the frame at a pivot lies 59.4 mm to the right");
    near(behind.offset - middle.offset + middle.heading * 9.5, 9.5 * 9.5 / 1520, 1e-14, "ahead as behind");
    near(front.heading - rear.heading, 2.56 / 760, 1e-16, "3.37 mrad over a wheelbase of 2.56 m");
}

static void none(void)
{
    struct alignment a;

    ok(alignment_new(&a, 0, NULL, NULL) == NULL, "no piece at all is an alignment");
    ok(alignment_at(&a, 1e3).offset == 0 && alignment_at(&a, 1e3).heading == 0, "and straight");
    alignment_free(&a);
}

/* 150 mm over 1.5 m from 10 m to 40 m: sin(angle) = cant/base, twist its derivative, constant beyond. */
static void cant(void)
{
    static const double at[2] = {10, 40}, height[2] = {0, 0.15};
    struct alignment a;

    ok(alignment_new(&a, 0, NULL, NULL) == NULL, "a straight");
    alignment_raise(&a, 2, at, height, 1.5);
    ok(alignment_at(&a, 9).cant == 0 && alignment_at(&a, 9).twist == 0, "level before its cant");
    near(alignment_at(&a, 25).cant, asin(0.05), 1e-16, "half of it half way up the ramp");
    near(alignment_at(&a, 25).twist, (alignment_at(&a, 25.01).cant - alignment_at(&a, 24.99).cant) / 0.02, 1e-9, "twist is its derivative");
    near(alignment_at(&a, 90).cant, asin(0.1), 1e-16, "all of it beyond");
    ok(alignment_at(&a, 90).twist == 0, "without twist");
    alignment_free(&a);
}

/* Counted from a station within a piece, all of it lies as before against the tangent there, ahead and behind. */
static void begun(void)
{
    struct alignment a, b;
    const double s = x[1] + 0.3 * (x[2] - x[1]);
    double worst = 0, turned = 0;

    ok(!alignment_new(&a, 3, x, curvature) && !alignment_new(&b, 3, x, curvature) && !alignment_begin(&b, s), "begun in its second piece");
    const struct alignment_point at = alignment_at(&a, s), zero = alignment_at(&b, s);
    ok(zero.heading == 0 && zero.offset == 0 && zero.curvature == at.curvature, "no heading, no offset, the same curvature there");
    for (double d = x[0] - 20; d < x[2] + 50; d += 0.7) {
        const struct alignment_point p = alignment_at(&a, d), q = alignment_at(&b, d);
        worst = fmax(worst, fabs(q.offset - (p.offset - at.offset - at.heading * (d - s))));
        turned = fmax(turned, fabs(q.heading - (p.heading - at.heading)) + fabs(q.curvature - p.curvature));
    }
    near(worst, 0, 1e-12, "offsets against its tangent");
    near(turned, 0, 1e-15, "headings and curvatures");
    alignment_free(&a);
    alignment_free(&b);
}

int main(void)
{
    struct alignment a;

    ok(alignment_new(&a, 3, x, curvature) == NULL, "three pieces");
    closed_forms(&a);
    continuity(&a);
    train_in_a_circle(&a);
    alignment_free(&a);
    none();
    cant();
    begun();
    return done();
}
