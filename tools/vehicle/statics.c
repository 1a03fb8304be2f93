/* Static equilibrium by the vertical springs alone, wheelsets held:
 *
 *   K q = W,   K = sum k b b',   b' q = e = zB - zA of a coupling,   preload = k e,
 *
 * with W the weights.  All other springs, and stops, are taken to be at ease at rest: a vehicle is levelled when it is built.
 * Several springs under a body share its weight by their stiffness. */
#include "tools/vehicle/statics.h"

#include <math.h>
#include <stdlib.h>

#include "formats/reason.h"
#include "tools/vehicle/semidefinite.h"

#define UNMET 1e-9      /* of all weight (times 1 m): equilibrium that round-off leaves open */

/* Degrees of freedom and coefficients of e in q: z, roll, pitch of both ends. */
struct row { int64_t dof[6]; double b[6]; };

static struct row coupling_row(const struct veh *v, int64_t c)
{
    struct row r;

    for (int k = 0; k < 2; k++) {
        int64_t body = v->ends[2*c + k];
        double sign = k ? 1 : -1, moves = v->bearing[c] == k ? 0 : 1;
        double dx = v->point[3*c] - v->cg[3*body], dy = v->point[3*c + 1] - v->cg[3*body + 1];
        for (int m = 0; m < 3; m++)
            r.dof[3*k + m] = VEH_DOFS*body + VEH_Z + m;
        r.b[3*k] = moves*sign;                                /* u_z = z + roll dy - pitch dx */
        r.b[3*k + 1] = moves*sign*dy;
        r.b[3*k + 2] = -moves*sign*dx;
    }
    return r;
}

static int64_t stiffness_factor(const struct veh *v, double *K)
{
    int64_t n = VEH_DOFS*v->bodies;

    for (int64_t c = 0; c < v->couplings; c++) {
        struct row r = coupling_row(v, c);
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 6; j++)
                K[n*r.dof[i] + r.dof[j]] += v->stiffness[VEH_DOFS*c + VEH_Z]*r.b[i]*r.b[j];
    }
    return semidefinite_factor(n, K);
}

/* q in: weights, out: displacements. */
static const char *settle(const struct veh *v, const double *K, double *q, double *left)
{
    int64_t n = VEH_DOFS*v->bodies;
    double weight = 0;

    for (int64_t i = 0; i < v->bodies; i++) {
        q[VEH_DOFS*i + VEH_Z] = v->mass[i]*v->gravity;
        weight += v->mass[i]*v->gravity;
    }
    for (int64_t w = 0; w < v->wheelsets; w++)
        q[VEH_DOFS*v->wheelset[w] + VEH_Z] = 0;
    semidefinite_solve(n, K, q, left);
    for (int64_t i = 0; i < n; i++)
        if (fabs(left[i]) > UNMET*weight)
            return reason("body %s: vertical springs do not carry its weight%s", v->body_name[i/VEH_DOFS],
                          i%VEH_DOFS == VEH_Z ? "" : i%VEH_DOFS == VEH_ROLL ? " level in roll" : " level in pitch");
    return NULL;
}

/* Vertical force and roll moment about its centre on each wheelset, then its two contacts. */
static const char *wheels_load(const struct veh *v, const double *preload, double *wheel_load)
{
    for (int64_t w = 0; w < v->wheelsets; w++) {
        int64_t body = v->wheelset[w];
        double cy = v->cg[3*body + 1];
        double Q = v->mass[body]*v->gravity, M = cy*Q;
        for (int64_t c = 0; c < v->couplings; c++)
            for (int k = 0; k < 2; k++)
                if (v->ends[2*c + k] == body) {
                    double F = (k ? -1 : 1)*preload[3*c + VEH_Z];
                    Q += F;
                    M += F*v->point[3*c + 1];
                }
        wheel_load[2*w] = (Q - M/STATICS_CONTACT_LEVER)/2;
        wheel_load[2*w + 1] = (Q + M/STATICS_CONTACT_LEVER)/2;
        for (int k = 0; k < 2; k++)
            if (wheel_load[2*w + k] < 0)
                return reason("wheelset %s: its %s wheel would lift at rest", v->body_name[body], k ? "right" : "left");
    }
    return NULL;
}

const char *statics_rest(const struct veh *v, double *preload, double *wheel_load)
{
    int64_t n = VEH_DOFS*v->bodies;
    double *K = calloc((size_t)(n*n), sizeof *K), *q = calloc((size_t)n, sizeof *q), *left = calloc((size_t)n, sizeof *left);
    const char *why = REASON_MEMORY;

    if (!K || !q || !left)
        goto done;
    stiffness_factor(v, K);
    if ((why = settle(v, K, q, left)))
        goto done;
    for (int64_t c = 0; c < v->couplings; c++) {
        struct row r = coupling_row(v, c);
        double e = 0;
        for (int i = 0; i < 6; i++)
            e += r.b[i]*q[r.dof[i]];
        preload[3*c + VEH_X] = preload[3*c + VEH_Y] = 0;
        preload[3*c + VEH_Z] = v->stiffness[VEH_DOFS*c + VEH_Z]*e;
    }
    why = wheels_load(v, preload, wheel_load);
done:
    free(K);
    free(q);
    free(left);
    return why;
}
