/* A case: one passage, as people write it: case-input(5).  SI, but for the speed. */
#ifndef VX_FORMATS_CASE_TEXT_H
#define VX_FORMATS_CASE_TEXT_H

#include "formats/run.h"
#include "formats/yaml.h"

enum case_route { CASE_THROUGH, CASE_DIVERGING };
enum case_direction { CASE_FACING, CASE_TRAILING };
enum case_scheme { CASE_EXPLICIT, CASE_IMPLICIT, CASE_AUTO };
enum case_law { CASE_HERTZ, CASE_LINEAR };
enum case_side { CASE_BOTH, CASE_LEFT, CASE_RIGHT };
enum case_place { CASE_ON_LEFT, CASE_ON_RIGHT, CASE_ON_SLEEPER };
enum case_kind { CASE_IMPULSE, CASE_SWEEP, CASE_NOISE };

enum case_shape { CASE_FRESH, CASE_WORN };
enum case_spectrum { CASE_NO_SPECTRUM, CASE_ERRI_LOW, CASE_ERRI_HIGH };

struct case_dip {
    double from, length, depth;              /* m */
    int rail;                                /* enum case_side */
};

struct case_joint {
    double at, length, depth;                /* m */
    int rail;                                /* enum case_side */
};

struct case_flat {
    int64_t wheelset;                        /* from 1 */
    int side;                                /* enum case_side */
    int shape;                               /* enum case_shape */
    double length, at;                       /* m, of the chord; a station where it meets the rail */
};

/* Contacts with a coefficient of friction of their own. */
struct case_friction {
    int side;                                /* enum case_side */
    int64_t body;                            /* number of the rail body in the contact table, from 0; -1 is any */
    double from, to;                         /* m, stations of the wheel */
    double angle;                            /* rad, contact angle from which on, either way */
    double friction;                         /* 1 */
};

struct case_force {                          /* amplitude 0: none */
    int rail;                                /* RUN_ON_LEFT, RUN_ON_RIGHT, RUN_ON_BOTH */
    int kind;                                /* enum case_kind */
    double at;                               /* m */
    double amplitude;                        /* N */
    double width;                            /* s */
    double from, to;                         /* Hz */
    double duration, rest;                   /* s */
    int64_t blows, seed;
};

struct case_probe {
    int on;                                  /* enum case_place */
    double at;                               /* m */
};

struct case_text {
    char *name;
    char *track, *vehicle;                   /* files, relative to the case; NULL where not named */
    char *contact_left, *contact_right;
    char *creep;                             /* .creep file; NULL: FASTSIM */
    double speed;                            /* km/h: the one input that is not SI; 0 where not given */
    int route, direction;                    /* enum case_route, case_direction */
    double friction;                         /* 1 */
    struct { double limit, decay; } falling; /* 1, s/m: friction times (1 - limit) exp(-decay w) + limit, w the slip's velocity */
    struct yaml_list friction_on;            /* of struct case_friction */
    double start, end;                       /* m, stations of the front wheelset */
    double step;                             /* s */
    int scheme;                              /* enum case_scheme */
    int train_scheme;                        /* 0 explicit, 1 implicit */
    struct {
        int law;                             /* enum case_law */
        double stiffness, damping, series;   /* N/m, N s/m, N/m: of the linear law */
        double hertz_damping;                /* s/m */
        int64_t grid;                        /* strips and steps of FASTSIM */
    } contact;
    double sampling;                         /* Hz */
    int filter;                              /* 1: samples are low-passed */
    struct { int group[RUN_GROUPS]; } channels;
    struct yaml_list dip, joint, flat;       /* of struct case_dip, case_joint, case_flat */
    struct {
        char *file;                          /* irregularity.h, relative to the case; NULL where there is none */
        int spectrum;                        /* enum case_spectrum */
        int64_t seed;
        double shortest, longest;            /* m, wavelengths */
        double scale, fade;                  /* 1, m */
    } irregularity;
    struct case_force force;                 /* instead of a vehicle */
    struct yaml_list probe;                  /* of struct case_probe */
};

extern const struct yaml_schema case_text_schema;

/* What the keys of a case owe each other, beside what its track and train ask. */
const char *case_text_check(const struct case_text *c);

#endif
