/* Exact derivatives of couplings_force at rest, column by column: the force of first order in a unit displacement.
 *
 * With d = P - cg, t the turn of a body, p the preload on A (so -p on B), m the mean turn:
 *
 *   e  = (xB + tB x dB) - (xA + tA x dA),        F = -k e - m x p                 on B, -F on A
 *   MB =  dB x F - (tB x dB) x p + (e x p)/2 - kr (tB - tA)
 *   MA = -dA x F + (tA x dA) x p + (e x p)/2 + kr (tB - tA)
 *
 * The terms in p are the geometric stiffness.  K is symmetric where the preloads and the weight of each body are in balance; gravity
 * itself is a constant force through the centre of gravity, hence no stiffness.  A stop without clearance adds its first slope. */
#include "tools/vehicle/linear.h"

#include <string.h>

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1]*b[2] - a[2]*b[1];
    c[1] = a[2]*b[0] - a[0]*b[2];
    c[2] = a[0]*b[1] - a[1]*b[0];
}

/* Column of the matrix of coupling c for unit degree of freedom `dof` of its end `which`, added to to[n][n] with n rows per column:
 * k[6] N/m, N m/rad, p[3] N. */
static void column_add(const struct veh *v, int64_t c, int which, int dof, const double k[6], const double p[3], double *to)
{
    int64_t n = VEH_DOFS*v->bodies, column = VEH_DOFS*v->ends[2*c + which] + dof;
    double t[3] = {0}, x[3] = {0}, d[2][3], arm[3], e[3], m[3], F[3], turned[3];
    double sign = which ? 1 : -1;
    double share[3] = {0.5, v->bearing[c] == 0 ? 0 : v->bearing[c] == 1 ? 1 : 0.5, 0.5};        /* of A, as in couplings_force */

    if (dof < VEH_ROLL)
        x[dof] = 1;
    else if (dof != VEH_PITCH || v->bearing[c] != which)
        t[dof - VEH_ROLL] = 1;
    for (int end = 0; end < 2; end++)
        for (int i = 0; i < 3; i++)
            d[end][i] = v->point[3*c + i] - v->cg[3*v->ends[2*c + end] + i];
    cross(t, d[which], arm);
    for (int i = 0; i < 3; i++) {
        e[i] = sign*(x[i] + arm[i]);
        m[i] = (which ? 1 - share[i] : share[i])*t[i];
    }
    cross(m, p, turned);
    for (int i = 0; i < 3; i++)
        F[i] = -k[i]*e[i] - turned[i];

    for (int end = 0; end < 2; end++) {
        double side = end ? 1 : -1, dF[3], armp[3], ep[3];
        int64_t row = VEH_DOFS*v->ends[2*c + end];
        cross(d[end], F, dF);
        cross(arm, p, armp);
        cross(e, p, ep);
        for (int i = 0; i < 3; i++) {
            int hidden = i == 1 && v->bearing[c] == end;
            double M = side*dF[i] - (end == which ? side*armp[i] : 0) + (end ? 1 - share[i] : share[i])*ep[i]
                       - (hidden ? 0 : side*k[VEH_ROLL + i]*sign*t[i]);
            to[n*(row + i) + column] -= side*F[i];
            to[n*(row + VEH_ROLL + i) + column] -= M;
        }
    }
}

/* Slope of a stop at rest. */
static double stop_slope(const struct veh *v, int64_t c)
{
    int64_t k = v->knot_first[c];
    return v->knot_at[k] > 0 ? 0 : v->knot_force[k + 1]/v->knot_at[k + 1];
}

void linear_matrices(const struct veh *v, double *M, double *C, double *K)
{
    static const double none[3];
    int64_t n = VEH_DOFS*v->bodies;
    double k[VEH_DOFS];

    for (int64_t i = 0; i < n*n; i++)
        M[i] = C[i] = K[i] = 0;
    for (int64_t i = 0; i < v->bodies; i++)
        for (int m = 0; m < 3; m++) {
            int64_t x = VEH_DOFS*i + m, t = x + VEH_ROLL;
            M[n*x + x] = v->mass[i];
            M[n*t + t] = v->inertia[3*i + m];
        }
    for (int64_t c = 0; c < v->couplings; c++) {
        memcpy(k, &v->stiffness[VEH_DOFS*c], sizeof k);
        if (v->type[c] == VEH_STOP)
            k[v->stop_axis[c]] += stop_slope(v, c);
        for (int which = 0; which < 2; which++)
            for (int dof = 0; dof < VEH_DOFS; dof++) {
                column_add(v, c, which, dof, k, &v->preload[3*c], K);
                column_add(v, c, which, dof, &v->damping[VEH_DOFS*c], none, C);
            }
    }
}
