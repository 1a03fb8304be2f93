/* The quasi-static equilibrium of a train that keeps its place in the track-following frames, on rails at rest: in a curve, on cant, where the
 * two sides differ, or pushed sideways.
 *
 * Unknown are the displacements of all bodies in their frames, the spins of the wheelsets in place of their pitch and, where rails yield
 * sideways, how far; x of wheelsets is prescribed.  Each body carries the force that keeps it on its way, m v^2 curvature.  Frictions of
 * the vehicle are centred there: they hold no force.  Dampers see what the frames do to each other, as on a ramp of cant.
 *
 * x forward, y to the right, z down. */
#ifndef VX_INTEGRATE_STEADY_H
#define VX_INTEGRATE_STEADY_H

#include "tools/integrate/passage.h"

struct steady_unknown {
    double *x;                      /* m, rad, rad/s where it is kept */
    double scale;                   /* the same unit, of its size */
    int64_t body;                   /* -1 for a rail */
    int dof;                        /* VEH_X...; of a rail its side */
    int64_t wheelset;               /* whose wheels feel it, -1 for none */
};

struct steady {
    struct passage *p;
    int64_t n;                      /* unknowns */
    struct steady_unknown *unknown; /* [n] */
    double *q, *v;                  /* [6 bodies] displacements and rates in the frames */
    double *r, *next;               /* [n] residuals over a wheel load, or over a scale */
    double *old, *move;             /* [n] */
    double *J, *A;                  /* [n][n] */
    int *pivot;                     /* [n] */
    double load;                    /* N, of a wheel */
    int held;                       /* wheelsets and rails stay where they are */
    struct wheel_memory *memory;    /* [wheelsets][2] kept */
};

/* From the present positions of the train in its frames. */
const char *steady_new(struct steady *s, struct passage *p);
void steady_free(struct steady *s);

/* What is not balanced, r [n], with the train where the unknowns have it; column j of J, dr/d(x/scale), about where s->r is that. */
const char *steady_residual(struct steady *s, double *r);
const char *steady_differ(struct steady *s, int64_t j);

/* The largest force N, or moment N m, that is not balanced, leaving what wheels and couplings remember as it is; fails where a wheel is beyond
 * its table. */
const char *steady_unbalanced(struct steady *s, double *most);

/* Finds it, for rails at the depth where they are; p->wheel, p->memory and all positions follow.  Fails where there is none near. */
const char *steady_find(struct steady *s);

#endif
