/* Static equilibrium by the vertical springs alone, wheelsets held, by Newton's method:
 *
 *   r(q) = W - sum b F(b'q),   K dq = r,   K = sum F' b b',   b' q = e = zB - zA of a coupling,   preload = F(e),
 *
 * with W the weights.  Linear springs take one round; of tables the first round has the steepest slope, whence springs that stiffen
 * are approached from one side.  A spring with a preload of its own is a weight more.  All other springs, and stops and rods, are taken to be
 * at ease at rest, and friction has no force: a vehicle is levelled when it is built.  Several springs under a body share its weight by
 * their stiffness. */
#include "tools/vehicle/statics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/vehicle/semidefinite.h"
#include "tools/vehicle/table.h"

#define UNMET 1e-9      /* of all weight (times 1 m): equilibrium that round-off leaves open */
#define SETTLED 1e-13   /* likewise: no further round */
enum { ROUNDS_MOST = 50 };

struct rest {
    const struct veh *v;
    const double *given;    /* N [couplings] vertical force, 0 where it is sought */
    double *K;              /* [n][n] */
    double *q, *r, *x, *left; /* [n] */
};

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

static double elongation(const struct row *r, const double *q)
{
    double e = 0;

    for (int i = 0; i < 6; i++)
        e += r->b[i]*q[r->dof[i]];
    return e;
}

/* Vertical force at e, and its slope, or the steepest of all. */
static double spring(const struct rest *s, int64_t c, double e, int steepest, double *slope)
{
    const struct veh *v = s->v;
    int64_t first = v->knot_first[c], n = v->knot_first[c + 1] - first;
    const double *x = v->knot_at + first, *F = v->knot_force + first;
    double most = 0;

    *slope = 0;
    if (s->given[c] > 0)
        return s->given[c];
    if (v->type[c] == VEH_BUSHING)
        *slope = v->stiffness[VEH_DOFS*c + VEH_Z];
    if (v->type[c] != VEH_SPRING || v->axis[c] != VEH_Z)
        return *slope*e;
    for (int64_t k = 0; k < n; k++)
        most = fmax(most, table_slope(n, x, F, x[k]));
    *slope = steepest ? most : table_slope(n, x, F, e);
    return table_at(n, x, F, e);
}

/* r and K at q. */
static void assemble(struct rest *s, int steepest)
{
    const struct veh *v = s->v;
    int64_t n = VEH_DOFS*v->bodies;

    memset(s->K, 0, (size_t)(n*n)*sizeof *s->K);
    memset(s->r, 0, (size_t)n*sizeof *s->r);
    for (int64_t i = 0; i < v->bodies; i++)
        s->r[VEH_DOFS*i + VEH_Z] = v->mass[i]*v->gravity;
    for (int64_t w = 0; w < v->wheelsets; w++)
        s->r[VEH_DOFS*v->wheelset[w] + VEH_Z] = 0;
    for (int64_t c = 0; c < v->couplings; c++) {
        struct row r = coupling_row(v, c);
        double slope, F = spring(s, c, elongation(&r, s->q), steepest, &slope);
        for (int i = 0; i < 6; i++) {
            s->r[r.dof[i]] -= F*r.b[i];
            for (int j = 0; j < 6; j++)
                s->K[n*r.dof[i] + r.dof[j]] += slope*r.b[i]*r.b[j];
        }
    }
}

/* The unknown whose equation is met worst, and by how much. */
static int64_t worst(int64_t n, const double *r)
{
    int64_t most = 0;

    for (int64_t i = 1; i < n; i++)
        if (fabs(r[i]) > fabs(r[most]))
            most = i;
    return most;
}

static const char *settle(struct rest *s)
{
    const struct veh *v = s->v;
    int64_t n = VEH_DOFS*v->bodies, i;
    double weight = 0;

    for (i = 0; i < v->bodies; i++)
        weight += v->mass[i]*v->gravity;
    for (int round = 0; round < ROUNDS_MOST; round++) {
        assemble(s, round == 0);
        i = worst(n, s->r);
        if (round > 0 && fabs(s->r[i]) <= SETTLED*weight)
            return NULL;
        memcpy(s->x, s->r, (size_t)n*sizeof *s->x);
        semidefinite_factor(n, s->K);
        semidefinite_solve(n, s->K, s->x, s->left);
        for (int64_t k = 0; k < n; k++)
            s->q[k] += s->x[k];
    }
    assemble(s, 0);
    i = worst(n, s->r);
    return fabs(s->r[i]) <= UNMET*weight ? NULL
        : reason("body %s: vertical springs do not carry its weight%s", v->body_name[i/VEH_DOFS],
                 i%VEH_DOFS == VEH_Z ? "" : i%VEH_DOFS == VEH_ROLL ? " level in roll" : " level in pitch");
}

/* Forces and places in their tables of the springs at rest. */
static const char *springs_load(const struct rest *s, double *preload, double *rest)
{
    const struct veh *v = s->v;

    for (int64_t c = 0; c < v->couplings; c++) {
        struct row r = coupling_row(v, c);
        int64_t first = v->knot_first[c], n = v->knot_first[c + 1] - first;
        double slope, e = elongation(&r, s->q), F = spring(s, c, e, 0, &slope);
        int stands = v->type[c] == VEH_SPRING && v->axis[c] == VEH_Z;
        rest[c] = !stands ? 0 : s->given[c] > 0 ? table_inverse(n, v->knot_at + first, v->knot_force + first, F) : e;
        if (!isfinite(rest[c]))
            return reason("spring %s: its table does not reach its preload", v->coupling_name[c]);
        preload[3*c + VEH_X] = preload[3*c + VEH_Y] = 0;
        preload[3*c + VEH_Z] = F;
    }
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

const char *statics_rest(const struct veh *v, const double *given, double *preload, double *rest, double *wheel_load)
{
    int64_t n = VEH_DOFS*v->bodies;
    struct rest s = {.v = v, .given = given, .K = calloc((size_t)(n*n), sizeof *s.K), .q = calloc((size_t)(4*n), sizeof *s.q)};
    const char *why = REASON_MEMORY;

    if (s.K && s.q) {
        s.r = s.q + n;
        s.x = s.r + n;
        s.left = s.x + n;
        if (!(why = settle(&s)) && !(why = springs_load(&s, preload, rest)))
            why = wheels_load(v, preload, wheel_load);
    }
    free(s.K);
    free(s.q);
    return why;
}
