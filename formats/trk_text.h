/* The track input written by people: track-input(5).
 *
 * SI units; stations along x, curvature positive to the right, y to the right, sleepers numbered from 1 at the turnout. */
#ifndef VX_FORMATS_TRK_TEXT_H
#define VX_FORMATS_TRK_TEXT_H

#include "formats/yaml.h"

enum { TRK_TEXT_FIXED, TRK_TEXT_MOVING_MASS };           /* model */
enum { TRK_TEXT_VERTICAL, TRK_TEXT_SPATIAL };            /* dofs */
enum { TRK_TEXT_FREE, TRK_TEXT_HELD };                   /* sleeper.roll */
enum { TRK_TEXT_LUMPED, TRK_TEXT_CONSISTENT };           /* rail.mass_model */
enum { TRK_TEXT_EULER, TRK_TEXT_TIMOSHENKO };            /* rail.beam */
enum { TRK_TEXT_LEFT, TRK_TEXT_RIGHT, TRK_TEXT_BOTH };   /* zone.rail */

struct trk_text_lateral { double mass, stiffness, damping; };   /* kg, N/m, N s/m; all 0 where not given */

struct trk_text_ground { double stiffness, damping; };          /* N/m, N s/m; 0 where not given */

/* Of one rail instead of both: N m2, kg/m, kg m2, N, kg m; no knots where not given. */
struct trk_text_own { struct yaml_table bending_stiffness, mass, pitch_inertia, shear_stiffness, rotary_inertia, lateral_bending_stiffness; };

struct trk_text_rail {
    struct yaml_table bending_stiffness;  /* N m2 */
    struct yaml_table mass;               /* kg/m */
    struct yaml_table pitch_inertia;      /* kg m2 per lumped node; no knots where not given */
    struct yaml_table shear_stiffness;    /* N, kappa G A; likewise */
    struct yaml_table rotary_inertia;     /* kg m, rho I; likewise */
    int mass_model;                       /* TRK_TEXT_LUMPED, ... */
    int beam;                             /* TRK_TEXT_EULER, ... */
    int64_t elements_per_bay;
    struct yaml_table lateral_bending_stiffness;     /* N m2; from here to foot_depth of a spatial track, empty or 0 where not given */
    double yaw_inertia;                   /* kg m2 per lumped node */
    double lateral_shear_stiffness;       /* N, kappa G A sideways */
    double lateral_rotary_inertia;        /* kg m, rho I about the vertical axis */
    double torsional_stiffness;           /* N m2, GJ */
    double polar_inertia;                 /* kg m, rho Ip */
    double head_height, foot_depth;       /* m, from the centroid */
    struct trk_text_own left, right;
    struct trk_text_lateral lateral;
    double running_mass;                  /* kg, of a moving mass under a wheel */
};

struct trk_text_sleeper {
    double spacing;                       /* m */
    struct yaml_table mass;               /* kg */
    struct yaml_table roll_inertia;       /* kg m2 */
    struct yaml_table length;             /* m */
    struct yaml_table centre;             /* m, lateral, from the track's centre line */
    struct trk_text_ground lateral;       /* of a moving mass */
    int roll;                             /* TRK_TEXT_FREE, ... */
    double pitch_inertia;                 /* kg m2, not used */
    struct yaml_table yaw_inertia;        /* kg m2, of a spatial track; no knots where not given */
    double seat_height;                   /* m, railpads above the centre, likewise */
};

struct trk_text_missing {
    struct yaml_nums sleepers;            /* numbers, first and last of each range */
    int rail;                             /* TRK_TEXT_LEFT, ... */
};

struct trk_text_pad {
    struct yaml_table stiffness, damping;                 /* N/m, N s/m */
    struct yaml_table lateral_stiffness, lateral_damping; /* of a spatial track; no knots where not given */
    double width, length;                 /* m, across and along the rail, likewise */
    struct yaml_list missing;             /* of struct trk_text_missing */
};

struct trk_text_spring { struct yaml_table stiffness, damping, gap; };   /* N/m, N s/m, m; no knots where not given */

struct trk_text_ballast {
    struct yaml_table stiffness, damping; /* N/m, N s/m of a whole sleeper */
    double edge;                          /* m, outer springs from the ends of the sleeper */
    struct yaml_table gap;                /* m, void under the unloaded sleeper */
    int tension;                          /* whether ballast without a gap holds both ways */
    struct trk_text_spring left, middle, right;
    struct yaml_table lateral_stiffness, lateral_damping;            /* N/m, N s/m of a sleeper of a spatial track, no knots where */
    struct yaml_table longitudinal_stiffness, longitudinal_damping;  /* not given */
};

struct trk_text_beam {
    double from, to;                      /* m, stations between which it stands on every sleeper */
    double side;                          /* m, lateral position of its centroid */
    double bending_stiffness, lateral_bending_stiffness, torsional_stiffness;   /* N m2 */
    double mass, polar_inertia;           /* kg/m, kg m */
    double head_height, foot_depth;       /* m, from its centroid */
    double stiffness, damping;            /* N/m, N s/m of a fastening, vertical */
    double lateral_stiffness, lateral_damping;       /* likewise, lateral; 0: as the vertical */
};

struct trk_text_check {
    int rail;                             /* TRK_TEXT_LEFT or TRK_TEXT_RIGHT */
    double stiffness, damping;            /* N/m, N s/m */
    struct yaml_table play;               /* m over station */
    struct trk_text_beam beam;            /* of a spatial track; all 0 where not given */
};

struct trk_text_curve { double from, curvature; };              /* m, 1/m */

/* N/m, N s/m; 0 keeps the reference */
struct trk_text_zone_pad { double stiffness, damping, lateral_stiffness, lateral_damping; };

struct trk_text_zone {
    char *name;
    struct yaml_nums sleepers;            /* numbers, first and last of each range */
    int rail;                             /* TRK_TEXT_LEFT, ... */
    struct trk_text_zone_pad railpad;
};

struct trk_text {
    char *name;
    int model;                            /* TRK_TEXT_FIXED, ... */
    int dofs;                             /* TRK_TEXT_VERTICAL, ... */
    double from, length;                  /* m */
    double first_sleeper;                 /* m, station where the bay of sleeper 1 begins */
    double rail_spacing;                  /* m */
    struct trk_text_rail rail;
    struct trk_text_sleeper sleeper;
    struct trk_text_pad railpad;
    struct trk_text_ballast ballast;
    struct yaml_list check_rail;          /* of struct trk_text_check, none or one */
    struct yaml_list curve;               /* of struct trk_text_curve */
    struct yaml_table cant;               /* m over station */
    struct yaml_list zone;                /* of struct trk_text_zone */
};

extern const struct yaml_schema trk_text_schema;

/* As yaml_read, and the checks between keys. */
const char *trk_text_read(struct trk_text *in, const char *path, char *const *set, int sets, uint64_t *hash);
void trk_text_free(struct trk_text *in);

#endif
