/* The track with lumped masses, for the explicit scheme: one rail node above every sleeper.
 *
 * z down, pitch t = -dw/dx.  The state is one vector of six parts of `stride` numbers each: deflection and pitch of the left rail's nodes, of the
 * right rail's, deflection and roll of the sleepers. */
#ifndef VX_INTEGRATE_LUMPED_H
#define VX_INTEGRATE_LUMPED_H

#include "tools/integrate/wheel_place.h"

enum lumped_part { LUMPED_WL, LUMPED_TL, LUMPED_WR, LUMPED_TR, LUMPED_Z, LUMPED_ROLL, LUMPED_PARTS };

enum { LUMPED_LANES = 8 }; /* numbers of a whole vector */

struct lumped {
    const struct trk *track;            /* must outlive this */
    int64_t n, stride;                  /* sleepers; rounded up to whole vectors */
    double gravity;                     /* m/s2 */
    double *u, *v, *a, *before;         /* [6 stride] m, rad; rates; accelerations now and a step before */
    double *pad[2], *ballast[3];        /* N [stride] compressive forces at the last accelerations, dead weight included */
    double *inverse;                    /* 1/kg, 1/(kg m2) [6 stride] */
    double *k12[2], *k6[2], *k4[2];     /* N/m, N, N m [stride] 12 EI/L^3, 6 EI/L^2, 4 EI/L of the element behind a node, or what
                                           stands for them where EI varies along it */
    double *taper_6[2], *taper_near[2], *taper_far[2]; /* N, N m, N m [stride] what its stiffness then has beside these */
    int tapered[2];                     /* whether any element of the rail has that */
    struct beam *beam[2];               /* [n - 1] */
    double *shear[2], *near[2], *far[2];/* N, N m [stride + 8] end forces of the elements, one ahead of the first */
    double *pad_k[2], *pad_c[2], *arm[2];               /* N/m, N s/m, m [stride] of the pads; arm to the sleeper's centre */
    double *ballast_k[3], *ballast_c[3], *ballast_y[3]; /* the same of the ballast */
    double *gap[3], *floor[3];          /* m, N [stride] beneath the sleeper, and the least force: 0, or -infinity where bonded */
    int pushes[3];                      /* whether any spring of the row only pushes */
    double *store;
};

/* Fails where nodes and sleepers do not go in pairs, mass does not stand at the nodes, or shear deforms the rails. */
const char *lumped_new(struct lumped *l, const struct trk *t, double gravity);
void lumped_free(struct lumped *l);

/* At rest with u [dofs of the track] m and rad, in the order of that. */
void lumped_set(struct lumped *l, const double *u);

/* The state u or v, as x [dofs of the track]. */
void lumped_state(const struct lumped *l, const double *state, double *x);

/* Accelerations a, pad and ballast forces from u and v, without wheels. */
void lumped_accelerate(struct lumped *l);

/* One step of h s by two_step.h, and the accelerations after it, without wheels. */
void lumped_step(struct lumped *l, double h);

/* f.[w t w t] with the shape or slope functions f, of the state u or v. */
double lumped_sample(const struct lumped *l, int rail, const struct wheel_place *p, const double f[4], const double *state);

/* Adds to a, and to the end moments of the element, what a force F down at the place gives. */
void lumped_load(struct lumped *l, int rail, const struct wheel_place *p, double F);

/* Bending moment N m at the nodes of a rail into m[n], positive with tension in the foot. */
void lumped_moment(const struct lumped *l, int rail, double *m);

/* rad/s, the highest natural frequency of the track without damping, by power iteration on M^-1 K (leaves the state zero); all ballast
 * touches, which is stiffest. */
double lumped_highest(struct lumped *l);

#endif
