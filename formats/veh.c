/* Reading, checking and writing a vehicle.  One table says what is stored; the checks are what every user of a vehicle relies on:
 * masses and inertias, couplings between two different bodies of the list, stops that rise from zero, wheelsets from the front. */
#include "formats/veh.h"

#include <stddef.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/room.h"
#include "formats/veh_check.h"
#include "formats/vxf_member.h"

/* Sizes an array may have. */
enum size { ONE, TWO, AXES, DOFS, BODIES, COUPLINGS, FIRSTS, KNOTS, WHEELSETS, ROWS, LETTERS, SIZES };

#define AT(member) offsetof(struct veh, member)

static const struct vxf_member TABLE[] = {
    {"body.name",          "text",          VXF_U8,  2, {BODIES, LETTERS},    AT(body_name)},
    {"body.mass",          "kg",            VXF_F64, 1, {BODIES, ONE},        AT(mass)},
    {"body.inertia",       "kg.m2",         VXF_F64, 2, {BODIES, AXES},       AT(inertia)},
    {"body.cg",            "m",             VXF_F64, 2, {BODIES, AXES},       AT(cg)},
    {"coupling.name",      "text",          VXF_U8,  2, {COUPLINGS, LETTERS}, AT(coupling_name)},
    {"coupling.type",      "1",             VXF_I64, 1, {COUPLINGS, ONE},     AT(type)},
    {"coupling.ends",      "1",             VXF_I64, 2, {COUPLINGS, TWO},     AT(ends)},
    {"coupling.bearing",   "1",             VXF_I64, 1, {COUPLINGS, ONE},     AT(bearing)},
    {"coupling.point",     "m",             VXF_F64, 2, {COUPLINGS, AXES},    AT(point)},
    {"coupling.end",       "m",             VXF_F64, 2, {COUPLINGS, AXES},    AT(end)},
    {"coupling.stiffness", "N/m,N.m/rad",   VXF_F64, 2, {COUPLINGS, DOFS},    AT(stiffness)},
    {"coupling.damping",   "N.s/m,N.m.s/rad", VXF_F64, 2, {COUPLINGS, DOFS},    AT(damping)},
    {"coupling.preload",   "N",             VXF_F64, 2, {COUPLINGS, AXES},    AT(preload)},
    {"coupling.axis",      "1",             VXF_I64, 1, {COUPLINGS, ONE},     AT(axis)},
    {"damper.series",      "N/m",           VXF_F64, 1, {COUPLINGS, ONE},     AT(series)},
    {"spring.rest",        "m",             VXF_F64, 1, {COUPLINGS, ONE},     AT(rest)},
    {"friction.coefficient", "1",           VXF_F64, 1, {COUPLINGS, ONE},     AT(coefficient)},
    {"friction.load",      "N",             VXF_F64, 1, {COUPLINGS, ONE},     AT(load)},
    {"friction.spring",    "1",             VXF_I64, 1, {COUPLINGS, ONE},     AT(spring)},
    {"friction.share",     "1",             VXF_F64, 1, {COUPLINGS, ONE},     AT(share)},
    {"friction.lever",     "m",             VXF_F64, 1, {COUPLINGS, ONE},     AT(lever)},
    {"knot.first",         "1",             VXF_I64, 1, {FIRSTS, ONE},        AT(knot_first)},
    {"knot.at",            "m,m/s",         VXF_F64, 1, {KNOTS, ONE},         AT(knot_at)},
    {"knot.force",         "N",             VXF_F64, 1, {KNOTS, ONE},         AT(knot_force)},
    {"wheelset.body",      "1",             VXF_I64, 1, {WHEELSETS, ONE},     AT(wheelset)},
    {"wheelset.radius",    "m",             VXF_F64, 1, {WHEELSETS, ONE},     AT(radius)},
    {"wheelset.load",      "N",             VXF_F64, 2, {WHEELSETS, TWO},     AT(wheel_load)},
    {"K",                  "SI",            VXF_F64, 2, {ROWS, ROWS},         AT(K)},
    {"C",                  "SI",            VXF_F64, 2, {ROWS, ROWS},         AT(C)},
    {"M",                  "SI",            VXF_F64, 2, {ROWS, ROWS},         AT(M)},
};

enum { ENTRIES = sizeof TABLE / sizeof TABLE[0] };

/* What follows from bodies and couplings, once they are known. */
static void derive_sizes(int64_t size[SIZES])
{
    if (size[BODIES] >= 0)
        size[ROWS] = VEH_DOFS * size[BODIES];
    if (size[COUPLINGS] >= 0)
        size[FIRSTS] = size[COUPLINGS] + 1;
}

static const char *check_names(const char *array, const char (*name)[32], int64_t n)
{
    for (int64_t i = 0; i < n; i++) {
        if (!memchr(name[i], 0, sizeof name[i]) || !name[i][0])
            return reason("array %s: no name at %lld", array, (long long)i);
        for (int64_t k = 0; k < i; k++)
            if (!strcmp(name[i], name[k]))
                return reason("%.*s %s: two are named %s", (int)strcspn(array, "."), array, name[i], name[i]);
    }
    return NULL;
}

static const char *check_bodies(const struct veh *v)
{
    static const char axis[] = "xyz";

    for (int64_t i = 0; i < v->bodies; i++) {
        if (!(v->mass[i] > 0))
            return reason("body %s: mass %g kg must be positive", v->body_name[i], v->mass[i]);
        for (int k = 0; k < 3; k++)
            if (!(v->inertia[3*i + k] > 0))
                return reason("body %s: inertia %g kg m2 about %c must be positive", v->body_name[i], v->inertia[3*i + k], axis[k]);
    }
    return NULL;
}

static const char *check_wheelsets(const struct veh *v)
{
    if (v->wheelsets < 1)
        return "no wheelset";
    for (int64_t w = 0; w < v->wheelsets; w++) {
        int64_t i = v->wheelset[w];
        if (i < 0 || i >= v->bodies)
            return reason("array wheelset.body: no body %lld", (long long)i);
        if (!(v->radius[w] > 0))
            return reason("wheelset %s: radius %g m must be positive", v->body_name[i], v->radius[w]);
        if (w && !(v->cg[3*i] < v->cg[3*v->wheelset[w - 1]]))
            return reason("wheelset %s: x %g m is not behind the wheelset before it", v->body_name[i], v->cg[3*i]);
    }
    if (v->cg[3*v->wheelset[0]] != 0)
        return reason("wheelset %s: x %g m, but x counts from the first wheelset", v->body_name[v->wheelset[0]],
                      v->cg[3*v->wheelset[0]]);
    return NULL;
}

int veh_is_wheelset(const struct veh *v, int64_t body)
{
    for (int64_t w = 0; w < v->wheelsets; w++)
        if (v->wheelset[w] == body)
            return 1;
    return 0;
}

const char *veh_check(const struct veh *v)
{
    const char *why;

    if (!(v->gravity >= 0))
        return reason("gravity %g m/s2 must not be negative", v->gravity);
    if ((why = check_names("body.name", v->body_name, v->bodies)) ||
        (why = check_names("coupling.name", v->coupling_name, v->couplings)) ||
        (why = check_bodies(v)) || (why = check_wheelsets(v)))
        return why;
    for (int64_t c = 0; c < v->couplings; c++)
        if ((why = veh_check_coupling(v, c)))
            return why;
    if (v->knot_first[0] != 0 || v->knot_first[v->couplings] != v->knots)
        return reason("array knot.first: must run from 0 to the %lld knots", (long long)v->knots);
    return NULL;
}

const char *veh_read(struct veh *v, const struct vxf *f)
{
    int64_t size[SIZES];
    const char *why;

    memset(v, 0, sizeof *v);
    for (int k = 0; k < SIZES; k++)
        size[k] = -1;
    size[TWO] = 2;
    size[AXES] = 3;
    size[DOFS] = VEH_DOFS;
    size[LETTERS] = sizeof v->body_name[0];
    const void *gravity;
    if ((why = vxf_is(f, "veh")) || (why = vxf_key(f, "NAME", v->name, sizeof v->name)) ||
        (why = vxf_get(f, "gravity", VXF_F64, "m/s2", 0, NULL, &gravity)))
        return why;
    v->gravity = *(const double *)gravity;
    for (int k = 0; k < ENTRIES; k++) {
        if ((why = vxf_get_member(f, &TABLE[k], size, v)))
            return why;
        derive_sizes(size);
    }
    v->bodies = size[BODIES];
    v->couplings = size[COUPLINGS];
    v->wheelsets = size[WHEELSETS];
    v->knots = size[KNOTS];
    return veh_check(v);
}

const char *veh_put(const struct veh *v, struct vxf_out *o)
{
    const char *why = veh_check(v);
    if (why)
        return why;
    const int64_t size[SIZES] = {
        [TWO] = 2, [AXES] = 3, [DOFS] = VEH_DOFS, [BODIES] = v->bodies, [COUPLINGS] = v->couplings, [FIRSTS] = v->couplings + 1,
        [KNOTS] = v->knots, [WHEELSETS] = v->wheelsets, [ROWS] = VEH_DOFS * v->bodies, [LETTERS] = sizeof v->body_name[0]};
    vxf_put_key(o, "NAME", "%s", v->name);
    vxf_put(o, "gravity", VXF_F64, "m/s2", 0, NULL, &v->gravity);
    vxf_put_members(o, TABLE, ENTRIES, size, v);
    return NULL;
}

void *veh_room(struct veh *v, int64_t n, size_t size)
{
    return room_take(&v->store, n, size);
}

void veh_free(struct veh *v)
{
    room_release(&v->store);
    memset(v, 0, sizeof *v);
}
