/* Reading and writing a track, and its memory.  One table says what is stored. */
#include "formats/trk.h"

#include <stddef.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/room.h"
#include "formats/trk_check.h"
#include "formats/vxf_member.h"

/* Sizes an array may have. */
enum size { ONE, RAILS, BALLAST, NODES, ELEMENTS, KNOTS, SLEEPERS, CHECKS, CURVES, CANTS, ZONES, LETTERS, COLUMNS, ENTRIES, PLANES,
            LATERAL_KNOTS, CHECK_NODES, SIZES };

enum { BENDING_PLANES = 2 };     /* vertical, lateral */

static const char *const DOFS[] = {"vertical", "spatial"};

#define AT(member) offsetof(struct trk, member)

static const struct vxf_member TABLE[] = {
    {"x",              "m",     VXF_F64, 1, {NODES, ONE},        AT(x)},
    {"bending.x",      "m",     VXF_F64, 1, {KNOTS, ONE},        AT(bending_x)},
    {"bending",        "N.m2",  VXF_F64, 2, {RAILS, KNOTS},      AT(bending)},
    {"rail.shear",     "1/N",   VXF_F64, 2, {RAILS, ELEMENTS},   AT(rail_shear)},
    {"rail.mass",      "kg",    VXF_F64, 2, {RAILS, NODES},      AT(rail_mass)},
    {"rail.inertia",   "kg.m2", VXF_F64, 2, {RAILS, NODES},      AT(rail_inertia)},
    {"rail.density",   "kg/m",  VXF_F64, 2, {RAILS, ELEMENTS},   AT(rail_density)},
    {"rail.rotary",    "kg.m",  VXF_F64, 2, {RAILS, ELEMENTS},   AT(rail_rotary)},
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
    {"ballast.gap",    "m",     VXF_F64, 2, {BALLAST, SLEEPERS}, AT(ballast_gap)},
    {"ballast.state",  "1",     VXF_I64, 2, {BALLAST, SLEEPERS}, AT(ballast_state)},
    {"lateral.m",      "kg",    VXF_F64, 1, {ONE, ONE},          AT(lateral_m)},
    {"lateral.k",      "N/m",   VXF_F64, 1, {ONE, ONE},          AT(lateral_k)},
    {"lateral.c",      "N.s/m", VXF_F64, 1, {ONE, ONE},          AT(lateral_c)},
    {"sleeper.lateral.k", "N/m",   VXF_F64, 1, {ONE, ONE},       AT(sleeper_lateral_k)},
    {"sleeper.lateral.c", "N.s/m", VXF_F64, 1, {ONE, ONE},       AT(sleeper_lateral_c)},
    {"running.m",      "kg",    VXF_F64, 1, {ONE, ONE},          AT(running_m)},
    {"check.rail",     "1",     VXF_I64, 1, {ONE, ONE},          AT(check_rail)},
    {"check.k",        "N/m",   VXF_F64, 1, {ONE, ONE},          AT(check_k)},
    {"check.c",        "N.s/m", VXF_F64, 1, {ONE, ONE},          AT(check_c)},
    {"check.x",        "m",     VXF_F64, 1, {CHECKS, ONE},       AT(check_x)},
    {"check.play",     "m",     VXF_F64, 1, {CHECKS, ONE},       AT(check_play)},
    {"curve.x",        "m",     VXF_F64, 1, {CURVES, ONE},       AT(curve_x)},
    {"curvature",      "1/m",   VXF_F64, 1, {CURVES, ONE},       AT(curvature)},
    {"cant.x",         "m",     VXF_F64, 1, {CANTS, ONE},        AT(cant_x)},
    {"cant",           "m",     VXF_F64, 1, {CANTS, ONE},        AT(cant)},
    {"zone.name",      "text",  VXF_U8,  2, {ZONES, LETTERS},    AT(zone_name)},
    {"pad.zone",       "1",     VXF_I64, 2, {RAILS, SLEEPERS},   AT(pad_zone)},
    {"node.dof",       "1",     VXF_I64, 1, {NODES, ONE},        AT(node_dof)},
    {"sleeper.dof",    "1",     VXF_I64, 1, {SLEEPERS, ONE},     AT(sleeper_dof)},
    {"A.p",            "1",     VXF_I64, 1, {COLUMNS, ONE},      AT(Ap)},
    {"A.i",            "1",     VXF_I64, 1, {ENTRIES, ONE},      AT(Ai)},
    {"K.x",            "N/m",   VXF_F64, 1, {ENTRIES, ONE},      AT(Kx)},
    {"C.x",            "N.s/m", VXF_F64, 1, {ENTRIES, ONE},      AT(Cx)},
    {"M.x",            "kg",    VXF_F64, 1, {ENTRIES, ONE},      AT(Mx)},
};

/* What a spatial track has beside them. */
static const struct vxf_member SPATIAL[] = {
    {"rail.yaw",       "kg.m2", VXF_F64, 2, {RAILS, NODES},      AT(rail_yaw)},
    {"rail.twist",     "kg.m2", VXF_F64, 2, {RAILS, NODES},      AT(rail_twist)},
    {"rail.lateral.shear", "1/N", VXF_F64, 2, {RAILS, ELEMENTS}, AT(rail_lateral_shear)},
    {"rail.lateral.rotary", "kg.m", VXF_F64, 2, {RAILS, ELEMENTS}, AT(rail_lateral_rotary)},
    {"rail.torsion",   "N.m2",  VXF_F64, 2, {RAILS, ELEMENTS},   AT(rail_torsion)},
    {"rail.polar",     "kg.m",  VXF_F64, 2, {RAILS, ELEMENTS},   AT(rail_polar)},
    {"bending.lateral.x", "m",  VXF_F64, 1, {LATERAL_KNOTS, ONE}, AT(lateral_bending_x)},
    {"bending.lateral", "N.m2", VXF_F64, 2, {RAILS, LATERAL_KNOTS}, AT(lateral_bending)},
    {"rail.head",      "m",     VXF_F64, 1, {ONE, ONE},          AT(rail_head)},
    {"rail.foot",      "m",     VXF_F64, 1, {ONE, ONE},          AT(rail_foot)},
    {"sleeper.yaw",    "kg.m2", VXF_F64, 1, {SLEEPERS, ONE},     AT(sleeper_yaw)},
    {"sleeper.seat",   "m",     VXF_F64, 1, {ONE, ONE},          AT(sleeper_seat)},
    {"pad.lateral.k",  "N/m",   VXF_F64, 2, {RAILS, SLEEPERS},   AT(pad_lateral_k)},
    {"pad.lateral.c",  "N.s/m", VXF_F64, 2, {RAILS, SLEEPERS},   AT(pad_lateral_c)},
    {"pad.width",      "m",     VXF_F64, 1, {ONE, ONE},          AT(pad_width)},
    {"pad.length",     "m",     VXF_F64, 1, {ONE, ONE},          AT(pad_length)},
    {"ballast.lateral.k", "N/m", VXF_F64, 1, {SLEEPERS, ONE},    AT(ballast_lateral_k)},
    {"ballast.lateral.c", "N.s/m", VXF_F64, 1, {SLEEPERS, ONE},  AT(ballast_lateral_c)},
    {"ballast.yaw.k",  "N.m",   VXF_F64, 1, {SLEEPERS, ONE},     AT(ballast_yaw_k)},
    {"ballast.yaw.c",  "N.m.s", VXF_F64, 1, {SLEEPERS, ONE},     AT(ballast_yaw_c)},
    {"check.node",     "1",     VXF_I64, 1, {CHECK_NODES, ONE},  AT(check_node)},
    {"check.dof",      "1",     VXF_I64, 1, {CHECK_NODES, ONE},  AT(check_dof)},
    {"check.y",        "m",     VXF_F64, 1, {ONE, ONE},          AT(check_y)},
    {"check.bending",  "N.m2",  VXF_F64, 1, {PLANES, ONE},       AT(check_bending)},
    {"check.torsion",  "N.m2",  VXF_F64, 1, {ONE, ONE},          AT(check_torsion)},
    {"check.density",  "kg/m",  VXF_F64, 1, {ONE, ONE},          AT(check_density)},
    {"check.polar",    "kg.m",  VXF_F64, 1, {ONE, ONE},          AT(check_polar)},
    {"check.head",     "m",     VXF_F64, 1, {ONE, ONE},          AT(check_head)},
    {"check.foot",     "m",     VXF_F64, 1, {ONE, ONE},          AT(check_foot)},
    {"check.pad.k",    "N/m",   VXF_F64, 1, {PLANES, ONE},       AT(check_pad_k)},
    {"check.pad.c",    "N.s/m", VXF_F64, 1, {PLANES, ONE},       AT(check_pad_c)},
};

enum { ENTRIES_OF_TABLE = sizeof TABLE / sizeof TABLE[0], ENTRIES_OF_SPATIAL = sizeof SPATIAL / sizeof SPATIAL[0] };

/* What follows from nodes and sleepers, once they are known. */
static void derive_sizes(const struct trk *t, int64_t size[SIZES])
{
    if (size[NODES] >= 0)
        size[ELEMENTS] = size[NODES] - 1;
    if (size[NODES] >= 0 && size[SLEEPERS] >= 0)
        size[COLUMNS] = t->rail_dofs * (TRK_RAILS * size[NODES] + size[CHECK_NODES]) + t->sleeper_dofs * size[SLEEPERS] + 1;
}

static const char *read_members(struct trk *t, const struct vxf *f, const struct vxf_member *member, int n, int64_t size[SIZES])
{
    for (int k = 0; k < n; k++) {
        const char *why = vxf_get_member(f, &member[k], size, t);
        if (why)
            return why;
        derive_sizes(t, size);
    }
    return NULL;
}

static const char *read_dofs(struct trk *t, const struct vxf *f)
{
    char word[16];
    const char *why = vxf_key(f, "DOFS", word, sizeof word);
    const int spatial = !why && strcmp(word, DOFS[1]) == 0;

    if (!why && !spatial && strcmp(word, DOFS[0]))
        return reason("header key DOFS: \"%s\" is not vertical or spatial", word);
    t->rail_dofs = spatial ? TRK_SPATIAL_RAIL : TRK_VERTICAL_RAIL;
    t->sleeper_dofs = spatial ? TRK_SPATIAL_SLEEPER : TRK_VERTICAL_SLEEPER;
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
    size[PLANES] = BENDING_PLANES;
    if ((why = vxf_is(f, "trk")) || (why = vxf_key(f, "NAME", t->name, sizeof t->name)) || (why = read_dofs(t, f)) ||
        (why = vxf_get(f, "rail.spacing", VXF_F64, "m", 0, NULL, &spacing)))
        return why;
    t->rail_spacing = *(const double *)spacing;
    size[CHECK_NODES] = size[LATERAL_KNOTS] = trk_is_spatial(t) ? -1 : 0;
    if ((trk_is_spatial(t) && (why = read_members(t, f, SPATIAL, ENTRIES_OF_SPATIAL, size))) ||
        (why = read_members(t, f, TABLE, ENTRIES_OF_TABLE, size)))
        return why;
    t->nodes = size[NODES];
    t->sleepers = size[SLEEPERS];
    t->dofs = size[COLUMNS] - 1;
    t->knots = size[KNOTS];
    t->checks = size[CHECKS];
    t->lateral_knots = size[LATERAL_KNOTS];
    t->check_nodes = size[CHECK_NODES];
    t->curves = size[CURVES];
    t->cants = size[CANTS];
    t->zones = size[ZONES];
    return trk_check(t, size[ENTRIES]);
}

const char *trk_put(const struct trk *t, struct vxf_out *o)
{
    const char *why = trk_check(t, t->Ap[t->dofs]);
    if (why)
        return why;
    const int64_t size[SIZES] = {
        [ONE] = 1, [RAILS] = TRK_RAILS, [BALLAST] = TRK_BALLAST, [NODES] = t->nodes, [ELEMENTS] = t->nodes - 1,
        [KNOTS] = t->knots, [SLEEPERS] = t->sleepers, [CHECKS] = t->checks, [CURVES] = t->curves, [CANTS] = t->cants, [ZONES] = t->zones,
        [LETTERS] = sizeof t->zone_name[0], [COLUMNS] = t->dofs + 1, [ENTRIES] = t->Ap[t->dofs],
        [PLANES] = BENDING_PLANES, [LATERAL_KNOTS] = t->lateral_knots, [CHECK_NODES] = t->check_nodes};
    vxf_put_key(o, "NAME", "%s", t->name);
    vxf_put_key(o, "DOFS", "%s", DOFS[trk_is_spatial(t)]);
    vxf_put(o, "rail.spacing", VXF_F64, "m", 0, NULL, &t->rail_spacing);
    vxf_put_members(o, TABLE, ENTRIES_OF_TABLE, size, t);
    if (trk_is_spatial(t))
        vxf_put_members(o, SPATIAL, ENTRIES_OF_SPATIAL, size, t);
    return NULL;
}

void *trk_room(struct trk *t, int64_t n, size_t size)
{
    return room_take(&t->store, n, size);
}

void trk_free(struct trk *t)
{
    room_release(&t->store);
    memset(t, 0, sizeof *t);
}
