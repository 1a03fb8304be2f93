/* Reads, checks and writes .ctab: ctab(5). */
#include "formats/ctab.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/room.h"

#define EVEN 1e-6        /* of a step: how far an evenly spaced axis may be off */

const struct ctab_column_info ctab_columns[CTAB_ALL] = {
    [CTAB_HEIGHT] = {"height", "m"},
    [CTAB_HEIGHT_U] = {"height_u", "1"},
    [CTAB_HEIGHT_YAW] = {"height_yaw", "m/rad"},
    [CTAB_HEIGHT_S] = {"height_s", "1"},
    [CTAB_HEIGHT_ROLL] = {"height_roll", "m/rad"},
    [CTAB_ROLL_Y] = {"roll_y", "m/rad"},
    [CTAB_RAIL_Y] = {"rail_y", "m"},
    [CTAB_RAIL_Z] = {"rail_z", "m"},
    [CTAB_WHEEL_Y] = {"wheel_y", "m"},
    [CTAB_X] = {"x", "m"},
    [CTAB_ANGLE] = {"angle", "rad"},
    [CTAB_RADIUS] = {"radius", "m"},
    [CTAB_RAIL_K] = {"rail_curvature", "1/m"},
    [CTAB_HERTZ_C] = {"hertz_c", "N/m^1.5"},
    [CTAB_HERTZ_A] = {"hertz_a", "m/N^(1/3)"},
    [CTAB_HERTZ_B] = {"hertz_b", "m/N^(1/3)"},
    [CTAB_WHEEL_K] = {"wheel_curvature", "1/m"},
    [CTAB_SHAPE] = {"shape", "1"},
    [CTAB_BODY] = {"body", "1"},
};

/* x[n] increases; evenly, where even. */
static const char *check_axis(const char *name, const double *x, int64_t n, int even)
{
    for (int64_t i = 1; i < n; i++)
        if (!(x[i] > x[i - 1]))
            return reason("array %s: not increasing at %lld", name, (long long)i);
    for (int64_t i = 1; even && i < n; i++) {
        double step = (x[n - 1] - x[0]) / (double)(n - 1);
        if (fabs(x[i] - x[0] - (double)i * step) > EVEN * step)
            return reason("array %s: not evenly spaced at %lld", name, (long long)i);
    }
    return NULL;
}

static const char *check_columns(const struct vxf *f)
{
    for (int i = 0; i < CTAB_ALL; i++) {
        const char *name = ctab_columns[i].name, *unit = ctab_columns[i].unit;
        size_t n = strlen(name), m = strlen(unit);
        int length = 0;
        const char *line = vxf_line(f, "COLUMN", i, &length);
        if (!line || (size_t)length != n + 1 + m || strncmp(line, name, n) || line[n] != ' ' || strncmp(line + n + 1, unit, m))
            return reason("column %d is not \"%s %s\"", i, name, unit);
    }
    return NULL;
}

static const char *read_keys(struct ctab *t, const struct vxf *f)
{
    const struct { const char *key; double *value; int positive; } number[] = {
        {"LOAD", &t->load, 1},
        {"SHEAR_MODULUS", &t->shear_modulus, 1},
        {"POISSON", &t->poisson, 0},
        {"RADIUS", &t->radius, 1},
        {"RAIL_POSITION", &t->rail_position, 0},
        {"WHEEL_POSITION", &t->wheel_position, 0},
    };
    char side[4];
    const char *why;

    if ((why = vxf_key(f, "SIDE", side, sizeof side)) ||
        (why = vxf_key(f, "YAW_METHOD", t->yaw_method, sizeof t->yaw_method)) || (why = vxf_key(f, "NORMAL", t->normal, sizeof t->normal)))
        return why;
    if (strcmp(side, "l") && strcmp(side, "r"))
        return reason("SIDE is %s, must be l or r", side);
    t->side = side[0];
    for (size_t i = 0; i < sizeof number / sizeof *number; i++) {
        if ((why = vxf_number(f, number[i].key, number[i].value)))
            return why;
        if (!isfinite(*number[i].value) || (number[i].positive && !(*number[i].value > 0)))
            return reason("%s is %g, must be %s", number[i].key, *number[i].value, number[i].positive ? "positive" : "finite");
    }
    return NULL;
}

const float *ctab_node(const struct ctab *t, int64_t station, int64_t yaw, int64_t u, int *count)
{
    int64_t node = (station * t->yaws + yaw) * t->us + u;

    *count = t->first[node + 1] - t->first[node];
    return t->row + (int64_t)t->first[node] * CTAB_N;
}

static int64_t nodes(const struct ctab *t)
{
    return t->stations * t->yaws * t->us;
}

/* Whether any of n nodes from first[0] on has fewer rows than least, or more than most. */
static int counts_beyond(const int32_t *first, int64_t n, int32_t least, int32_t most)
{
    int beyond = 0;

    for (int64_t i = 0; i < n; i++)
        beyond |= (first[i + 1] < first[i] + least) | (first[i + 1] > first[i] + most);
    return beyond;
}

static const char *check_first(const struct ctab *t)
{
    int64_t i = 0;

    if (counts_beyond(t->first, nodes(t), 0, CTAB_MOST)) {
        while (!counts_beyond(t->first + i, 1, 0, CTAB_MOST))
            i++;
        return reason("array first: node %lld has %d rows, must be 0 to %d", (long long)i, t->first[i + 1] - t->first[i], CTAB_MOST);
    }
    if (t->first[0] != 0 || t->first[nodes(t)] != t->rows)
        return reason("array first: runs from %d to %d, must be 0 to %lld", t->first[0], t->first[nodes(t)], (long long)t->rows);
    return NULL;
}

/* need[k] of the branches of a cell, the rows they take of each corner. */
static void branch_needs(const struct ctab *t, int32_t cell, uint8_t need[CTAB_CORNERS])
{
    static const uint8_t end[CTAB_CORNERS];

    memset(need, 0, CTAB_CORNERS);
    for (const uint8_t *b = t->branch + (int64_t)cell * CTAB_CORNERS; memcmp(b, end, sizeof end); b += CTAB_CORNERS)
        for (int k = 0; k < CTAB_CORNERS; k++)
            need[k] = b[k] > need[k] ? b[k] : need[k];
}

static int32_t smallest_count(const int32_t *first, int64_t n)
{
    int32_t least = CTAB_MOST;

    for (int64_t i = 0; i < n; i++)
        least = first[i + 1] - first[i] < least ? first[i + 1] - first[i] : least;
    return least;
}

/* Along u at one station and yaw and at the next ones, by the bits of a corner: 1 yaw, 2 station. */
struct rows_around {
    int in[4];                  /* the table goes on to there */
    int64_t next[4];            /* nodes from the one to the other */
    int32_t least[4];           /* rows of the node that has fewest */
};

/* Cells from node `from` to before `to`, which have the same branches; the row of nodes ends before `end`. */
static const char *check_alike(const struct ctab *t, const struct rows_around *a, int64_t from, int64_t to, int64_t end)
{
    uint8_t need[CTAB_CORNERS];

    branch_needs(t, t->cell[from], need);
    for (int k = 0; k < CTAB_CORNERS; k++) {
        const int64_t n = a->in[k >> 1] ? (to < end ? to : end - (k & 1)) - from : 0;     /* of them have this corner */
        const int32_t *first = t->first + from + a->next[k >> 1] + (k & 1);
        int64_t i = 0;
        if (!need[k] || (n == to - from && (need[k] <= a->least[k >> 1] || !counts_beyond(first, n, need[k], CTAB_MOST))))
            continue;
        while (i < n && !counts_beyond(first + i, 1, need[k], CTAB_MOST))
            i++;
        return reason("array branch: cell %lld needs %d rows of its corner %d", (long long)(from + i), need[k], k);
    }
    return NULL;
}

/* Cells of u at one station and yaw. */
static const char *check_cells(const struct ctab *t, int64_t is, int64_t iy)
{
    const int64_t begin = (is * t->yaws + iy) * t->us, end = begin + t->us;
    const int on = iy + 1 < t->yaws, ahead = is + 1 < t->stations;
    struct rows_around a = {.in = {1, on, ahead, on && ahead}, .next = {0, t->us, t->yaws * t->us, (t->yaws + 1) * t->us}};
    const char *why = NULL;

    for (int k = 0; k < 4; k++)
        a.least[k] = a.in[k] ? smallest_count(t->first + begin + a.next[k], t->us) : 0;
    for (int64_t from = begin, to; from < end && !why; from = to) {
        if (t->cell[from] < 0 || t->cell[from] >= t->branches)
            return reason("array cell: cell %lld begins with branch %d of %lld", (long long)from, t->cell[from], (long long)t->branches);
        for (to = from + 1; to < end && t->cell[to] == t->cell[from]; to++)
            ;
        why = check_alike(t, &a, from, to, end);
    }
    return why;
}

static const char *check_all_cells(const struct ctab *t)
{
    const char *why = NULL;

    for (int k = 0; k < CTAB_CORNERS; k++)
        if (t->branches < 1 || t->branch[(t->branches - 1) * CTAB_CORNERS + k])
            return "array branch: the last row is not zeros";
    for (int64_t is = 0; is < t->stations && !why; is++)
        for (int64_t iy = 0; iy < t->yaws && !why; iy++)
            why = check_cells(t, is, iy);
    return why;
}

/* Rows and what is as many. */
static const char *read_rows(struct ctab *t, const struct vxf *f)
{
    int64_t row[2] = {-1, CTAB_N}, rest[2], link[2], branch[2] = {-1, CTAB_CORNERS};
    const char *why = vxf_get(f, "contact", VXF_F32, "mixed", 2, row, (const void **)&t->row);

    t->rows = rest[0] = link[0] = row[0];
    rest[1] = CTAB_REST;
    link[1] = CTAB_LINKS;
    if (why || (why = vxf_get(f, "rest", VXF_F32, "mixed", 2, rest, (const void **)&t->rest)) ||
        (why = vxf_get(f, "body", VXF_U8, "1", 1, row, (const void **)&t->body)) ||
        (why = vxf_get(f, "link", VXF_U8, "1", 2, link, (const void **)&t->link)) ||
        (why = vxf_get(f, "branch", VXF_U8, "1", 2, branch, (const void **)&t->branch)))
        return why;
    t->branches = branch[0];
    return NULL;
}

const char *ctab_read(struct ctab *t, const struct vxf *f)
{
    const char *why;

    *t = (struct ctab){.stations = -1, .yaws = -1, .us = -1, .rows = -1};
    if ((why = vxf_is(f, "ctab")) || (why = read_keys(t, f)) || (why = check_columns(f)) ||
        (why = vxf_get(f, "station", VXF_F64, "m", 1, &t->stations, (const void **)&t->station)) ||
        (why = vxf_get(f, "yaw", VXF_F64, "rad", 1, &t->yaws, (const void **)&t->yaw)) ||
        (why = vxf_get(f, "u", VXF_F64, "m", 1, &t->us, (const void **)&t->u)))
        return why;
    if (t->stations < 1 || t->yaws < 1 || t->us < 2 || t->stations > INT32_MAX / CTAB_MOST / t->yaws / t->us)
        return reason("needs a station, a yaw and two u, and no more than int32 rows; has %lld, %lld and %lld", (long long)t->stations,
                      (long long)t->yaws, (long long)t->us);
    int64_t firsts = nodes(t) + 1, cells = nodes(t);
    if ((why = check_axis("station", t->station, t->stations, 0)) || (why = check_axis("yaw", t->yaw, t->yaws, 1)) ||
        (why = check_axis("u", t->u, t->us, 1)) ||
        (why = vxf_get(f, "first", VXF_I32, "1", 1, &firsts, (const void **)&t->first)) ||
        (why = vxf_get(f, "cell", VXF_I32, "1", 1, &cells, (const void **)&t->cell)) || (why = read_rows(t, f)) ||
        (why = check_first(t)) || (why = check_all_cells(t)))
        return why;
    return NULL;
}

const char *ctab_put(const struct ctab *t, struct vxf_out *o)
{
    const int64_t firsts = nodes(t) + 1, cells = nodes(t), row[2] = {t->rows, CTAB_N}, rest[2] = {t->rows, CTAB_REST};
    const int64_t link[2] = {t->rows, CTAB_LINKS}, branch[2] = {t->branches, CTAB_CORNERS};

    vxf_put_key(o, "SIDE", "%c", t->side);
    vxf_put_key(o, "YAW_METHOD", "%s", t->yaw_method);
    vxf_put_key(o, "NORMAL", "%s", t->normal);
    vxf_put_key(o, "LOAD", "%.17g", t->load);
    vxf_put_key(o, "SHEAR_MODULUS", "%.17g", t->shear_modulus);
    vxf_put_key(o, "POISSON", "%.17g", t->poisson);
    vxf_put_key(o, "RADIUS", "%.17g", t->radius);
    vxf_put_key(o, "RAIL_POSITION", "%.17g", t->rail_position);
    vxf_put_key(o, "WHEEL_POSITION", "%.17g", t->wheel_position);
    for (int i = 0; i < CTAB_ALL; i++)
        vxf_put_key(o, "COLUMN", "%s %s", ctab_columns[i].name, ctab_columns[i].unit);
    vxf_put(o, "station", VXF_F64, "m", 1, &t->stations, t->station);
    vxf_put(o, "yaw", VXF_F64, "rad", 1, &t->yaws, t->yaw);
    vxf_put(o, "u", VXF_F64, "m", 1, &t->us, t->u);
    vxf_put(o, "first", VXF_I32, "1", 1, &firsts, t->first);
    vxf_put(o, "cell", VXF_I32, "1", 1, &cells, t->cell);
    vxf_put(o, "contact", VXF_F32, "mixed", 2, row, t->row);
    vxf_put(o, "rest", VXF_F32, "mixed", 2, rest, t->rest);
    vxf_put(o, "body", VXF_U8, "1", 1, &t->rows, t->body);
    vxf_put(o, "link", VXF_U8, "1", 2, link, t->link);
    vxf_put(o, "branch", VXF_U8, "1", 2, branch, t->branch);
    return o->why;
}

void ctab_free(struct ctab *t)
{
    room_release(&t->store);
    free(t->row_store);
    free(t->rest_store);
    free(t->body_store);
    *t = (struct ctab){0};
}
