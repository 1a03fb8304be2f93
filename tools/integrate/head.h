/* The head of a spatial rail under a wheel, or of a check rail beside one: how far it stands to the side and rolls.
 *
 * At its running surface a rail takes a lateral force Y, and a moment M in twist about that point of its axis: of vertical forces beside
 * the axis, which stands half the rail spacing off the track's, and of lateral ones above or below the surface.  So the rails get all of
 * a wheel's moment about the track axis.  y to the right, turns right-handed about x.
 *
 * Between its nodes an element, ends held, yields by  b Y + h t (M + h Y)  sideways and  t (M + h Y)  in twist, h the height of the surface
 * above the centroid; its slope under the force that bends it is half of the change of b along it. */
#ifndef VX_INTEGRATE_HEAD_H
#define VX_INTEGRATE_HEAD_H

#include "formats/trk.h"
#include "tools/integrate/direction.h"
#include "tools/track/beam.h"

struct head_place {
    struct direction y, twist;      /* of the running surface to the side, 1; of the rail */
    struct direction slope;         /* 1/m, of y by x */
    struct direction turn;          /* 1/m, of twist by x */
    double height;                  /* m, h */
    double b, b_half;               /* m/N, and half of its derivative by x, 1/N */
    double t, t_half;               /* rad/(N m), likewise */
};

/* Of an element of two planes, a m from its near end; near, far: numbers of w at its ends. */
void head_find(struct head_place *p, const struct beam *lateral, double torsion, double a, double height, int64_t near, int64_t far);

/* Of the check rail at station x.  Returns 0 where no beam runs there. */
int head_find_check(struct head_place *p, const struct trk *t, double x);

struct head_force {
    double Y, M;                    /* N, N m */
};

/* Where the head is and how it moves. */
struct head_motion {
    double y, v;                    /* m, m/s of the material */
    double slope;                   /* 1, dy/dx */
    double roll, vroll;             /* rad, rad/s, this one with the change along the rail */
};

/* Adds what the loaded element yields under F, which changes by rate per second, with the force moving at `speed`. */
void head_bend(const struct head_place *p, const struct head_force *F, const struct head_force *rate, double speed, struct head_motion *m);

#endif
