/* The kink a path shows: between straight lines, at a change of body, where both sides are long enough. */
#include "tools/draw/path.h"

#include <string.h>

#include "tests/kernel/tap.h"

enum { ROWS = 201, COLUMNS = 5, CHANGE = 100 };

static double value[COLUMNS][ROWS];
static struct columns table = {
    .n = COLUMNS,
    .rows = ROWS,
    .name = {"station", "body", "x", "rail_y", "height"},
    .value = {value[0], value[1], value[2], value[3], value[4]},
};

/* Falls by 3 mrad up to row CHANGE - 1, then rises by 5 mrad, in steps of 2 mm; the contact goes from -40 mm to 20 mm. */
static void table_make(int nose)
{
    for (int i = 0; i < ROWS; i++) {
        double s = 46.8 + 0.002 * i;
        int before = i < CHANGE;
        value[0][i] = s;
        value[1][i] = before ? 1 : nose;
        value[3][i] = before ? -0.04 : 0.02;
        value[4][i] = before ? 0.003 * (s - 47) : -0.005 * (s - 47);
    }
}

static void check(const char *want, const char *what)
{
    struct chart c;

    chart_begin(&c);
    const char *why = path_add(&c, &table, 0, "wheel");
    ok(!why && c.panels == 3 && strcmp(c.panel[0].series->label, want) == 0, "%s: %s%s", what, c.panel[0].series->label, why ? why : "");
    const struct chart_series *disc = c.panel[0].series->next;
    ok(strcmp(want, "wheel") == 0 ? !disc : disc && disc->n == 1 && disc->x[0] == value[0][CHANGE], "a disc there");
    ok(isnan(c.panel[1].series->y[CHANGE]) && c.panel[1].series->y[CHANGE + 1] == 0.02 && !isnan(c.panel[0].series->y[CHANGE]),
       "the contact's line is parted, the wheel's is not");
    chart_free(&c);
}

int main(void)
{
    struct chart c;

    table_make(2);
    check("wheel: 8.0 mrad", "from body to body");
    for (int i = 0; i < ROWS; i++)
        value[4][i] += 1e-5 * (i % 2 ? 1 : -1);
    check("wheel: 8.0 mrad", "rough by 0.01 mm");
    table_make(1);
    check("wheel", "on one body");
    table_make(2);
    value[1][CHANGE + 20] = 1;
    check("wheel", "back on the first body after 40 mm");
    table_make(2);
    table.rows = CHANGE + 20;
    check("wheel", "rows that end after 40 mm");
    chart_begin(&c);
    table.n = COLUMNS - 1;
    const char *why = path_add(&c, &table, 0, "wheel");
    ok(why && strstr(why, "height"), "a table without height: %s", why ? why : "");
    chart_free(&c);
    return done();
}
