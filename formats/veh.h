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

enum veh_coupling {
    VEH_BUSHING,   /* spring and damper in x y z, rotational springs about x y z, at a common point */
    VEH_STOP       /* piecewise-linear spring along one axis, odd, zero up to its clearance */
};

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
    const double *point;             /* m [couplings][3] common point at rest, x y z as cg */
    const double *stiffness;         /* N/m, N m/rad [couplings][6] x y z, roll pitch yaw */
    const double *damping;           /* N s/m, N m s/rad [couplings][6] */
    const double *preload;           /* N [couplings][3] force on the first body at rest, x y z */
    const int64_t *stop_axis;        /* [couplings] VEH_X.. of a stop, else 0 */
    const int64_t *knot_first;       /* [couplings + 1] its first knot */
    const double *knot_at;           /* m [knots] increasing from >= 0 */
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
