/* Numbers bodies and couplings, mirrors what has a twin, and brings the vehicle to rest. */
#include "tools/vehicle/vehicle.h"

#include <stdio.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/vehicle/check.h"
#include "tools/vehicle/couplings_lay.h"
#include "tools/vehicle/linear.h"
#include "tools/vehicle/statics.h"

static const char *make_room(struct veh *v, struct vehicle_parts *p)
{
    int64_t n = v->bodies, w = v->wheelsets, rows = VEH_DOFS*n;

    if (!(p->body_name = veh_room(v, n, sizeof *p->body_name)) ||
        !(v->mass = p->mass = veh_room(v, n, sizeof(double))) ||
        !(v->inertia = p->inertia = veh_room(v, n, 3*sizeof(double))) ||
        !(v->cg = p->cg = veh_room(v, n, 3*sizeof(double))) ||
        !(v->wheelset = p->wheelset = veh_room(v, w, sizeof(int64_t))) ||
        !(v->radius = p->radius = veh_room(v, w, sizeof(double))) ||
        !(v->wheel_load = p->wheel_load = veh_room(v, w, 2*sizeof(double))) ||
        !(v->K = p->K = veh_room(v, rows*rows, sizeof(double))) ||
        !(v->C = p->C = veh_room(v, rows*rows, sizeof(double))) ||
        !(v->M = p->M = veh_room(v, rows*rows, sizeof(double))))
        return REASON_MEMORY;
    v->body_name = (const char (*)[32])p->body_name;
    return NULL;
}

static void lay_bodies(struct vehicle_parts *p, const struct veh_text *in)
{
    const struct veh_text_body *b = in->parts.body.item;
    const struct veh_text_wheelset *w = in->parts.wheelset.item;

    for (int64_t i = 0; i < in->parts.body.n; i++) {
        snprintf(p->body_name[i], sizeof p->body_name[i], "%s", b[i].name);
        p->mass[i] = b[i].mass;
        memcpy(&p->inertia[3*i], b[i].inertia.x, 3*sizeof(double));
        p->cg[3*i] = b[i].x;
        p->cg[3*i + 1] = b[i].y;
        p->cg[3*i + 2] = -b[i].height;
    }
    for (int64_t k = 0; k < in->parts.wheelset.n; k++) {
        int64_t i = in->parts.body.n + k;
        snprintf(p->body_name[i], sizeof p->body_name[i], "%s", w[k].name);
        p->mass[i] = w[k].mass;
        memcpy(&p->inertia[3*i], w[k].inertia.x, 3*sizeof(double));
        p->cg[3*i] = w[k].x;
        p->cg[3*i + 2] = -w[k].radius;
        p->wheelset[k] = i;
        p->radius[k] = w[k].radius;
    }
}

const char *vehicle_build(struct veh *v, const struct veh_text *in)
{
    struct vehicle_parts p;
    const char *why;

    memset(v, 0, sizeof *v);
    snprintf(v->name, sizeof v->name, "%s", in->name);
    v->gravity = in->gravity;
    v->bodies = in->parts.body.n + in->parts.wheelset.n;
    v->wheelsets = in->parts.wheelset.n;
    if ((why = make_room(v, &p)))
        return why;
    lay_bodies(&p, in);
    if ((why = couplings_lay(v, &p, &in->parts)) || (why = veh_check(v)) ||
        (why = statics_rest(v, p.given, p.preload, p.rest, p.wheel_load)))
        return why;
    linear_matrices(v, p.M, p.C, p.K);
    return check_support(v);
}
