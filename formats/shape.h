/* The points of a profile file as they stand in it, and what the file says of its axes: profile-input(5).
 *
 * The ending names the kind, in any case of letters: Simpack .prr .prw, MiniProf .ban .bnd .whl .mpt, GENSYS .rail .wheel,
 * Vampire .rai .whe; any other is plain points.  Which way round they are is settled by tools/profile/orient.h. */
#ifndef VX_FORMATS_SHAPE_H
#define VX_FORMATS_SHAPE_H

#include "formats/points.h"

struct shape_kind {
    const char *ending;
    const char *name;        /* of the kind, as "MiniProf" */
    char part;               /* 'w' wheel, 'r' rail; 0 where the ending does not say */
    double unit;             /* m of one unit of its columns; 0 where it does not say */
    int y_to_centre, z_up;   /* its usual axes */
    int fixed;               /* they are the kind's rule or stated by keys of the file; else files turned round are about too */
    int from_back;           /* the y of a wheel counts from its flange back */
};

struct shape {
    const struct shape_kind *kind;
    struct points points;    /* m */
    char side;               /* 'l' or 'r' as the file says; 0 where it does not */
    double flange_height, flange_width, flange_slope;   /* m, the Sh, Sd and qR that the file says; 0 where it does not */
    double distance;         /* m, between the flange backs, or the gauge, as the file says; 0 where it does not */
    double datum;            /* m, from the flange back to the running circle, or from the top to the gauge point; the same */
};

enum shape_pick { SHAPE_ANY, SHAPE_RIGHT, SHAPE_LEFT };

struct shape_choice {
    char part;               /* 'w' or 'r' */
    double unit;             /* m, of plain points; 0 where their heading is to say */
    int64_t section;         /* of a file that holds several, from 1; 0 where it holds one */
    int pick;                /* enum shape_pick: of a file that holds both sides */
};

/* Never NULL. */
const struct shape_kind *shape_kind(const char *path);

/* path "-" is standard input. */
const char *shape_read(struct shape *s, const char *path, const struct shape_choice *c);
void shape_free(struct shape *s);

#endif
