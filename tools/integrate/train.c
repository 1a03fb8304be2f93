#include "tools/integrate/train.h"
#include "formats/reason.h"
#include "tools/integrate/two_step.h"
#include "tools/vehicle/couplings.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void set_inverse(struct train *t)
{
    const struct veh *v = t->vehicle;

    for (int64_t i = 0; i < v->bodies; i++)
        for (int k = 0; k < 6; k++)
            t->inverse[6 * i + k] = 1 / (k < 3 ? v->mass[i] : v->inertia[3 * i + k - 3]);
    for (int64_t i = 0; i < v->wheelsets; i++)
        t->inverse[6 * v->wheelset[i] + VEH_X] = 0;
}

static double middle(const struct veh *v)
{
    double mass = 0, moment = 0;

    for (int64_t i = 0; i < v->bodies; i++) {
        mass += v->mass[i];
        moment += v->mass[i] * v->cg[3 * i];
    }
    return mass > 0 ? moment / mass : 0;
}

const char *train_new(struct train *t, const struct veh *v, double speed, double h)
{
    size_t n = (size_t)(6 * v->bodies);

    *t = (struct train){.vehicle = v, .dofs = 6 * v->bodies, .speed = speed, .middle = middle(v), .h = h};
    const char *why = couplings_memory_new(&t->memory, v);
    t->q = calloc(7 * n, sizeof *t->q);
    t->line = calloc((size_t)v->bodies, sizeof *t->line);
    if (why || !t->q || !t->line) {
        train_free(t);
        return REASON_MEMORY;
    }
    t->v = t->q + n;
    t->a = t->v + n;
    t->before = t->a + n;
    t->f = t->before + n;
    t->inverse = t->f + n;
    t->local = t->inverse + n;
    set_inverse(t);
    return NULL;
}

void train_free(struct train *t)
{
    free(t->q);
    free(t->line);
    free(t->S);
    couplings_memory_free(&t->memory);
    *t = (struct train){0};
}

/* What is prescribed has no share in it. */
const char *train_imply(struct train *t)
{
    const struct veh *v = t->vehicle;
    const int64_t n = t->dofs;
    const double h = t->h;

    if (!(t->S = calloc((size_t)(n * n) + 1, sizeof *t->S)))
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++) {
        for (int64_t j = 0; j < n; j++)
            if (t->inverse[i] > 0 && t->inverse[j] > 0)
                t->S[i * n + j] = 0.5 * h * v->C[i * n + j] + 0.25 * h * h * v->K[i * n + j];
        t->S[i * n + i] += t->inverse[i] > 0 ? 1 / t->inverse[i] : 1;
    }
    if (n > 0 && LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', (lapack_int)n, t->S, (lapack_int)n) != 0)
        return "the implicit scheme finds no factor of the vehicle's matrices";
    return NULL;
}

void train_locate(struct train *t, const struct alignment *a, double s)
{
    for (int64_t i = 0; i < t->vehicle->bodies; i++)
        t->line[i] = alignment_at(a, s + t->vehicle->cg[3 * i]);
    t->tangent = alignment_at(a, s + t->middle);
}

/* Where the origin of body i's frame puts it: a roll about the centre line moves its centre of gravity, at (y, z), by roll (-z, y). */
static void frame_at(const struct train *t, int64_t i, double offset, double heading, double roll, double place[6])
{
    const double *cg = &t->vehicle->cg[3 * i];

    place[VEH_X] = place[VEH_PITCH] = 0;
    place[VEH_Y] = offset - roll * cg[2];
    place[VEH_Z] = roll * cg[1];
    place[VEH_ROLL] = roll;
    place[VEH_YAW] = heading;
}

/* Positions and rotations against the tangent and the cant at the train's middle.  Rates may keep the motion of that frame, which is
 * that of a rigid body and moves no coupling. */
static void localise(struct train *t)
{
    const struct alignment_point *p = &t->tangent;

    for (int64_t i = 0; i < t->vehicle->bodies; i++) {
        double place[6];
        frame_at(t, i, p->offset + p->heading * (t->vehicle->cg[3 * i] - t->middle), p->heading, p->cant, place);
        for (int k = 0; k < 6; k++)
            t->local[6 * i + k] = t->q[6 * i + k] - place[k];
    }
}

/* Where the frame of body i has it, and how it carries it: d offset/dt = heading v,  d heading/dt = curvature v,  d cant/dt = twist v. */
static void frame_of(const struct train *t, int64_t i, double place[6], double rate[6])
{
    const struct alignment_point *p = &t->line[i];

    frame_at(t, i, p->offset, p->heading, p->cant, place);
    frame_at(t, i, p->heading * t->speed, p->curvature * t->speed, p->twist * t->speed, rate);
}

void train_in_frame(const struct train *t, int64_t i, double q[6], double v[6])
{
    double place[6], rate[6];

    frame_of(t, i, place, rate);
    for (int k = 0; k < 6; k++) {
        q[k] = t->q[6 * i + k] - place[k];
        v[k] = t->v[6 * i + k] - rate[k];
    }
}

void train_put(struct train *t, int64_t i, const double q[6], const double v[6])
{
    double place[6], rate[6];

    frame_of(t, i, place, rate);
    for (int k = 0; k < 6; k++) {
        t->q[6 * i + k] = place[k] + q[k];
        t->v[6 * i + k] = rate[k] + v[k];
    }
}

void train_carried(const struct train *t, int64_t i, double a[6])
{
    frame_at(t, i, t->line[i].curvature * t->speed * t->speed, 0, 0, a);
}

void train_level(struct train *t)
{
    memset(t->line, 0, (size_t)t->vehicle->bodies * sizeof *t->line);
    t->tangent = (struct alignment_point){0};
}

/* Acceleration of body i by its weight in axes rolled by the cant, with what of the centripetal acceleration along them is not yet in its
 * coordinates, which count as if the plane of the rails were level:
 *   along y: g sin - (v^2 curvature)(cos - 1),   along z: g cos + v^2 curvature sin. */
static void fall(const struct train *t, int64_t i, double a[3])
{
    const struct alignment_point *p = &t->line[i];
    const double g = t->vehicle->gravity, inward = t->speed * t->speed * p->curvature;

    a[VEH_X] = 0;
    a[VEH_Y] = g * sin(p->cant) + inward * (1 - cos(p->cant));
    a[VEH_Z] = g * cos(p->cant) + inward * sin(p->cant);
}

void train_felt(const struct train *t, int64_t i, double a[6])
{
    double weight[3];

    fall(t, i, weight);
    memcpy(a, t->a + 6 * i, 6 * sizeof *a);
    a[VEH_Y] -= weight[VEH_Y];
    a[VEH_Z] -= weight[VEH_Z] - t->vehicle->gravity;
}

void train_wheelset(const struct train *t, int64_t i, struct wheel_input *in)
{
    int64_t body = t->vehicle->wheelset[i];
    double q[6], v[6];

    train_in_frame(t, body, q, v);
    in->v = t->speed;
    in->curvature = t->line[body].curvature;
    in->radius = t->vehicle->radius[i];
    in->y = q[VEH_Y];
    in->z = q[VEH_Z];
    in->roll = q[VEH_ROLL];
    in->yaw = q[VEH_YAW];
    in->vy = v[VEH_Y];
    in->vz = v[VEH_Z];
    in->vroll = v[VEH_ROLL];
    in->vyaw = v[VEH_YAW];
    in->spin = v[VEH_PITCH] - t->speed / in->radius;
}

/* Forces of both wheels, and what turning the spinning wheelset takes: with the axle along (-yaw, 1, roll) and H = Jy spin,
 *   Jx roll'' - H yaw' = Mx,   Jz yaw'' + H roll' = Mz,   yaw' that in space. */
static void add_wheels(struct train *t, int64_t i, const struct wheel_output w[2])
{
    const struct veh *v = t->vehicle;
    int64_t body = v->wheelset[i];
    double *f = t->f + 6 * body, *rate = t->v + 6 * body;
    double H = v->inertia[3 * body + 1] * (rate[VEH_PITCH] - t->speed / v->radius[i]);

    f[VEH_PITCH] = 0; /* the bearings leave the axle free */
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < 3; k++) {
            f[k] += w[side].force[k];
            f[3 + k] += w[side].moment[k];
        }
    f[VEH_ROLL] += H * rate[VEH_YAW];
    f[VEH_YAW] -= H * rate[VEH_ROLL];
}

static void foresee(struct train *t)
{
    const double h = t->h;

    for (int64_t k = 0; k < t->dofs; k++) {
        const double a0 = t->a[k], a = 2 * a0 - t->before[k];
        t->q[k] += h * t->v[k] + 0.25 * h * h * (a0 + a);
        t->v[k] += 0.5 * h * (a0 + a);
        t->before[k] = a0;
        t->a[k] = a;
    }
}

void train_advance(struct train *t)
{
    couplings_keep(&t->memory, t->h);
    if (t->S)
        foresee(t);
    else
        two_step(t->dofs, t->h, t->q, t->v, t->a, t->before);
}

double train_correct(struct train *t)
{
    const lapack_int n = (lapack_int)t->dofs;
    const double h = t->h;
    double most = 0;

    for (int64_t k = 0; k < t->dofs; k++)
        t->local[k] = t->inverse[k] > 0 ? t->f[k] - t->a[k] / t->inverse[k] : 0;
    LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'L', n, 1, t->S, n, t->local, n);
    for (int64_t k = 0; k < t->dofs; k++) {
        const double da = t->local[k], move = 0.25 * h * h * da;
        t->a[k] += da;
        t->v[k] += 0.5 * h * da;
        t->q[k] += move;
        most = fmax(most, fabs(move));
    }
    return most;
}

void train_force(struct train *t, const struct wheel_output *w)
{
    const struct veh *v = t->vehicle;

    memset(t->f, 0, (size_t)t->dofs * sizeof *t->f);
    for (int64_t i = 0; i < v->bodies; i++) {
        double weight[3];
        fall(t, i, weight);
        t->f[6 * i + VEH_Y] = v->mass[i] * weight[VEH_Y];
        t->f[6 * i + VEH_Z] = v->mass[i] * weight[VEH_Z];
    }
    localise(t);
    couplings_force(v, &t->memory, t->local, t->v, t->f);
    for (int64_t i = 0; i < v->wheelsets; i++)
        add_wheels(t, i, w + 2 * i);
}

void train_accelerate(struct train *t, const struct wheel_output *w)
{
    train_force(t, w);
    for (int64_t k = 0; k < t->dofs; k++)
        t->a[k] = t->f[k] * t->inverse[k];
}
