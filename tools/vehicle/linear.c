/* Exact derivatives of couplings_force at rest, column by column: the force of first order in a unit displacement.
 *
 * With d = P - cg, t the turn of a body, p the preload on A (so -p on B), m the mean turn:
 *
 *   e  = (xB + tB x dB) - (xA + tA x dA),        F = -k e - m x p                 on B, -F on A
 *   MB =  dB x F - (tB x dB) x p + (e x p)/2 - kr (tB - tA)
 *   MA = -dA x F + (tA x dA) x p + (e x p)/2 + kr (tB - tA)
 *
 * The terms in p are the geometric stiffness.  K is symmetric where the preloads and the weight of each body are in balance; gravity
 * itself is a constant force through the centre of gravity, hence no stiffness.  A stop without clearance adds its first slope, a spring
 * its slope at rest, friction its stick stiffness, a damper its first slope to C: its spring in series is not in the matrices.  Along a
 * line F = -k n (n.e), n the line's direction. */
#include "tools/vehicle/linear.h"

#include <math.h>
#include <string.h>

#include "tools/vehicle/table.h"

/* Stiffness or damping of one coupling: along and about the axes, or the first along n. */
struct law {
    double k[VEH_DOFS];
    int line;
    double n[3];
};

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1]*b[2] - a[2]*b[1];
    c[1] = a[2]*b[0] - a[0]*b[2];
    c[2] = a[0]*b[1] - a[1]*b[0];
}

/* Column of the matrix of coupling c for unit degree of freedom `dof` of its end `which`, added to to[n][n] with n rows per column:
 * preload p[3] N. */
static void column_add(const struct veh *v, int64_t c, int which, int dof, const struct law *law, const double p[3], double *to)
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
            d[end][i] = (end ? v->end : v->point)[3*c + i] - v->cg[3*v->ends[2*c + end] + i];
    cross(t, d[which], arm);
    for (int i = 0; i < 3; i++) {
        e[i] = sign*(x[i] + arm[i]);
        m[i] = (which ? 1 - share[i] : share[i])*t[i];
    }
    cross(m, p, turned);
    for (int i = 0; i < 3; i++)
        F[i] = (law->line ? -law->k[0]*law->n[i]*(law->n[0]*e[0] + law->n[1]*e[1] + law->n[2]*e[2]) : -law->k[i]*e[i]) - turned[i];

    for (int end = 0; end < 2; end++) {
        double side = end ? 1 : -1, dF[3], armp[3], ep[3];
        int64_t row = VEH_DOFS*v->ends[2*c + end];
        cross(d[end], F, dF);
        cross(arm, p, armp);
        cross(e, p, ep);
        for (int i = 0; i < 3; i++) {
            int hidden = i == 1 && v->bearing[c] == end;
            double M = side*dF[i] - (end == which ? side*armp[i] : 0) + (end ? 1 - share[i] : share[i])*ep[i]
                       - (hidden ? 0 : side*law->k[VEH_ROLL + i]*sign*t[i]);
            to[n*(row + i) + column] -= side*F[i];
            to[n*(row + VEH_ROLL + i) + column] -= M;
        }
    }
}

static void law_begin(const struct veh *v, int64_t c, const double k[VEH_DOFS], struct law *law)
{
    double length = 0;

    memcpy(law->k, k, sizeof law->k);
    law->line = v->type[c] == VEH_ROD || v->axis[c] == VEH_LINE;
    for (int i = 0; i < 3; i++) {
        law->n[i] = v->end[3*c + i] - v->point[3*c + i];
        length += law->n[i]*law->n[i];
    }
    for (int i = 0; i < 3 && law->line; i++)
        law->n[i] /= sqrt(length);
}

static struct law stiffness_law(const struct veh *v, int64_t c)
{
    int64_t first = v->knot_first[c], knots = v->knot_first[c + 1] - first;
    const double *x = v->knot_at + first, *F = v->knot_force + first;
    struct law law;

    law_begin(v, c, &v->stiffness[VEH_DOFS*c], &law);
    if (v->type[c] == VEH_STOP && x[0] == 0)
        law.k[v->axis[c]] += table_slope(knots, x, F, 0);
    if (v->type[c] == VEH_SPRING)
        law.k[v->axis[c]] += table_slope(knots, x, F, v->rest[c]);
    for (int i = 0; i < VEH_DOFS && v->type[c] == VEH_FRICTION && v->coefficient[c] == 0; i++)
        law.k[i] = 0;
    return law;
}

static struct law damping_law(const struct veh *v, int64_t c)
{
    int64_t first = v->knot_first[c];
    struct law law;

    law_begin(v, c, &v->damping[VEH_DOFS*c], &law);
    if (v->type[c] == VEH_DAMPER)
        law.k[law.line ? 0 : v->axis[c]] += table_slope(v->knot_first[c + 1] - first, v->knot_at + first, v->knot_force + first, 0);
    return law;
}

void linear_matrices(const struct veh *v, double *M, double *C, double *K)
{
    static const double none[3];
    int64_t n = VEH_DOFS*v->bodies;

    for (int64_t i = 0; i < n*n; i++)
        M[i] = C[i] = K[i] = 0;
    for (int64_t i = 0; i < v->bodies; i++)
        for (int m = 0; m < 3; m++) {
            int64_t x = VEH_DOFS*i + m, t = x + VEH_ROLL;
            M[n*x + x] = v->mass[i];
            M[n*t + t] = v->inertia[3*i + m];
        }
    for (int64_t c = 0; c < v->couplings; c++) {
        struct law k = stiffness_law(v, c), d = damping_law(v, c);
        for (int which = 0; which < 2; which++)
            for (int dof = 0; dof < VEH_DOFS; dof++) {
                column_add(v, c, which, dof, &k, &v->preload[3*c], K);
                column_add(v, c, which, dof, &d, none, C);
            }
    }
}
