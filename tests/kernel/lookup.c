/* Interpolation in the contact table: nodes, derivatives by u, roll and station, continuity, ends. S1002 on 60E1 1:40. */
#include "tools/contact/lookup.h"

#include "tests/kernel/random.h"
#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/table.h"

static const struct table_grid grid = {.u_max = 9e-3, .u_step = 1e-4, .yaw_max = 0.02, .yaws = 21, .shear_modulus = 82e9, .poisson = 0.28};

/* Contact with the largest weight near wheel_y. */
static const struct contact *nearest(const struct contact *c, int n, double wheel_y)
{
    const struct contact *best = c;
    for (int i = 1; i < n; i++)
        if (fabs(c[i].row[CTAB_WHEEL_Y] - wheel_y) < fabs(best->row[CTAB_WHEEL_Y] - wheel_y))
            best = &c[i];
    return best;
}

static void at_nodes(const struct ctab *t)
{
    struct contact c[CONTACT_MAX];
    double worst = 0;
    int same = 1;
    for (int64_t iy = 0; iy < t->yaws; iy++)
        for (int64_t iu = 0; iu < t->us; iu++) {
            int n = contact_lookup(t, 0, t->yaw[iy], t->u[iu], 0, c), held = 0, count;
            const float *row = ctab_node(t, 0, iy, iu, &count);
            for (int i = 0; i < n; i++)
                held += c[i].weight > 1e-9;                      /* rounding may let a neighbour in with less */
            same &= held == count;
            for (int i = 0; i < CTAB_N && held > 0; i++)
                worst = fmax(worst, fabs(c[0].row[i] - row[i]) / (1 + fabs(row[i])));
        }
    ok(same, "as many contacts at a node as it holds");
    ok(worst < 1e-8, "at a node the row of the node (%.1e)", worst);
}

/* Central differences within one branch; steps of a hundredth of a cell. */
static void slopes(const struct ctab *t)
{
    struct contact a[CONTACT_MAX], b[CONTACT_MAX], c[CONTACT_MAX];
    double worst = 0, curved = 0, h = 1e-6;
    for (int i = 0; i < 2000; i++) {
        double u = 8e-3 * (2 * random_number() - 1), yaw = 0.02 * (2 * random_number() - 1);
        int n = contact_lookup(t, 0, yaw, u, 0, c), na = contact_lookup(t, 0, yaw, u - h, 0, a), nb = contact_lookup(t, 0, yaw, u + h, 0, b);
        if (n != na || n != nb || a[0].weight < 1 || b[0].weight < 1)
            continue;
        double difference = (b[0].height - a[0].height) / (2 * h);
        if (fabs(c[0].height_u) < 0.3 && fabs(b[0].row[CTAB_WHEEL_Y] - a[0].row[CTAB_WHEEL_Y]) < 1e-5)
            worst = fmax(worst, fabs(difference - c[0].height_u));
        curved = fmax(curved, fabs(c[0].height_u));
    }
    ok(worst < 2e-4, "height_u is the derivative of the height on the tread (%.1e)", worst);
    ok(curved > 2, "and the flange was met");
}

static void turn_profile(struct shape *w, double roll)
{
    for (int64_t i = 0; i < w->prof.points; i++) {
        double y = w->y[i], z = w->z[i], a = atan(w->slope[i]) + roll;
        w->y[i] = y * cos(roll) - z * sin(roll);
        w->z[i] = z * cos(roll) + y * sin(roll);
        w->slope[i] = tan(a);
    }
}

/* The wheel's profile turned by roll about its running circle's lowest point, tabulated anew. */
static void turned(const struct ctab *t, const struct prof *rail, double roll, double place_most)
{
    struct shape *w = shape_s1002('r');
    struct table_grid g = grid;
    struct ctab exact;
    double height = 0, place = 0, angle = 0, without = 0;
    g.yaws = 3;
    turn_profile(w, roll);
    if (!ok(!table_fill(&exact, &w->prof, rail, TABLE_EXACT, &g), "table of the turned wheel"))
        return;
    for (int i = -80; i <= 80; i++) {
        struct contact c[CONTACT_MAX], e[CONTACT_MAX];
        double u = i * 1e-4;
        int n = contact_lookup(t, 0, 0, u, roll, c), m = contact_lookup(&exact, 0, 0, u, 0, e), zero;
        const struct contact *mate = nearest(c, n, e[0].row[CTAB_WHEEL_Y]);
        if (m < 1 || n < 1 || fabs(mate->row[CTAB_WHEEL_Y] - e[0].row[CTAB_WHEEL_Y]) > 1e-3)
            continue;                                            /* a branch of one only */
        height = fmax(height, fabs(mate->height - e[0].height));
        place = fmax(place, fabs(mate->row[CTAB_RAIL_Y] - e[0].row[CTAB_RAIL_Y]));
        angle = fmax(angle, fabs(mate->row[CTAB_ANGLE] - e[0].row[CTAB_ANGLE]));
        zero = contact_lookup(t, 0, 0, u, 0, c);
        without = fmax(without, fabs(nearest(c, zero, e[0].row[CTAB_WHEEL_Y])->height - e[0].height));
    }
    printf("# roll %g: height within %.2g m (without roll %.2g), rail_y %.2g m, angle %.2g rad\n", roll, height, without, place, angle);
    ok(height < 0.02 * without, "roll %g: heights as of the turned wheel", roll);
    ok(place < place_most, "roll %g: contact points within %g mm of the turned wheel's", roll, place_most * 1e3);
    ok(angle < place_most / 13e-3, "roll %g: contact angles within that over the gauge corner's radius", roll);
    ctab_free(&exact);
    free(w);
}

/* How far ahead a yawed and rolled wheelset touches: the turned profile is that of a wheel whose own slope is greater by roll, which
 * the wheelset's is not, so its x has roll r sin(yaw) too much taken off. */
static void turned_ahead(const struct ctab *t, const struct prof *rail)
{
    struct shape *w = shape_s1002('r');
    struct table_grid g = grid;
    struct ctab exact;
    double worst = 0, moved = 0, roll = -3e-3, yaw = 0.02;
    g.yaws = 2;
    turn_profile(w, roll);
    if (!ok(!table_fill(&exact, &w->prof, rail, TABLE_EXACT, &g), "table of the turned wheel"))
        return;
    for (int i = -80; i <= 80; i++) {
        struct contact c[CONTACT_MAX], e[CONTACT_MAX];
        int n = contact_lookup(t, 0, yaw, i * 1e-4, roll, c), m = contact_lookup(&exact, 0, yaw, i * 1e-4, 0, e);
        if (m < 1 || n < 1)
            continue;
        const struct contact *mate = nearest(c, n, e[0].row[CTAB_WHEEL_Y]);
        if (fabs(e[0].row[CTAB_ANGLE]) > 0.1 || fabs(mate->row[CTAB_RAIL_Y] - e[0].row[CTAB_RAIL_Y]) > 0.1e-3)
            continue;
        worst = fmax(worst, fabs(mate->row[CTAB_X] - e[0].row[CTAB_X] - roll * e[0].row[CTAB_RADIUS] * sin(yaw)));
        moved = fmax(moved, fabs(mate->row[CTAB_X] + t->wheel_position * sin(yaw)));
    }
    ok(worst < 10e-6 && moved > 0.3e-3, "roll %g, yaw %g: x as of the turned wheel within 10 um (%.2g m)", roll, yaw, worst);
    ctab_free(&exact);
    free(w);
}

/* Vertical force of a wheel held 0.1 mm below its first touch at the start of a walk. */
static double force(const struct contact *c, int n, double z)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        double depth = (z - c[i].height) * cos(c[i].row[CTAB_ANGLE]);
        sum += depth > 0 ? c[i].weight * c[i].row[CTAB_HERTZ_C] * depth * sqrt(depth) * cos(c[i].row[CTAB_ANGLE]) : 0;
    }
    return sum;
}

/* Largest change of force, over the force's own scale, along straight walks of `steps` steps through the table. */
static double walk(const struct ctab *t, int steps)
{
    struct contact c[CONTACT_MAX];
    double worst = 0;
    for (int k = 0; k < 40; k++) {
        double u0 = -8e-3 + 16e-3 * k / 39, u1 = u0 + 3e-4, y0 = 0.018 * sin(k), y1 = y0 + 1.3e-3 * cos(3 * k), last = 0, z = 0;
        for (int i = 0; i <= steps; i++) {
            double f = (double)i / steps;
            int n = contact_lookup(t, 0.6 + 0.8 * f, y0 + f * (y1 - y0), fmin(u0 + f * (u1 - u0), 8.9e-3), 1e-3 * f, c);
            z = i ? z : c[0].height + 1e-4;
            double now = force(c, n, z);
            worst = i ? fmax(worst, fabs(now - last)) : worst;
            last = now;
        }
    }
    return worst;
}

/* A rail in two sections, the second dz lower and dy further right. */
static struct shape *rail_pair(double dy, double dz)
{
    struct shape *one = shape_60e1('r', 1 / 40.0), *two = calloc(1, sizeof *two);
    static double station[2] = {0, 1};
    static int64_t section[2] = {0, 1}, body[2] = {0, 0}, first[3];
    int64_t n = one->prof.points;
    *two = *one;
    two->prof.sections = two->prof.polys = 2;
    two->prof.points = 2 * n;
    if (2 * n > SHAPE_POINTS)
        exit(1);
    for (int64_t i = 0; i < n; i++) {
        two->y[n + i] = one->y[i] + dy;
        two->z[n + i] = one->z[i] + dz;
        two->slope[n + i] = one->slope[i];
        two->curvature[n + i] = one->curvature[i];
        two->fall[i] = two->fall[n + i] = dz - one->slope[i] * dy;
    }
    first[1] = n;
    first[2] = 2 * n;
    two->prof.station = station;
    two->prof.poly_section = section;
    two->prof.poly_body = body;
    two->prof.poly_first = first;
    two->prof.y = two->y;
    two->prof.z = two->z;
    two->prof.slope = two->slope;
    two->prof.curvature = two->curvature;
    two->prof.fall = two->fall;
    two->prof.body = (const char (*)[PROF_NAME])two->body;
    free(one);
    return two;
}

static void along_the_track(const struct prof *wheel)
{
    struct shape *two = rail_pair(0.2e-3, 5e-3);
    struct ctab t;
    struct contact c[CONTACT_MAX], a[CONTACT_MAX], b[CONTACT_MAX];
    ok(!table_fill(&t, wheel, &two->prof, TABLE_EXACT, &grid), "table of two sections");
    contact_lookup(&t, 0.25, 0, -5e-3, 0, c);
    contact_lookup(&t, 0.2499, 0, -5e-3, 0, a);
    contact_lookup(&t, 0.2501, 0, -5e-3, 0, b);
    near(c[0].height_s, (b[0].height - a[0].height) / 2e-4, 1e-10, "height_s is the derivative by station");
    ok(fabs(c[0].height_s - 5e-3) < 1e-4, "near the slope of the rail, 5 mm a metre");
    contact_lookup(&t, -7, 0, -5e-3, 0, a);
    contact_lookup(&t, 0, 0, -5e-3, 0, b);
    ok(a[0].height == b[0].height && a[0].height_s == 0, "constant before the first station");
    ok(b[0].height_s != 0, "at a station the slope ahead");
    contact_lookup(&t, 1, 0, -5e-3, 0, a);
    contact_lookup(&t, 9, 0, -5e-3, 0, b);
    ok(a[0].height == b[0].height && b[0].height_s == 0 && a[0].height_s == 0, "constant from the last station on");

    double coarse = walk(&t, 400), fine = walk(&t, 40000);
    printf("# largest change of force in a step: %.3g N with 400 steps, %.3g N with 40000\n", coarse, fine);
    ok(fine < 0.012 * coarse, "force is continuous along walks, across a section too: a hundredth of the step, a hundredth of the change");
    ctab_free(&t);
    free(two);
}

int main(void)
{
    struct shape *w = shape_s1002('r'), *r = shape_60e1('r', 1 / 40.0);
    struct ctab t;
    struct contact c[CONTACT_MAX];

    ok(!table_fill(&t, &w->prof, &r->prof, TABLE_EXACT, &grid), "table of S1002 on 60E1");
    at_nodes(&t);
    slopes(&t);
    turned(&t, &r->prof, 5e-4, 0.2e-3);
    turned(&t, &r->prof, -3e-3, 1e-3);
    turned_ahead(&t, &r->prof);
    along_the_track(&w->prof);

    ok(contact_lookup(&t, 0, 0, 9.01e-3, 0, c) == -1 && contact_lookup(&t, 0, 0, -9.01e-3, 0, c) == -1, "u beyond the table is said");
    ok(contact_lookup(&t, 0, 0, (double)NAN, 0, c) == -1, "NaN is beyond every table");
    int n = contact_lookup(&t, 0, 0.5, 0, 0, c);
    double held = c[0].height;
    ok(n > 0 && contact_lookup(&t, 0, 0.02, 0, 0, c) == n && c[0].height == held, "yaw is held within the table");
    ctab_free(&t);
    free(w);
    free(r);
    return done();
}
