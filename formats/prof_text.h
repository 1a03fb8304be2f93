/* The profile input, YAML with the root key `profile`: profile-input(5).
 *
 * A wheel, a rail, a turnout made of a rail, or measured sections along the track.  The shape is given as zones, points or a file, always
 * that of the right side: y to the right (the field side), z down.  Shapes may be in mm (key unit); everything else is SI. */
#ifndef VX_FORMATS_PROF_TEXT_H
#define VX_FORMATS_PROF_TEXT_H

#include "formats/sections_text.h"
#include "formats/shape.h"
#include "formats/yaml.h"

enum prof_part { PROF_WHEEL, PROF_RAIL, PROF_TURNOUT, PROF_SECTIONS };
enum prof_unit { PROF_UNSTATED, PROF_M, PROF_MM };
enum prof_mirror { PROF_MIRROR_UNSTATED, PROF_MIRROR_NO, PROF_MIRROR_YES };
enum { TURNOUT_RIGHT, TURNOUT_LEFT };
enum { TURNOUT_DIVERGING, TURNOUT_THROUGH };

/* One piece of a shape, z over from <= y <= to: a polynomial of y, or an arc. */
struct prof_zone {
    double from, to;
    struct yaml_nums polynomial;   /* c0 + c1 y + c2 y^2 ...; n = 0 for an arc */
    struct yaml_nums centre;       /* y, z [2]; n = 0 for a polynomial */
    double radius;                 /* positive where the centre lies below the surface, as the crown of a rail */
};

/* Sections every `step` from `from` to `to`. */
struct turnout_stations { double from, to, step; };

struct turnout_text {
    double radius;                 /* m, of the diverging track's centre line */
    double ratio;                  /* n of the crossing angle 1:n, where the curve ends */
    double length;                 /* m, front to end; 0 where the profile is no turnout */
    int hand, route;
    double reach;                  /* m, a body whose running edge lies further from that of the route is left out */
    struct yaml_list stations;     /* struct turnout_stations */
    struct {
        double tip;                /* m, station where the switch rail begins */
        double edge_radius;        /* m */
        struct yaml_nums lowering; /* [thickness m, depth of its top below the stock rail's m] */
    } blade;
    struct {
        double flangeway;          /* m, between wing rail and nose: fixes the throat */
        double knee;               /* m, distance to either side of the running edge over which its edge bends away; 0 is a corner */
        double end;                /* m behind the mathematical point, where it ends; 0 where it goes on beyond `reach` */
        double flare;              /* m, length at its end over which the flangeway opens */
        double opening;            /* m, flangeway at its end; 0 where it does not open */
        double edge_radius;        /* m, of the machined top */
        double crown_radius;       /* m, of the machined top between its edge and where it is level */
        double level;              /* m, from the edge to where the top is level */
        double blend;              /* m, distance from the running edge at which the top is machined in full */
        struct yaml_nums raise;    /* [distance from the running edge m, height of its top above the rail's m] */
    } wing;
    struct {
        double edge_radius;        /* m */
        struct yaml_nums lowering; /* [width m, depth of its top below the rail's m]: begins at the first width */
    } nose;
    struct {                       /* beside the rail opposite the crossing; flangeway.n = 0 where there is none */
        int body;                  /* the sections hold it */
        double height;             /* m, its top above the rail's */
        double width;              /* m, of its level top */
        double edge_radius;        /* m, between top and working face */
        double inclination;        /* 1, of the working face to the vertical, the flangeway wider above */
        double step;               /* m, between its sections at most */
        struct yaml_nums flangeway; /* [m behind the mathematical point, m from the rail's running edge]: from its front to its end */
    } check;
};

struct prof_text {
    char *name, *source;
    int part, unit;
    char *file;                    /* relative to the input; NULL where zones or points are given */
    struct yaml_list zones;        /* struct prof_zone */
    struct yaml_nums points;       /* [y, z] */
    int symmetric;                 /* zones are given for y >= 0 */
    int64_t section;               /* of a file that holds several, from 1; 0 unstated */
    int file_side;                 /* enum shape_pick: of a file that holds both sides */
    double shift_y;                /* m, added to y */
    int mirror_y, mirror_z;        /* enum prof_mirror, before the shift: files with y towards the track's centre, or z up */
    double radius, back_to_back, flange_back;  /* m, of a wheel */
    double cant;                   /* 1, of a rail: 0.025 is 1:40 */
    double gauge, gauge_depth;     /* m, of a rail */
    double smoothing, spacing;     /* m, wavelength that is halved; between points */
    struct turnout_text turnout;
    struct sections_text sections;
};

extern const struct yaml_schema prof_text_schema;
extern const char *const prof_part_names[], *const prof_unit_names[];   /* by enum, NULL-terminated */

/* Reads and checks; zones and points are in metres afterwards, and file is made relative to where path is.
 * *hash covers the values, not the file they name. */
const char *prof_text_read(struct prof_text *t, const char *path, char *const *set, int sets, uint64_t *hash);

/* The same for a bare shape file: everything else is default or override.  unit is PROF_UNSTATED where the file says it. */
const char *prof_text_file(struct prof_text *t, const char *file, enum prof_part part, enum prof_unit unit,
                           char *const *set, int sets, uint64_t *hash);

void prof_text_free(struct prof_text *t);

/* The points of the shape, from `points` or `file`, as they stand there. */
const char *prof_text_shape(const struct prof_text *t, struct shape *s);

#endif
