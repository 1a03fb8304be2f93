/* The keys of the profile input, each with type, unit, range, default and meaning. */
#include "formats/prof_text.h"

#include <stddef.h>

#define ANY (-YAML_NO_LIMIT), YAML_NO_LIMIT

const char *const prof_part_names[] = {"wheel", "rail", "turnout", "sections", NULL};
const char *const prof_unit_names[] = {"unstated", "m", "mm", NULL};
static const char *const mirrors[] = {"unstated", "false", "true", NULL};
static const char *const file_sides[] = {"unstated", "right", "left", NULL};
static const char *const hands[] = {"right", "left", NULL};
static const char *const routes[] = {"diverging", "through", NULL};

static const struct yaml_schema zone_schema = {"zones", sizeof(struct prof_zone), (const struct yaml_field[]){
    {"from", YAML_NUM, offsetof(struct prof_zone, from), ANY, "unit", NULL, "y where the zone begins", NULL, NULL},
    {"to", YAML_NUM, offsetof(struct prof_zone, to), ANY, "unit", NULL, "y where it ends", NULL, NULL},
    {"polynomial", YAML_NUMS, offsetof(struct prof_zone, polynomial), ANY, "unit", YAML_ABSENT,
     "z = c0 + c1 y + c2 y^2 ...", NULL, NULL},
    {"centre", YAML_NUMS, offsetof(struct prof_zone, centre), ANY, "unit", YAML_ABSENT, "y, z of an arc's centre", NULL, NULL},
    {"radius", YAML_NUM, offsetof(struct prof_zone, radius), ANY, "unit", YAML_ABSENT,
     "of the arc, positive where its centre lies below the surface", NULL, NULL},
    {0}}};

static const struct yaml_schema stations_schema = {"stations", sizeof(struct turnout_stations), (const struct yaml_field[]){
    {"from", YAML_NUM, offsetof(struct turnout_stations, from), ANY, "m", NULL, "first section", NULL, NULL},
    {"to", YAML_NUM, offsetof(struct turnout_stations, to), ANY, "m", NULL, "last section", NULL, NULL},
    {"step", YAML_NUM, offsetof(struct turnout_stations, step), 1e-3, YAML_NO_LIMIT, "m", NULL, "at most this far apart",
     NULL, NULL},
    {0}}};

static const struct yaml_schema blade_schema = {"switch_rail", sizeof ((struct turnout_text *)0)->blade, (const struct yaml_field[]){
    {"tip", YAML_NUM, offsetof(struct turnout_text, blade.tip) - offsetof(struct turnout_text, blade), YAML_POSITIVE,
     YAML_NO_LIMIT, "m", NULL, "station where the switch rail begins", NULL, NULL},
    {"edge_radius", YAML_NUM, offsetof(struct turnout_text, blade.edge_radius) - offsetof(struct turnout_text, blade),
     YAML_POSITIVE, 0.013, "m", "0.005", "rounding of the planed top's edges", NULL, NULL},
    {"lowering", YAML_PAIRS, offsetof(struct turnout_text, blade.lowering) - offsetof(struct turnout_text, blade), 0, 1, "m",
     NULL, "[thickness of the blade, its top below the stock rail's]", NULL, NULL},
    {0}}};

static const struct yaml_schema wing_schema = {"wing_rail", sizeof ((struct turnout_text *)0)->wing, (const struct yaml_field[]){
    {"flangeway", YAML_NUM, offsetof(struct turnout_text, wing.flangeway) - offsetof(struct turnout_text, wing), YAML_POSITIVE,
     0.1, "m", NULL, "between wing rail and nose", NULL, NULL},
    {"knee", YAML_NUM, offsetof(struct turnout_text, wing.knee) - offsetof(struct turnout_text, wing), 0, 0.02, "m", "0",
     "its edge bends away from the running edge between so much before and behind the line it follows; 0 is a corner", NULL, NULL},
    {"end", YAML_NUM, offsetof(struct turnout_text, wing.end) - offsetof(struct turnout_text, wing), YAML_POSITIVE, YAML_NO_LIMIT,
     "m", YAML_ABSENT, "behind the mathematical point, where the wing rail ends; absent, where it is out of reach", NULL, NULL},
    {"flare", YAML_NUM, offsetof(struct turnout_text, wing.flare) - offsetof(struct turnout_text, wing), YAML_POSITIVE, YAML_NO_LIMIT,
     "m", YAML_ABSENT, "length at its end over which the flangeway opens", NULL, NULL},
    {"opening", YAML_NUM, offsetof(struct turnout_text, wing.opening) - offsetof(struct turnout_text, wing), YAML_POSITIVE, 0.2,
     "m", YAML_ABSENT, "flangeway at its end", NULL, NULL},
    {"edge_radius", YAML_NUM, offsetof(struct turnout_text, wing.edge_radius) - offsetof(struct turnout_text, wing),
     YAML_POSITIVE, 0.013, "m", "0.006", "rounding of the machined top's edge", NULL, NULL},
    {"crown_radius", YAML_NUM, offsetof(struct turnout_text, wing.crown_radius) - offsetof(struct turnout_text, wing),
     YAML_POSITIVE, 1, "m", "0.08", "of the machined top, from the edge to where it is level", NULL, NULL},
    {"level", YAML_NUM, offsetof(struct turnout_text, wing.level) - offsetof(struct turnout_text, wing), YAML_POSITIVE,
     0.05, "m", "0.0125", "from the edge to where the machined top is level", NULL, NULL},
    {"blend", YAML_NUM, offsetof(struct turnout_text, wing.blend) - offsetof(struct turnout_text, wing), YAML_POSITIVE,
     0.1, "m", "0.03", "distance from the running edge where the top is machined in full, from nothing at the throat", NULL, NULL},
    {"raise", YAML_PAIRS, offsetof(struct turnout_text, wing.raise) - offsetof(struct turnout_text, wing), 0, 1, "m", NULL,
     "[distance from the running edge, top above the plain rail's]", NULL, NULL},
    {0}}};

static const struct yaml_schema nose_schema = {"nose", sizeof ((struct turnout_text *)0)->nose, (const struct yaml_field[]){
    {"edge_radius", YAML_NUM, offsetof(struct turnout_text, nose.edge_radius) - offsetof(struct turnout_text, nose),
     YAML_POSITIVE, 0.013, "m", "0.008", "rounding of its edges", NULL, NULL},
    {"lowering", YAML_PAIRS, offsetof(struct turnout_text, nose.lowering) - offsetof(struct turnout_text, nose), 0, 1, "m", NULL,
     "[width of the nose, its top below the plain rail's]; it begins at the first width", NULL, NULL},
    {0}}};

static const struct yaml_schema check_schema = {"check_rail", sizeof ((struct turnout_text *)0)->check, (const struct yaml_field[]){
    {"body", YAML_BOOL, offsetof(struct turnout_text, check.body) - offsetof(struct turnout_text, check), ANY, "", "false",
     "the sections hold it; false where the track input's check_rail, a spring, guides the flange", NULL, NULL},
    {"height", YAML_NUM, offsetof(struct turnout_text, check.height) - offsetof(struct turnout_text, check), 0, 0.06, "m", "0.02",
     "its top above the rail's", NULL, NULL},
    {"width", YAML_NUM, offsetof(struct turnout_text, check.width) - offsetof(struct turnout_text, check), 0.005, 0.1, "m", "0.025",
     "of its level top", NULL, NULL},
    {"edge_radius", YAML_NUM, offsetof(struct turnout_text, check.edge_radius) - offsetof(struct turnout_text, check), 1e-3, 0.02, "m",
     "0.008", "between top and working face", NULL, NULL},
    {"inclination", YAML_NUM, offsetof(struct turnout_text, check.inclination) - offsetof(struct turnout_text, check), 0.02, 0.5, "1",
     "0.05", "of the working face to the vertical, the flangeway wider above", NULL, NULL},
    {"step", YAML_NUM, offsetof(struct turnout_text, check.step) - offsetof(struct turnout_text, check), 1e-3, YAML_NO_LIMIT, "m", "0.35",
     "between its sections at most; one stands at each pair of flangeway", NULL, NULL},
    {"flangeway", YAML_PAIRS, offsetof(struct turnout_text, check.flangeway) - offsetof(struct turnout_text, check), ANY, "m", NULL,
     "[distance behind the mathematical point, from the rail's running edge to the working face]: from its front to its end", NULL, NULL},
    {0}}};

static const struct yaml_schema turnout_schema = {"turnout", sizeof(struct turnout_text), (const struct yaml_field[]){
    {"radius", YAML_NUM, offsetof(struct turnout_text, radius), YAML_POSITIVE, YAML_NO_LIMIT, "m", NULL,
     "of the diverging track's centre line, from station 0 to the crossing angle", NULL, NULL},
    {"ratio", YAML_NUM, offsetof(struct turnout_text, ratio), 1, YAML_NO_LIMIT, "1", NULL, "n of the angle 1:n where the curve ends",
     NULL, NULL},
    {"length", YAML_NUM, offsetof(struct turnout_text, length), YAML_POSITIVE, YAML_NO_LIMIT, "m", NULL, "front to end", NULL, NULL},
    {"hand", YAML_CHOICE, offsetof(struct turnout_text, hand), ANY, "", "right", "side to which the track diverges", NULL, hands},
    {"route", YAML_CHOICE, offsetof(struct turnout_text, route), ANY, "", "diverging", "in whose frame the sections stand", NULL,
     routes},
    {"reach", YAML_NUM, offsetof(struct turnout_text, reach), YAML_POSITIVE, YAML_NO_LIMIT, "m", "0.15",
     "a rail whose edge lies further from the running edge is left out", NULL, NULL},
    {"stations", YAML_LIST, offsetof(struct turnout_text, stations), ANY, "", NULL, "where sections stand", &stations_schema, NULL},
    {"switch_rail", YAML_MAP, offsetof(struct turnout_text, blade), ANY, "", NULL, "machining of the blade", &blade_schema, NULL},
    {"wing_rail", YAML_MAP, offsetof(struct turnout_text, wing), ANY, "", NULL, "behind the throat", &wing_schema, NULL},
    {"nose", YAML_MAP, offsetof(struct turnout_text, nose), ANY, "", NULL, "of the crossing", &nose_schema, NULL},
    {"check_rail", YAML_MAP, offsetof(struct turnout_text, check), ANY, "", YAML_ABSENT, "beside the rail opposite the crossing",
     &check_schema, NULL},
    {0}}};

const struct yaml_schema prof_text_schema = {"profile", sizeof(struct prof_text), (const struct yaml_field[]){
    {"name", YAML_TEXT, offsetof(struct prof_text, name), ANY, "", NULL, "kept in the .prof", NULL, NULL},
    {"source", YAML_TEXT, offsetof(struct prof_text, source), ANY, "", YAML_ABSENT, "standard or measurement it comes from", NULL,
     NULL},
    {"part", YAML_CHOICE, offsetof(struct prof_text, part), ANY, "", NULL, "what it is", NULL,
     prof_part_names},
    {"unit", YAML_CHOICE, offsetof(struct prof_text, unit), ANY, "", "unstated", "of zones, points or a plain file", NULL,
     prof_unit_names},
    {"file", YAML_TEXT, offsetof(struct prof_text, file), ANY, "", YAML_ABSENT,
     "of points, its ending says the kind; for a turnout the .yaml of its rail", NULL, NULL},
    {"zones", YAML_LIST, offsetof(struct prof_text, zones), ANY, "", YAML_ABSENT, "published pieces of the shape", &zone_schema,
     NULL},
    {"points", YAML_PAIRS, offsetof(struct prof_text, points), ANY, "unit", YAML_ABSENT, "[y, z] along the shape", NULL, NULL},
    {"symmetric", YAML_BOOL, offsetof(struct prof_text, symmetric), ANY, "", "false", "zones are given for y >= 0 only", NULL, NULL},
    {"section", YAML_INT, offsetof(struct prof_text, section), 1, 10000, "1", YAML_ABSENT, "of a .mpt that holds several", NULL, NULL},
    {"file_side", YAML_CHOICE, offsetof(struct prof_text, file_side), ANY, "", "unstated", "which of the two sides of a .rai or .whe",
     NULL, file_sides},
    {"mirror_y", YAML_CHOICE, offsetof(struct prof_text, mirror_y), ANY, "", "unstated", "the shape has y towards the track's centre",
     NULL, mirrors},
    {"mirror_z", YAML_CHOICE, offsetof(struct prof_text, mirror_z), ANY, "", "unstated", "the shape has z upwards", NULL, mirrors},
    {"shift_y", YAML_NUM, offsetof(struct prof_text, shift_y), -0.5, 0.5, "m", "0", "added to y, which then has its origin on the"
     " running circle or the rail's centre line", NULL, NULL},
    {"radius", YAML_NUM, offsetof(struct prof_text, radius), YAML_POSITIVE, 2, "m", "0.46", "wheel: at the running circle", NULL,
     NULL},
    {"back_to_back", YAML_NUM, offsetof(struct prof_text, back_to_back), YAML_POSITIVE, 3, "m", "1.360",
     "wheel: between the flange backs", NULL, NULL},
    {"flange_back", YAML_NUM, offsetof(struct prof_text, flange_back), YAML_POSITIVE, 0.2, "m", "0.070",
     "wheel: from the flange back to the running circle", NULL, NULL},
    {"cant", YAML_NUM, offsetof(struct prof_text, cant), -0.1, 0.1, "1", "0",
     "rail: inclination towards the track's centre, 0.025 is 1:40", NULL, NULL},
    {"gauge", YAML_NUM, offsetof(struct prof_text, gauge), YAML_POSITIVE, 3, "m", "1.435", "rail: between the gauge faces", NULL,
     NULL},
    {"gauge_depth", YAML_NUM, offsetof(struct prof_text, gauge_depth), YAML_POSITIVE, 0.04, "m", "0.014",
     "rail: the gauge is measured down to here below the top", NULL, NULL},
    {"smoothing", YAML_NUM, offsetof(struct prof_text, smoothing), 0, 0.05, "m", "0.003",
     "wavelength halved by the smoothing spline; 0 passes through every point", NULL, NULL},
    {"spacing", YAML_NUM, offsetof(struct prof_text, spacing), 1e-5, 0.002, "m", "0.0001", "of the points along the curve", NULL,
     NULL},
    {"turnout", YAML_MAP, offsetof(struct prof_text, turnout), ANY, "", YAML_ABSENT, "plan and machining of a turnout",
     &turnout_schema, NULL},
    {"sections", YAML_MAP, offsetof(struct prof_text, sections), ANY, "", YAML_ABSENT, "measured sections along the track",
     &sections_text_schema, NULL},
    {0}}};
