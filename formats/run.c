/* The table of channels, and .run files read and announced by it. */
#include "formats/run.h"
#include "formats/reason.h"

#include <string.h>

const char *const run_group_name[RUN_GROUPS + 1] = {"wheels", "bodies", "pads", "ballast", "sleepers", "rails", NULL};

#define PER_WHEEL {RUN_PER_WHEELSET, RUN_PER_SIDE}
#define PER_CONTACT {RUN_PER_WHEELSET, RUN_PER_SIDE, RUN_PER_CONTACT}
#define PER_BODY {RUN_PER_BODY, RUN_PER_DOF}
#define PER_PAD {RUN_PER_SIDE, RUN_PER_SLEEPER}
#define PER_SPRING {RUN_PER_BALLAST, RUN_PER_SLEEPER}
#define PER_NODE {RUN_PER_SIDE, RUN_PER_NODE}

const struct run_channel_info run_channels[RUN_CHANNELS] = {
    [RUN_TIME] = {"time", "s", RUN_GROUPS, VXF_F64, {0}, "time"},
    [RUN_STATION] = {"station", "m", RUN_GROUPS, VXF_F64, {0}, "station of the front wheelset"},
    [RUN_Q] = {"wheel.Q", "N", RUN_WHEELS, VXF_F64, PER_WHEEL, "vertical force of the wheel on the rail"},
    [RUN_Y] = {"wheel.Y", "N", RUN_WHEELS, VXF_F64, PER_WHEEL, "lateral force of the wheel on the rail"},
    [RUN_T] = {"wheel.T", "N", RUN_WHEELS, VXF_F64, PER_WHEEL, "longitudinal force of the wheel on the rail"},
    [RUN_CHECK] = {"wheel.check", "N", RUN_WHEELS, VXF_F64, PER_WHEEL, "of Y, what the back of the flange puts on the check rail"},
    [RUN_MX] = {"wheel.Mx", "N.m", RUN_WHEELS, VXF_F64, PER_WHEEL, "moment of Q and Y about the track axis at rail level"},
    [RUN_RAIL_Y] = {"wheel.rail_y", "m", RUN_WHEELS, VXF_F64, PER_WHEEL, "displacement of the rail under the wheel to the right"},
    [RUN_RAIL_Z] = {"wheel.rail_z", "m", RUN_WHEELS, VXF_F64, PER_WHEEL, "deflection of the rail under the wheel"},
    [RUN_N] = {"contact.N", "N", RUN_WHEELS, VXF_F64, PER_CONTACT, "normal force; 0 where there is no contact"},
    [RUN_CONTACT_Y] = {"contact.rail_y", "m", RUN_WHEELS, VXF_F64, PER_CONTACT, "lateral position in the rail's profile axes"},
    [RUN_CONTACT_WHEEL_Y] = {"contact.wheel_y", "m", RUN_WHEELS, VXF_F64, PER_CONTACT, "lateral position in the wheel's profile axes"},
    [RUN_CONTACT_X] = {"contact.x", "m", RUN_WHEELS, VXF_F64, PER_CONTACT, "contact point ahead of the wheelset's centre"},
    [RUN_ANGLE] = {"contact.angle", "rad", RUN_WHEELS, VXF_F64, PER_CONTACT, "contact angle"},
    [RUN_XI] = {"creep.xi", "1", RUN_WHEELS, VXF_F64, PER_CONTACT, "longitudinal creepage"},
    [RUN_ETA] = {"creep.eta", "1", RUN_WHEELS, VXF_F64, PER_CONTACT, "lateral creepage"},
    [RUN_PHI] = {"creep.phi", "rad/m", RUN_WHEELS, VXF_F64, PER_CONTACT, "spin creepage"},
    [RUN_TX] = {"creep.Tx", "N", RUN_WHEELS, VXF_F64, PER_CONTACT, "longitudinal creep force on the rail"},
    [RUN_TY] = {"creep.Ty", "N", RUN_WHEELS, VXF_F64, PER_CONTACT, "creep force on the rail along the contact plane"},
    [RUN_BODY] = {"contact.body", "1", RUN_WHEELS, VXF_F64, PER_CONTACT, "number of the rail body, from 0"},
    [RUN_BODY_Q] = {"body.q", "m,rad", RUN_BODIES, VXF_F64, PER_BODY, "displacement from rest in the body's own frame, x y z roll pitch yaw"},
    [RUN_BODY_V] = {"body.v", "m/s,rad/s", RUN_BODIES, VXF_F64, PER_BODY, "its rate; of a wheelset's pitch: spin beyond -v/r0"},
    [RUN_BODY_A] = {"body.a", "m/s2,rad/s2", RUN_BODIES, VXF_F64, PER_BODY, "as felt: in space, in axes rolled by the cant, gravity as on level track"},
    [RUN_BODY_OFFSET] = {"body.offset", "m", RUN_BODIES, VXF_F64, {RUN_PER_BODY},
                         "the frame's origin right of the tangent where the alignment begins, or 1 m behind the rear of the train at the start"},
    [RUN_BODY_HEADING] = {"body.heading", "rad", RUN_BODIES, VXF_F64, {RUN_PER_BODY}, "heading of the frame against that tangent"},
    [RUN_PAD] = {"pad.F", "N", RUN_PADS, VXF_F32, PER_PAD, "force of the railpad on the sleeper, dead weight included"},
    [RUN_BALLAST_F] = {"ballast.F", "N", RUN_BALLAST, VXF_F32, PER_SPRING, "force on the ballast left, middle, right, dead weight included"},
    [RUN_SLEEPER_Z] = {"sleeper.z", "m", RUN_SLEEPERS, VXF_F32, {RUN_PER_SLEEPER}, "deflection"},
    [RUN_SLEEPER_ROLL] = {"sleeper.roll", "rad", RUN_SLEEPERS, VXF_F32, {RUN_PER_SLEEPER}, "roll"},
    [RUN_SLEEPER_A] = {"sleeper.a", "m/s2", RUN_SLEEPERS, VXF_F32, {RUN_PER_SLEEPER}, "vertical acceleration"},
    [RUN_NODE_Z] = {"rail.z", "m", RUN_RAILS, VXF_F32, PER_NODE, "deflection of the rail at its nodes"},
    [RUN_NODE_A] = {"rail.a", "m/s2", RUN_RAILS, VXF_F32, PER_NODE, "vertical acceleration of the rail"},
    [RUN_NODE_M] = {"rail.M", "N.m", RUN_RAILS, VXF_F32, PER_NODE, "bending moment of the rail, positive with tension in the foot"},
    [RUN_FORCE] = {"force.F", "N", RUN_GROUPS, VXF_F64, {RUN_PER_FORCE}, "prescribed force, down, on each rail it acts on"},
    [RUN_PROBE] = {"probe.z", "m", RUN_GROUPS, VXF_F64, {RUN_PER_PROBE}, "deflection there"},
};

const struct run_channel_info run_extremes[RUN_EXTREMES] = {
    [RUN_MAX_Q] = {"max.Q", "N", RUN_GROUPS, VXF_F64, PER_WHEEL, "largest Q"},
    [RUN_MIN_Q] = {"min.Q", "N", RUN_GROUPS, VXF_F64, PER_WHEEL, "smallest Q"},
    [RUN_MAX_Y] = {"max.Y", "N", RUN_GROUPS, VXF_F64, PER_WHEEL, "largest magnitude of Y"},
    [RUN_AT_MAX_Q] = {"max.Q.station", "m", RUN_GROUPS, VXF_F64, PER_WHEEL, "station of the wheel at its largest Q"},
    [RUN_SLEEPER_MAX_Q] = {"max.sleeper.Q", "N", RUN_GROUPS, VXF_F64, PER_PAD, "largest Q of a wheel nearest to the sleeper"},
    [RUN_SLEEPER_MAX_Y] = {"max.sleeper.Y", "N", RUN_GROUPS, VXF_F64, PER_PAD, "largest magnitude of Y of a wheel nearest to the sleeper"},
    [RUN_MAX_PAD] = {"max.pad.F", "N", RUN_GROUPS, VXF_F64, PER_PAD, "largest force of a railpad"},
    [RUN_MAX_PAD_COMPRESSION] = {"max.pad.d", "m", RUN_GROUPS, VXF_F64, PER_PAD, "largest compression of a railpad"},
    [RUN_MAX_BALLAST] = {"max.ballast.F", "N", RUN_GROUPS, VXF_F64, PER_SPRING, "largest force on the ballast"},
    [RUN_MAX_SLEEPER_A] = {"max.sleeper.a", "m/s2", RUN_GROUPS, VXF_F64, {RUN_PER_SLEEPER}, "largest magnitude of a sleeper's acceleration"},
    [RUN_MAX_NODE_M] = {"max.rail.M", "N.m", RUN_GROUPS, VXF_F64, PER_NODE, "largest magnitude of the rail's bending moment"},
};

static int64_t size_of(const struct run *r, enum run_dim dim)
{
    switch (dim) {
    case RUN_PER_WHEELSET:
        return r->wheelsets;
    case RUN_PER_SIDE:
        return 2;
    case RUN_PER_CONTACT:
        return RUN_CONTACTS;
    case RUN_PER_BODY:
        return r->bodies;
    case RUN_PER_DOF:
        return 6;
    case RUN_PER_SLEEPER:
        return r->sleepers;
    case RUN_PER_NODE:
        return r->nodes;
    case RUN_PER_BALLAST:
        return 3;
    case RUN_PER_FORCE:
        return r->forces;
    case RUN_PER_PROBE:
        return r->probes;
    case RUN_END:
        break;
    }
    return 1;
}

static int dims_of(const struct run *r, const struct run_channel_info *c, int64_t *dim)
{
    int n = 0;

    while (n < 4 && c->dim[n] != RUN_END) {
        dim[n] = size_of(r, c->dim[n]);
        n++;
    }
    return n;
}

int64_t run_count(const struct run *r, const struct run_channel_info *c)
{
    int64_t dim[4], count = 1;
    int n = dims_of(r, c, dim);

    while (n > 0)
        count *= dim[--n];
    return count;
}

/* ---- arrays that stand in every run ---- */

struct member {
    const char *name, *unit;
    enum vxf_type type;
    int64_t *count;        /* first dim, found here the first time */
    int64_t second;        /* 0: one dim only */
    int first;             /* 1: dims are [second][*count] */
    const void **data;
};

enum { MEMBERS = 20 };

static void members(struct run *r, struct member *m)
{
    const struct member list[MEMBERS] = {
        {"wheelset.x", "m", VXF_F64, &r->wheelsets, 0, 0, (const void **)&r->wheelset_x},
        {"wheelset.static_Q", "N", VXF_F64, &r->wheelsets, 2, 0, (const void **)&r->static_q},
        {"wheelset.radius", "m", VXF_F64, &r->wheelsets, 0, 0, (const void **)&r->radius},
        {"wheelset.body", "1", VXF_I64, &r->wheelsets, 0, 0, (const void **)&r->wheelset},
        {"body.mass", "kg", VXF_F64, &r->bodies, 0, 0, (const void **)&r->mass},
        {"body.inertia", "kg.m2", VXF_F64, &r->bodies, 3, 0, (const void **)&r->inertia},
        {"body.cg", "m", VXF_F64, &r->bodies, 3, 0, (const void **)&r->cg},
        {"body.name", "text", VXF_U8, &r->bodies, 32, 0, (const void **)&r->body_name},
        {"sleeper.x", "m", VXF_F64, &r->sleepers, 0, 0, (const void **)&r->sleeper_x},
        {"sleeper.number", "1", VXF_I64, &r->sleepers, 0, 0, (const void **)&r->sleeper_number},
        {"pad.zone", "1", VXF_I64, &r->sleepers, 2, 1, (const void **)&r->pad_zone},
        {"node.x", "m", VXF_F64, &r->nodes, 0, 0, (const void **)&r->node_x},
        {"zone.name", "text", VXF_U8, &r->zones, 32, 0, (const void **)&r->zone_name},
        {"curve.x", "m", VXF_F64, &r->curves, 0, 0, (const void **)&r->curve_x},
        {"curve.curvature", "1/m", VXF_F64, &r->curves, 0, 0, (const void **)&r->curvature},
        {"force.x", "m", VXF_F64, &r->forces, 0, 0, (const void **)&r->force_x},
        {"force.on", "1", VXF_I64, &r->forces, 0, 0, (const void **)&r->force_on},
        {"probe.x", "m", VXF_F64, &r->probes, 0, 0, (const void **)&r->probe_x},
        {"probe.on", "1", VXF_I64, &r->probes, 0, 0, (const void **)&r->probe_on},
        {"probe.held", "m/N", VXF_F64, &r->probes, 0, 0, (const void **)&r->probe_held},
    };

    memcpy(m, list, sizeof list);
}

static int member_dims(const struct member *m, int64_t *dim)
{
    dim[m->first] = *m->count;
    if (m->second)
        dim[!m->first] = m->second;
    return m->second ? 2 : 1;
}

void run_put(const struct run *r, const int *recorded, struct vxf_out *o)
{
    struct run copy = *r;
    struct member m[MEMBERS];
    int64_t dim[4];

    members(&copy, m);
    vxf_put_key(o, "NAME", "%s", r->name);
    vxf_put_key(o, "ROUTE", "%s", r->route);
    vxf_put_key(o, "FILTER", "%s", *r->filter ? r->filter : "none");
    vxf_put_key(o, "DIRECTION", "%s", *r->direction ? r->direction : "facing");
    vxf_put_key(o, "SPEED", "%.17g", r->speed);
    vxf_put_key(o, "STEP", "%.17g", r->step);
    vxf_put_key(o, "FRICTION", "%.17g", r->friction);
    vxf_put_key(o, "GRAVITY", "%.17g", r->gravity);
    vxf_put_key(o, "RAIL_SPACING", "%.17g", r->rail_spacing);
    for (int i = 0; i < MEMBERS; i++) {
        int n = member_dims(&m[i], dim);
        vxf_put(o, m[i].name, m[i].type, m[i].unit, n, dim, *m[i].data);
    }
    for (int c = 0; c < RUN_CHANNELS; c++)
        if (recorded[c]) {
            int n = dims_of(r, &run_channels[c], dim);
            vxf_put_series(o, run_channels[c].name, run_channels[c].type, run_channels[c].unit, n, dim);
        }
    for (int c = 0; c < RUN_EXTREMES; c++) {
        int n = dims_of(r, &run_extremes[c], dim);
        vxf_put_tail(o, run_extremes[c].name, VXF_F64, run_extremes[c].unit, n, dim);
    }
}

static const char *read_keys(struct run *r, const struct vxf *f)
{
    const char *why;

    if ((why = vxf_key(f, "NAME", r->name, sizeof r->name)) || (why = vxf_key(f, "ROUTE", r->route, sizeof r->route)) ||
        (why = vxf_key(f, "FILTER", r->filter, sizeof r->filter)) ||
        (why = vxf_key(f, "DIRECTION", r->direction, sizeof r->direction)) ||
        (why = vxf_number(f, "SPEED", &r->speed)) || (why = vxf_number(f, "STEP", &r->step)) ||
        (why = vxf_number(f, "FRICTION", &r->friction)) || (why = vxf_number(f, "GRAVITY", &r->gravity)) ||
        (why = vxf_number(f, "RAIL_SPACING", &r->rail_spacing)))
        return why;
    return r->speed >= 0 && r->step > 0 ? NULL : "header: speed must not be negative, step be greater than 0";
}

static const char *read_series(struct run *r, struct vxf *f)
{
    const char *why = NULL;
    int64_t dim[4];

    for (int c = 0; c < RUN_CHANNELS && !why; c++) {
        const struct run_channel_info *info = &run_channels[c];
        if (!vxf_find(&f->series, info->name))
            continue;
        int n = dims_of(r, info, dim);
        why = vxf_get_series(f, info->name, info->type, info->unit, n, dim, &r->channel[c]);
    }
    for (int c = 0; c < RUN_EXTREMES && r->complete && !why; c++) {
        int n = dims_of(r, &run_extremes[c], dim);
        why = vxf_get_tail(f, run_extremes[c].name, VXF_F64, run_extremes[c].unit, n, dim, (const void **)&r->extreme[c]);
    }
    if (!why && (!r->channel[RUN_TIME] || !r->channel[RUN_STATION]))
        why = "series time and station are missing";
    return why;
}

/* Indices stored in the file must point into it. */
static const char *check_indices(const struct run *r)
{
    for (int64_t i = 0; i < r->wheelsets; i++)
        if (r->wheelset[i] < 0 || r->wheelset[i] >= r->bodies)
            return reason("array wheelset.body: no body %lld", (long long)r->wheelset[i]);
    for (int64_t i = 0; i < 2 * r->sleepers; i++)
        if (r->pad_zone[i] < 0 || r->pad_zone[i] > r->zones)
            return reason("array pad.zone: no zone %lld", (long long)r->pad_zone[i]);
    for (int64_t i = 0; i < r->bodies; i++)
        if (!memchr(r->body_name[i], 0, 32))
            return "array body.name: a name does not end";
    for (int64_t i = 0; i < r->zones; i++)
        if (!memchr(r->zone_name[i], 0, 32))
            return "array zone.name: a name does not end";
    if (r->wheelsets > 0 && !(r->speed > 0))
        return "header: speed must be greater than 0";
    for (int64_t i = 0; i < r->forces; i++)
        if (r->force_on[i] < RUN_ON_LEFT || r->force_on[i] > RUN_ON_BOTH)
            return reason("array force.on: %lld is neither rail, nor both", (long long)r->force_on[i]);
    for (int64_t i = 0; i < r->probes; i++)
        if (r->probe_on[i] < RUN_ON_LEFT || r->probe_on[i] > RUN_ON_SLEEPER || r->probe_on[i] == RUN_ON_BOTH)
            return reason("array probe.on: %lld is neither a rail nor a sleeper", (long long)r->probe_on[i]);
    return NULL;
}

const char *run_read(struct run *r, struct vxf *f)
{
    struct member m[MEMBERS];
    const char *why;

    memset(r, 0, sizeof *r);
    r->wheelsets = r->bodies = r->sleepers = r->nodes = r->zones = r->curves = r->forces = r->probes = -1;
    r->records = f->records;
    r->complete = f->complete;
    members(r, m);
    why = read_keys(r, f);
    for (int i = 0; i < MEMBERS && !why; i++) {
        int64_t dim[2] = {-1, -1};
        int n = member_dims(&m[i], dim);
        why = vxf_get(f, m[i].name, m[i].type, m[i].unit, n, dim, m[i].data);
        if (!why)
            *m[i].count = dim[m[i].first];
    }
    if (!why)
        why = check_indices(r);
    return why ? why : read_series(r, f);
}
