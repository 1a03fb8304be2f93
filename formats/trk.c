/* Reading, checking and writing a track.  One table says what is stored; the checks are what every user of a track relies on:
 * dimensions that agree, increasing stations, positive masses, the order of the degrees of freedom, a symmetric pattern. */
#include "formats/trk.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

/* Sizes an array may have. */
enum size { ONE, RAILS, BALLAST, NODES, ELEMENTS, SLEEPERS, CHECKS, CURVES, ZONES, LETTERS, COLUMNS, ENTRIES, SIZES };

enum {
    DOFS_NODE = 4,               /* wl tl wr tr */
    DOFS_SLEEPER = 2             /* z roll */
};

static const double SAME_STATION = 1e-6;   /* m, sleeper and rail node above it */
static const double SYMMETRY = 1e-9;       /* of a matrix, relative to its largest entry */

struct entry {
    const char *name, *unit;
    enum vxf_type type;
    int ndim;
    enum size dim[2];
    size_t at;
};

#define AT(member) offsetof(struct trk, member)

static const struct entry TABLE[] = {
    {"x",              "m",     VXF_F64, 1, {NODES, ONE},        AT(x)},
    {"bending",        "N.m2",  VXF_F64, 2, {RAILS, ELEMENTS},   AT(bending)},
    {"rail.mass",      "kg",    VXF_F64, 2, {RAILS, NODES},      AT(rail_mass)},
    {"rail.inertia",   "kg.m2", VXF_F64, 2, {RAILS, NODES},      AT(rail_inertia)},
    {"sleeper.x",      "m",     VXF_F64, 1, {SLEEPERS, ONE},     AT(sleeper_x)},
    {"sleeper.node",   "1",     VXF_I64, 1, {SLEEPERS, ONE},     AT(sleeper_node)},
    {"sleeper.number", "1",     VXF_I64, 1, {SLEEPERS, ONE},     AT(sleeper_number)},
    {"sleeper.mass",   "kg",    VXF_F64, 1, {SLEEPERS, ONE},     AT(sleeper_mass)},
    {"sleeper.inertia", "kg.m2", VXF_F64, 1, {SLEEPERS, ONE},    AT(sleeper_inertia)},
    {"sleeper.y",      "m",     VXF_F64, 1, {SLEEPERS, ONE},     AT(sleeper_y)},
    {"pad.k",          "N/m",   VXF_F64, 2, {RAILS, SLEEPERS},   AT(pad_k)},
    {"pad.c",          "N.s/m", VXF_F64, 2, {RAILS, SLEEPERS},   AT(pad_c)},
    {"ballast.k",      "N/m",   VXF_F64, 2, {BALLAST, SLEEPERS}, AT(ballast_k)},
    {"ballast.c",      "N.s/m", VXF_F64, 2, {BALLAST, SLEEPERS}, AT(ballast_c)},
    {"ballast.y",      "m",     VXF_F64, 2, {BALLAST, SLEEPERS}, AT(ballast_y)},
    {"check.rail",     "1",     VXF_I64, 1, {ONE, ONE},          AT(check_rail)},
    {"check.k",        "N/m",   VXF_F64, 1, {ONE, ONE},          AT(check_k)},
    {"check.c",        "N.s/m", VXF_F64, 1, {ONE, ONE},          AT(check_c)},
    {"check.x",        "m",     VXF_F64, 1, {CHECKS, ONE},       AT(check_x)},
    {"check.play",     "m",     VXF_F64, 1, {CHECKS, ONE},       AT(check_play)},
    {"curve.x",        "m",     VXF_F64, 1, {CURVES, ONE},       AT(curve_x)},
    {"curvature",      "1/m",   VXF_F64, 1, {CURVES, ONE},       AT(curvature)},
    {"zone.name",      "1",     VXF_U8,  2, {ZONES, LETTERS},    AT(zone_name)},
    {"pad.zone",       "1",     VXF_I64, 2, {RAILS, SLEEPERS},   AT(pad_zone)},
    {"node.dof",       "1",     VXF_I64, 1, {NODES, ONE},        AT(node_dof)},
    {"sleeper.dof",    "1",     VXF_I64, 1, {SLEEPERS, ONE},     AT(sleeper_dof)},
    {"A.p",            "1",     VXF_I64, 1, {COLUMNS, ONE},      AT(Ap)},
    {"A.i",            "1",     VXF_I64, 1, {ENTRIES, ONE},      AT(Ai)},
    {"K.x",            "N/m",   VXF_F64, 1, {ENTRIES, ONE},      AT(Kx)},
    {"C.x",            "N.s/m", VXF_F64, 1, {ENTRIES, ONE},      AT(Cx)},
    {"M.x",            "kg",    VXF_F64, 1, {ENTRIES, ONE},      AT(Mx)},
};

enum { ENTRIES_OF_TABLE = sizeof TABLE / sizeof TABLE[0] };

static const void *member(const struct trk *t, const struct entry *e)
{
    const void *data;
    memcpy(&data, (const char *)t + e->at, sizeof data);
    return data;
}

static const char *get(struct trk *t, const struct vxf *f, const struct entry *e, int64_t size[SIZES])
{
    int64_t dim[VXF_DIMS];
    const void *data;

    for (int k = 0; k < e->ndim; k++)
        dim[k] = size[e->dim[k]];
    const char *why = vxf_get(f, e->name, e->type, e->unit, e->ndim, dim, &data);
    if (why)
        return why;
    for (int k = 0; k < e->ndim; k++)
        size[e->dim[k]] = dim[k];
    if (size[NODES] >= 0)
        size[ELEMENTS] = size[NODES] - 1;
    if (size[NODES] >= 0 && size[SLEEPERS] >= 0)
        size[COLUMNS] = DOFS_NODE * size[NODES] + DOFS_SLEEPER * size[SLEEPERS] + 1;
    memcpy((char *)t + e->at, &data, sizeof data);
    return NULL;
}

static const char *increasing(const char *name, const double *x, int64_t n)
{
    for (int64_t i = 1; i < n; i++)
        if (!(x[i] > x[i - 1]))
            return reason("array %s: not increasing at %lld", name, (long long)i);
    return NULL;
}

static const char *at_least(const char *name, const double *x, int64_t n, double least, int may_equal)
{
    for (int64_t i = 0; i < n; i++)
        if (x[i] < least || (!may_equal && x[i] <= least))
            return reason("array %s: %g at %lld must be %s %g", name, x[i], (long long)i, may_equal ? "at least" : "above", least);
    return NULL;
}

static const char *check_numbers(const struct trk *t)
{
    const int64_t n = t->nodes, s = t->sleepers;
    const char *why;

    (void)((why = increasing("x", t->x, n)) ||
           (why = increasing("sleeper.x", t->sleeper_x, s)) ||
           (why = increasing("check.x", t->check_x, t->checks)) ||
           (why = increasing("curve.x", t->curve_x, t->curves)) ||
           (why = at_least("check.k", t->check_k, 1, 0, 1)) ||
           (why = at_least("check.c", t->check_c, 1, 0, 1)) ||
           (why = at_least("bending", t->bending, TRK_RAILS * (n - 1), 0, 0)) ||
           (why = at_least("rail.mass", t->rail_mass, TRK_RAILS * n, 0, 0)) ||
           (why = at_least("rail.inertia", t->rail_inertia, TRK_RAILS * n, 0, 0)) ||
           (why = at_least("sleeper.mass", t->sleeper_mass, s, 0, 0)) ||
           (why = at_least("sleeper.inertia", t->sleeper_inertia, s, 0, 0)) ||
           (why = at_least("pad.k", t->pad_k, TRK_RAILS * s, 0, 1)) ||
           (why = at_least("pad.c", t->pad_c, TRK_RAILS * s, 0, 1)) ||
           (why = at_least("ballast.k", t->ballast_k, TRK_BALLAST * s, 0, 1)) ||
           (why = at_least("ballast.c", t->ballast_c, TRK_BALLAST * s, 0, 1)));
    return why;
}

static const char *check_sleepers(const struct trk *t)
{
    for (int64_t k = 0; k < t->sleepers; k++) {
        int64_t i = t->sleeper_node[k];
        if (i < 0 || i >= t->nodes || (k && i <= t->sleeper_node[k - 1]))
            return reason("array sleeper.node: %lld at %lld is out of order or range", (long long)i, (long long)k);
        if (fabs(t->x[i] - t->sleeper_x[k]) > SAME_STATION)
            return reason("array sleeper.x: %g at %lld is not below its rail node at %g", t->sleeper_x[k], (long long)k, t->x[i]);
        if (k && t->sleeper_number[k] != t->sleeper_number[k - 1] + 1)
            return reason("array sleeper.number: not counting on at %lld", (long long)k);
    }
    for (int64_t k = 0; k < TRK_RAILS * t->sleepers; k++)
        if (t->pad_zone[k] < 0 || t->pad_zone[k] > t->zones)
            return reason("array pad.zone: %lld at %lld, but there are %lld zones", (long long)t->pad_zone[k], (long long)k,
                          (long long)t->zones);
    for (int64_t z = 0; z < t->zones; z++)
        if (!memchr(t->zone_name[z], 0, sizeof t->zone_name[z]))
            return reason("array zone.name: no end at %lld", (long long)z);
    return NULL;
}

/* Degrees of freedom come by node and bay, without a gap. */
static const char *check_dofs(const struct trk *t)
{
    int64_t dof = 0, k = 0;

    for (int64_t i = 0; i < t->nodes; i++) {
        if (t->node_dof[i] != dof)
            return reason("array node.dof: %lld at %lld should be %lld", (long long)t->node_dof[i], (long long)i, (long long)dof);
        dof += DOFS_NODE;
        if (k < t->sleepers && t->sleeper_node[k] == i) {
            if (t->sleeper_dof[k] != dof)
                return reason("array sleeper.dof: %lld at %lld should be %lld", (long long)t->sleeper_dof[k], (long long)k,
                              (long long)dof);
            dof += DOFS_SLEEPER;
            k++;
        }
    }
    return NULL;
}

/* Rows increase in each column and end within the array, so that walking the columns is safe. */
static const char *check_columns(const struct trk *t, int64_t entries)
{
    if (t->Ap[0] != 0 || t->Ap[t->dofs] != entries)
        return reason("array A.p: must run from 0 to the %lld entries of A.i", (long long)entries);
    for (int64_t j = 0; j < t->dofs; j++)
        if (t->Ap[j + 1] < t->Ap[j] || t->Ap[j + 1] > entries)
            return reason("array A.p: not increasing at %lld", (long long)j + 1);
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            if (t->Ai[p] < 0 || t->Ai[p] >= t->dofs || (p > t->Ap[j] && t->Ai[p] <= t->Ai[p - 1]))
                return reason("array A.i: row %lld at %lld is out of order or range", (long long)t->Ai[p], (long long)p);
    return NULL;
}

static double largest(const double *x, int64_t n)
{
    double most = 0;
    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* next[i] is the entry of column i whose row is the column now walked: A_ij at p has its mirror A_ji at next[i]. */
static const char *check_symmetric(const struct trk *t, int64_t *next)
{
    const int64_t entries = t->Ap[t->dofs];
    const double *value[3] = {t->Kx, t->Cx, t->Mx};
    double slack[3];

    for (int m = 0; m < 3; m++)
        slack[m] = SYMMETRY * largest(value[m], entries);
    memcpy(next, t->Ap, (size_t)t->dofs * sizeof *next);
    for (int64_t j = 0; j < t->dofs; j++) {
        int diagonal = 0;
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            int64_t i = t->Ai[p], q = next[i]++;
            if (q >= t->Ap[i + 1] || t->Ai[q] != j)
                return reason("arrays A.p, A.i: row %lld of column %lld has no mirror", (long long)i, (long long)j);
            for (int m = 0; m < 3; m++)
                if (fabs(value[m][p] - value[m][q]) > slack[m])
                    return reason("array %c.x: not symmetric at row %lld of column %lld", "KCM"[m], (long long)i, (long long)j);
            diagonal |= i == j && t->Mx[p] > 0;
        }
        if (!diagonal)
            return reason("array M.x: no positive diagonal in column %lld", (long long)j);
    }
    return NULL;
}

static const char *check(const struct trk *t, int64_t entries)
{
    const char *why;

    if (t->nodes < 2 || t->sleepers < 1)
        return reason("a track needs two rail nodes and a sleeper; here are %lld and %lld", (long long)t->nodes,
                      (long long)t->sleepers);
    if (!(t->rail_spacing > 0))
        return reason("rail.spacing: %g must be positive", t->rail_spacing);
    if (*t->check_rail != TRK_LEFT && *t->check_rail != TRK_RIGHT)
        return reason("array check.rail: %lld is no side", (long long)*t->check_rail);
    if ((why = check_numbers(t)) || (why = check_sleepers(t)) || (why = check_dofs(t)) || (why = check_columns(t, entries)))
        return why;
    int64_t *next = calloc((size_t)t->dofs, sizeof *next);
    if (!next)
        return REASON_MEMORY;
    why = check_symmetric(t, next);
    free(next);
    return why;
}

const char *trk_read(struct trk *t, const struct vxf *f)
{
    int64_t size[SIZES];
    const void *spacing;
    const char *why;

    memset(t, 0, sizeof *t);
    for (int k = 0; k < SIZES; k++)
        size[k] = -1;
    size[ONE] = 1;
    size[RAILS] = TRK_RAILS;
    size[BALLAST] = TRK_BALLAST;
    size[LETTERS] = sizeof t->zone_name[0];
    if ((why = vxf_is(f, "trk")) || (why = vxf_key(f, "NAME", t->name, sizeof t->name)) ||
        (why = vxf_get(f, "rail.spacing", VXF_F64, "m", 0, NULL, &spacing)))
        return why;
    t->rail_spacing = *(const double *)spacing;
    for (int k = 0; k < ENTRIES_OF_TABLE; k++)
        if ((why = get(t, f, &TABLE[k], size)))
            return why;
    t->nodes = size[NODES];
    t->sleepers = size[SLEEPERS];
    t->dofs = size[COLUMNS] - 1;
    t->checks = size[CHECKS];
    t->curves = size[CURVES];
    t->zones = size[ZONES];
    return check(t, size[ENTRIES]);
}

const char *trk_put(const struct trk *t, struct vxf_out *o)
{
    const char *why = check(t, t->Ap[t->dofs]);
    if (why)
        return why;
    const int64_t size[SIZES] = {
        [ONE] = 1, [CHECKS] = t->checks, [RAILS] = TRK_RAILS, [BALLAST] = TRK_BALLAST, [NODES] = t->nodes, [ELEMENTS] = t->nodes - 1, [SLEEPERS] = t->sleepers,
        [CURVES] = t->curves, [ZONES] = t->zones, [LETTERS] = sizeof t->zone_name[0], [COLUMNS] = t->dofs + 1,
        [ENTRIES] = t->Ap[t->dofs]};
    vxf_put_key(o, "NAME", "%s", t->name);
    vxf_put(o, "rail.spacing", VXF_F64, "m", 0, NULL, &t->rail_spacing);
    for (int k = 0; k < ENTRIES_OF_TABLE; k++) {
        const struct entry *e = &TABLE[k];
        const int64_t dim[2] = {size[e->dim[0]], size[e->dim[1]]};
        vxf_put(o, e->name, e->type, e->unit, e->ndim, dim, member(t, e));
    }
    return NULL;
}

/* The room after its head, which points to the room before it and keeps the alignment of malloc. */
union head { union head *next; max_align_t align; };

void *trk_room(struct trk *t, int64_t n, size_t size)
{
    if (n < 0 || (uint64_t)n > (SIZE_MAX - sizeof(union head)) / size)
        return NULL;
    union head *h = calloc(1, sizeof *h + (size_t)n * size);
    if (!h)
        return NULL;
    h->next = t->store;
    t->store = h;
    return h + 1;
}

void trk_free(struct trk *t)
{
    for (union head *h = t->store, *next; h; h = next) {
        next = h->next;
        free(h);
    }
    memset(t, 0, sizeof *t);
}
