/* Every entry: local minima of the gap between each rail body and the wheel's silhouette, sorted by height.
 *
 * All work is done for a right wheel.  A left one is mirrored in (y, u, yaw and their derivatives change sign) and mirrored out, so both
 * sides of a symmetric track agree to the last bit. */
#include "tools/contact/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/contact/hertz.h"
#include "tools/contact/locus.h"
#include "tools/contact/search.h"

#define ROLL_Y_MOST 5.0       /* m/rad: flatter than 0.2 1/m the contact runs away and its rate says nothing */
#define END_CURVATURE 1e3     /* 1/m: an end of a rail section is taken as an edge of 1 mm radius */

/* One row from a minimum of the gap, still of the right side.
 *
 * The wheel hangs at H = min over y of z_rail(y) - z_wheel(y - u), so dH/du is the slope where they touch.  Roll turns a wheel point (y, z),
 * counted from the running circle's lowest point, to (y - z roll, z + y roll): dH/d(roll) = -(y + slope z), and the contact moves by
 * d(y)/d(roll) = (1 + slope^2 + z_wheel'' z)/(z_rail'' - z_wheel''). */
static void table_row(const struct gap_minimum *m, const struct ctab *t, const struct search *s, double yaw, double u,
                      double *row)
{
    struct locus_point p;
    struct hertz h;
    double A, B, z = m->z - m->gap, t2 = 1 + m->slope * m->slope, bend = t2 * sqrt(t2);
    double rail_k = m->end ? END_CURVATURE : m->rail_k, wheel_k = -m->wheel_k, both = (rail_k + wheel_k) * bend;

    locus_invert(m->y - u + s->rail_position, z, m->slope, t->radius, yaw, &p);
    double out = yaw != 0 ? acos(cos(p.turn) * cos(yaw)) : 0;     /* between rolling direction on the wheel and rail */
    hertz_curvatures(wheel_k, 1 / (p.r * sqrt(1 + p.rate * p.rate)), rail_k, out, &A, &B);
    hertz_contact(A, B, t->shear_modulus, t->poisson, &h);
    double roll_y = both > 0 ? (t2 - wheel_k * bend * z) / both : ROLL_Y_MOST;

    row[CTAB_HEIGHT] = m->gap;
    row[CTAB_RAIL_Y] = m->y;
    row[CTAB_RAIL_Z] = m->z;
    row[CTAB_WHEEL_Y] = p.a - s->wheel_position;
    row[CTAB_X] = p.x;
    row[CTAB_ANGLE] = atan(m->slope);
    row[CTAB_RADIUS] = p.r;
    row[CTAB_RAIL_K] = rail_k;
    row[CTAB_WHEEL_K] = wheel_k;
    row[CTAB_HERTZ_C] = h.C;
    row[CTAB_HERTZ_A] = h.a1;
    row[CTAB_HERTZ_B] = h.b1;
    row[CTAB_HEIGHT_U] = m->slope;
    row[CTAB_HEIGHT_ROLL] = -(m->y - u + s->rail_position - s->wheel_position + m->slope * z);
    row[CTAB_ROLL_Y] = m->end ? 0 : fmax(0, fmin(roll_y, ROLL_Y_MOST));
}

static void mirror_row(double *row)
{
    row[CTAB_RAIL_Y] = -row[CTAB_RAIL_Y];
    row[CTAB_WHEEL_Y] = -row[CTAB_WHEEL_Y];
    row[CTAB_ANGLE] = -row[CTAB_ANGLE];
    row[CTAB_HEIGHT_U] = -row[CTAB_HEIGHT_U];
    row[CTAB_HEIGHT_ROLL] = -row[CTAB_HEIGHT_ROLL];
}

/* Contacts of one node into rows[SEARCH_MOST][CTAB_N], the first to touch first. */
static int table_node(const struct search *s, const struct ctab *t, double yaw, int64_t iy, int64_t shift, double *rows)
{
    struct search_contact c[SEARCH_MOST];
    int n = search_contacts(s, iy, shift, c);

    for (int i = 0; i < n; i++) {
        double *row = rows + i * CTAB_N;
        table_row(&c[i].at, t, s, yaw, (double)shift * s->step, row);
        row[CTAB_BODY] = c[i].body;
        if (s->mirror)
            mirror_row(row);
    }
    return n;
}

/* Arrays of t in one block, SEARCH_MOST wide; axes filled in. */
static const char *table_room(struct ctab *t, const struct prof *rail, const struct table_grid *g)
{
    int64_t reach = (int64_t)floor(g->u_max / g->u_step + 0.5);

    t->us = 2 * reach + 1;
    size_t nodes = (size_t)(t->stations * t->yaws * t->us), axes = (size_t)(t->stations + t->yaws + t->us);
    size_t counts = (nodes + sizeof(double) - 1) / sizeof(double);
    double *at = calloc(axes + counts + nodes * SEARCH_MOST * CTAB_N, sizeof *at);
    if (!at)
        return REASON_MEMORY;
    t->store = at;
    memcpy(at, rail->station, (size_t)t->stations * sizeof *at);
    t->station = at;
    t->yaw = at += t->stations;
    for (int64_t i = 0; i < t->yaws; i++)
        at[i] = t->yaws > 1 ? g->yaw_max * (double)(2 * i - (t->yaws - 1)) / (double)(t->yaws - 1) : 0;
    t->u = at += t->yaws;
    for (int64_t i = 0; i < t->us; i++)
        at[i] = (double)(i - reach) * g->u_step;
    at += t->us;
    t->count = (uint8_t *)at;
    t->contact = at + counts;
    t->slots = SEARCH_MOST;
    return NULL;
}

/* Narrows the rows to as many slots as are used, and gives back the rest. */
static const char *table_narrow(struct ctab *t, double *contact)
{
    int64_t nodes = t->stations * t->yaws * t->us, slots = 0;

    for (int64_t i = 0; i < nodes; i++)
        slots = t->count[i] > slots ? t->count[i] : slots;
    if (slots == 0)
        return "wheel and rail nowhere touch";
    for (int64_t i = 0; i < nodes && slots < SEARCH_MOST; i++)
        memmove(contact + i * slots * CTAB_N, contact + i * SEARCH_MOST * CTAB_N, (size_t)(slots * CTAB_N) * sizeof *contact);
    t->slots = slots;

    double *old = t->store, *new = realloc(old, (size_t)(contact - old + nodes * slots * CTAB_N) * sizeof *new);
    if (!new)
        return REASON_MEMORY;
    t->store = new;
    t->station = new;
    t->yaw = t->station + t->stations;
    t->u = t->yaw + t->yaws;
    t->count = (uint8_t *)(new + t->stations + t->yaws + t->us);
    t->contact = new + (nodes + (int64_t)sizeof(double) - 1) / (int64_t)sizeof(double) + t->stations + t->yaws + t->us;
    return NULL;
}

static const char *check_pair(const struct prof *wheel, const struct prof *rail)
{
    if (wheel->part != 'w')
        return "the wheel's profile is that of a rail";
    if (rail->part != 'r')
        return "the rail's profile is that of a wheel";
    if (wheel->side != rail->side)
        return reason("wheel is of side %c, rail of side %c", wheel->side, rail->side);
    if (wheel->polys != 1)
        return reason("wheel has %lld polylines, must have one", (long long)wheel->polys);
    if (!(wheel->radius > 0))
        return reason("wheel's radius is %g m, must be positive", wheel->radius);
    return NULL;
}

const char *table_fill(struct ctab *t, const struct prof *wheel, const struct prof *rail, enum table_yaw method,
                       const struct table_grid *g)
{
    struct search s = {0};
    const char *why;

    *t = (struct ctab){
        .side = wheel->side, .yaws = method == TABLE_NONE ? 1 : g->yaws, .stations = rail->sections,
        .shear_modulus = g->shear_modulus, .poisson = g->poisson, .radius = wheel->radius,
        .rail_position = rail->position, .wheel_position = wheel->position,
    };
    memcpy(t->yaw_method, method == TABLE_NONE ? "none" : "exact", method == TABLE_NONE ? 5 : 6);
    if ((why = check_pair(wheel, rail)) || (why = table_room(t, rail, g)) ||
        (why = search_begin(&s, wheel, rail, t->yaw, t->yaws, g->u_step)))
        goto done;

    double *contact = (double *)t->store + (t->contact - (const double *)t->store);
    uint8_t *count = (uint8_t *)t->store + (t->count - (const uint8_t *)t->store);
    for (int64_t is = 0; is < t->stations; is++) {
        if ((why = search_section(&s, rail, is)))
            goto done;
        for (int64_t iy = 0; iy < t->yaws; iy++)
            for (int64_t iu = 0; iu < t->us; iu++) {
                int64_t jy = s.mirror ? t->yaws - 1 - iy : iy, ju = s.mirror ? t->us - 1 - iu : iu;
                int64_t node = (is * t->yaws + jy) * t->us + ju;
                count[node] = (uint8_t)table_node(&s, t, t->yaw[iy], iy, iu - t->us / 2, contact + node * SEARCH_MOST * CTAB_N);
            }
    }
    why = table_narrow(t, contact);
done:
    search_free(&s);
    if (why)
        ctab_free(t);
    return why;
}
