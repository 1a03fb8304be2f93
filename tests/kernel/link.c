/* Which contact of the next node is the same one: the nearest on the wheel and in height. */
#include "tests/kernel/tap.h"

#include "tools/contact/link.h"

enum { STATIONS = 2, ROWS = 4 };

static const double station[STATIONS] = {46.5, 46.6}, yaw[1], u[1];
static float row[ROWS][CTAB_N];
static uint8_t link[ROWS][CTAB_LINKS], of[ROWS];
static int32_t first[STATIONS + 1];
static struct ctab table = {.stations = STATIONS, .yaws = 1, .us = 1, .station = station, .yaw = yaw, .u = u, .first = first, .row = row[0], .body = of};

static void row_add(double wheel_y, double height, double fall, int body)
{
    float *r = row[table.rows];

    r[CTAB_WHEEL_Y] = (float)wheel_y;
    r[CTAB_HEIGHT] = (float)height;
    r[CTAB_HEIGHT_S] = (float)fall;
    of[table.rows++] = (uint8_t)body;
}

static void table_begin(void)
{
    table.rows = 0;
    for (int i = 0; i < ROWS; i++)
        link[i][CTAB_LINK_STATION] = 0;
}

static void table_link(void)
{
    first[STATIONS] = (int32_t)table.rows;
    link_rows(&table, link[0]);
}

int main(void)
{
    table_begin();
    row_add(-7.6e-3, -0.42e-3, -1e-3, 1);
    first[1] = 1;
    row_add(-14.4e-3, -0.52e-3, -1e-3, 1);
    row_add(-3.0e-3, 4.08e-3, -1e-3, 1);
    table_link();
    ok(link[0][CTAB_LINK_STATION] == 1, "a wing rail carries on 6.8 mm aside, not 4.6 mm aside where the wheel is 4.6 mm above it");

    table_begin();
    row_add(-7.6e-3, -0.42e-3, 16e-3, 1);
    row_add(3.0e-3, 2.0e-3, -18e-3, 1);
    first[1] = 2;
    row_add(4.0e-3, 0.2e-3, -18e-3, 1);
    row_add(-9.0e-3, 1.2e-3, 16e-3, 1);
    table_link();
    ok(link[0][CTAB_LINK_STATION] == 2 && link[1][CTAB_LINK_STATION] == 1, "what rises by 1.8 mm carries on where it stays: contacts change order");

    table_begin();
    row_add(0, 0, 0, 1);
    first[1] = 1;
    row_add(8.1e-3, 0, 0, 1);
    row_add(0, 0, 0, 2);
    table_link();
    ok(link[0][CTAB_LINK_STATION] == 0, "not beyond 8 mm, nor on another body");

    table_begin();
    row_add(0, 0, 2e-3, 1);
    first[1] = 1;
    row_add(1e-3, 1e-3, 2e-3, 1);
    table_link();
    ok(link[0][CTAB_LINK_STATION] == 0, "nor 0.8 mm lower than its falls lead to");
    return done();
}
