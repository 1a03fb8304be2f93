/* The permanent way in the time step: rails, sleepers and ballast, moved by one of two schemes.
 *
 * Explicit: lumped masses, one element a bay, Zhai's two-step method (lumped.h); nothing is solved, and a step is stable up to a limit.
 * Implicit: any track, average acceleration, one banded factor (newmark.h); stable with any step, and the rails give to the forces of a
 * step within it.  z down, x forward, y to the right, pitch t = -dw/dx.
 *
 * A step:   way_advance, way_load of what forces are foreseen, way_move;
 *           then way_look under each wheel, way_load of what differs from the foreseen, way_move, until nothing differs (way_yields: else
 *           once is all, and there is no need to foresee);
 *           way_finish. */
#ifndef VX_INTEGRATE_WAY_H
#define VX_INTEGRATE_WAY_H

#include "formats/state.h"
#include "tools/integrate/lumped.h"
#include "tools/integrate/newmark.h"
#include "tools/integrate/wheel_place.h"

enum way_scheme { WAY_EXPLICIT, WAY_IMPLICIT, WAY_AUTO };

struct way {
    enum way_scheme scheme;             /* the one that moves it: explicit or implicit */
    char because[160];                  /* why */
    const struct trk *track;            /* must outlive this */
    double gravity, step;               /* m/s2, s */
    double limit;                       /* s, of a stable step; HUGE_VAL */
    int accelerated;                    /* the explicit one: by way_advance */
    int at_rest;                        /* not moved yet: the state is what way_set gave */
    struct lumped lumped;               /* the one, */
    struct newmark newmark;             /* or the other */

    /* What the last way_finish left, for those who record it. */
    const double *w[2], *wa[2];         /* m, m/s2 [nodes] deflection and acceleration of the rails */
    const double *seat[2];              /* m [sleepers] deflection of the rails above the sleepers */
    const double *z, *roll, *za;        /* m, rad, m/s2 [sleepers] */
    const double *arm[2];               /* m [sleepers] from the sleeper's centre to the railpad */
    const double *pad[2], *ballast[3];  /* N [sleepers] compressive */
};

/* The rail under a wheel. */
struct way_rail {
    double z, v, slope;                 /* m, m/s, 1 deflection, rate of the material, dw/dx, under what is loaded so far */
    double local;                       /* m/N beside it, of the loaded element between its nodes */
    double give, give_other;            /* m/N what a force gives within the step under it, and at the same place of the other rail */
    double turn, turn_other;            /* 1/N the same of the slope */
    double quick;                       /* 1/s rate of that over it */

    /* Of a spatial rail. */
    struct head_motion head;            /* of its nodes; vroll is the material's */
    double head_turn;                   /* 1/m change of its roll along it */
    double yield[3];                    /* m/N, 1/N, rad/(N m) what its head gives within the step, to the side by Y and M and in twist by M */
};

/* Fails where the scheme asked for does not hold on this track or with this step. */
const char *way_new(struct way *w, const struct trk *t, double gravity, double step, enum way_scheme scheme);
void way_free(struct way *w);

/* At rest with u [dofs] m and rad, in the order of t. */
void way_set(struct way *w, const double *u);

/* u, v [dofs] m and rad, m/s and rad/s, in the order of the track. */
void way_state(const struct way *w, double *u, double *v);

/* The arrays that a step takes from the one before into part [WAY_PARTS], displacements first; returns how many. */
enum { WAY_PARTS = 4 };
int way_parts(struct way *w, struct state_part *part);

/* Those arrays have been set to what a moving track had. */
void way_resume(struct way *w);

/* One step on, without wheels. */
void way_advance(struct way *w);

struct wheel_place way_find(const struct way *w, int rail, double x);
void way_load(struct way *w, int rail, const struct wheel_place *p, double F);
void way_load_head(struct way *w, const struct head_place *p, const struct head_force *F);
void way_move(struct way *w);

/* Whether the rails give to forces within this step. */
static inline int way_yields(const struct way *w)
{
    return w->scheme == WAY_IMPLICIT && !w->at_rest;
}

/* N, by which forces of the track itself still change after way_move; 0 where they are found. */
double way_unrest(const struct way *w);

void way_look(const struct way *w, int rail, const struct wheel_place *p, struct way_rail *r);

/* The head of a spatial rail, or of a check rail, and what it yields as in struct way_rail. */
void way_look_head(const struct way *w, const struct head_place *p, struct head_motion *m, double *turn, double yield[3]);

/* Forces in pads and ballast, and all that is shown above. */
void way_finish(struct way *w);

/* Bending moment N m at the nodes of a rail into m [nodes], positive with tension in the foot: after way_finish. */
void way_moment(const struct way *w, int rail, double *m);

#endif
