/* The train in the time step: bodies on the alignment, couplings, weights, wheel forces, gyroscopic moments.
 *
 * Lateral position and yaw of every body count from the tangent at the beginning of the alignment, roll from the level (alignment.h).  Less
 * offset, heading and cant at the body's station they are those in its own track-following frame, which wheels and recorders use; less
 * tangent and cant at the train's middle they are small in one straight frame, in which the couplings act: relative yaw, roll and lateral
 * offset of the bodies' frames are in them already.  y and z lie along the canted plane of the rails and across it, so gravity has a
 * part in each.  The pitch of a wheelset is its spin beyond -v/r0. */
#ifndef VX_INTEGRATE_TRAIN_H
#define VX_INTEGRATE_TRAIN_H

#include "formats/veh.h"
#include "tools/integrate/alignment.h"
#include "tools/integrate/wheel.h"
#include "tools/vehicle/couplings_memory.h"

struct train {
    const struct veh *vehicle;      /* must outlive this */
    int64_t dofs;                   /* 6 bodies */
    double speed;                   /* m/s */
    double *q, *v, *a, *before;     /* [dofs] m, rad; rates; accelerations now and a step before */
    double *f;                      /* [dofs] N, N m */
    double *inverse;                /* [dofs] 1/kg, 1/(kg m2); 0 for a wheelset's x, which is prescribed */
    struct alignment_point *line;   /* [bodies] the alignment at each body now */
    double middle;                  /* m, of the train, from the front wheelset: its centre of gravity */
    struct alignment_point tangent; /* the alignment there now */
    double *local;                  /* [dofs] q against that tangent */
    struct couplings_memory memory; /* of friction and series dampers */
    double h;                       /* s, of a step */
    double *S;                      /* [dofs][dofs] Cholesky factor of M + h/2 C + h^2/4 K; NULL: the explicit scheme */
};

/* In steps of h s, by the explicit scheme until told otherwise. */
const char *train_new(struct train *t, const struct veh *v, double speed, double h);
void train_free(struct train *t);

/* Steps are taken by average acceleration from here on. */
const char *train_imply(struct train *t);

/* The alignment under every body, the front wheelset at station s. */
void train_locate(struct train *t, const struct alignment *a, double s);

/* Position, rates and spin of wheelset i (from 0) in its own frame into in. */
void train_wheelset(const struct train *t, int64_t i, struct wheel_input *in);

/* One step on.  Explicit: Zhai's, done with that.  Implicit, with a the mean of the accelerations now and a step before (Newmark 1959),
 *   q = q0 + h v0 + h^2/4 (a0 + a),   v = v0 + h/2 (a0 + a),
 * with a foreseen along a straight line; train_correct then brings it to M a = f(q, v). */
void train_advance(struct train *t);

/* Forces f from q, v and the wheel forces w [wheelsets][2]. */
void train_force(struct train *t, const struct wheel_output *w);

/* Accelerations of these forces. */
void train_accelerate(struct train *t, const struct wheel_output *w);

/* Implicit: S da = f - M a, by the stiffness about rest; a, v and q follow.  Returns the largest move of a body, m or rad. */
double train_correct(struct train *t);

/* What accelerometers on body i read, in its frame: the acceleration in space less the fall of gravity, that of level track set to
 * zero.  So its forces but for m g along z are m a, canted or not. */
void train_felt(const struct train *t, int64_t i, double a[6]);

/* Displacement and rate of body i in its own frame. */
void train_in_frame(const struct train *t, int64_t i, double q[6], double v[6]);

/* The opposite: body i has this displacement and rate in its own frame. */
void train_put(struct train *t, int64_t i, const double q[6], const double v[6]);

/* Into a its acceleration when it keeps its place in that frame; between changes of curvature and of the cant's slope. */
void train_carried(const struct train *t, int64_t i, double a[6]);

/* As if the alignment were straight and level, until the next train_locate. */
void train_level(struct train *t);

#endif
