/* The wheel's path as drawn is the one the simulation looks up: a contact that goes on, one that ends, one that begins. */
#include "tools/draw/path.h"

#include "tests/kernel/tap.h"
#include "tools/contact/lookup.h"

enum { STATIONS = 3, US = 2, ROWS = 12 };

static const double station[STATIONS] = {46.9, 46.95, 47.0}, yaw[1], u[US] = {-1e-3, 1e-3};
static float row[ROWS][CTAB_N];
static uint8_t link[ROWS][CTAB_LINKS];
static int32_t first[STATIONS * US + 1];
static struct ctab table = {
    .side = 'l', .yaw_method = "none", .radius = 0.46, .rail_position = -0.7535, .wheel_position = -0.75, .stations = STATIONS, .yaws = 1,
    .us = US, .station = station, .yaw = yaw, .u = u, .first = first, .row = row[0], .link = link[0],
};

/* A row of height and slope along the track, touching at y, `on` the link to the next station. */
static void row_add(double height, double slope, double y, int on)
{
    float *r = row[table.rows];

    r[CTAB_HEIGHT] = (float)height;
    r[CTAB_HEIGHT_S] = (float)slope;
    r[CTAB_RAIL_Y] = (float)y;
    r[CTAB_X] = (float)(-0.46 * slope);
    r[CTAB_HERTZ_C] = 1e11f;
    link[table.rows++][CTAB_LINK_STATION] = (uint8_t)on;
}

/* The wing rail falls away, with a hump that ends at the second station; the nose rises from there. */
static void table_make(void)
{
    for (int k = 0; k < US; k++) {
        first[k] = (int32_t)table.rows;
        row_add(-2e-4, 6e-3, -0.030, 0);
        row_add(-1e-4, 4e-3, -0.035, 1);
    }
    for (int k = 0; k < US; k++) {
        first[US + k] = (int32_t)table.rows;
        row_add(2e-4, 8e-3, -0.036, 2);
        row_add(5e-4, -9e-3, 0.020, 1);
    }
    for (int k = 0; k < US; k++) {
        first[2 * US + k] = (int32_t)table.rows;
        row_add(-1e-4, -5e-3, 0.022, 0);
        row_add(6e-4, 8e-3, -0.040, 0);
    }
    first[STATIONS * US] = (int32_t)table.rows;
}

int main(void)
{
    double worst[PATH_VALUES] = {0}, before = NAN;
    int changes = 0, samples = 0;

    table_make();
    for (int64_t i = 0; i + 1 < STATIONS; i++)
        for (double part = 0.02; part < 1; part += 0.04) {
            double value[PATH_VALUES], s = (1 - part) * station[i] + part * station[i + 1];
            struct contact c[CONTACT_MAX];
            int n = contact_lookup(&table, s, 0, u[0], 0, c), k = 0;
            while (k + 1 < n && c[k].weight < 0.5)
                k++;
            path_between(&table, i, 0, 0, part, value);
            worst[0] = fmax(worst[0], fabs(value[0] - c[k].height));
            worst[1] = fmax(worst[1], fabs(value[1] - c[k].row[CTAB_RAIL_Y]));
            worst[2] = fmax(worst[2], fabs(value[2] - c[k].row[CTAB_X]));
            changes += fabs(value[1] - before) > 3e-3;
            before = value[1];
            samples += n > 0;
        }
    ok(samples == 50 && changes == 2, "fifty places, two changes of contact (%d, %d)", samples, changes);
    near(worst[0], 0, 1e-9, "height as looked up");
    near(worst[1], 0, 1e-8, "place on the rail as looked up");
    near(worst[2], 0, 1e-8, "place ahead as looked up");
    return done();
}
