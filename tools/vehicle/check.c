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

const char *check_support(const struct veh *v)
{
    static const char *const motion[VEH_DOFS] = {"along x", "along y", "along z", "in roll", "in pitch", "in yaw"};
    int64_t n = VEH_DOFS*v->bodies;
    double *K = calloc((size_t)(n*n), sizeof *K);

    if (!K)
        return REASON_MEMORY;
    memcpy(K, v->K, (size_t)(n*n)*sizeof *K);
    for (int64_t w = 0; w < v->wheelsets; w++)
        for (int64_t i = VEH_DOFS*v->wheelset[w]; i < VEH_DOFS*(v->wheelset[w] + 1); i++)
            for (int64_t j = 0; j < n; j++)
                K[n*i + j] = K[n*j + i] = i == j;
    int64_t loose = semidefinite_factor(n, K);
    free(K);
    return loose < 0 ? NULL : reason("body %s: nothing holds it %s", v->body_name[loose/VEH_DOFS], motion[loose%VEH_DOFS]);
}
