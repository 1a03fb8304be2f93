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
 * A line has ends of its own, D = rB - rA and n = D/|D| at rest.  It lengthens by n.e + w^2/(2|D|), w the part of e - m x D across n, to
 * second order, and nothing in a rotation of all; its force lies along D + e, from end to end.
 *
 * The end at a wheelset is an axlebox, which does not spin: its pitch is zero, the other body alone turns F in pitch and takes the
 * moment e x F about y. */
#include "tools/vehicle/couplings.h"

#include <math.h>

#include "tools/vehicle/friction.h"
#include "tools/vehicle/maxwell.h"
#include "tools/vehicle/table.h"

struct end {
    double turn[3], rate[3];    /* roll, pitch, yaw rad and rad/s, as the coupling sees them */
    double u[3], ud[3];         /* m, m/s displacement of the end */
    double arm[3];              /* m from the displaced centre of gravity to the displaced end */
};

/* Both ends, and what the law needs of them. */
struct pair {
    struct end A, B;
    double e[3], ed[3];         /* m, m/s end of B less that of A */
    double turn[3], rate[3];    /* rad, rad/s of B less A */
    double share[3], m[3];      /* of A in the mean turn, and that turn */
};

/* c = a x b */
static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1]*b[2] - a[2]*b[1];
    c[1] = a[2]*b[0] - a[0]*b[2];
    c[2] = a[0]*b[1] - a[1]*b[0];
}

static double dot(const double a[3], const double b[3])
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

static void end_move(const struct veh *v, int64_t c, int which, const double *q, const double *qd, struct end *p)
{
    int64_t body = v->ends[2*c + which];
    const double *at = which ? &v->end[3*c] : &v->point[3*c];
    double d[3], ud[3];

    q += VEH_DOFS*body;
    qd += VEH_DOFS*body;
    for (int k = 0; k < 3; k++) {
        d[k] = at[k] - v->cg[3*body + k];
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

static void pair_move(const struct veh *v, int64_t c, const double *q, const double *qd, struct pair *p)
{
    end_move(v, c, 0, q, qd, &p->A);
    end_move(v, c, 1, q, qd, &p->B);
    for (int k = 0; k < 3; k++) {
        p->share[k] = k != 1 || v->bearing[c] < 0 ? 0.5 : (double)v->bearing[c];
        p->e[k] = p->B.u[k] - p->A.u[k];
        p->ed[k] = p->B.ud[k] - p->A.ud[k];
        p->turn[k] = p->B.turn[k] - p->A.turn[k];
        p->rate[k] = p->B.rate[k] - p->A.rate[k];
        p->m[k] = p->share[k]*p->A.turn[k] + (1 - p->share[k])*p->B.turn[k];
    }
}

double couplings_stop(const struct veh *v, int64_t c, double e)
{
    int64_t k = v->knot_first[c];
    return table_odd(v->knot_first[c + 1] - k, v->knot_at + k, v->knot_force + k, e);
}

/* ---- laws: force on the second body ---- */

/* Beyond that at rest. */
static double spring_force(const struct veh *v, int64_t c, double e)
{
    int64_t k = v->knot_first[c];
    return v->preload[3*c + v->axis[c]] - table_at(v->knot_first[c + 1] - k, v->knot_at + k, v->knot_force + k, v->rest[c] + e);
}

/* From elongation e0 and force F0 before the step to e, at the rate ed. */
static double damper_force(const struct veh *v, int64_t c, double step, double e0, double F0, double e, double ed)
{
    int64_t k = v->knot_first[c], n = v->knot_first[c + 1] - k;
    const double *rate = v->knot_at + k, *force = v->knot_force + k;

    if (v->series[c] == 0)
        return -table_odd(n, rate, force, ed);
    if (step == 0)
        return 0;
    return -maxwell_step(-F0, e - e0, step, v->series[c], n, rate, force);
}

/* Normal force: its own and a share of that of its spring, as far as that pushes the way it does at rest. */
static double friction_load(const struct veh *v, int64_t c, const struct couplings_state *now)
{
    int64_t s = v->spring[c];

    if (s < 0)
        return v->load[c];
    double p = v->preload[3*s + VEH_Z], push = now ? copysign(1, -p)*now[s].F[VEH_Z] : fabs(p);
    return v->load[c] + v->share[c]*fmax(push, 0);
}

/* F[3] in: that before, out: that after e has grown from `from`. */
static void slide(const struct veh *v, int64_t c, const struct couplings_state *now, const double from[3], const double e[3], double F[3])
{
    double de[3], lever = v->lever[c] > 0 ? v->lever[c] : 1;

    for (int k = 0; k < 3; k++)
        de[k] = e[k] - from[k];
    friction_step(&v->stiffness[VEH_DOFS*c + (v->lever[c] > 0 ? VEH_ROLL : VEH_X)],
                  v->coefficient[c]*lever*friction_load(v, c, now), de, F);
}

/* Along the axes turned by m: e, ed there. */
static void axes_law(const struct veh *v, int64_t c, const struct couplings_memory *m, const double e[3], const double ed[3], double F[3])
{
    static const struct couplings_state none;
    const struct couplings_state *before = m ? &m->before[c] : &none;
    int64_t axis = v->axis[c];

    if (v->type[c] == VEH_FRICTION) {
        for (int k = 0; k < 3; k++)
            F[k] = v->lever[c] > 0 ? 0 : before->F[k];
        if (v->lever[c] == 0)
            slide(v, c, m ? m->now : NULL, before->e, e, F);
        return;
    }
    for (int k = 0; k < 3; k++)
        F[k] = -v->stiffness[VEH_DOFS*c + k]*e[k] - v->damping[VEH_DOFS*c + k]*ed[k] - v->preload[3*c + k];
    if (v->type[c] == VEH_STOP)
        F[axis] -= couplings_stop(v, c, e[axis]);
    if (v->type[c] == VEH_SPRING)
        F[axis] += spring_force(v, c, e[axis]);
    if (v->type[c] == VEH_DAMPER)
        F[axis] += damper_force(v, c, m ? m->step : 0, before->e[axis], before->F[axis], e[axis], ed[axis]);
}

/* Moments about the axes on B. */
static void turn_law(const struct veh *v, int64_t c, const struct couplings_memory *m, const struct pair *p, double T[3])
{
    static const struct couplings_state none;
    const struct couplings_state *before = m ? &m->before[c] : &none;
    const double *k = &v->stiffness[VEH_DOFS*c + VEH_ROLL], *d = &v->damping[VEH_DOFS*c + VEH_ROLL];
    int sticks = v->type[c] == VEH_FRICTION && v->lever[c] > 0;

    for (int i = 0; i < 3; i++)
        T[i] = sticks ? before->F[i] : -k[i]*p->turn[i] - d[i]*p->rate[i];
    if (sticks)
        slide(v, c, m ? m->now : NULL, before->e, p->turn, T);
}

/* ---- couplings of one point ---- */

static void point_force(const struct veh *v, int64_t c, struct couplings_memory *m, const struct pair *p, double *fA, double *fB)
{
    double me[3], med[3], mF[3], e[3], ed[3], law[3], T[3], F[3], onA[3], onB[3], pair[3];

    cross(p->m, p->e, me);
    cross(p->m, p->ed, med);
    for (int k = 0; k < 3; k++) {
        e[k] = p->e[k] - me[k];
        ed[k] = p->ed[k] - med[k];
    }
    axes_law(v, c, m, e, ed, law);
    turn_law(v, c, m, p, T);
    cross(p->m, law, mF);
    for (int k = 0; k < 3; k++)
        F[k] = law[k] + mF[k];
    cross(p->A.arm, F, onA);
    cross(p->B.arm, F, onB);
    cross(p->e, F, pair);
    for (int k = 0; k < 3; k++) {
        int hidden = k == 1 ? (int)v->bearing[c] : -1;      /* end that a moment about y does not reach */
        fA[k] -= F[k];
        fB[k] += F[k];
        fA[VEH_ROLL + k] -= onA[k] + p->share[k]*pair[k] + (hidden == 0 ? 0 : T[k]);
        fB[VEH_ROLL + k] += onB[k] - (1 - p->share[k])*pair[k] + (hidden == 1 ? 0 : T[k]);
    }
    if (m)
        m->now[c] = v->lever[c] > 0 ? (struct couplings_state){.e = {p->turn[0], p->turn[1], p->turn[2]}, .F = {T[0], T[1], T[2]}}
                                    : (struct couplings_state){.e = {e[0], e[1], e[2]}, .F = {law[0], law[1], law[2]}};
}

/* ---- lines ---- */

static void line_force(const struct veh *v, int64_t c, struct couplings_memory *m, const struct pair *p, double *fA, double *fB)
{
    static const struct couplings_state none;
    const struct couplings_state *before = m ? &m->before[c] : &none;
    double D[3], n[3], turned[3], F[3], onA[3], onB[3], across = 0, size = 0, length, force;

    for (int k = 0; k < 3; k++)
        D[k] = v->end[3*c + k] - v->point[3*c + k];
    length = sqrt(dot(D, D));
    cross(p->m, D, turned);
    for (int k = 0; k < 3; k++)
        n[k] = D[k]/length;
    double along = dot(n, p->e), rate = dot(n, p->ed);
    for (int k = 0; k < 3; k++) {
        double w = p->e[k] - along*n[k] - turned[k];
        across += w*w;
        rate += w*p->ed[k]/length;
        D[k] += p->e[k];
        size += D[k]*D[k];
    }
    double e = along + across/(2*length);
    if (v->type[c] == VEH_ROD)
        force = -v->stiffness[VEH_DOFS*c]*e - v->damping[VEH_DOFS*c]*rate;
    else
        force = damper_force(v, c, m ? m->step : 0, before->e[0], before->F[0], e, rate);
    for (int k = 0; k < 3; k++)
        F[k] = force*D[k]/sqrt(size);
    cross(p->A.arm, F, onA);
    cross(p->B.arm, F, onB);
    for (int k = 0; k < 3; k++) {
        fA[k] -= F[k];
        fB[k] += F[k];
        fA[VEH_ROLL + k] -= onA[k];
        fB[VEH_ROLL + k] += onB[k];
    }
    if (m)
        m->now[c] = (struct couplings_state){.e = {e}, .F = {force}};
}

void couplings_force(const struct veh *v, struct couplings_memory *m, const double *q, const double *qd, double *f)
{
    for (int64_t c = 0; c < v->couplings; c++) {
        struct pair p;
        double *fA = f + VEH_DOFS*v->ends[2*c], *fB = f + VEH_DOFS*v->ends[2*c + 1];

        pair_move(v, c, q, qd, &p);
        if (v->type[c] == VEH_ROD || v->axis[c] == VEH_LINE)
            line_force(v, c, m, &p, fA, fB);
        else
            point_force(v, c, m, &p, fA, fB);
    }
}
