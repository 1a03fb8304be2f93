/* Every node: local minima of the gap between each rail body and the wheel's silhouette, sorted by height.
 *
 * All work is done for a right wheel.  A left one is mirrored in (y, u, yaw and their derivatives change sign) and mirrored out, so both
 * sides of a symmetric track agree to the last bit. */
#include "tools/contact/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/room.h"
#include "tools/contact/branch.h"
#include "tools/contact/clearance.h"
#include "tools/contact/link.h"
#include "tools/contact/row.h"
#include "tools/contact/search.h"

#define YAW_MAX 0.02          /* rad, and how many, where not given */
#define YAWS 21
#define YAWS_THESIS 3

_Static_assert((int)SEARCH_MOST <= (int)CTAB_MOST, "a node holds what a search finds");

/* A table being filled. */
struct filling {
    struct ctab *t;
    struct search search;
    struct strip_law law;
    int strips;              /* the law counts */
    double *station, *yaw, *u;
    int32_t *first;
    int64_t room;            /* rows there is memory for */
};

static const char *axes_room(struct filling *f, const struct prof *rail, const struct table_grid *g)
{
    struct ctab *t = f->t;
    int64_t reach = (int64_t)floor(g->u_max / g->u_step + 0.5);

    t->us = 2 * reach + 1;
    f->station = room_take(&t->store, t->stations, sizeof *f->station);
    f->yaw = room_take(&t->store, t->yaws, sizeof *f->yaw);
    f->u = room_take(&t->store, t->us, sizeof *f->u);
    f->first = room_take(&t->store, t->stations * t->yaws * t->us + 1, sizeof *f->first);
    if (!f->station || !f->yaw || !f->u || !f->first)
        return REASON_MEMORY;
    memcpy(f->station, rail->station, (size_t)t->stations * sizeof *f->station);
    for (int64_t i = 0; i < t->yaws; i++)
        f->yaw[i] = t->yaws > 1 ? g->yaw_max * (double)(2 * i - (t->yaws - 1)) / (double)(t->yaws - 1) : 0;
    for (int64_t i = 0; i < t->us; i++)
        f->u[i] = (double)(i - reach) * g->u_step;
    t->station = f->station;
    t->yaw = f->yaw;
    t->u = f->u;
    t->first = f->first;
    return NULL;
}

/* The arrays of rows as long as `rows`; 0 without memory. */
static int rows_resize(struct ctab *t, int64_t rows)
{
    float *row = realloc(t->row_store, (size_t)rows * CTAB_N * sizeof *row);
    if (row)
        t->row = t->row_store = row;
    float *rest = realloc(t->rest_store, (size_t)rows * CTAB_REST * sizeof *rest);
    if (rest)
        t->rest = t->rest_store = rest;
    uint8_t *body = realloc(t->body_store, (size_t)rows);
    if (body)
        t->body = t->body_store = body;
    return row && rest && body;
}

/* Room for as many rows as another yaw may take. */
static const char *rows_room(struct filling *f)
{
    int64_t most = f->t->rows + f->t->us * CTAB_MOST;

    if (most <= f->room)
        return NULL;
    most += f->room;
    if (most > INT32_MAX || !rows_resize(f->t, most))
        return REASON_MEMORY;
    f->room = most;
    return NULL;
}

/* A contact, of the wheel yawed and moved by these, as the next row. */
static void row_add(struct filling *f, const struct search_contact *c, double yaw, double u)
{
    struct ctab *t = f->t;
    float row[CTAB_ALL];

    row_make(c, &f->search, t, yaw, u, f->strips ? &f->law : NULL, row);
    if (f->search.mirror)
        row_mirror(row);
    memcpy(t->row_store + t->rows * CTAB_N, row, CTAB_N * sizeof *row);
    memcpy(t->rest_store + t->rows * CTAB_REST, row + CTAB_N, CTAB_REST * sizeof *row);
    t->body_store[t->rows++] = (uint8_t)c->body;
}

/* The contacts at all u of one station and yaw, in the order of the file. */
static const char *fill_us(struct filling *f, int64_t is, int64_t iy)
{
    struct ctab *t = f->t;
    const struct search *s = &f->search;
    int64_t search_yaw = s->mirror ? t->yaws - 1 - iy : iy;
    const char *why = rows_room(f);

    for (int64_t iu = 0; !why && iu < t->us; iu++) {
        struct search_contact c[SEARCH_MOST];
        int64_t shift = s->mirror ? t->us / 2 - iu : iu - t->us / 2;
        int n = search_contacts(s, search_yaw, shift, c);
        for (int i = 0; i < n; i++)
            row_add(f, &c[i], t->yaw[search_yaw], (double)shift * s->gap.step);
        f->first[(is * t->yaws + iy) * t->us + iu + 1] = (int32_t)t->rows;
    }
    return why;
}

/* Links and branches; gives back the rows too many. */
static const char *fill_end(struct filling *f)
{
    struct ctab *t = f->t;
    uint8_t *link = room_take(&t->store, t->rows, CTAB_LINKS);

    if (t->rows == 0)
        return "wheel and rail nowhere touch";
    if (!link || !rows_resize(t, t->rows))
        return REASON_MEMORY;
    link_rows(t, link);
    t->link = link;
    return branch_cells(t);
}

const char *table_pair(const struct prof *wheel, const struct prof *rail)
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
    if (rail->bodies > CTAB_BODIES)
        return reason("rail has %lld bodies, must have %d at most", (long long)rail->bodies, CTAB_BODIES);
    return NULL;
}

/* What g leaves to the method. */
static const char *grid_complete(const struct prof *wheel, const struct prof *rail, enum table_yaw method, struct table_grid *g)
{
    double clearance;
    const char *why = NULL;

    if (g->yaws == 0)
        g->yaws = method == TABLE_THESIS ? YAWS_THESIS : YAWS;
    if (g->yaw_max > 0)
        return NULL;
    g->yaw_max = YAW_MAX;
    if (method == TABLE_THESIS && !(why = clearance_find(wheel, rail, g->u_max, g->u_step, &clearance)))
        g->yaw_max = thesis_yaw(clearance);
    return why;
}

const char *table_fill(struct ctab *t, const struct prof *wheel, const struct prof *rail, enum table_yaw method,
                       const struct table_grid *grid)
{
    static const struct { const char *name; enum search_method search; } methods[] = {
        [TABLE_NONE] = {"none", SEARCH_PLANE}, [TABLE_THESIS] = {"thesis", SEARCH_THESIS}, [TABLE_EXACT] = {"exact", SEARCH_EXACT},
    };
    struct table_grid g = *grid;
    struct filling f = {.t = t, .strips = grid->normal == TABLE_STRIP};
    const char *why = table_pair(wheel, rail);

    *t = (struct ctab){0};
    if (why || (why = grid_complete(wheel, rail, method, &g)))
        return why;
    *t = (struct ctab){
        .side = wheel->side, .yaws = method == TABLE_NONE ? 1 : g.yaws, .stations = rail->sections,
        .shear_modulus = g.shear_modulus, .poisson = g.poisson, .radius = wheel->radius,
        .load = g.load > 0 ? g.load : TABLE_LOAD, .rail_position = rail->position, .wheel_position = wheel->position,
    };
    memcpy(t->normal, f.strips ? "strip" : "hertz", 5);
    if (f.strips)
        strip_law(g.shear_modulus, g.poisson, &f.law);
    memcpy(t->yaw_method, methods[method].name, strlen(methods[method].name));
    if (!(why = axes_room(&f, rail, &g)))
        why = search_begin(&f.search, wheel, rail, t->yaw, t->yaws, methods[method].search, g.u_step);
    for (int64_t is = 0; !why && is < t->stations; is++) {
        why = search_section(&f.search, rail, is);
        for (int64_t iy = 0; !why && iy < t->yaws; iy++)
            why = fill_us(&f, is, iy);
    }
    if (!why)
        why = fill_end(&f);
    search_free(&f.search);
    if (why)
        ctab_free(t);
    return why;
}
