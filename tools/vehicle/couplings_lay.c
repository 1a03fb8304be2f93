/* One kind after the other, each right one followed by its mirrored twin. */
#include "tools/vehicle/couplings_lay.h"

#include <stdio.h>
#include <string.h>

#include "formats/reason.h"

/* Where the next coupling and the next knot go. */
struct cursor { int64_t coupling, knot; };

/* ---- room ---- */

/* Couplings and knots of one kind, whose items are `size` large and have their table at `table`, 0 for none. */
static void count_kind(struct veh *v, const struct yaml_list *list, size_t size, size_t table)
{
    for (int64_t i = 0; i < list->n; i++) {
        const char *item = (const char *)list->item + (size_t)i*size;
        int twins = ((const struct veh_text_place *)(const void *)item)->mirror ? 2 : 1;
        v->couplings += twins;
        if (table)
            v->knots += twins*((const struct yaml_nums *)(const void *)(item + table))->n/2;
    }
}

static void count(struct veh *v, const struct veh_text_parts *in)
{
    count_kind(v, &in->coupling, sizeof(struct veh_text_coupling), 0);
    count_kind(v, &in->stop, sizeof(struct veh_text_stop), offsetof(struct veh_text_stop, table));
    count_kind(v, &in->spring, sizeof(struct veh_text_spring), offsetof(struct veh_text_spring, table));
    count_kind(v, &in->damper, sizeof(struct veh_text_damper), offsetof(struct veh_text_damper, table));
    count_kind(v, &in->rod, sizeof(struct veh_text_rod), 0);
    count_kind(v, &in->friction, sizeof(struct veh_text_friction), 0);
}

static const char *make_room(struct veh *v, struct vehicle_parts *p)
{
    int64_t m = v->couplings, k = v->knots;
    const size_t one = sizeof(double);

    if (!(p->coupling_name = veh_room(v, m, sizeof *p->coupling_name)) || !(v->type = p->type = veh_room(v, m, sizeof(int64_t))) ||
        !(v->ends = p->ends = veh_room(v, m, 2*sizeof(int64_t))) || !(v->bearing = p->bearing = veh_room(v, m, sizeof(int64_t))) ||
        !(v->point = p->point = veh_room(v, m, 3*one)) || !(v->end = p->end = veh_room(v, m, 3*one)) ||
        !(v->stiffness = p->stiffness = veh_room(v, m, VEH_DOFS*one)) || !(v->damping = p->damping = veh_room(v, m, VEH_DOFS*one)) ||
        !(v->preload = p->preload = veh_room(v, m, 3*one)) || !(v->axis = p->axis = veh_room(v, m, sizeof(int64_t))) ||
        !(v->series = p->series = veh_room(v, m, one)) || !(v->rest = p->rest = veh_room(v, m, one)) ||
        !(v->coefficient = p->coefficient = veh_room(v, m, one)) || !(v->load = p->load = veh_room(v, m, one)) ||
        !(v->spring = p->spring = veh_room(v, m, sizeof(int64_t))) || !(v->share = p->share = veh_room(v, m, one)) ||
        !(v->lever = p->lever = veh_room(v, m, one)) || !(p->given = veh_room(v, m, one)) ||
        !(v->knot_first = p->knot_first = veh_room(v, m + 1, sizeof(int64_t))) || !(v->knot_at = p->knot_at = veh_room(v, k, one)) ||
        !(v->knot_force = p->knot_force = veh_room(v, k, one)))
        return REASON_MEMORY;
    v->coupling_name = (const char (*)[32])p->coupling_name;
    return NULL;
}

/* ---- places ---- */

static int64_t body_named(const struct veh *v, const char *name)
{
    int64_t i = 0;
    while (strcmp(v->body_name[i], name))       /* veh_text_read has seen it */
        i++;
    return i;
}

static void lay_point(const struct yaml_nums *at, int side, double *to)
{
    to[0] = at->x[0];
    to[1] = side < 0 ? -at->x[1] : at->x[1];
    to[2] = -at->x[2];
}

/* The next coupling: the right or left one (side 1, -1) of a mirrored pair, or as written (side 0).  Returns its number. */
static int64_t lay_one(const struct veh *v, struct vehicle_parts *p, struct cursor *at, enum veh_coupling type,
                         const struct veh_text_place *t, int side)
{
    int64_t c = at->coupling++, first = v->bodies - v->wheelsets;       /* wheelsets come last */
    int mirrored = side && (t->at.x[1] < 0) != (side < 0) ? -1 : 1;     /* whichever side was written */

    snprintf(p->coupling_name[c], sizeof p->coupling_name[c], "%s%s", t->name, side > 0 ? "-r" : side < 0 ? "-l" : "");
    lay_point(&t->at, mirrored, &p->point[3*c]);
    lay_point(t->end.n ? &t->end : &t->at, mirrored, &p->end[3*c]);
    p->type[c] = type;
    p->ends[2*c] = body_named(v, t->from);
    p->ends[2*c + 1] = body_named(v, t->to);
    p->bearing[c] = p->ends[2*c] >= first ? 0 : p->ends[2*c + 1] >= first ? 1 : -1;
    p->spring[c] = -1;
    p->knot_first[c + 1] = at->knot;
    return c;
}

static void lay_table(struct vehicle_parts *p, struct cursor *at, int64_t c, const struct yaml_nums *table)
{
    for (int64_t m = 0; m < table->n; m += 2, at->knot++) {
        p->knot_at[at->knot] = table->x[m];
        p->knot_force[at->knot] = table->x[m + 1];
    }
    p->knot_first[c + 1] = at->knot;
}

/* Three numbers or none. */
static void lay_three(const struct yaml_nums *from, double *to)
{
    for (int64_t m = 0; m < from->n; m++)
        to[m] = from->x[m];
}

/* ---- kinds ---- */

/* Each side of t, 1 and -1 of a mirrored one, else 0. */
#define SIDES(t) int side = (t).place.mirror; side >= -(t).place.mirror; side -= 2

static void lay_bushings(const struct veh *v, struct vehicle_parts *p, const struct yaml_list *list, struct cursor *at)
{
    const struct veh_text_coupling *t = list->item;

    for (int64_t i = 0; i < list->n; i++)
        for (SIDES(t[i])) {
            int64_t c = lay_one(v, p, at, VEH_BUSHING, &t[i].place, side);
            lay_three(&t[i].stiffness, &p->stiffness[VEH_DOFS*c]);
            lay_three(&t[i].rotation, &p->stiffness[VEH_DOFS*c + VEH_ROLL]);
            lay_three(&t[i].damping, &p->damping[VEH_DOFS*c]);
            lay_three(&t[i].rotation_damping, &p->damping[VEH_DOFS*c + VEH_ROLL]);
        }
}

static void lay_stops(const struct veh *v, struct vehicle_parts *p, const struct yaml_list *list, struct cursor *at)
{
    const struct veh_text_stop *t = list->item;

    for (int64_t i = 0; i < list->n; i++)
        for (SIDES(t[i])) {
            int64_t c = lay_one(v, p, at, VEH_STOP, &t[i].place, side);
            p->axis[c] = t[i].axis;
            lay_table(p, at, c, &t[i].table);
        }
}

static void lay_springs(const struct veh *v, struct vehicle_parts *p, const struct yaml_list *list, struct cursor *at)
{
    const struct veh_text_spring *t = list->item;

    for (int64_t i = 0; i < list->n; i++)
        for (SIDES(t[i])) {
            int64_t c = lay_one(v, p, at, VEH_SPRING, &t[i].place, side);
            p->axis[c] = t[i].axis;
            p->given[c] = t[i].preload;
            lay_table(p, at, c, &t[i].table);
        }
}

static void lay_dampers(const struct veh *v, struct vehicle_parts *p, const struct yaml_list *list, struct cursor *at)
{
    const struct veh_text_damper *t = list->item;

    for (int64_t i = 0; i < list->n; i++)
        for (SIDES(t[i])) {
            int64_t c = lay_one(v, p, at, VEH_DAMPER, &t[i].place, side);
            p->axis[c] = t[i].axis;
            p->series[c] = t[i].series;
            lay_table(p, at, c, &t[i].table);
        }
}

static void lay_rods(const struct veh *v, struct vehicle_parts *p, const struct yaml_list *list, struct cursor *at)
{
    const struct veh_text_rod *t = list->item;

    for (int64_t i = 0; i < list->n; i++)
        for (SIDES(t[i])) {
            int64_t c = lay_one(v, p, at, VEH_ROD, &t[i].place, side);
            p->stiffness[VEH_DOFS*c] = t[i].stiffness;
            p->damping[VEH_DOFS*c] = t[i].damping;
        }
}

/* The spring on the same side, or the one of just that name, before coupling c; -1 where there is none. */
static int64_t spring_named(const struct vehicle_parts *p, int64_t c, const char *name, int side)
{
    char sided[40];
    int64_t found = -1;

    snprintf(sided, sizeof sided, "%s%s", name, side > 0 ? "-r" : side < 0 ? "-l" : "");
    for (int64_t i = 0; i < c; i++) {
        if (!strcmp(p->coupling_name[i], sided))
            return i;
        if (!strcmp(p->coupling_name[i], name))
            found = i;
    }
    return found;
}

static const char *lay_frictions(const struct veh *v, struct vehicle_parts *p, const struct yaml_list *list, struct cursor *at)
{
    const struct veh_text_friction *t = list->item;

    for (int64_t i = 0; i < list->n; i++)
        for (SIDES(t[i])) {
            int64_t c = lay_one(v, p, at, VEH_FRICTION, &t[i].place, side);
            lay_three(&t[i].stiffness, &p->stiffness[VEH_DOFS*c]);
            lay_three(&t[i].rotation, &p->stiffness[VEH_DOFS*c + VEH_ROLL]);
            p->coefficient[c] = t[i].coefficient;
            p->load[c] = t[i].load;
            p->share[c] = t[i].share;
            p->lever[c] = t[i].radius;
            if (t[i].spring && (p->spring[c] = spring_named(p, c, t[i].spring, side)) < 0)
                return reason("friction %s: there is no coupling or spring %s", t[i].place.name, t[i].spring);
        }
    return NULL;
}

const char *couplings_lay(struct veh *v, struct vehicle_parts *p, const struct veh_text_parts *in)
{
    struct cursor at = {0};
    const char *why;

    count(v, in);
    if ((why = make_room(v, p)))
        return why;
    lay_bushings(v, p, &in->coupling, &at);
    lay_stops(v, p, &in->stop, &at);
    lay_springs(v, p, &in->spring, &at);
    lay_dampers(v, p, &in->damper, &at);
    lay_rods(v, p, &in->rod, &at);
    return lay_frictions(v, p, &in->friction, &at);
}
