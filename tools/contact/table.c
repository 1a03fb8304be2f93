/* Every entry: local minima of the gap between each rail body and the wheel's silhouette, sorted by height.
 *
 * All work is done for a right wheel.  A left one is mirrored in (y, u, yaw and their derivatives change sign) and mirrored out, so both
 * sides of a symmetric track agree to the last bit. */
#include "tools/contact/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/contact/gap.h"
#include "tools/contact/hertz.h"
#include "tools/contact/locus.h"

#define APART 4e-3            /* m: nearer minima on one body are one patch (D_COMB of CONTACT, Vollebregt 2022) */
#define WITHIN 8e-3           /* m: a contact further above the first is left out; no approach is that large */
#define ROLL_Y_MOST 5.0       /* m/rad: flatter than 0.2 1/m the contact runs away and its rate says nothing */
#define END_CURVATURE 1e3     /* 1/m: an end of a rail section is taken as an edge of 1 mm radius */
#define BESIDE 1e-3           /* m beyond its end another body must reach for the end not to count */

enum { SLOTS = 4, BODIES = 8 };

/* One polyline in right-handed coordinates. */
struct poly {
    int64_t n;
    double *y, *z, *slope, *k;               /* [n] */
};

/* What a table is made from, all of the right side. */
struct work {
    int mirror;
    double *store;
    struct poly poly;                        /* room for the longest polyline */
    double *ly, *lz, *lslope;                /* room for the wheel's silhouette */
    struct gap_curve *wheel;                 /* [yaws] y from the rail's origin */
    struct gap_curve rail[BODIES];
    int body[BODIES], ends[BODIES], bodies;
    double rail_position;
};

static void poly_copy(const struct prof *p, int64_t poly, int mirror, struct poly *o)
{
    int64_t from = p->poly_first[poly], to = p->poly_first[poly + 1];

    o->n = to - from;
    for (int64_t i = 0; i < o->n; i++) {
        int64_t j = mirror ? to - 1 - i : from + i;
        o->y[i] = mirror ? -p->y[j] : p->y[j];
        o->z[i] = p->z[j];
        o->slope[i] = mirror ? -p->slope[j] : p->slope[j];
        o->k[i] = p->curvature[j];
    }
}

static int64_t longest(const struct prof *p)
{
    int64_t n = 0;

    for (int64_t i = 0; i < p->polys; i++)
        n = p->poly_first[i + 1] - p->poly_first[i] > n ? p->poly_first[i + 1] - p->poly_first[i] : n;
    return n;
}

/* Nodes on the grid of the widest polyline, with one to spare. */
static int64_t widest(const struct prof *p, double step)
{
    int64_t n = 0;

    for (int64_t i = 0; i < p->polys; i++) {
        int64_t from = p->poly_first[i], m = gap_nodes(p->y + from, p->poly_first[i + 1] - from, step) + 1;
        n = m > n ? m : n;
    }
    return n;
}

/* The wheel's silhouettes for all yaws on the grid, y from the rail's origin.  Yaw narrows the silhouette but for the shift of steep
 * parts, which stays below `spare` nodes. */
static const char *work_begin(struct work *w, const struct ctab *t, const struct prof *wheel, const struct prof *rail,
                              const struct table_grid *g)
{
    double largest = t->yaw[t->yaws - 1], sign = w->mirror ? -1 : 1;
    int64_t spare = (int64_t)ceil(2 * wheel->radius * largest / g->u_step);
    int64_t points = longest(wheel) > longest(rail) ? longest(wheel) : longest(rail);
    int64_t wheel_nodes = widest(wheel, g->u_step) + 2 * spare, rail_nodes = widest(rail, g->u_step);
    size_t doubles = (size_t)(7 * points + 3 * wheel_nodes * t->yaws + 3 * rail_nodes * BODIES);

    w->store = calloc(doubles, sizeof *w->store);
    w->wheel = calloc((size_t)t->yaws, sizeof *w->wheel);
    if (!w->store || !w->wheel)
        return REASON_MEMORY;
    double *at = w->store, **part[] = {&w->poly.y, &w->poly.z, &w->poly.slope, &w->poly.k, &w->ly, &w->lz, &w->lslope};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++, at += points)
        *part[i] = at;
    for (int i = 0; i < BODIES; i++, at += 3 * rail_nodes)
        w->rail[i] = (struct gap_curve){.z = at, .slope = at + rail_nodes, .k = at + 2 * rail_nodes};
    w->rail_position = sign * rail->position;
    for (int64_t i = 0; i < t->yaws; i++, at += 3 * wheel_nodes) {
        struct gap_curve *c = &w->wheel[i];
        *c = (struct gap_curve){.z = at, .slope = at + wheel_nodes, .k = at + 2 * wheel_nodes};
        poly_copy(wheel, 0, w->mirror, &w->poly);
        locus_silhouette(w->poly.y, w->poly.z, w->poly.slope, w->poly.n, sign * wheel->position, wheel->radius, t->yaw[i], w->ly,
                         w->lz, w->lslope);
        for (int64_t j = 0; j < w->poly.n; j++)
            w->ly[j] -= w->rail_position;
        if (gap_nodes(w->ly, w->poly.n, g->u_step) > wheel_nodes)
            return reason("wheel profile too steep for a yaw of %g rad", t->yaw[i]);
        gap_tabulate(w->ly, w->lz, w->lslope, w->poly.k, w->poly.n, g->u_step, c);
    }
    return NULL;
}

static void work_free(struct work *w)
{
    free(w->store);
    free(w->wheel);
}

/* Does a body of this section other than `poly` reach over y (m, of the file)? */
static int covered(const struct prof *p, int64_t section, int64_t poly, double y)
{
    for (int64_t i = 0; i < p->polys; i++)
        if (i != poly && p->poly_section[i] == section && p->y[p->poly_first[i]] <= y && p->y[p->poly_first[i + 1] - 1] >= y)
            return 1;
    return 0;
}

static const char *work_section(struct work *w, const struct prof *p, int64_t section, double step)
{
    w->bodies = 0;
    for (int64_t i = 0; i < p->polys; i++) {
        if (p->poly_section[i] != section)
            continue;
        if (w->bodies == BODIES)
            return reason("section %lld has more than %d bodies", (long long)section, BODIES);
        int low = covered(p, section, i, p->y[p->poly_first[i]] - BESIDE) ? 0 : w->mirror ? GAP_RIGHT_END : GAP_LEFT_END;
        int high = covered(p, section, i, p->y[p->poly_first[i + 1] - 1] + BESIDE) ? 0 : w->mirror ? GAP_LEFT_END : GAP_RIGHT_END;
        poly_copy(p, i, w->mirror, &w->poly);
        w->body[w->bodies] = (int)p->poly_body[i];
        w->ends[w->bodies] = low | high;
        gap_tabulate(w->poly.y, w->poly.z, w->poly.slope, w->poly.k, w->poly.n, step, &w->rail[w->bodies++]);
    }
    return NULL;
}

/* One row from a minimum of the gap, still of the right side.
 *
 * The wheel hangs at H = min over y of z_rail(y) - z_wheel(y - u), so dH/du is the slope where they touch.  Roll turns a wheel point (y, z),
 * counted from the running circle's lowest point, to (y - z roll, z + y roll): dH/d(roll) = -(y + slope z), and the contact moves by
 * d(y)/d(roll) = (1 + slope^2 + z_wheel'' z)/(z_rail'' - z_wheel''). */
static void table_row(const struct gap_minimum *m, const struct ctab *t, double rail_position, double yaw, double u, double *row)
{
    struct locus_point p;
    struct hertz h;
    double A, B, z = m->z - m->gap, t2 = 1 + m->slope * m->slope, bend = t2 * sqrt(t2);
    double rail_k = m->end ? END_CURVATURE : m->rail_k, wheel_k = -m->wheel_k, both = (rail_k + wheel_k) * bend;

    locus_invert(m->y - u + rail_position, z, m->slope, t->radius, yaw, &p);
    double out = yaw != 0 ? acos(cos(p.turn) * cos(yaw)) : 0;     /* between rolling direction on the wheel and rail */
    hertz_curvatures(wheel_k, 1 / (p.r * sqrt(1 + p.rate * p.rate)), rail_k, out, &A, &B);
    hertz_contact(A, B, t->shear_modulus, t->poisson, &h);
    double roll_y = both > 0 ? (t2 - wheel_k * bend * z) / both : ROLL_Y_MOST;

    row[CTAB_HEIGHT] = m->gap;
    row[CTAB_RAIL_Y] = m->y;
    row[CTAB_RAIL_Z] = m->z;
    row[CTAB_WHEEL_Y] = p.a - fabs(t->wheel_position);
    row[CTAB_X] = p.x;
    row[CTAB_ANGLE] = atan(m->slope);
    row[CTAB_RADIUS] = p.r;
    row[CTAB_RAIL_K] = rail_k;
    row[CTAB_WHEEL_K] = wheel_k;
    row[CTAB_HERTZ_C] = h.C;
    row[CTAB_HERTZ_A] = h.a1;
    row[CTAB_HERTZ_B] = h.b1;
    row[CTAB_HEIGHT_U] = m->slope;
    row[CTAB_HEIGHT_ROLL] = -(m->y - u + rail_position - fabs(t->wheel_position) + m->slope * z);
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

/* Contacts of one node into rows[SLOTS][CTAB_N], the first to touch first. */
static int table_node(const struct work *w, const struct ctab *t, int64_t iy, int64_t shift, double step, double *rows)
{
    struct gap_minimum found[SLOTS], kept[SLOTS];
    int body[SLOTS], n = 0;

    for (int b = 0; b < w->bodies; b++) {
        int found_n = gap_minima(&w->rail[b], &w->wheel[iy], shift, step, APART, w->ends[b], found, SLOTS);
        for (int k = 0; k < found_n; k++) {
            if (n == SLOTS && found[k].gap >= kept[n - 1].gap)
                continue;
            int i = n < SLOTS ? n++ : n - 1;
            for (; i > 0 && kept[i - 1].gap > found[k].gap; i--) {
                kept[i] = kept[i - 1];
                body[i] = body[i - 1];
            }
            kept[i] = found[k];
            body[i] = w->body[b];
        }
    }
    while (n > 0 && kept[n - 1].gap > kept[0].gap + WITHIN)
        n--;
    for (int i = 0; i < n; i++) {
        double *row = rows + i * CTAB_N;
        table_row(&kept[i], t, w->rail_position, t->yaw[iy], (double)shift * step, row);
        row[CTAB_BODY] = body[i];
        if (w->mirror)
            mirror_row(row);
    }
    return n;
}

/* Arrays of t in one block, SLOTS wide; axes filled in. */
static const char *table_room(struct ctab *t, const struct prof *rail, const struct table_grid *g)
{
    int64_t reach = (int64_t)floor(g->u_max / g->u_step + 0.5);

    t->us = 2 * reach + 1;
    size_t nodes = (size_t)(t->stations * t->yaws * t->us), axes = (size_t)(t->stations + t->yaws + t->us);
    size_t counts = (nodes + sizeof(double) - 1) / sizeof(double);
    double *at = calloc(axes + counts + nodes * SLOTS * CTAB_N, sizeof *at);
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
    t->slots = SLOTS;
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
    for (int64_t i = 0; i < nodes && slots < SLOTS; i++)
        memmove(contact + i * slots * CTAB_N, contact + i * SLOTS * CTAB_N, (size_t)(slots * CTAB_N) * sizeof *contact);
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
    struct work w = {.mirror = wheel->side == 'l'};
    const char *why;

    *t = (struct ctab){
        .side = wheel->side, .yaws = method == TABLE_NONE ? 1 : g->yaws, .stations = rail->sections,
        .shear_modulus = g->shear_modulus, .poisson = g->poisson, .radius = wheel->radius,
        .rail_position = rail->position, .wheel_position = wheel->position,
    };
    memcpy(t->yaw_method, method == TABLE_NONE ? "none" : "exact", method == TABLE_NONE ? 5 : 6);
    if ((why = check_pair(wheel, rail)) || (why = table_room(t, rail, g)) || (why = work_begin(&w, t, wheel, rail, g)))
        goto done;

    double *contact = (double *)t->store + (t->contact - (const double *)t->store);
    uint8_t *count = (uint8_t *)t->store + (t->count - (const uint8_t *)t->store);
    for (int64_t is = 0; is < t->stations; is++) {
        if ((why = work_section(&w, rail, is, g->u_step)))
            goto done;
        for (int64_t iy = 0; iy < t->yaws; iy++)
            for (int64_t iu = 0; iu < t->us; iu++) {
                int64_t jy = w.mirror ? t->yaws - 1 - iy : iy, ju = w.mirror ? t->us - 1 - iu : iu;
                int64_t node = (is * t->yaws + jy) * t->us + ju;
                count[node] = (uint8_t)table_node(&w, t, iy, iu - t->us / 2, g->u_step, contact + node * SLOTS * CTAB_N);
            }
    }
    why = table_narrow(t, contact);
done:
    work_free(&w);
    if (why)
        ctab_free(t);
    return why;
}
