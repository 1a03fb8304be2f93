/* Any track in the time step, implicit: Newmark's method with average acceleration, beta 1/4, gamma 1/2 (Newmark 1959).
 *
 * With  S = K + 2/h C + 4/h^2 M,  factored once, a step is
 *   S u = f + M (4/h^2 u0 + 4/h v0 + a0) + C (2/h u0 + v0),
 *   v = 2/h (u - u0) - v0,   a = 4/h^2 (u - u0) - 4/h v0 - a0.
 * Second order, stable with any step, without damping of its own: what it stores and dissipates is the work of the mean forces.  A force
 * F at a wheel moves the rail there by N' S^-1 N F within the step, N the shape functions: known beforehand, from the inverse within the
 * band.  z down, pitch t = -dw/dx; degrees of freedom in the order of trk.h. */
#ifndef VX_INTEGRATE_NEWMARK_H
#define VX_INTEGRATE_NEWMARK_H

#include "tools/integrate/banded.h"
#include "tools/integrate/direction.h"
#include "tools/integrate/relief.h"
#include "tools/integrate/wheel_place.h"

struct newmark {
    const struct trk *track;            /* must outlive this */
    int64_t n;                          /* degrees of freedom */
    double h;                           /* s */
    struct banded S, M, C;
    int beyond;                         /* half band of Z: all pairs of the two rails' ends of an element */
    double *Z;                          /* [n][beyond + 1] of S^-1 */
    double *weight;                     /* N [n] */
    double *u, *v, *a;                  /* m, rad; rates [n + BANDED_PAD] now */
    double *u0;                         /* a step before, while v and a still are that; v0 and a0 are not kept */
    double *f;                          /* N, N m loads that u has not got yet */
    double *displaced, *moved;          /* work: what M and C multiply */
    struct relief relief;               /* of ballast that only pushes */
    int solved;                         /* u is that of this step, without f */
    struct beam *beam[2];               /* [nodes - 1] */
    double *near[2], *far[2];           /* N m [nodes] end moments of the elements less those of their loads' held ends */
    double *near_held[2], *far_held[2]; /* N m [nodes] those */
    double *bend[2][5];                 /* N, N m [nodes] K(t1, w1 t1 t2) and K(t2, w1 t2) of the elements */
    double *pitch[2];                   /* rad [nodes] */

    double *w[2], *wa[2];               /* as of struct way */
    double *seat[2], *z, *roll, *za, *arm[2], *pad[2], *ballast[3];
    double *store;
};

/* Fails where the matrix of the step has no factor. */
const char *newmark_new(struct newmark *m, const struct trk *t, double gravity, double step);
void newmark_free(struct newmark *m);

/* At rest with u [dofs]. */
void newmark_set(struct newmark *m, const double *u);

void newmark_advance(struct newmark *m);
void newmark_load(struct newmark *m, int rail, const struct wheel_place *p, double F);
void newmark_move(struct newmark *m);

/* N, by which forces of ballast that only pushes still change: small unless newmark_move found none. */
double newmark_unrest(const struct newmark *m);

void newmark_finish(struct newmark *m);

/* f.[w t w t] of the rail, of a state u, v or a. */
double newmark_sample(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4], const double *state);

/* f.v of the rail, after newmark_move. */
double newmark_rate(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4]);

/* d.v of the track, after newmark_move. */
double newmark_speed(const struct newmark *m, const struct direction *d);

/* f.(u - u0) of the rail: how far it has come in the step. */
double newmark_moved(const struct newmark *m, int rail, const struct wheel_place *p, const double f[4]);

/* Adds to lost [sleepers] J what the dampers of each took in the step, at its mean rates; of a spatial track all to the first. */
void newmark_lose(struct newmark *m, double *lost);

/* m/N, 1/N: f' S^-1 N, f on rail `to` under a force N on rail `from`. */
double newmark_give(const struct newmark *m, const struct wheel_place *p, int to, const double f[4], int from);

/* As way_moment. */
void newmark_moment(const struct newmark *m, int rail, double *moment);

#endif
