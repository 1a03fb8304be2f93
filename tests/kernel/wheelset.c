/* A wheelset S1002 on 60E1 1:40, gauge 1435 mm, back-to-back 1360 mm: rest positions, jumps, symmetry, load. */
#include "tools/contact/wheelset.h"

#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/table.h"

static const struct table_grid grid = {.u_max = 12e-3, .u_step = 1e-4, .yaw_max = 0.02, .yaws = 5, .shear_modulus = 82e9, .poisson = 0.28};

static struct ctab left, right;

/* Rests with the displacement u at rail level instead of y at the axle: y = u + r0 roll, by bisection. */
static int rest_at_rail_level(double u, struct wheelset *w)
{
    double lo = u - 3e-3, hi = u + 3e-3;
    for (int i = 0; i < 50; i++) {
        double y = 0.5 * (lo + hi);
        int beyond = wheelset_rest(&left, &right, 0, 0, y, 0, 1, w) || w->side[WHEELSET_RIGHT].u > u;
        *(beyond ? &hi : &lo) = y;
    }
    return !wheelset_rest(&left, &right, 0, 0, lo, 0, 1, w);
}

/* Displacement at rail level (mm), roll, height (mm, up, from that at 0), wheel_y of the right and -wheel_y of the left wheel (mm),
 * radius difference (mm): from an independent solver of the same formulas.  Rows at jumps of contact are left out. */
static void published_rows(void)
{
    static const double row[][6] = {
        {0, 0, -0.1820, 3.222, 3.222, 0},
        {0.1, -0.000003, -0.1819, 2.752, 3.651, 0.0220},
        {0.5, -0.000023, -0.1757, -8.180, 5.070, 0.5294},
        {1, -0.000051, -0.1632, -8.995, 6.469, 0.6100},
        {2, -0.000111, -0.1332, -10.708, 8.623, 0.7684},
        {3, -0.000174, -0.0967, -12.557, 10.311, 0.9429},
        {4, -0.000245, -0.0530, -14.640, 11.725, 1.1564},
        {5, -0.000326, -0.0003, -17.229, 12.949, 1.4583},
        {5.5, -0.000417, 0.0651, -29.205, 13.524, 3.8858},
        {6, -0.000540, 0.1549, -30.294, 14.079, 4.2802},
        {6.5, -0.000694, 0.2684, -32.407, 14.608, 5.2620},
        {7, -0.001506, 0.8861, -38.843, 15.293, 13.4010},
        {8, -0.003429, 2.3516, -39.837, 16.612, 16.1419},
    };
    double roll = 0, z = 0, place = 0, dr = 0;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct wheelset w;
        if (!rest_at_rail_level(row[i][0] * 1e-3, &w)) {
            ok(0, "rests at %g mm", row[i][0]);
            continue;
        }
        roll = fmax(roll, fabs(w.roll - row[i][1]));
        z = fmax(z, fabs(-w.z * 1e3 - row[i][2]));
        place = fmax(place, fabs(w.side[WHEELSET_RIGHT].contact[0].row[CTAB_WHEEL_Y] * 1e3 - row[i][3]));
        place = fmax(place, fabs(-w.side[WHEELSET_LEFT].contact[0].row[CTAB_WHEEL_Y] * 1e3 - row[i][4]));
        dr = fmax(dr, fabs(w.radius_difference * 1e3 - row[i][5]) / (1 + row[i][5]));
    }
    printf("# roll %.2g rad, height %.2g mm, place on the wheel %.2g mm, radius difference %.2g\n", roll, z, place, dr);
    /* On the flange the roll rises by 2e-3 a mm: 1e-5 is 5 um of displacement. */
    ok(roll < 1e-5, "roll of thirteen positions within 1e-5");
    ok(z < 0.01, "height within 10 um");
    ok(place < 0.05, "place on the wheels within 0.05 mm");
    ok(dr < 5e-3, "rolling radius difference within 0.5 %%");
}

/* Where the right wheel's contact leaps more than 3 mm, displacement at rail level in mm. */
static int jumps(double *at, int most)
{
    struct wheelset w;
    double last = 0;
    int n = 0;
    for (int i = 0; i <= 700; i++) {
        rest_at_rail_level(i * 1e-5, &w);
        double y = w.side[WHEELSET_RIGHT].contact[0].row[CTAB_WHEEL_Y];
        if (i && fabs(y - last) > 3e-3 && n < most)
            at[n++] = (i - 0.5) * 1e-2;
        last = y;
    }
    return n;
}

static void symmetry(void)
{
    double worst = 0, elastic = 0;
    for (int i = 1; i <= 70; i++)
        for (int k = -1; k <= 1; k++)
            for (int load = 0; load <= 1; load++) {
                struct wheelset a, b;
                double y = i * 1.03e-4, yaw = k * 0.0137;
                if (wheelset_rest(&left, &right, 0, yaw, y, load * 1e5, 1, &a) || wheelset_rest(&left, &right, 0, -yaw, -y, load * 1e5, 1, &b)) {
                    worst = 1;
                    continue;
                }
                double d = fmax(fabs(a.z - b.z), fmax(fabs(a.roll + b.roll), fabs(a.radius_difference + b.radius_difference)));
                *(load ? &elastic : &worst) = fmax(load ? elastic : worst, d);
            }
    ok(worst < 1e-9, "mirrored displacement and yaw: mirrored rest, rigid (%.1e)", worst);
    ok(elastic < 1e-9, "mirrored displacement and yaw: mirrored rest, 100 kN a wheel (%.1e)", elastic);
}

static void loaded(void)
{
    struct wheelset w, rigid;
    double worst = 0, balance = 0, load = 1e5;
    for (int i = -70; i <= 70; i++) {
        if (wheelset_rest(&left, &right, 0, 0.004, i * 1e-4, load, 1, &w)) {
            worst = 1;
            continue;
        }
        for (int s = 0; s < 2; s++) {
            double sum = 0, b = s ? right.wheel_position : left.wheel_position;
            for (int k = 0; k < w.side[s].n; k++)
                sum += w.side[s].force[k] * cos(w.side[s].contact[k].row[CTAB_ANGLE]);
            worst = fmax(worst, fabs(sum / load - 1));
            balance = fmax(balance, fabs(w.z + w.roll * b - w.side[s].z));
        }
    }
    ok(worst < 1e-9, "vertical forces carry the load on both sides (%.1e)", worst);
    ok(balance < 1e-12, "both sides hang on one rigid axle (%.1e m)", balance);

    wheelset_rest(&left, &right, 0, 0, 3e-3, 0, 1, &rigid);
    wheelset_rest(&left, &right, 0, 0, 3e-3, 1, 1, &w);
    ok(w.z > rigid.z && w.z - rigid.z < 1e-7, "under 1 N it rests where the rigid one does");
}

int main(void)
{
    struct shape *wr = shape_s1002('r'), *wl = shape_s1002('l'), *rr = shape_60e1('r', 1 / 40.0), *rl = shape_60e1('l', 1 / 40.0);
    struct wheelset w;
    double at[4] = {0};

    ok(!table_fill(&right, &wr->prof, &rr->prof, TABLE_EXACT, &grid) && !table_fill(&left, &wl->prof, &rl->prof, TABLE_EXACT, &grid),
       "tables of both sides");
    published_rows();
    int n = jumps(at, 4);
    ok(n == 3, "the right wheel's contact jumps three times up to 7 mm");
    near(at[0], 0.225, 0.05, "off the tread's middle between 0.2 and 0.25 mm, to a step of that list");
    near(at[1], 5.125, 0.05, "into the flange root between 5.1 and 5.15 mm");
    near(at[2], 6.575, 0.05, "onto the flange between 6.55 and 6.6 mm");
    symmetry();
    loaded();
    const char *why = wheelset_rest(&left, &right, 0, 0, 13e-3, 0, 1, &w);
    ok(why && strstr(why, "beyond the table"), "beyond the table is said");
    ctab_free(&left);
    ctab_free(&right);
    free(wr);
    free(wl);
    free(rr);
    free(rl);
    return done();
}
