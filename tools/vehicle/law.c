#include "tools/vehicle/law.h"

#include <math.h>

#include "tools/vehicle/couplings.h"
#include "tools/vehicle/friction.h"
#include "tools/vehicle/maxwell.h"
#include "tools/vehicle/table.h"

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

void law_along(const struct veh *v, int64_t c, const struct couplings_memory *m, const double e[3], const double ed[3], double F[3])
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

void law_about(const struct veh *v, int64_t c, const struct couplings_memory *m, const double turn[3], const double rate[3], double T[3])
{
    static const struct couplings_state none;
    const struct couplings_state *before = m ? &m->before[c] : &none;
    const double *k = &v->stiffness[VEH_DOFS*c + VEH_ROLL], *d = &v->damping[VEH_DOFS*c + VEH_ROLL];
    int sticks = v->type[c] == VEH_FRICTION && v->lever[c] > 0;

    for (int i = 0; i < 3; i++)
        T[i] = sticks ? before->F[i] : -k[i]*turn[i] - d[i]*rate[i];
    if (sticks)
        slide(v, c, m ? m->now : NULL, before->e, turn, T);
}

double law_line(const struct veh *v, int64_t c, const struct couplings_memory *m, double e, double rate)
{
    if (v->type[c] == VEH_ROD)
        return -v->stiffness[VEH_DOFS*c]*e - v->damping[VEH_DOFS*c]*rate;
    return damper_force(v, c, m ? m->step : 0, m ? m->before[c].e[0] : 0, m ? m->before[c].F[0] : 0, e, rate);
}
