/* Wheels and rails in one step: the forces between them and what these move, found together. */
#ifndef VX_INTEGRATE_COUPLE_H
#define VX_INTEGRATE_COUPLE_H

#include "tools/integrate/lateral.h"
#include "tools/integrate/way.h"
#include "tools/integrate/wheel.h"

struct passage;

/* A wheel on its rail in this step. */
struct couple {
    struct wheel_place place, left;     /* now, and a step before */
    struct way_rail rail;
    struct wheel_input in;
    struct wheel_approach approach;
    double Q;               /* N it presses with */
    double applied;         /* N of it that the rails have got */

    /* On a spatial track. */
    struct lateral side;
    struct head_force made;             /* by the wheel on its rail */
    int checked;                        /* a check rail that is a beam runs beside it, */
    struct head_place check, check_left; /* at which place now, and a step before, */
    double check_applied;               /* and has got so much, N */
};

/* Forces of all wheels, on the rails too, which have advanced; and the rails moved by them.  Fails, with wheelset, wheel and station, where a
 * wheel leaves its table, and where forces and rails do not come to agree. */
const char *couple_wheels(struct passage *p);

#endif
