/* Reads, checks and writes .ctab: ctab(5). */
#include "formats/ctab.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

#define EVEN 1e-6        /* of a step: how far an evenly spaced axis may be off */

const struct ctab_column_info ctab_columns[CTAB_N] = {
    [CTAB_HEIGHT] = {"height", "m"},
    [CTAB_RAIL_Y] = {"rail_y", "m"},
    [CTAB_RAIL_Z] = {"rail_z", "m"},
    [CTAB_WHEEL_Y] = {"wheel_y", "m"},
    [CTAB_X] = {"x", "m"},
    [CTAB_ANGLE] = {"angle", "rad"},
    [CTAB_RADIUS] = {"radius", "m"},
    [CTAB_RAIL_K] = {"rail_curvature", "1/m"},
    [CTAB_WHEEL_K] = {"wheel_curvature", "1/m"},
    [CTAB_HERTZ_C] = {"hertz_c", "N/m^1.5"},
    [CTAB_HERTZ_A] = {"hertz_a", "m/N^(1/3)"},
    [CTAB_HERTZ_B] = {"hertz_b", "m/N^(1/3)"},
    [CTAB_HEIGHT_U] = {"height_u", "1"},
    [CTAB_HEIGHT_ROLL] = {"height_roll", "m/rad"},
    [CTAB_ROLL_Y] = {"roll_y", "m/rad"},
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
    for (int i = 0; i < CTAB_N; i++) {
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
        {"SHEAR_MODULUS", &t->shear_modulus, 1},
        {"POISSON", &t->poisson, 0},
        {"RADIUS", &t->radius, 1},
        {"RAIL_POSITION", &t->rail_position, 0},
        {"WHEEL_POSITION", &t->wheel_position, 0},
    };
    char side[4];
    const char *why;

    if ((why = vxf_key(f, "SIDE", side, sizeof side)) ||
        (why = vxf_key(f, "YAW_METHOD", t->yaw_method, sizeof t->yaw_method)))
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

const char *ctab_read(struct ctab *t, const struct vxf *f)
{
    const void *station, *yaw, *u, *count, *contact;
    const char *why;

    *t = (struct ctab){.stations = -1, .yaws = -1, .us = -1, .slots = -1};
    if ((why = vxf_is(f, "ctab")) || (why = read_keys(t, f)) || (why = check_columns(f)) ||
        (why = vxf_get(f, "station", VXF_F64, "m", 1, &t->stations, &station)) ||
        (why = vxf_get(f, "yaw", VXF_F64, "rad", 1, &t->yaws, &yaw)) ||
        (why = vxf_get(f, "u", VXF_F64, "m", 1, &t->us, &u)))
        return why;
    if (t->stations < 1 || t->yaws < 1 || t->us < 2)
        return reason("needs a station, a yaw and two u, has %lld, %lld and %lld", (long long)t->stations, (long long)t->yaws,
                      (long long)t->us);
    int64_t node[3] = {t->stations, t->yaws, t->us};
    int64_t row[5] = {t->stations, t->yaws, t->us, -1, CTAB_N};
    if ((why = check_axis("station", station, t->stations, 0)) || (why = check_axis("yaw", yaw, t->yaws, 1)) ||
        (why = check_axis("u", u, t->us, 1)) || (why = vxf_get(f, "count", VXF_U8, "1", 3, node, &count)) ||
        (why = vxf_get(f, "contact", VXF_F64, "mixed", 5, row, &contact)))
        return why;
    t->slots = row[3];
    if (t->slots < 1 || t->slots > CTAB_SLOTS)
        return reason("array contact: %lld slots, must be 1 to %d", (long long)t->slots, CTAB_SLOTS);
    t->station = station;
    t->yaw = yaw;
    t->u = u;
    t->count = count;
    t->contact = contact;
    for (int64_t i = 0; i < t->stations * t->yaws * t->us; i++)
        if (t->count[i] > t->slots)
            return reason("array count: %d at %lld, but there are %lld slots", t->count[i], (long long)i, (long long)t->slots);
    return NULL;
}

const char *ctab_put(const struct ctab *t, struct vxf_out *o)
{
    const int64_t node[3] = {t->stations, t->yaws, t->us};
    const int64_t row[5] = {t->stations, t->yaws, t->us, t->slots, CTAB_N};

    vxf_put_key(o, "SIDE", "%c", t->side);
    vxf_put_key(o, "YAW_METHOD", "%s", t->yaw_method);
    vxf_put_key(o, "SHEAR_MODULUS", "%.17g", t->shear_modulus);
    vxf_put_key(o, "POISSON", "%.17g", t->poisson);
    vxf_put_key(o, "RADIUS", "%.17g", t->radius);
    vxf_put_key(o, "RAIL_POSITION", "%.17g", t->rail_position);
    vxf_put_key(o, "WHEEL_POSITION", "%.17g", t->wheel_position);
    for (int i = 0; i < CTAB_N; i++)
        vxf_put_key(o, "COLUMN", "%s %s", ctab_columns[i].name, ctab_columns[i].unit);
    vxf_put(o, "station", VXF_F64, "m", 1, &t->stations, t->station);
    vxf_put(o, "yaw", VXF_F64, "rad", 1, &t->yaws, t->yaw);
    vxf_put(o, "u", VXF_F64, "m", 1, &t->us, t->u);
    vxf_put(o, "count", VXF_U8, "1", 3, node, t->count);
    vxf_put(o, "contact", VXF_F64, "mixed", 5, row, t->contact);
    return o->why;
}

void ctab_free(struct ctab *t)
{
    free(t->store);
    *t = (struct ctab){0};
}
