/* Sums, and one factorisation of the stiffness. */
#include "tools/vehicle/check.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/vehicle/semidefinite.h"

void check_balance(const struct veh *v, struct check *k)
{
    memset(k, 0, sizeof *k);
    for (int64_t i = 0; i < v->bodies; i++) {
        k->mass += v->mass[i];
        for (int m = 0; m < 3; m++)
            k->cg[m] += v->mass[i]*v->cg[3*i + m];
    }
    for (int m = 0; m < 3; m++)
        k->cg[m] /= k->mass;
    k->weight = k->mass*v->gravity;
    for (int64_t w = 0; w < 2*v->wheelsets; w++)
        k->wheels += v->wheel_load[w];
}

/* K with the wheelsets held, their rows and columns those of the unit matrix. */
static double *held_stiffness(const struct veh *v)
{
    const int64_t n = VEH_DOFS*v->bodies;
    double *K = calloc((size_t)(n*n), sizeof *K);

    if (!K)
        return NULL;
    memcpy(K, v->K, (size_t)(n*n)*sizeof *K);
    for (int64_t w = 0; w < v->wheelsets; w++)
        for (int64_t i = VEH_DOFS*v->wheelset[w]; i < VEH_DOFS*(v->wheelset[w] + 1); i++)
            for (int64_t j = 0; j < n; j++)
                K[n*i + j] = K[n*j + i] = i == j;
    return K;
}

/* Displacement along axis of the end of a stop on a body: q + t x d. */
static double end_move(const struct veh *v, const double *q, int64_t c, int end)
{
    const int64_t body = v->ends[2*c + end];
    const int k = (int)v->axis[c], i = (k + 1)%3, j = (k + 2)%3;
    const double *x = &q[VEH_DOFS*body], *t = x + VEH_ROLL;
    double d[3];

    for (int m = 0; m < 3; m++)
        d[m] = v->point[3*c + m] - v->cg[3*body + m];
    return x[k] + t[i]*d[j] - t[j]*d[i];
}

const char *check_sideways(const struct veh *v, double a, double *deflection)
{
    const int64_t n = VEH_DOFS*v->bodies;
    double *K = held_stiffness(v), *q = calloc((size_t)(2*n), sizeof *q);

    if (!K || !q) {
        free(K);
        free(q);
        return REASON_MEMORY;
    }
    for (int64_t i = 0; i < v->bodies; i++)
        q[VEH_DOFS*i + VEH_Y] = veh_is_wheelset(v, i) ? 0 : -v->mass[i]*a;
    semidefinite_factor(n, K);
    semidefinite_solve(n, K, q, q + n);
    for (int64_t c = 0; c < v->couplings; c++)
        deflection[c] = v->type[c] == VEH_STOP ? end_move(v, q, c, 1) - end_move(v, q, c, 0) : 0;
    free(K);
    free(q);
    return NULL;
}

const char *check_support(const struct veh *v)
{
    static const char *const motion[VEH_DOFS] = {"along x", "along y", "along z", "in roll", "in pitch", "in yaw"};
    double *K = held_stiffness(v);

    if (!K)
        return REASON_MEMORY;
    int64_t loose = semidefinite_factor(VEH_DOFS*v->bodies, K);
    free(K);
    return loose < 0 ? NULL : reason("body %s: nothing holds it %s", v->body_name[loose/VEH_DOFS], motion[loose%VEH_DOFS]);
}
