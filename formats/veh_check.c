/* One coupling against the rules: its ends, its law, its table. */
#include "formats/veh_check.h"

#include <math.h>

#include "formats/reason.h"

#define SHORTEST 0.01   /* m between the ends of a line: below it small angles are none */

/* Whether it acts along the line between two ends of their own. */
static int is_line(const struct veh *v, int64_t c)
{
    return v->type[c] == VEH_ROD || (v->type[c] == VEH_DAMPER && v->axis[c] == VEH_LINE);
}

/* The axlebox of a wheelset sits on its axle, and no coupling joins two wheelsets, so that pitch is the spin of a wheelset alone. */
static const char *check_ends(const struct veh *v, int64_t c)
{
    const int64_t *end = &v->ends[2*c];
    int wheelset[2];

    for (int k = 0; k < 2; k++) {
        if (end[k] < 0 || end[k] >= v->bodies)
            return reason("coupling %s: no body %lld", v->coupling_name[c], (long long)end[k]);
        wheelset[k] = veh_is_wheelset(v, end[k]);
        if (k && wheelset[0] && wheelset[1] && end[0] != end[1])
            return reason("coupling %s: joins two wheelsets, %s and %s; join each to a frame", v->coupling_name[c], v->body_name[end[0]],
                          v->body_name[end[1]]);
    }
    for (int k = 0; k < 2; k++) {
        const double *at = k ? &v->end[3*c] : &v->point[3*c], *cg = &v->cg[3*end[k]];
        if (wheelset[k] && (at[VEH_X] != cg[VEH_X] || at[VEH_Z] != cg[VEH_Z]))
            return reason("coupling %s: must sit on the axle of wheelset %s, at x %g, height %g", v->coupling_name[c],
                          v->body_name[end[k]], cg[VEH_X], -cg[VEH_Z]);
    }
    if (end[0] == end[1])
        return reason("coupling %s: joins body %s to itself", v->coupling_name[c], v->body_name[end[0]]);
    if (v->bearing[c] != (wheelset[0] ? 0 : wheelset[1] ? 1 : -1))
        return reason("coupling %s: bearing %lld is not the end at a wheelset", v->coupling_name[c], (long long)v->bearing[c]);
    return NULL;
}

static const char *check_distance(const struct veh *v, int64_t c)
{
    const double *a = &v->point[3*c], *b = &v->end[3*c];
    double length = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);

    if (is_line(v, c) && !(length >= SHORTEST))
        return reason("coupling %s: its ends are %g m apart, but a line needs %g m", v->coupling_name[c], length, SHORTEST);
    if (!is_line(v, c) && length != 0)
        return reason("coupling %s: its ends must meet at rest, and are %g m apart", v->coupling_name[c], length);
    return NULL;
}

static const char *check_law(const struct veh *v, int64_t c)
{
    const char *name = v->coupling_name[c];

    if (v->type[c] < 0 || v->type[c] >= VEH_COUPLINGS)
        return reason("coupling %s: no type %lld", name, (long long)v->type[c]);
    if (v->axis[c] < VEH_X || v->axis[c] > (v->type[c] == VEH_DAMPER ? (int64_t)VEH_LINE : (int64_t)VEH_Z))
        return reason("coupling %s: no axis %lld", name, (long long)v->axis[c]);
    for (int k = 0; k < VEH_DOFS; k++)
        if (v->stiffness[VEH_DOFS*c + k] < 0 || v->damping[VEH_DOFS*c + k] < 0)
            return reason("coupling %s: a stiffness or damping is negative", name);
    if (v->series[c] < 0)
        return reason("coupling %s: its series stiffness is negative", name);
    return NULL;
}

/* Friction acts along axes or about axes, and its spring comes before it, so that no two load each other. */
static const char *check_friction(const struct veh *v, int64_t c)
{
    const double *k = &v->stiffness[VEH_DOFS*c];
    const char *name = v->coupling_name[c];
    int64_t s = v->spring[c];

    if (v->type[c] != VEH_FRICTION)
        return NULL;
    if (v->coefficient[c] < 0 || v->load[c] < 0 || v->share[c] < 0 || v->lever[c] < 0)
        return reason("friction %s: coefficient, load, share and radius must not be negative", name);
    if (s < -1 || s >= c)
        return reason("friction %s: no spring %lld before it", name, (long long)s);
    if (s >= 0 && v->type[s] != VEH_BUSHING && v->type[s] != VEH_SPRING)
        return reason("friction %s: %s is no spring", name, v->coupling_name[s]);
    int along = k[0] > 0 || k[1] > 0 || k[2] > 0, about = k[3] > 0 || k[4] > 0 || k[5] > 0;
    if (along == about)
        return reason("friction %s: needs a stick stiffness along axes or about axes, not %s", name, along ? "both" : "none");
    if (about != (v->lever[c] > 0))
        return reason("friction %s: a radius goes with a rotation", name);
    return NULL;
}

/* A stop rises from its clearance, a damper from 0, 0; a spring may begin anywhere. */
static const char *check_knots(const struct veh *v, int64_t c)
{
    int64_t first = v->knot_first[c], last = v->knot_first[c + 1], type = v->type[c];
    const double *x = v->knot_at, *F = v->knot_force;
    const char *name = v->coupling_name[c];

    if (first < 0 || last < first || last > v->knots)
        return reason("array knot.first: out of order or range at %lld", (long long)c);
    if (type != VEH_STOP && type != VEH_SPRING && type != VEH_DAMPER)
        return last > first ? reason("coupling %s: only stops, springs and dampers have knots", name) : NULL;
    if (last - first < 2)
        return reason("coupling %s: its table needs two rows", name);
    if (type == VEH_STOP && (x[first] < 0 || F[first] != 0))
        return reason("stop %s: its table must start at a clearance >= 0 with force 0, not at %g m with %g N", name, x[first], F[first]);
    if (type == VEH_DAMPER && (x[first] != 0 || F[first] != 0))
        return reason("damper %s: its table must start at 0 m/s with 0 N", name);
    for (int64_t k = first + 1; k < last; k++)
        if (!(x[k] > x[k - 1]) || F[k] < F[k - 1] || (type == VEH_DAMPER && F[k] == F[k - 1]))
            return reason("%s %s: its table does not rise at %g %s", type == VEH_STOP ? "stop" : type == VEH_SPRING ? "spring" : "damper",
                          name, x[k], type == VEH_DAMPER ? "m/s" : "m");
    return NULL;
}

const char *veh_check_coupling(const struct veh *v, int64_t c)
{
    const char *why;

    if ((why = check_ends(v, c)) || (why = check_law(v, c)) || (why = check_distance(v, c)) || (why = check_friction(v, c)))
        return why;
    return check_knots(v, c);
}
