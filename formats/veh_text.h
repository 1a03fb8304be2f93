/* The vehicle input written by people: vehicle-input(5).
 *
 * SI units; x forward, counted from the first wheelset, so the others are at negative x; y to the right; heights above rail level. */
#ifndef VX_FORMATS_VEH_TEXT_H
#define VX_FORMATS_VEH_TEXT_H

#include "formats/yaml.h"

struct veh_text_body {
    char *name;
    double mass;                    /* kg */
    struct yaml_nums inertia;       /* kg m2 [3] about x, y, z through the centre of gravity */
    double x, y, height;            /* m, of the centre of gravity */
};

struct veh_text_wheelset {
    char *name;
    double mass;                    /* kg */
    struct yaml_nums inertia;       /* kg m2 [3] */
    double x;                       /* m */
    double radius;                  /* m, nominal rolling radius: the height of the axle */
};

/* Where a coupling of any kind sits. */
struct veh_text_place {
    char *name, *from, *to;         /* of the bodies */
    struct yaml_nums at;            /* m [3] x, y, height */
    struct yaml_nums end;           /* m [3] of the end on `to`, where it is not at `at` */
    int mirror;                     /* a twin at -y */
};

struct veh_text_coupling {
    struct veh_text_place place;
    struct yaml_nums stiffness;     /* N/m [3] */
    struct yaml_nums damping;       /* N s/m [3], or none */
    struct yaml_nums rotation;      /* N m/rad [3], or none */
    struct yaml_nums rotation_damping; /* N m s/rad [3], or none */
};

struct veh_text_stop {
    struct veh_text_place place;
    int axis;                       /* VEH_X, VEH_Y, VEH_Z */
    struct yaml_nums table;         /* pairs of m, N */
};

struct veh_text_spring {
    struct veh_text_place place;
    int axis;                       /* VEH_X, VEH_Y, VEH_Z */
    double preload;                 /* N at rest; 0 leaves it to the static equilibrium */
    struct yaml_nums table;         /* pairs of m, N */
};

struct veh_text_damper {
    struct veh_text_place place;
    int axis;                       /* VEH_X, VEH_Y, VEH_Z, VEH_LINE */
    double series;                  /* N/m, 0 for rigid */
    struct yaml_nums table;         /* pairs of m/s, N */
};

struct veh_text_rod {
    struct veh_text_place place;
    double stiffness, damping;      /* N/m, N s/m along its line */
};

struct veh_text_friction {
    struct veh_text_place place;
    double coefficient, load;       /* 1, N */
    char *spring;                   /* whose vertical force loads it, or "" */
    double share;                   /* of that force */
    struct yaml_nums stiffness;     /* N/m [3] before it slides, or none */
    struct yaml_nums rotation;      /* N m/rad [3] before it slides, or none */
    double radius;                  /* m, lever of a rotation */
};

/* Bodies, wheelsets and couplings of a vehicle, or of a bogie. */
struct veh_text_parts {
    struct yaml_list body;          /* of struct veh_text_body */
    struct yaml_list wheelset;      /* of struct veh_text_wheelset */
    struct yaml_list coupling;      /* of struct veh_text_coupling */
    struct yaml_list stop;          /* of struct veh_text_stop */
    struct yaml_list spring;        /* of struct veh_text_spring */
    struct yaml_list damper;        /* of struct veh_text_damper */
    struct yaml_list rod;           /* of struct veh_text_rod */
    struct yaml_list friction;      /* of struct veh_text_friction */
};

/* Parts that are repeated, x counted from each place. */
struct veh_text_bogie {
    struct yaml_nums at;            /* m [places] x of its centre */
    struct veh_text_parts parts;
};

struct veh_text {
    char *name;
    double gravity;                 /* m/s2 */
    struct veh_text_parts parts;    /* once read, those of the bogies too */
    struct yaml_list bogie;         /* of struct veh_text_bogie */
};

extern const struct yaml_schema veh_text_schema;

/* As yaml_read, and the checks between keys. */
const char *veh_text_read(struct veh_text *in, const char *path, char *const *set, int sets, uint64_t *hash);
/* Line of the item that a reason from vehicle_build begins with, "KIND NAME: ...", or 0. */
int veh_text_line(const struct veh_text *in, const char *why);
void veh_text_free(struct veh_text *in);

#endif
