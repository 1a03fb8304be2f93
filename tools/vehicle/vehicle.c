/* Numbers bodies and couplings, mirrors what has a twin, and brings the vehicle to rest. */
#include "tools/vehicle/vehicle.h"

#include <stdio.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/vehicle/check.h"
#include "tools/vehicle/linear.h"
#include "tools/vehicle/statics.h"

/* The arrays of a vehicle while they are written. */
struct parts {
    char (*body_name)[32], (*coupling_name)[32];
    double *mass, *inertia, *cg, *point, *stiffness, *damping, *preload, *knot_at, *knot_force, *radius, *wheel_load, *K, *C, *M;
    int64_t *type, *ends, *bearing, *stop_axis, *knot_first, *wheelset;
};

static void count(struct veh *v, const struct veh_text *in)
{
    const struct veh_text_coupling *c = in->coupling.item;
    const struct veh_text_stop *s = in->stop.item;

    v->bodies = in->body.n + in->wheelset.n;
    v->wheelsets = in->wheelset.n;
    for (int64_t i = 0; i < in->coupling.n; i++)
        v->couplings += c[i].mirror ? 2 : 1;
    for (int64_t i = 0; i < in->stop.n; i++) {
        v->couplings += s[i].mirror ? 2 : 1;
        v->knots += (s[i].mirror ? 2 : 1)*s[i].table.n/2;
    }
}

static const char *make_room(struct veh *v, struct parts *p)
{
    int64_t n = v->bodies, m = v->couplings, w = v->wheelsets, rows = VEH_DOFS*n;

    if (!(p->body_name = veh_room(v, n, sizeof *p->body_name)) ||
        !(v->mass = p->mass = veh_room(v, n, sizeof(double))) ||
        !(v->inertia = p->inertia = veh_room(v, n, 3*sizeof(double))) ||
        !(v->cg = p->cg = veh_room(v, n, 3*sizeof(double))) ||
        !(p->coupling_name = veh_room(v, m, sizeof *p->coupling_name)) ||
        !(v->type = p->type = veh_room(v, m, sizeof(int64_t))) ||
        !(v->ends = p->ends = veh_room(v, m, 2*sizeof(int64_t))) ||
        !(v->bearing = p->bearing = veh_room(v, m, sizeof(int64_t))) ||
        !(v->point = p->point = veh_room(v, m, 3*sizeof(double))) ||
        !(v->stiffness = p->stiffness = veh_room(v, m, VEH_DOFS*sizeof(double))) ||
        !(v->damping = p->damping = veh_room(v, m, VEH_DOFS*sizeof(double))) ||
        !(v->preload = p->preload = veh_room(v, m, 3*sizeof(double))) ||
        !(v->stop_axis = p->stop_axis = veh_room(v, m, sizeof(int64_t))) ||
        !(v->knot_first = p->knot_first = veh_room(v, m + 1, sizeof(int64_t))) ||
        !(v->knot_at = p->knot_at = veh_room(v, v->knots, sizeof(double))) ||
        !(v->knot_force = p->knot_force = veh_room(v, v->knots, sizeof(double))) ||
        !(v->wheelset = p->wheelset = veh_room(v, w, sizeof(int64_t))) ||
        !(v->radius = p->radius = veh_room(v, w, sizeof(double))) ||
        !(v->wheel_load = p->wheel_load = veh_room(v, w, 2*sizeof(double))) ||
        !(v->K = p->K = veh_room(v, rows*rows, sizeof(double))) ||
        !(v->C = p->C = veh_room(v, rows*rows, sizeof(double))) ||
        !(v->M = p->M = veh_room(v, rows*rows, sizeof(double))))
        return REASON_MEMORY;
    v->body_name = (const char (*)[32])p->body_name;
    v->coupling_name = (const char (*)[32])p->coupling_name;
    return NULL;
}

static void place_bodies(struct parts *p, const struct veh_text *in)
{
    const struct veh_text_body *b = in->body.item;
    const struct veh_text_wheelset *w = in->wheelset.item;

    for (int64_t i = 0; i < in->body.n; i++) {
        snprintf(p->body_name[i], sizeof p->body_name[i], "%s", b[i].name);
        p->mass[i] = b[i].mass;
        memcpy(&p->inertia[3*i], b[i].inertia.x, 3*sizeof(double));
        p->cg[3*i] = b[i].x;
        p->cg[3*i + 1] = b[i].y;
        p->cg[3*i + 2] = -b[i].height;
    }
    for (int64_t k = 0; k < in->wheelset.n; k++) {
        int64_t i = in->body.n + k;
        snprintf(p->body_name[i], sizeof p->body_name[i], "%s", w[k].name);
        p->mass[i] = w[k].mass;
        memcpy(&p->inertia[3*i], w[k].inertia.x, 3*sizeof(double));
        p->cg[3*i] = w[k].x;
        p->cg[3*i + 2] = -w[k].radius;
        p->wheelset[k] = i;
        p->radius[k] = w[k].radius;
    }
}

static int64_t body_named(const struct veh *v, const char *name)
{
    int64_t i = 0;
    while (strcmp(v->body_name[i], name))       /* veh_text_read has seen it */
        i++;
    return i;
}

/* Coupling c, the right or left one (side 1, -1) of a mirrored pair, or as written (side 0). */
static void place_coupling(const struct veh *v, struct parts *p, int64_t c, const char *name, const char *from, const char *to,
                           const struct yaml_nums *at, int side)
{
    double y = at->x[1];

    snprintf(p->coupling_name[c], sizeof p->coupling_name[c], "%s%s", name, side > 0 ? "-r" : side < 0 ? "-l" : "");
    p->point[3*c] = at->x[0];
    p->point[3*c + 1] = side ? side*(y < 0 ? -y : y) : y;
    p->point[3*c + 2] = -at->x[2];
    p->ends[2*c] = body_named(v, from);
    p->ends[2*c + 1] = body_named(v, to);
    int64_t first = v->bodies - v->wheelsets;   /* wheelsets come last */
    p->bearing[c] = p->ends[2*c] >= first ? 0 : p->ends[2*c + 1] >= first ? 1 : -1;
}

static int64_t place_bushings(const struct veh *v, struct parts *p, const struct veh_text *in)
{
    const struct veh_text_coupling *t = in->coupling.item;
    int64_t c = 0;

    for (int64_t i = 0; i < in->coupling.n; i++)
        for (int side = t[i].mirror; side >= -t[i].mirror; side -= 2, c++) {
            const struct { const struct yaml_nums *from; double *to; } part[4] = {
                {&t[i].stiffness, &p->stiffness[VEH_DOFS*c]}, {&t[i].rotation, &p->stiffness[VEH_DOFS*c + VEH_ROLL]},
                {&t[i].damping, &p->damping[VEH_DOFS*c]}, {&t[i].rotation_damping, &p->damping[VEH_DOFS*c + VEH_ROLL]}};
            place_coupling(v, p, c, t[i].name, t[i].from, t[i].to, &t[i].at, side);
            p->type[c] = VEH_BUSHING;
            for (int k = 0; k < 4; k++)
                for (int64_t m = 0; m < part[k].from->n; m++)
                    part[k].to[m] = part[k].from->x[m];
        }
    return c;
}

static void place_stops(const struct veh *v, struct parts *p, const struct veh_text *in, int64_t c)
{
    const struct veh_text_stop *t = in->stop.item;
    int64_t k = 0;

    for (int64_t i = 0; i < in->stop.n; i++)
        for (int side = t[i].mirror; side >= -t[i].mirror; side -= 2) {
            place_coupling(v, p, c, t[i].name, t[i].from, t[i].to, &t[i].at, side);
            p->type[c] = VEH_STOP;
            p->stop_axis[c] = t[i].axis;
            for (int64_t m = 0; m < t[i].table.n; m += 2, k++) {
                p->knot_at[k] = t[i].table.x[m];
                p->knot_force[k] = t[i].table.x[m + 1];
            }
            p->knot_first[++c] = k;
        }
}

const char *vehicle_build(struct veh *v, const struct veh_text *in)
{
    struct parts p;
    const char *why;

    memset(v, 0, sizeof *v);
    snprintf(v->name, sizeof v->name, "%s", in->name);
    v->gravity = in->gravity;
    count(v, in);
    if ((why = make_room(v, &p)))
        return why;
    place_bodies(&p, in);
    place_stops(v, &p, in, place_bushings(v, &p, in));
    if ((why = veh_check(v)) || (why = statics_rest(v, p.preload, p.wheel_load)))
        return why;
    linear_matrices(v, p.M, p.C, p.K);
    return check_support(v);
}
