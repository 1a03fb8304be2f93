/* .ctab: the contacts of one wheel on its rails, over station, yaw and lateral displacement: ctab(5).
 *
 * Track axes: x forward, y to the right, z down; displacement and yaw have the same sign on both sides.
 * u is the wheel's lateral displacement at rail level against its rail (axle's y minus roll times r0, minus the
 * rail's).  The station is that of the wheel's own centre: the wheelset's less wheel_position sin(yaw).  A node (station, yaw, u) holds a
 * row of CTAB_N numbers, one line of a processor's cache, for each local minimum of the gap, the first to touch first.  A row's links name
 * the rows of the neighbouring nodes that continue the same contact; interpolation goes within the branches that they join a cell's rows to. */
#ifndef VX_FORMATS_CTAB_H
#define VX_FORMATS_CTAB_H

#include "formats/vxf.h"

/* Columns of a contact: those of a row, which a time step needs, then the rest. */
enum ctab_column {
    CTAB_HEIGHT,      /* m, z of the running circle's lowest point when this contact touches: the smallest touches first */
    CTAB_HEIGHT_U,    /* 1, derivative of the height by u: the slope of the contact plane */
    CTAB_HEIGHT_YAW,  /* m/rad, by yaw */
    CTAB_HEIGHT_S,    /* 1, by station: the rail's fall where it is touched */
    CTAB_HEIGHT_ROLL, /* m/rad, by roll of the wheelset at fixed u */
    CTAB_ROLL_Y,      /* m/rad, derivative of the contact point's y by roll of the wheelset at fixed u */
    CTAB_RAIL_Y,      /* m, contact point in the rail's profile axes */
    CTAB_RAIL_Z,      /* m */
    CTAB_WHEEL_Y,     /* m, contact point in the wheel's profile axes */
    CTAB_X,           /* m, contact point ahead of the wheelset's centre, -y tan yaw included */
    CTAB_ANGLE,       /* rad, slope angle of the contact plane, atan dz/dy: negative on a right rail's gauge side */
    CTAB_RADIUS,      /* m, distance of the contact point from the axle's axis */
    CTAB_RAIL_K,      /* 1/m, lateral curvature of the rail, positive where convex */
    CTAB_HERTZ_C,     /* N/m^1.5, N = C d^1.5 with d the approach along the normal */
    CTAB_HERTZ_A,     /* m/N^(1/3), longitudinal semi-axis a = A N^(1/3) */
    CTAB_HERTZ_B,     /* m/N^(1/3), lateral semi-axis */
    CTAB_N,
    CTAB_WHEEL_K = CTAB_N, /* 1/m, lateral curvature of the wheel, positive where convex */
    CTAB_SHAPE,       /* 1, how far the gap is from the parabola of Hertz, 0 where it is one */
    CTAB_BODY,        /* number of the rail body in the .prof, from 0 */
    CTAB_ALL,
    CTAB_REST = CTAB_BODY - CTAB_N
};

enum { CTAB_MOST = 8, CTAB_BODIES = 256 };     /* contacts a node may hold, bodies a rail */

/* To the next node along each axis. */
enum ctab_link { CTAB_LINK_U, CTAB_LINK_YAW, CTAB_LINK_STATION, CTAB_LINKS };

/* Corners of the cell between a node and the next along each axis: bit 0 is set at the next u, bit 1 yaw, bit 2 station. */
enum { CTAB_CORNERS = 8 };

struct ctab_column_info { const char *name, *unit; };
extern const struct ctab_column_info ctab_columns[CTAB_ALL];

struct ctab {
    char side;                  /* 'l' or 'r' */
    char yaw_method[8];         /* none, thesis, exact */
    char normal[8];             /* hertz, or strip: the ellipse stands for a patch made strip by strip */
    double load;                /* N, on a contact: reference of the shape column and of strips */
    double shear_modulus;       /* Pa, of the Hertz columns */
    double poisson;             /* 1 */
    double radius;              /* m, nominal rolling radius r0 */
    double rail_position;       /* m, y of the rail's profile origin in track axes */
    double wheel_position;      /* m, y of the running circle in track axes, wheelset centred */
    int64_t stations, yaws, us, rows;
    const double *station;      /* m [stations] increasing; one station is the same everywhere */
    const double *yaw;          /* rad [yaws] increasing, evenly spaced; one is yaw 0 */
    const double *u;            /* m [us] increasing, evenly spaced */
    const int32_t *first;       /* [stations][yaws][us], and one more: the node's first row, its last is before the next node's first */
    const float *row;           /* [rows][CTAB_N], units by column */
    const float *rest;          /* [rows][CTAB_REST] */
    const uint8_t *body;        /* [rows] */
    const uint8_t *link;        /* [rows][CTAB_LINKS] 1 + which of the next node's rows goes on with this contact, 0 none */
    const int32_t *cell;        /* [stations][yaws][us] first branch of the cell from this node on */
    const uint8_t *branch;      /* [branches][CTAB_CORNERS] 1 + which row of each corner, 0 none; all zeros end a cell's branches */
    int64_t branches;
    const struct ctab *turned;  /* NULL, or the table this is, seen by who runs the track the other way: contact_turn */
    void *store;                /* room.h, and the rows: what ctab_free releases; NULL where the arrays belong to a file */
    float *row_store, *rest_store;
    uint8_t *body_store;
};

/* Rows [*count][CTAB_N] of a node, the first to touch first. */
const float *ctab_node(const struct ctab *t, int64_t station, int64_t yaw, int64_t u, int *count);

const char *ctab_read(struct ctab *t, const struct vxf *f);
const char *ctab_put(const struct ctab *t, struct vxf_out *o);
void ctab_free(struct ctab *t);

#endif
