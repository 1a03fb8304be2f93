/* Cells of a table: which of their corners' rows are one contact, and that a file which says otherwise is refused. */
#include "tests/kernel/shapes.h"
#include "tests/kernel/tap.h"

#include <string.h>

#include "tools/contact/branch.h"
#include "tools/contact/table.h"

enum { US = 2, YAWS = 2, NODES = US * YAWS, ROWS = 6 };

static const double station[1], yaw[YAWS] = {-0.01, 0.01}, u[US] = {-1e-3, 1e-3};
static const int32_t first[NODES + 1] = {0, 2, 3, 4, 6};
static uint8_t link[ROWS][CTAB_LINKS];

/* Nodes (yaw, u) of 2, 1, 1 and 2 rows. */
static struct ctab table(void)
{
    memset(link, 0, sizeof link);
    return (struct ctab){.stations = 1, .yaws = YAWS, .us = US, .rows = ROWS, .station = station, .yaw = yaw, .u = u, .first = first, .link = link[0]};
}

/* Branch `at` of a cell holds these rows, from 1 on, of the corners 0 to 3. */
static int is_branch(const struct ctab *t, int cell, int at, const uint8_t of[4])
{
    const uint8_t *b = t->branch + (t->cell[cell] + at) * CTAB_CORNERS;
    static const uint8_t none[4];

    return !memcmp(b, of, 4) && !memcmp(b + 4, none, 4);
}

static void joins(void)
{
    struct ctab t = table();
    static const uint8_t none[4];

    link[0][CTAB_LINK_U] = 1;              /* from row 0 of node (0, 0) all the way round to row 1 of (1, 1) */
    link[2][CTAB_LINK_YAW] = 2;
    link[1][CTAB_LINK_YAW] = 1;            /* row 1 of (0, 0), by yaw alone, to row 0 of (1, 1) */
    link[3][CTAB_LINK_U] = 1;
    ok(!branch_cells(&t), "branches of a cell");
    ok(is_branch(&t, 0, 0, (const uint8_t[]){1, 1, 0, 2}), "u, then yaw");
    ok(is_branch(&t, 0, 1, (const uint8_t[]){2, 0, 1, 1}), "yaw, then u");
    ok(is_branch(&t, 0, 2, none), "and no other");
    ok(is_branch(&t, 1, 0, (const uint8_t[]){1, 0, 2, 0}), "a cell at the last u has corners by yaw");
    ok(is_branch(&t, 3, 0, (const uint8_t[]){1, 0, 0, 0}) && is_branch(&t, 3, 1, (const uint8_t[]){2, 0, 0, 0}), "the last node's rows stand alone");
    ctab_free(&t);

    t = table();
    link[0][CTAB_LINK_U] = 1;
    link[1][CTAB_LINK_YAW] = 1;
    link[2][CTAB_LINK_YAW] = link[3][CTAB_LINK_U] = 1;
    ok(!branch_cells(&t), "a fold");
    ok(is_branch(&t, 0, 0, (const uint8_t[]){1, 1, 0, 0}) && is_branch(&t, 0, 1, (const uint8_t[]){2, 0, 1, 1}),
       "where ways round the cell lead from one row of a node to its other they stay two branches");
    ctab_free(&t);
}

/* Every row of every corner is in one branch of its cell, of a table of S1002 on 60E1. */
static void complete(void)
{
    static const struct table_grid grid = {.u_max = 9e-3, .u_step = 1e-4, .yaw_max = 0.02, .yaws = 11, .shear_modulus = 82e9, .poisson = 0.28};
    struct shape *w = shape_s1002('r'), *r = shape_60e1('r', 1 / 40.0);
    struct ctab t;
    int once = 1;

    if (ok(!table_fill(&t, &w->prof, &r->prof, TABLE_EXACT, &grid), "a table of one station")) {
        for (int64_t node = 0; node < t.yaws * t.us; node++)
            for (int k = 0; k < 4; k++) {
                int64_t iu = node % t.us + (k & 1), iy = node / t.us + (k >> 1), at = iy * t.us + iu;
                int rows = iu < t.us && iy < t.yaws ? t.first[at + 1] - t.first[at] : 0, seen[CTAB_MOST + 1] = {0};
                for (const uint8_t *b = t.branch + t.cell[node] * CTAB_CORNERS; b[0] | b[1] | b[2] | b[3]; b += CTAB_CORNERS)
                    seen[b[k]]++;
                for (int i = 1; i <= CTAB_MOST; i++)
                    once &= seen[i] == (i <= rows);
            }
        ok(once, "each row of each corner is in one branch");
        ctab_free(&t);
    }
    free(w);
    free(r);
}

int main(void)
{
    joins();
    complete();
    return done();
}
