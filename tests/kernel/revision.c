/* The revision of the contact kernels: a cache gives old tables back as long as it stands.
 *
 * Who moves the numbers of a table raises TABLE_REVISION in tools/contact/table.h, and then puts what this test prints in place of
 * what is recorded here.  S1002 on a 60E1 1:40 that falls by 1:200, some means of magnitudes. */
#include <math.h>
#include <stdlib.h>

#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"
#include "tools/contact/table.h"

enum { MEANS = 6, METHODS = 3 };

static const enum ctab_column mean_of[MEANS] = {CTAB_HEIGHT, CTAB_WHEEL_Y, CTAB_X, CTAB_RADIUS, CTAB_HERTZ_C, CTAB_HEIGHT_ROLL};
static const char *const method_name[METHODS] = {"TABLE_NONE", "TABLE_THESIS", "TABLE_EXACT"};

struct record {
    int64_t rows, links;
    double mean[MEANS];
};

static const struct record recorded[METHODS] = {
    [TABLE_NONE] = {187, 207, {0.000414413442, 0.0158103776, 0, 0.461714428, 9.07476025e+10, 0.0189090895}},
    [TABLE_THESIS] = {939, 1900, {0.0004185186, 0.0158996988, 0.00446686948, 0.461759875, 9.04773396e+10, 0.0191229502}},
    [TABLE_EXACT] = {935, 1880, {0.000417486693, 0.0159350773, 0.00464687889, 0.461772425, 9.02334482e+10, 0.0191948442}},
};

static struct record measure(const struct prof *wheel, const struct prof *rail, enum table_yaw method)
{
    static const struct table_grid grid = {.u_max = 8e-3, .u_step = 1e-4, .yaw_max = 0.01, .yaws = 5, .shear_modulus = 82e9, .poisson = 0.28};
    struct record r = {0};
    struct ctab t;

    if (table_fill(&t, wheel, rail, method, &grid))
        return r;
    r.rows = t.rows;
    for (int64_t i = 0; i < t.rows * CTAB_LINKS; i++)
        r.links += t.link[i];
    for (int64_t i = 0; i < t.rows; i++)
        for (int k = 0; k < MEANS; k++)
            r.mean[k] += fabs(t.row[i * CTAB_N + mean_of[k]]) / (double)t.rows;
    ctab_free(&t);
    return r;
}

int main(void)
{
    struct shape *wheel = shape_s1002('r'), *rail = shape_60e1('r', 1 / 40.0);
    int same = 1;

    for (int64_t i = 0; i < rail->prof.points; i++)
        rail->fall[i] = 0.005;
    for (int m = 0; m < METHODS; m++) {
        struct record r = measure(&wheel->prof, &rail->prof, m);
        int as = r.rows == recorded[m].rows && r.links == recorded[m].links;
        for (int k = 0; k < MEANS; k++)
            as &= fabs(r.mean[k] - recorded[m].mean[k]) <= 1e-6 * fabs(recorded[m].mean[k]);
        printf("#     [%s] = {%lld, %lld, {", method_name[m], (long long)r.rows, (long long)r.links);
        for (int k = 0; k < MEANS; k++)
            printf("%.9g%s", r.mean[k], k < MEANS - 1 ? ", " : "}},\n");
        same &= as;
    }
    ok(same, "the numbers are those recorded here; else raise TABLE_REVISION where the change did not, and record the lines above");
    free(wheel);
    free(rail);
    return done();
}
