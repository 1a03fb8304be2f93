/* .veh: a train as rigid bodies and couplings: veh(5).
 *
 * Track axes: x forward, y to the right, z down from rail level; so the height h of a point is z = -h.  Each body follows its own
 * frame on the track centre line, at the station of its centre of gravity.  Displacements count from the rest
 * position on straight level track, in which the couplings carry `preload`. */
#ifndef VX_FORMATS_VEH_H
#define VX_FORMATS_VEH_H

#include "formats/vxf.h"

/* Degrees of freedom of a body, in this order. */
enum { VEH_X, VEH_Y, VEH_Z, VEH_ROLL, VEH_PITCH, VEH_YAW, VEH_DOFS };

/* In this order in the list of couplings, so that a friction finds the force of its spring ready. */
enum veh_coupling {
    VEH_BUSHING,   /* spring and damper in x y z, rotational springs about x y z, at a common point */
    VEH_STOP,      /* piecewise-linear spring along one axis, odd, zero up to its clearance */
    VEH_SPRING,    /* piecewise-linear spring along one axis, from its free length, which may carry weight */
    VEH_DAMPER,    /* piecewise-linear damper along one axis or a line, odd, rigid or in series with a spring */
    VEH_ROD,       /* spring and damper along the line between two ends */
    VEH_FRICTION,  /* dry friction with a stick stiffness, its limit a share of the load of a spring */
    VEH_COUPLINGS
};
enum { VEH_LINE = 3 };  /* axis of what acts along the line from its first to its second end */

struct veh {
    char name[64];
    double gravity;                  /* m/s2 */
    int64_t bodies, couplings, wheelsets, knots;
    const char (*body_name)[32];     /* [bodies] */
    const double *mass;              /* kg [bodies] */
    const double *inertia;           /* kg m2 [bodies][3] about x, y, z through the centre of gravity */
    const double *cg;                /* m [bodies][3] x counted back from the first wheelset (so negative), y, z = -height */
    const char (*coupling_name)[32]; /* [couplings] */
    const int64_t *type;             /* [couplings] enum veh_coupling */
    const int64_t *ends;             /* [couplings][2] bodies; force and moment are those on the second */
    const int64_t *bearing;          /* [couplings] end, 0 or 1, at a wheelset, whose pitch it does not see; else -1 */
    const double *point;             /* m [couplings][3] end on the first body at rest, x y z as cg */
    const double *end;               /* m [couplings][3] end on the second: the same point, but for lines */
    const double *stiffness;         /* N/m, N m/rad [couplings][6] x y z, roll pitch yaw; of a rod the first; of friction stick */
    const double *damping;           /* N s/m, N m s/rad [couplings][6]; of a rod the first */
    const double *preload;           /* N [couplings][3] force on the first body at rest, x y z */
    const int64_t *axis;             /* [couplings] VEH_X.. of a stop, spring or damper, or VEH_LINE; else 0 */
    const double *series;            /* N/m [couplings] stiffness in series with a damper, 0 for rigid */
    const double *rest;              /* m [couplings] place of a spring in its table at rest */
    const double *coefficient;       /* [couplings] of friction */
    const double *load;              /* N [couplings] normal force of friction that does not depend on a spring */
    const int64_t *spring;           /* [couplings] whose vertical force loads a friction, before it in the list, or -1 */
    const double *share;             /* [couplings] of that force */
    const double *lever;             /* m [couplings] lever of a friction about axes, 0 for one along axes */
    const int64_t *knot_first;       /* [couplings + 1] its first knot */
    const double *knot_at;           /* m, m/s [knots] deflection, compression or rate, increasing */
    const double *knot_force;        /* N [knots] */
    const int64_t *wheelset;         /* [wheelsets] body of each wheelset, from the front */
    const double *radius;            /* m [wheelsets] nominal rolling radius r0 */
    const double *wheel_load;        /* N [wheelsets][2] static, left and right */
    const double *K, *C, *M;         /* [6 bodies][6 bodies] about rest, wheelsets included; degrees of freedom by body */
    void *store;
};

/* A vehicle being built: n zeroed items of this size, which live as long as it does; NULL without memory. */
void *veh_room(struct veh *v, int64_t n, size_t size);

/* What veh_read and veh_put ask of a vehicle, its matrices and loads aside. */
const char *veh_check(const struct veh *v);

/* 1 where the body is a wheelset, else 0. */
int veh_is_wheelset(const struct veh *v, int64_t body);

const char *veh_read(struct veh *v, const struct vxf *f);
const char *veh_put(const struct veh *v, struct vxf_out *o);
void veh_free(struct veh *v);

#endif
