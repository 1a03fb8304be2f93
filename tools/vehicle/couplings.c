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

#include "tools/vehicle/law.h"
#include "tools/vehicle/table.h"

struct end {
    double d[3];                /* m from the centre of gravity to the end at rest */
    double turn[3];             /* roll, pitch, yaw rad, as the coupling sees them */
    double u[3];                /* m displacement of the end */
    double arm[3];              /* m from the displaced centre of gravity to the displaced end */
};

/* Both ends, and what the law needs of them. */
struct pair {
    struct end A, B;
    double e[3], ed[3];         /* m, m/s end of B less that of A; rates where it is damped, else 0 */
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

/* Whether its force depends on rates: most springs, stops and frictions are spared them. */
static int is_damped(const struct veh *v, int64_t c)
{
    const double *d = &v->damping[VEH_DOFS*c];

    return v->type[c] == VEH_DAMPER || d[0] + d[1] + d[2] + d[3] + d[4] + d[5] > 0;
}

static inline void end_move(const struct veh *v, int64_t c, int which, const double *q, struct end *p)
{
    int64_t body = v->ends[2*c + which];
    const double *at = which ? &v->end[3*c] : &v->point[3*c];

    q += VEH_DOFS*body;
    for (int k = 0; k < 3; k++) {
        p->d[k] = at[k] - v->cg[3*body + k];
        p->turn[k] = q[VEH_ROLL + k];
    }
    if (v->bearing[c] == which)
        p->turn[1] = 0;
    cross(p->turn, p->d, p->arm);
    for (int k = 0; k < 3; k++) {
        p->u[k] = q[k] + p->arm[k];
        p->arm[k] += p->d[k];
    }
}

/* Rate of the end's displacement, and of its turn. */
static inline void end_rate(const struct veh *v, int64_t c, int which, const double *qd, const struct end *p, double ud[3], double rate[3])
{
    qd += VEH_DOFS*v->ends[2*c + which];
    for (int k = 0; k < 3; k++)
        rate[k] = qd[VEH_ROLL + k];
    if (v->bearing[c] == which)
        rate[1] = 0;
    cross(rate, p->d, ud);
    for (int k = 0; k < 3; k++)
        ud[k] += qd[k];
}

static inline void pair_move(const struct veh *v, int64_t c, const double *q, const double *qd, struct pair *p)
{
    double ud[2][3], rate[2][3];

    end_move(v, c, 0, q, &p->A);
    end_move(v, c, 1, q, &p->B);
    for (int k = 0; k < 3; k++) {
        p->share[k] = k != 1 || v->bearing[c] < 0 ? 0.5 : (double)v->bearing[c];
        p->e[k] = p->B.u[k] - p->A.u[k];
        p->turn[k] = p->B.turn[k] - p->A.turn[k];
        p->m[k] = p->share[k]*p->A.turn[k] + (1 - p->share[k])*p->B.turn[k];
        p->ed[k] = p->rate[k] = 0;
    }
    if (!is_damped(v, c))
        return;
    end_rate(v, c, 0, qd, &p->A, ud[0], rate[0]);
    end_rate(v, c, 1, qd, &p->B, ud[1], rate[1]);
    for (int k = 0; k < 3; k++) {
        p->ed[k] = ud[1][k] - ud[0][k];
        p->rate[k] = rate[1][k] - rate[0][k];
    }
}

double couplings_stop(const struct veh *v, int64_t c, double e)
{
    int64_t k = v->knot_first[c];
    return table_odd(v->knot_first[c + 1] - k, v->knot_at + k, v->knot_force + k, e);
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
    law_along(v, c, m, e, ed, law);
    law_about(v, c, m, p->turn, p->rate, T);
    if (m)
        m->now[c] = v->lever[c] > 0 ? (struct couplings_state){.e = {p->turn[0], p->turn[1], p->turn[2]}, .F = {T[0], T[1], T[2]}}
                                    : (struct couplings_state){.e = {e[0], e[1], e[2]}, .F = {law[0], law[1], law[2]}};
    if (law[0] == 0 && law[1] == 0 && law[2] == 0 && T[0] == 0 && T[1] == 0 && T[2] == 0)
        return;
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
}

/* ---- lines ---- */

static void line_force(const struct veh *v, int64_t c, struct couplings_memory *m, const struct pair *p, double *fA, double *fB)
{
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
    force = law_line(v, c, m, e, rate);
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
