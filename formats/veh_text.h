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

struct veh_text_coupling {
    char *name, *from, *to;         /* of the bodies */
    struct yaml_nums at;            /* m [3] x, y, height */
    int mirror;                     /* a twin at -y */
    struct yaml_nums stiffness;     /* N/m [3] */
    struct yaml_nums damping;       /* N s/m [3], or none */
    struct yaml_nums rotation;      /* N m/rad [3], or none */
    struct yaml_nums rotation_damping; /* N m s/rad [3], or none */
};

struct veh_text_stop {
    char *name, *from, *to;
    struct yaml_nums at;
    int mirror;
    int axis;                       /* VEH_X, VEH_Y, VEH_Z */
    struct yaml_nums table;         /* pairs of m, N */
};

struct veh_text {
    char *name;
    double gravity;                 /* m/s2 */
    struct yaml_list body;          /* of struct veh_text_body */
    struct yaml_list wheelset;      /* of struct veh_text_wheelset */
    struct yaml_list coupling;      /* of struct veh_text_coupling */
    struct yaml_list stop;          /* of struct veh_text_stop */
};

extern const struct yaml_schema veh_text_schema;

/* As yaml_read, and the checks between keys. */
const char *veh_text_read(struct veh_text *in, const char *path, char *const *set, int sets, uint64_t *hash);
void veh_text_free(struct veh_text *in);

#endif
