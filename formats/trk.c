/* Reading and writing a track, and its memory.  One table says what is stored. */
#include "formats/trk.h"

#include <stddef.h>
#include <string.h>

#include "formats/room.h"
#include "formats/trk_check.h"
#include "formats/vxf_member.h"

/* Sizes an array may have. */
enum size { ONE, RAILS, BALLAST, NODES, ELEMENTS, KNOTS, SLEEPERS, CHECKS, CURVES, CANTS, ZONES, LETTERS, COLUMNS, ENTRIES, SIZES };

enum {
    DOFS_NODE = 4,               /* wl tl wr tr */
    DOFS_SLEEPER = 2             /* z roll */
};

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

enum { ENTRIES_OF_TABLE = sizeof TABLE / sizeof TABLE[0] };

/* What follows from nodes and sleepers, once they are known. */
static void derive_sizes(int64_t size[SIZES])
{
    if (size[NODES] >= 0)
        size[ELEMENTS] = size[NODES] - 1;
    if (size[NODES] >= 0 && size[SLEEPERS] >= 0)
        size[COLUMNS] = DOFS_NODE * size[NODES] + DOFS_SLEEPER * size[SLEEPERS] + 1;
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
    for (int k = 0; k < ENTRIES_OF_TABLE; k++) {
        if ((why = vxf_get_member(f, &TABLE[k], size, t)))
            return why;
        derive_sizes(size);
    }
    t->nodes = size[NODES];
    t->sleepers = size[SLEEPERS];
    t->dofs = size[COLUMNS] - 1;
    t->knots = size[KNOTS];
    t->checks = size[CHECKS];
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
        [LETTERS] = sizeof t->zone_name[0], [COLUMNS] = t->dofs + 1, [ENTRIES] = t->Ap[t->dofs]};
    vxf_put_key(o, "NAME", "%s", t->name);
    vxf_put(o, "rail.spacing", VXF_F64, "m", 0, NULL, &t->rail_spacing);
    vxf_put_members(o, TABLE, ENTRIES_OF_TABLE, size, t);
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
