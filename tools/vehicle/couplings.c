/* Forces of couplings, for small angles.
 *
 * The ends of a coupling between bodies A and B meet at P when at rest.  With d = P - cg and turn t = (roll, pitch, yaw) of a body, its
 * end moves by u = (x, y, z) + t x d.  The elongation e = uB - uA gives, on B and reversed on A,
 *
 *   F = -(k e + c e') - preload,
 *
 * in axes turned with the mean of the two bodies, m = (tA + tB)/2: e and e' less m x e and m x e' there, and back F + m x F.
 *
 * Both forces act midway between the displaced ends, rB = d + t x d - e/2 and rA = d + t x d + e/2 from the displaced centres of
 * gravity, so forces and moments cancel in pairs about any axis.  The preload on a displaced point and its turning with the
 * bodies are the geometric stiffness of a loaded spring.  A preload that kept its direction would not be conservative: a lateral
 * displacement would give a roll moment, but a roll no lateral force.
 *
 * The end at a wheelset is an axlebox, which does not spin: its pitch is zero, the other body alone turns F in pitch and takes the
 * moment e x F about y. */
#include "tools/vehicle/couplings.h"

struct end {
    double turn[3], rate[3];    /* roll, pitch, yaw rad and rad/s, as the coupling sees them */
    double u[3], ud[3];         /* m, m/s displacement of the end */
    double arm[3];              /* m from the displaced centre of gravity to the displaced end */
};

/* c = a x b */
static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1]*b[2] - a[2]*b[1];
    c[1] = a[2]*b[0] - a[0]*b[2];
    c[2] = a[0]*b[1] - a[1]*b[0];
}

static void end_move(const struct veh *v, int64_t c, int which, const double *q, const double *qd, struct end *p)
{
    int64_t body = v->ends[2*c + which];
    double d[3], ud[3];

    q += VEH_DOFS*body;
    qd += VEH_DOFS*body;
    for (int k = 0; k < 3; k++) {
        d[k] = v->point[3*c + k] - v->cg[3*body + k];
        p->turn[k] = q[VEH_ROLL + k];
        p->rate[k] = qd[VEH_ROLL + k];
    }
    if (v->bearing[c] == which)
        p->turn[1] = p->rate[1] = 0;
    cross(p->turn, d, p->arm);
    cross(p->rate, d, ud);
    for (int k = 0; k < 3; k++) {
        p->u[k] = q[k] + p->arm[k];
        p->ud[k] = qd[k] + ud[k];
        p->arm[k] += d[k];
    }
}

double couplings_stop(const struct veh *v, int64_t c, double e)
{
    const double *x = v->knot_at, *F = v->knot_force;
    int64_t first = v->knot_first[c], last = v->knot_first[c + 1] - 1;
    double size = e < 0 ? -e : e;

    if (size <= x[first])
        return 0;
    int64_t k = first + 1;
    while (k < last && size > x[k])
        k++;                                                /* beyond the table its last slope goes on */
    double force = F[k - 1] + (F[k] - F[k - 1])*(size - x[k - 1])/(x[k] - x[k - 1]);
    return e < 0 ? -force : force;
}

/* Force on the second body, the law holding in axes turned by m. */
static void coupling_law(const struct veh *v, int64_t c, const double m[3], const double e[3], const double ed[3], double F[3])
{
    double me[3], med[3], mF[3], f[3];

    cross(m, e, me);
    cross(m, ed, med);
    for (int k = 0; k < 3; k++)
        f[k] = -v->stiffness[VEH_DOFS*c + k]*(e[k] - me[k]) - v->damping[VEH_DOFS*c + k]*(ed[k] - med[k]) - v->preload[3*c + k];
    if (v->type[c] == VEH_STOP)
        f[v->stop_axis[c]] -= couplings_stop(v, c, e[v->stop_axis[c]] - me[v->stop_axis[c]]);
    cross(m, f, mF);
    for (int k = 0; k < 3; k++)
        F[k] = f[k] + mF[k];
}

void couplings_force(const struct veh *v, const double *q, const double *qd, double *f)
{
    for (int64_t c = 0; c < v->couplings; c++) {
        struct end A, B;
        end_move(v, c, 0, q, qd, &A);
        end_move(v, c, 1, q, qd, &B);

        double e[3], ed[3], F[3], m[3];
        double share[3] = {0.5, v->bearing[c] == 0 ? 0 : v->bearing[c] == 1 ? 1 : 0.5, 0.5};    /* of A */
        for (int k = 0; k < 3; k++) {
            e[k] = B.u[k] - A.u[k];
            ed[k] = B.ud[k] - A.ud[k];
            m[k] = share[k]*A.turn[k] + (1 - share[k])*B.turn[k];
        }
        coupling_law(v, c, m, e, ed, F);

        double onA[3], onB[3], pair[3];
        cross(A.arm, F, onA);
        cross(B.arm, F, onB);
        cross(e, F, pair);
        double *fA = f + VEH_DOFS*v->ends[2*c], *fB = f + VEH_DOFS*v->ends[2*c + 1];
        for (int k = 0; k < 3; k++) {
            double T = -v->stiffness[VEH_DOFS*c + VEH_ROLL + k]*(B.turn[k] - A.turn[k])
                       - v->damping[VEH_DOFS*c + VEH_ROLL + k]*(B.rate[k] - A.rate[k]);
            int hidden = k == 1 ? (int)v->bearing[c] : -1;  /* end that a moment about y does not reach */
            fA[k] -= F[k];
            fB[k] += F[k];
            fA[VEH_ROLL + k] -= onA[k] + share[k]*pair[k] + (hidden == 0 ? 0 : T);
            fB[VEH_ROLL + k] += onB[k] - (1 - share[k])*pair[k] + (hidden == 1 ? 0 : T);
        }
    }
}
