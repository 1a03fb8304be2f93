/* Normal forces first, with the rail's local deflection d = compliance Q solved together with them (a lagged force is unstable
 * with contact damping); then creepages and creep forces of each contact.
 *
 * Contact plane: t = (0, cos g, sin g) along it, n = (0, -sin g, cos g) into the rail, g the contact angle. */
#include "tools/integrate/wheel.h"
#include "formats/reason.h"
#include "tools/creep/kalker.h"
#include "tools/creep/table.h"

#include <math.h>
#include <string.h>

enum { NEWTON_MOST = 50 };
#define NEWTON_TOLERANCE 1e-14 /* m, of the local deflection: 1e-5 N */

void wheel_condense(struct wheel_law *law, double stiffness, double damping, double series)
{
    double share = series / (stiffness + series);

    law->stiffness = stiffness * share;
    law->damping = damping * share * share;
}

const char *wheel_meet(const struct wheel_input *in, struct wheel_approach *a)
{
    double u = in->y - in->roll * in->radius - in->rail_y - in->line;

    a->n = contact_lookup(in->table, in->s, in->yaw - in->line_slope - in->rail_turn, u, in->roll - in->rail_roll, a->c);
    if (a->n < 0)
        return reason("the wheel is %.1f mm beside its rail, which is beyond the contact table", 1e3 * u);
    for (int k = 0; k < a->n; k++) {
        a->c[k].row[CTAB_ANGLE] += in->rail_roll;
        a->cosg[k] = cos(a->c[k].row[CTAB_ANGLE]);
        a->sing[k] = sin(a->c[k].row[CTAB_ANGLE]);
    }
    return NULL;
}

/* reach = z + roll b - height(u, roll, s) - rail - dip, all vertical, b the running circle's y. */
static void find_reach(const struct wheel_input *in, struct wheel_approach *a)
{
    double b = in->table->wheel_position, vu = in->vy - in->vroll * in->radius - in->rail_vy - (in->line_slope + in->rail_turn) * in->v;

    for (int k = 0; k < a->n; k++) {
        const struct contact *c = &a->c[k];
        a->reach[k] = in->z + in->roll * b - c->height - in->rail_z - in->dip;
        a->rate[k] = in->vz + in->vroll * b - c->height_u * vu - c->height_roll * (in->vroll - in->rail_vroll) - c->height_yaw * in->vyaw -
                     c->height_s * in->v - in->rail_v - in->rail_slope * in->v - in->dip_slope * in->v;
    }
}

/* Normal force of contact k for local deflection d and its rate; *slope is dN/dd, d moving the rail down. */
static double normal_force(const struct wheel_law *law, const struct wheel_input *in, const struct wheel_approach *a, int k, double d,
                           double *slope)
{
    const double *row = a->c[k].row;
    const double cosg = a->cosg[k];
    double e = (a->reach[k] - d) * cosg, ve = (a->rate[k] - (d - in->past) / in->time) * cosg, N;

    *slope = 0;
    if (e <= 0)
        return 0;
    if (law->normal == WHEEL_LINEAR) {
        N = law->stiffness * e + law->damping * ve;
        *slope = -(law->stiffness + law->damping / in->time) * cosg;
    } else {
        double root = sqrt(e), C = row[CTAB_HERTZ_C], factor = 1 + law->hertz_damping * ve;
        N = C * e * root * factor;
        *slope = -(1.5 * C * root * factor + C * e * root * law->hertz_damping / in->time) * cosg;
    }
    if (N <= 0) {
        *slope = 0;
        return 0;
    }
    return N;
}

/* d - compliance Q(d) = 0 by Newton; Q falls with d, so the function rises and has one zero. */
double wheel_press(const struct wheel_law *law, const struct wheel_input *in, const struct wheel_memory *memory, struct wheel_approach *a)
{
    double d = a->d, Q = 0;

    find_reach(in, a);
    for (int i = 0; i < NEWTON_MOST; i++) {
        double dQ = 0, move;
        Q = memory->creep_z;
        for (int k = 0; k < a->n; k++) {
            double slope;
            a->N[k] = normal_force(law, in, a, k, d, &slope);
            Q += a->c[k].weight * a->N[k] * a->cosg[k];
            dQ += a->c[k].weight * slope * a->cosg[k];
        }
        move = (d - in->compliance * Q) / (1 - in->compliance * dQ);
        if (fabs(move) < NEWTON_TOLERANCE)
            break;
        d -= move;
    }
    a->d = d;
    return Q;
}

/* Creepages of wheel against rail at a point r from the wheelset's centre, over v.  The wheel's material moves with
 * omega x r, omega = (roll' - spin yaw, spin, yaw' + spin roll); the rail comes along x at v(1 - curvature y).  Sideways the material moves
 * by sy; as fast as wheel and rail approach, `rate` downwards, it goes into the contact plane, and along it by the rest:
 * -sy sin g + sz cos g = rate cos g, eta v = sy cos g + sz sin g.  Where contact lies ahead of the axle needs not be known for that. */
static void creepages(const struct wheel_input *in, const double r[3], double track_y, double cosg, double sing, double rate, double creep[3])
{
    double wx = in->vroll - in->spin * in->yaw, wy = in->spin, wz = in->vyaw + in->spin * in->roll;
    double sx = wy * r[2] - wz * r[1] + in->v * (1 - in->curvature * track_y);
    double sy = in->vy + wz * r[0] - wx * r[2] - in->rail_vy;

    creep[0] = sx / in->v;
    creep[1] = (sy / cosg + rate * sing) / in->v;
    creep[2] = ((wz + in->curvature * in->v) * cosg - wy * sing) / in->v;
}

/* G a b C22 cos^2 g / v: how lateral creep of the linear theory resists the rail's moving sideways. */
static double creep_damping(const struct ctab *t, double a, double b, double cosg, double v)
{
    double C[KALKER_COEFFICIENTS];

    kalker(a / b, t->poisson, C);
    return t->shear_modulus * a * b * C[KALKER_C22] * cosg * cosg / v;
}

/* The longitudinal part of a normal force whose other parts are Fy, Fz, at r: a surface of revolution's normals meet its axle,
 * (-yaw, 1, roll), so the force has no moment about it. */
static double normal_ahead(const struct wheel_input *in, const double r[3], double Fy, double Fz)
{
    return (r[0] * (Fz - in->roll * Fy) + in->yaw * (r[1] * Fz - r[2] * Fy)) / (r[2] - in->roll * r[1]);
}

/* What contact k adds to the wheel's forces. */
static void add_contact(const struct wheel_law *law, const struct wheel_input *in, const struct wheel_approach *a, int k,
                        double rail_z, struct wheel_output *out, struct wheel_patch *p)
{
    const struct ctab *t = in->table;
    const double *row = a->c[k].row;
    double N = a->N[k], w = a->c[k].weight, root = cbrt(N), g = row[CTAB_ANGLE], cosg = a->cosg[k], sing = a->sing[k];
    double y = t->rail_position + in->rail_y + in->line + row[CTAB_RAIL_Y], z = rail_z + row[CTAB_RAIL_Z];
    double semi_a = row[CTAB_HERTZ_A] * root, semi_b = row[CTAB_HERTZ_B] * root;
    double r[3] = {row[CTAB_X], y - in->y, z - in->z + in->radius}, creep[3], T[3], F[3], M[3];

    creepages(in, r, y, cosg, sing, a->rate[k], creep);
    const double s = t->turned ? -in->s : in->s;
    double mu = friction_of(&law->varied, law->friction, t->turned ? t->turned->side : t->side, s, row[CTAB_BODY], g, in->v * hypot(creep[0], creep[1]));
    if (law->creep)
        creep_table(law->creep, semi_a, semi_b, N, mu, t->shear_modulus, t->poisson, creep[0], creep[1], creep[2], T);
    else
        fastsim(&law->grid, semi_a, semi_b, N, mu, t->shear_modulus, t->poisson, creep[0], creep[1], creep[2], T);
    out->creep_damping += w * creep_damping(t, semi_a, semi_b, cosg, in->v);
    F[0] = w * (T[0] + normal_ahead(in, r, -N * sing, N * cosg));    /* on the rail: N n + Tx x + Ty t, spin moment Mz n */
    F[1] = w * (-N * sing + T[1] * cosg);
    F[2] = w * (N * cosg + T[1] * sing);
    M[0] = r[1] * F[2] - r[2] * F[1];
    M[1] = r[2] * F[0] - r[0] * F[2] - w * T[2] * sing;
    M[2] = r[0] * F[1] - r[1] * F[0] + w * T[2] * cosg;
    out->T += F[0];
    out->Y += F[1];
    out->Q += F[2];
    out->Mx += y * F[2] - z * F[1];
    out->force[0] -= F[0];
    out->force[1] -= F[1];
    out->force[2] -= F[2];
    out->moment[0] -= M[0];
    out->moment[1] -= M[1] - in->yaw * M[0] + in->roll * M[2]; /* about the axle (-yaw, 1, roll) */
    out->moment[2] -= M[2];
    *p = (struct wheel_patch){w * N, w * T[0], w * T[1], creep[0], creep[1], creep[2],
                              row[CTAB_RAIL_Y], row[CTAB_WHEEL_Y], row[CTAB_X], g, row[CTAB_BODY]};
}

/* Keeps the RUN_CONTACTS most loaded, in order. */
static void keep_patch(struct wheel_output *out, const struct wheel_patch *p)
{
    int i = out->patches < RUN_CONTACTS ? out->patches++ : RUN_CONTACTS;

    while (i > 0 && out->patch[i - 1].N < p->N) {
        if (i < RUN_CONTACTS)
            out->patch[i] = out->patch[i - 1];
        i--;
    }
    if (i < RUN_CONTACTS)
        out->patch[i] = *p;
}

void wheel_roll(const struct wheel_law *law, const struct wheel_input *in, const struct wheel_approach *a, struct wheel_memory *memory,
                struct wheel_output *out)
{
    double normal_z = 0;

    memset(out, 0, sizeof *out);
    for (int k = 0; k < a->n; k++)
        if (a->N[k] > 0) {
            struct wheel_patch p;
            add_contact(law, in, a, k, in->rail_z + in->dip + a->d, out, &p);
            keep_patch(out, &p);
            normal_z += a->c[k].weight * a->N[k] * a->cosg[k];
        }
    memory->creep_z = out->Q - normal_z;
    out->rail_z = in->rail_z + a->d;
}

const char *wheel_force(const struct wheel_law *law, const struct wheel_input *in, struct wheel_memory *memory,
                        struct wheel_output *out)
{
    struct wheel_input own = *in;
    struct wheel_approach a;
    const char *why = wheel_meet(in, &a);

    if (why)
        return why;
    own.time = law->step;
    own.past = a.d = memory->local;
    wheel_press(law, &own, memory, &a);
    wheel_roll(law, &own, &a, memory, out);
    memory->local = a.d;
    return NULL;
}
