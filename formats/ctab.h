/* .ctab: the contacts of one wheel on its rails, over station, yaw and lateral displacement: ctab(5).
 *
 * Track axes: x forward, y to the right, z down; displacement and yaw have the same sign on both sides.
 * u is the wheel's lateral displacement at rail level against its rail (axle's y minus roll times r0, minus the
 * rail's), yaw that of the wheelset about z.  For each local minimum of the gap a node (station, yaw, u) holds a row of
 * CTAB_N numbers in a slot, the first to touch first; slots from count[node] on are zero. */
#ifndef VX_FORMATS_CTAB_H
#define VX_FORMATS_CTAB_H

#include "formats/vxf.h"

/* Columns of a contact row. */
enum ctab_column {
    CTAB_HEIGHT,      /* m, z of the running circle's lowest point when this contact touches: the smallest touches first */
    CTAB_RAIL_Y,      /* m, contact point in the rail's profile axes */
    CTAB_RAIL_Z,      /* m */
    CTAB_WHEEL_Y,     /* m, contact point in the wheel's profile axes */
    CTAB_X,           /* m, contact point ahead of the wheelset's centre, -y tan yaw included */
    CTAB_ANGLE,       /* rad, slope angle of the contact plane, atan dz/dy: negative on a right rail's gauge side */
    CTAB_RADIUS,      /* m, distance of the contact point from the axle's axis */
    CTAB_RAIL_K,      /* 1/m, lateral curvature of the rail, positive where convex */
    CTAB_WHEEL_K,     /* 1/m, lateral curvature of the wheel, positive where convex */
    CTAB_HERTZ_C,     /* N/m^1.5, N = C d^1.5 with d the approach along the normal */
    CTAB_HERTZ_A,     /* m/N^(1/3), longitudinal semi-axis a = A N^(1/3) */
    CTAB_HERTZ_B,     /* m/N^(1/3), lateral semi-axis */
    CTAB_HEIGHT_U,    /* 1, derivative of the height by u: the slope of the contact plane */
    CTAB_HEIGHT_ROLL, /* m/rad, derivative of the height by roll of the wheelset at fixed u */
    CTAB_ROLL_Y,      /* m/rad, derivative of the contact point's y by roll of the wheelset at fixed u */
    CTAB_BODY,        /* number of the rail body in the .prof, from 0 */
    CTAB_N
};

enum { CTAB_SLOTS = 8 };    /* most contacts a node may hold */

struct ctab_column_info { const char *name, *unit; };
extern const struct ctab_column_info ctab_columns[CTAB_N];

struct ctab {
    char side;                  /* 'l' or 'r' */
    char yaw_method[8];         /* none, thesis, exact */
    double shear_modulus;       /* Pa, of the Hertz columns */
    double poisson;             /* 1 */
    double radius;              /* m, nominal rolling radius r0 */
    double rail_position;       /* m, y of the rail's profile origin in track axes */
    double wheel_position;      /* m, y of the running circle in track axes, wheelset centred */
    int64_t stations, yaws, us, slots;
    const double *station;      /* m [stations] increasing; one station is the same everywhere */
    const double *yaw;          /* rad [yaws] increasing, evenly spaced; one is yaw 0 */
    const double *u;            /* m [us] increasing, evenly spaced */
    const uint8_t *count;       /* [stations][yaws][us] contacts held, 0 where none */
    const double *contact;      /* [stations][yaws][us][slots][CTAB_N], units by column */
    void *store;                /* what ctab_free releases; NULL where the arrays belong to a file */
};

const char *ctab_read(struct ctab *t, const struct vxf *f);
const char *ctab_put(const struct ctab *t, struct vxf_out *o);
void ctab_free(struct ctab *t);

#endif
