/* The schema of a vehicle input and the checks between its keys. */
#include "formats/veh_text.h"

#include <string.h>

#include "formats/reason.h"
#include "formats/veh_repeat.h"
#include "formats/veh_text_check.h"

#define AT(type, member) offsetof(struct type, member)

static const char *const AXES[] = {"x", "y", "z", NULL};
static const char *const LINES[] = {"x", "y", "z", "line", NULL};

static const struct yaml_field BODY_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text_body, name), 0, 0, "", NULL, "of the body, up to 31 letters", NULL, NULL},
    {"mass", YAML_NUM, AT(veh_text_body, mass), YAML_POSITIVE, 1e7, "kg", NULL, "of the body", NULL, NULL},
    {"inertia", YAML_NUMS, AT(veh_text_body, inertia), YAML_POSITIVE, 1e10, "kg.m2", NULL,
     "about x, y and z through the centre of gravity", NULL, NULL},
    {"x", YAML_NUM, AT(veh_text_body, x), -1e3, 1e3, "m", NULL,
     "centre of gravity, from the first wheelset, negative behind it; in a bogie from its centre", NULL, NULL},
    {"y", YAML_NUM, AT(veh_text_body, y), -5, 5, "m", "0", "centre of gravity, to the right", NULL, NULL},
    {"height", YAML_NUM, AT(veh_text_body, height), 0, 10, "m", NULL, "centre of gravity, above rail level", NULL, NULL},
    {0}};

static const struct yaml_field WHEELSET_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text_wheelset, name), 0, 0, "", NULL, "of the wheelset, up to 31 letters", NULL, NULL},
    {"mass", YAML_NUM, AT(veh_text_wheelset, mass), YAML_POSITIVE, 1e5, "kg", NULL, "with axleboxes", NULL, NULL},
    {"inertia", YAML_NUMS, AT(veh_text_wheelset, inertia), YAML_POSITIVE, 1e6, "kg.m2", NULL, "about x, y and z; y is the axle", NULL,
     NULL},
    {"x", YAML_NUM, AT(veh_text_wheelset, x), -1e3, 1e3, "m", NULL, "from the first wheelset, which is at 0; in a bogie from its centre", NULL, NULL},
    {"radius", YAML_NUM, AT(veh_text_wheelset, radius), 0.1, 2, "m", NULL, "nominal rolling radius, the height of the axle", NULL, NULL},
    {0}};

#define PLACE(type) \
    {"name", YAML_TEXT, AT(type, place.name), 0, 0, "", NULL, "up to 31 letters, 29 with mirror", NULL, NULL}, \
    {"from", YAML_TEXT, AT(type, place.from), 0, 0, "", NULL, "body or wheelset", NULL, NULL}, \
    {"to", YAML_TEXT, AT(type, place.to), 0, 0, "", NULL, "body or wheelset", NULL, NULL}, \
    {"at", YAML_NUMS, AT(type, place.at), -1e3, 1e3, "m", NULL, "x, y and height of its point", NULL, NULL}, \
    {"mirror", YAML_BOOL, AT(type, place.mirror), 0, 0, "", "false", "a twin at -y; names end in -r and -l", NULL, NULL}
#define END(type, value, help) {"end", YAML_NUMS, AT(type, place.end), -1e3, 1e3, "m", value, help, NULL, NULL}

static const struct yaml_field COUPLING_FIELDS[] = {
    PLACE(veh_text_coupling),
    {"stiffness", YAML_NUMS, AT(veh_text_coupling, stiffness), 0, 1e12, "N/m", NULL, "along x, y and z", NULL, NULL},
    {"damping", YAML_NUMS, AT(veh_text_coupling, damping), 0, 1e10, "N.s/m", YAML_ABSENT, "along x, y and z", NULL, NULL},
    {"rotation", YAML_NUMS, AT(veh_text_coupling, rotation), 0, 1e12, "N.m/rad", YAML_ABSENT, "stiffness about x, y and z", NULL, NULL},
    {"rotation_damping", YAML_NUMS, AT(veh_text_coupling, rotation_damping), 0, 1e10, "N.m.s/rad", YAML_ABSENT, "about x, y and z", NULL,
     NULL},
    {0}};

static const struct yaml_field STOP_FIELDS[] = {
    PLACE(veh_text_stop),
    {"axis", YAML_CHOICE, AT(veh_text_stop, axis), 0, 0, "", NULL, "along which it acts", NULL, AXES},
    {"table", YAML_PAIRS, AT(veh_text_stop, table), 0, 1e9, "m, N", NULL,
     "deflection and force, rising from the clearance with force 0; odd, beyond its end the last slope", NULL, NULL},
    {0}};

static const struct yaml_field SPRING_FIELDS[] = {
    PLACE(veh_text_spring),
    {"axis", YAML_CHOICE, AT(veh_text_spring, axis), 0, 0, "", "z", "along which it acts", NULL, AXES},
    {"preload", YAML_NUM, AT(veh_text_spring, preload), 0, 1e9, "N", "0", "vertical force at rest; 0 leaves it to the equilibrium", NULL,
     NULL},
    {"table", YAML_PAIRS, AT(veh_text_spring, table), -1e9, 1e9, "m, N", NULL,
     "compression and force, rising; beyond its ends the first and last slope", NULL, NULL},
    {0}};

static const struct yaml_field DAMPER_FIELDS[] = {
    PLACE(veh_text_damper),
    END(veh_text_damper, YAML_ABSENT, "x, y and height of its point on the second body, for axis line"),
    {"axis", YAML_CHOICE, AT(veh_text_damper, axis), 0, 0, "", NULL, "along which it acts; line is that between its ends", NULL, LINES},
    {"series", YAML_NUM, AT(veh_text_damper, series), 0, 1e12, "N/m", "0", "stiffness in series; 0 is rigid", NULL, NULL},
    {"table", YAML_PAIRS, AT(veh_text_damper, table), 0, 1e9, "m/s, N", NULL,
     "rate and force, rising from 0, 0; odd, beyond its end the last slope", NULL, NULL},
    {0}};

static const struct yaml_field ROD_FIELDS[] = {
    PLACE(veh_text_rod),
    END(veh_text_rod, NULL, "x, y and height of its point on the second body"),
    {"stiffness", YAML_NUM, AT(veh_text_rod, stiffness), 0, 1e12, "N/m", NULL, "along its line", NULL, NULL},
    {"damping", YAML_NUM, AT(veh_text_rod, damping), 0, 1e10, "N.s/m", "0", "along its line", NULL, NULL},
    {0}};

static const struct yaml_field FRICTION_FIELDS[] = {
    PLACE(veh_text_friction),
    {"coefficient", YAML_NUM, AT(veh_text_friction, coefficient), 0, 10, "1", NULL, "of friction; 0 takes it out", NULL, NULL},
    {"load", YAML_NUM, AT(veh_text_friction, load), 0, 1e9, "N", "0", "normal force that depends on no spring", NULL, NULL},
    {"spring", YAML_TEXT, AT(veh_text_friction, spring), 0, 0, "", YAML_ABSENT, "coupling or spring whose vertical force loads it", NULL,
     NULL},
    {"share", YAML_NUM, AT(veh_text_friction, share), 0, 100, "1", "1", "normal force over that vertical force", NULL, NULL},
    {"stiffness", YAML_NUMS, AT(veh_text_friction, stiffness), 0, 1e12, "N/m", YAML_ABSENT, "stick, along x, y and z; 0 is free", NULL,
     NULL},
    {"rotation", YAML_NUMS, AT(veh_text_friction, rotation), 0, 1e12, "N.m/rad", YAML_ABSENT, "stick, about x, y and z", NULL, NULL},
    {"radius", YAML_NUM, AT(veh_text_friction, radius), 0, 10, "m", "0", "lever of a rotation: torque at most coefficient load radius", NULL,
     NULL},
    {0}};

static const struct yaml_schema BODY = {"body", sizeof(struct veh_text_body), BODY_FIELDS};
static const struct yaml_schema WHEELSET = {"wheelset", sizeof(struct veh_text_wheelset), WHEELSET_FIELDS};
static const struct yaml_schema COUPLING = {"coupling", sizeof(struct veh_text_coupling), COUPLING_FIELDS};
static const struct yaml_schema STOP = {"stop", sizeof(struct veh_text_stop), STOP_FIELDS};
static const struct yaml_schema SPRING = {"spring", sizeof(struct veh_text_spring), SPRING_FIELDS};
static const struct yaml_schema DAMPER = {"damper", sizeof(struct veh_text_damper), DAMPER_FIELDS};
static const struct yaml_schema ROD = {"rod", sizeof(struct veh_text_rod), ROD_FIELDS};
static const struct yaml_schema FRICTION = {"friction", sizeof(struct veh_text_friction), FRICTION_FIELDS};

#define PARTS(type, wheelsets) \
    {"body", YAML_LIST, AT(type, parts.body), 0, 0, "", YAML_ABSENT, "rigid bodies above the wheelsets", &BODY, NULL}, \
    {"wheelset", YAML_LIST, AT(type, parts.wheelset), 0, 0, "", YAML_ABSENT, wheelsets, &WHEELSET, NULL}, \
    {"coupling", YAML_LIST, AT(type, parts.coupling), 0, 0, "", YAML_ABSENT, "spring and damper between two bodies", &COUPLING, NULL}, \
    {"stop", YAML_LIST, AT(type, parts.stop), 0, 0, "", YAML_ABSENT, "piecewise-linear spring with clearance along one axis", &STOP, NULL}, \
    {"spring", YAML_LIST, AT(type, parts.spring), 0, 0, "", YAML_ABSENT, "piecewise-linear spring from its free length", &SPRING, NULL}, \
    {"damper", YAML_LIST, AT(type, parts.damper), 0, 0, "", YAML_ABSENT, "piecewise-linear damper, rigid or on a spring", &DAMPER, NULL}, \
    {"rod", YAML_LIST, AT(type, parts.rod), 0, 0, "", YAML_ABSENT, "spring and damper along the line between two ends", &ROD, NULL}, \
    {"friction", YAML_LIST, AT(type, parts.friction), 0, 0, "", YAML_ABSENT, "dry friction under the load of a spring", &FRICTION, NULL}

static const struct yaml_field BOGIE_FIELDS[] = {
    {"at", YAML_NUMS, AT(veh_text_bogie, at), -1e3, 0, "m", NULL, "x of its centre, once for each bogie from the front", NULL, NULL},
    PARTS(veh_text_bogie, "from the front of the bogie"),
    {0}};

static const struct yaml_schema BOGIE = {"bogie", sizeof(struct veh_text_bogie), BOGIE_FIELDS};

static const struct yaml_field VEHICLE_FIELDS[] = {
    {"name", YAML_TEXT, AT(veh_text, name), 0, 0, "", NULL, "of the vehicle, up to 63 letters", NULL, NULL},
    {"gravity", YAML_NUM, AT(veh_text, gravity), 0, 100, "m/s2", "9.81", "acceleration of free fall", NULL, NULL},
    PARTS(veh_text, "from the front; before those of bogies"),
    {"bogie", YAML_LIST, AT(veh_text, bogie), 0, 0, "", YAML_ABSENT, "parts repeated at several places; their names take its number", &BOGIE,
     NULL},
    {0}};

const struct yaml_schema veh_text_schema = {"vehicle", sizeof(struct veh_text), VEHICLE_FIELDS};

const char *veh_text_read(struct veh_text *in, const char *path, char *const *set, int sets, uint64_t *hash)
{
    const char *why = yaml_read(path, &veh_text_schema, set, sets, in, hash);
    int line = 0;

    if (why)
        return why;
    if (!(why = veh_repeat(in)))
        why = veh_text_check(in, &line);
    if (!why)
        return NULL;
    path = strcmp(path, "-") ? path : "standard input";
    why = line > 0 ? reason("%s:%d: error: %s", path, line, why) : reason("%s: error: %s", path, why);
    veh_text_free(in);
    return why;
}

void veh_text_free(struct veh_text *in)
{
    yaml_release(&veh_text_schema, in);
}
