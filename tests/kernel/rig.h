/* Tracks, vehicles and contact tables for tests of a passage; run from the project root.
 *
 * The tables stand for a wheel that touches a plane rail with its running circle alone, so contact has closed forms: contact angle g
 * everywhere, height u tan g, contact at the running circle's lowest point. */
#ifndef VX_RIG_H
#define VX_RIG_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/ctab.h"
#include "formats/veh_text.h"
#include "tests/kernel/table1.h"
#include "tools/integrate/passage.h"
#include "tools/vehicle/vehicle.h"

#define RIG_STRAIGHT "data/tracks/thesis-straight.yaml"
#define RIG_TURNOUT "data/tracks/60E1-R760-1-15-diverging.yaml"
#define RIG_COACH "data/vehicles/manchester-passenger.yaml"
#define RIG_WHEELSET "data/vehicles/wheelset.yaml"

/* Hertz's coefficients of a new wheel on a new rail, by their order of size. */
#define RIG_HERTZ_C 9e10 /* N/m^1.5 */
#define RIG_HERTZ_A 1.3e-4 /* m/N^(1/3) */
#define RIG_HERTZ_B 1.0e-4

enum { RIG_US = 3 };
#define RIG_REACH 0.02 /* m, of u */

struct rig_table {
    struct ctab ctab;
    double station[1], yaw[1], u[RIG_US];
    float row[RIG_US][CTAB_N];
    int32_t first[RIG_US + 1];
    int32_t cell[RIG_US];
    uint8_t body[RIG_US], branch[2][CTAB_CORNERS];       /* the one branch of all cells */
};

/* A plane under contact angle g, rail and running circle at y = +-0.75 m. */
static inline void rig_table(struct rig_table *t, char side, double g)
{
    double position = side == 'r' ? 0.75 : -0.75;

    memset(t, 0, sizeof *t);
    for (int i = 0; i < RIG_US; i++) {
        double u = RIG_REACH * (i - 1);
        float *row = t->row[i];
        t->u[i] = u;
        t->first[i + 1] = i + 1;
        row[CTAB_HEIGHT] = row[CTAB_RAIL_Z] = (float)(u * tan(g));
        row[CTAB_RAIL_Y] = (float)u;
        row[CTAB_ANGLE] = (float)g;
        row[CTAB_RADIUS] = 0.46f;
        row[CTAB_HERTZ_C] = (float)RIG_HERTZ_C;
        row[CTAB_HERTZ_A] = (float)RIG_HERTZ_A;
        row[CTAB_HERTZ_B] = (float)RIG_HERTZ_B;
        row[CTAB_HEIGHT_U] = (float)tan(g);
    }
    t->branch[0][0] = t->branch[0][1] = 1;
    t->ctab = (struct ctab){.side = side, .yaw_method = "none", .shear_modulus = 82e9, .poisson = 0.28, .radius = 0.46,
                            .rail_position = position, .wheel_position = position, .stations = 1, .yaws = 1, .us = RIG_US, .rows = RIG_US,
                            .station = t->station, .yaw = t->yaw, .u = t->u, .first = t->first, .row = t->row[0], .body = t->body,
                            .cell = t->cell, .branch = t->branch[0], .branches = 2};
}

/* set: [sets] "key=value". */
static inline const char *rig_track(struct trk *t, const char *path, const char *const *set, int sets)
{
    return track_from(t, path, set, sets);
}

static inline const char *rig_vehicle(struct veh *v, const char *path, const char *const *set, int sets)
{
    struct veh_text in;
    const char *why;

    memset(v, 0, sizeof *v);
    if ((why = veh_text_read(&in, path, (char *const *)set, sets, NULL)))
        return why;
    why = vehicle_build(v, &in);
    veh_text_free(&in);
    return why;
}

/* 80 km/h, Hertz, without friction. */
static inline struct passage_options rig_options(double start, double end)
{
    struct passage_options o = {.speed = 80 / 3.6, .start = start, .end = end, .step = 1e-4,
                                .law = {.normal = WHEEL_HERTZ, .stiffness = 1e9, .step = 1e-4}};

    fastsim_begin(&o.law.grid, 10);
    return o;
}

/* Repeatable numbers within -1..1. */
static inline double rig_draw(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / 8388608.0 - 1;
}

#endif
