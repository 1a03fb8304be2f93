/* The keys of the track input, each with type, unit, range, default and meaning. */
#include "formats/trk_text.h"

#include <stddef.h>

#define AT(type, member) offsetof(struct type, member)

static const char *const MODELS[] = {"fixed", "moving_mass", NULL};
static const char *const DOFS[] = {"vertical", "spatial", NULL};
static const char *const ROLLS[] = {"free", "held", NULL};
static const char *const MASS_MODELS[] = {"lumped", "consistent", NULL};
static const char *const BEAMS[] = {"euler", "timoshenko", NULL};
static const char *const SIDES[] = {"left", "right", NULL};
static const char *const RAILS[] = {"left", "right", "both", NULL};

static const struct yaml_field LATERAL_FIELDS[] = {
    {"mass", YAML_NUM, AT(trk_text_lateral, mass), YAML_POSITIVE, 1e6, "kg", NULL, "of the rail that moves with a wheel", NULL, NULL},
    {"stiffness", YAML_NUM, AT(trk_text_lateral, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL, "between it and the ground", NULL, NULL},
    {"damping", YAML_NUM, AT(trk_text_lateral, damping), 0, 1e9, "N.s/m", "0", "likewise", NULL, NULL},
    {0}};

static const struct yaml_schema LATERAL = {"lateral", sizeof(struct trk_text_lateral), LATERAL_FIELDS};

static const struct yaml_field GROUND_FIELDS[] = {
    {"stiffness", YAML_NUM, AT(trk_text_ground, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL, "between the sleeper and the ground", NULL, NULL},
    {"damping", YAML_NUM, AT(trk_text_ground, damping), 0, 1e9, "N.s/m", "0", "likewise", NULL, NULL},
    {0}};

static const struct yaml_schema GROUND = {"lateral", sizeof(struct trk_text_ground), GROUND_FIELDS};

static const struct yaml_field OWN_FIELDS[] = {
    {"bending_stiffness", YAML_TABLE, AT(trk_text_own, bending_stiffness), YAML_POSITIVE, 1e12, "N.m2", YAML_ABSENT,
     "of this rail, instead of that of both", NULL, NULL},
    {"mass", YAML_TABLE, AT(trk_text_own, mass), YAML_POSITIVE, 1e5, "kg/m", YAML_ABSENT, "likewise", NULL, NULL},
    {"pitch_inertia", YAML_TABLE, AT(trk_text_own, pitch_inertia), YAML_POSITIVE, 1e5, "kg.m2", YAML_ABSENT, "likewise", NULL, NULL},
    {"shear_stiffness", YAML_TABLE, AT(trk_text_own, shear_stiffness), YAML_POSITIVE, 1e15, "N", YAML_ABSENT, "likewise", NULL, NULL},
    {"rotary_inertia", YAML_TABLE, AT(trk_text_own, rotary_inertia), YAML_POSITIVE, 1e5, "kg.m", YAML_ABSENT, "likewise", NULL, NULL},
    {"lateral_bending_stiffness", YAML_TABLE, AT(trk_text_own, lateral_bending_stiffness), YAML_POSITIVE, 1e12, "N.m2", YAML_ABSENT,
     "of this rail, instead of that of both", NULL, NULL},
    {0}};

static const struct yaml_schema OWN = {"rail", sizeof(struct trk_text_own), OWN_FIELDS};

static const struct yaml_field RAIL_FIELDS[] = {
    {"bending_stiffness", YAML_TABLE, AT(trk_text_rail, bending_stiffness), YAML_POSITIVE, 1e12, "N.m2", NULL,
     "vertical bending stiffness EI of each rail; it may vary within a bay", NULL, NULL},
    {"mass", YAML_TABLE, AT(trk_text_rail, mass), YAML_POSITIVE, 1e5, "kg/m", NULL, "of each rail", NULL, NULL},
    {"pitch_inertia", YAML_TABLE, AT(trk_text_rail, pitch_inertia), YAML_POSITIVE, 1e5, "kg.m2", YAML_ABSENT,
     "of each rail node, lumped only, where it must be given: it sets the pinned-pinned frequency", NULL, NULL},
    {"shear_stiffness", YAML_TABLE, AT(trk_text_rail, shear_stiffness), YAML_POSITIVE, 1e15, "N", YAML_ABSENT,
     "kappa G A of each rail, timoshenko only, where it must be given", NULL, NULL},
    {"rotary_inertia", YAML_TABLE, AT(trk_text_rail, rotary_inertia), YAML_POSITIVE, 1e5, "kg.m", YAML_ABSENT,
     "rho I of each rail, pitch inertia of a metre of it, timoshenko with consistent mass only, where it must be given", NULL, NULL},
    {"mass_model", YAML_CHOICE, AT(trk_text_rail, mass_model), 0, 0, "", "lumped", "mass at the nodes, or along the elements", NULL, MASS_MODELS},
    {"beam", YAML_CHOICE, AT(trk_text_rail, beam), 0, 0, "", "euler", "beam theory", NULL, BEAMS},
    {"elements_per_bay", YAML_INT, AT(trk_text_rail, elements_per_bay), 1, 20, "1", "1", "beam elements between sleepers", NULL,
     NULL},
    {"lateral_bending_stiffness", YAML_TABLE, AT(trk_text_rail, lateral_bending_stiffness), YAML_POSITIVE, 1e12, "N.m2", YAML_ABSENT,
     "EI of each rail against bending sideways, spatial only, where it must be given", NULL, NULL},
    {"yaw_inertia", YAML_NUM, AT(trk_text_rail, yaw_inertia), YAML_POSITIVE, 1e5, "kg.m2", YAML_ABSENT,
     "of each rail node, spatial and lumped only, where it must be given: it sets the lateral pinned-pinned frequency", NULL, NULL},
    {"lateral_shear_stiffness", YAML_NUM, AT(trk_text_rail, lateral_shear_stiffness), YAML_POSITIVE, 1e15, "N", YAML_ABSENT,
     "kappa G A sideways, spatial and timoshenko only, where it must be given", NULL, NULL},
    {"lateral_rotary_inertia", YAML_NUM, AT(trk_text_rail, lateral_rotary_inertia), YAML_POSITIVE, 1e5, "kg.m", YAML_ABSENT,
     "rho I about the vertical axis, spatial and timoshenko with consistent mass only, where it must be given", NULL, NULL},
    {"torsional_stiffness", YAML_NUM, AT(trk_text_rail, torsional_stiffness), YAML_POSITIVE, 1e12, "N.m2", YAML_ABSENT,
     "GJ of each rail, spatial only, where it must be given", NULL, NULL},
    {"polar_inertia", YAML_NUM, AT(trk_text_rail, polar_inertia), YAML_POSITIVE, 1e5, "kg.m", YAML_ABSENT,
     "rho Ip, twist inertia of a metre of each rail, spatial only, where it must be given", NULL, NULL},
    {"head_height", YAML_NUM, AT(trk_text_rail, head_height), YAML_POSITIVE, 1, "m", YAML_ABSENT,
     "running surface above the rail's centroid, spatial only, where it must be given", NULL, NULL},
    {"foot_depth", YAML_NUM, AT(trk_text_rail, foot_depth), YAML_POSITIVE, 1, "m", YAML_ABSENT,
     "railpad below the rail's centroid, spatial only, where it must be given", NULL, NULL},
    {"left", YAML_MAP, AT(trk_text_rail, left), 0, 0, "", YAML_ABSENT, "what is different in the left rail", &OWN, NULL},
    {"right", YAML_MAP, AT(trk_text_rail, right), 0, 0, "", YAML_ABSENT, "what is different in the right rail", &OWN, NULL},
    {"lateral", YAML_MAP, AT(trk_text_rail, lateral), 0, 0, "", YAML_ABSENT,
     "each rail yields sideways under each wheel by itself, a moving mass as one; absent: not at all", &LATERAL, NULL},
    {"running_mass", YAML_NUM, AT(trk_text_rail, running_mass), 0, 1e5, "kg", "0",
     "of each rail of a moving mass under a wheel; 0: none, its railpad is in series with the contact", NULL, NULL},
    {0}};

static const struct yaml_field SLEEPER_FIELDS[] = {
    {"spacing", YAML_NUM, AT(trk_text_sleeper, spacing), 0.1, 10, "m", NULL, "centre to centre", NULL, NULL},
    {"mass", YAML_TABLE, AT(trk_text_sleeper, mass), YAML_POSITIVE, 1e6, "kg", NULL, "of each sleeper", NULL, NULL},
    {"roll_inertia", YAML_TABLE, AT(trk_text_sleeper, roll_inertia), YAML_POSITIVE, 1e7, "kg.m2", NULL,
     "about the track's direction, through the sleeper's centre", NULL, NULL},
    {"roll", YAML_CHOICE, AT(trk_text_sleeper, roll), 0, 0, "", "free", "whether it rolls; that of a moving mass may be held", NULL, ROLLS},
    {"lateral", YAML_MAP, AT(trk_text_sleeper, lateral), 0, 0, "", YAML_ABSENT,
     "of a moving mass, then each rail yields sideways against it by itself; absent: rails and sleeper as one", &GROUND, NULL},
    {"length", YAML_TABLE, AT(trk_text_sleeper, length), 0.1, 20, "m", NULL, "across the track", NULL, NULL},
    {"centre", YAML_TABLE, AT(trk_text_sleeper, centre), -10, 10, "m", "0", "lateral position of its centre, right of the track's",
     NULL, NULL},
    {"pitch_inertia", YAML_NUM, AT(trk_text_sleeper, pitch_inertia), 0, 1e7, "kg.m2", "0",
     "about its own length; no part of any track", NULL, NULL},
    {"yaw_inertia", YAML_TABLE, AT(trk_text_sleeper, yaw_inertia), YAML_POSITIVE, 1e7, "kg.m2", YAML_ABSENT,
     "about the vertical axis, spatial only, where it must be given", NULL, NULL},
    {"seat_height", YAML_NUM, AT(trk_text_sleeper, seat_height), 0, 2, "m", "0", "railpads above the sleeper's centre, spatial only",
     NULL, NULL},
    {0}};

static const struct yaml_field MISSING_FIELDS[] = {
    {"sleepers", YAML_PAIRS, AT(trk_text_missing, sleepers), -1e6, 1e6, "1", NULL, "numbers of the first and the last, each range a pair",
     NULL, NULL},
    {"rail", YAML_CHOICE, AT(trk_text_missing, rail), 0, 0, "", "both", "whose railpads", NULL, RAILS},
    {0}};

static const struct yaml_schema MISSING = {"missing", sizeof(struct trk_text_missing), MISSING_FIELDS};

static const struct yaml_field PAD_FIELDS[] = {
    {"stiffness", YAML_TABLE, AT(trk_text_pad, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL, "of each railpad", NULL, NULL},
    {"damping", YAML_TABLE, AT(trk_text_pad, damping), 0, 1e9, "N.s/m", NULL, "of each railpad", NULL, NULL},
    {"missing", YAML_LIST, AT(trk_text_pad, missing), 0, 0, "", YAML_ABSENT, "railpads that are not there", &MISSING, NULL},
    {"lateral_stiffness", YAML_TABLE, AT(trk_text_pad, lateral_stiffness), YAML_POSITIVE, 1e12, "N/m", YAML_ABSENT,
     "of each railpad and its fastening, spatial only, where it must be given", NULL, NULL},
    {"lateral_damping", YAML_TABLE, AT(trk_text_pad, lateral_damping), 0, 1e9, "N.s/m", YAML_ABSENT, "likewise", NULL, NULL},
    {"width", YAML_NUM, AT(trk_text_pad, width), YAML_POSITIVE, 1, "m", YAML_ABSENT,
     "across the rail, against its tilt, spatial only, where it must be given", NULL, NULL},
    {"length", YAML_NUM, AT(trk_text_pad, length), 0, 1, "m", "0", "along the rail, against its pitch and yaw, spatial only", NULL, NULL},
    {0}};

static const struct yaml_field SPRING_FIELDS[] = {
    {"stiffness", YAML_TABLE, AT(trk_text_spring, stiffness), 0, 1e12, "N/m", YAML_ABSENT, "of this spring, instead of its part of the whole",
     NULL, NULL},
    {"damping", YAML_TABLE, AT(trk_text_spring, damping), 0, 1e9, "N.s/m", YAML_ABSENT, "likewise", NULL, NULL},
    {"gap", YAML_TABLE, AT(trk_text_spring, gap), 0, 0.05, "m", YAML_ABSENT, "above this spring, instead of ballast.gap", NULL, NULL},
    {0}};

static const struct yaml_schema SPRING = {"spring", sizeof(struct trk_text_spring), SPRING_FIELDS};

static const struct yaml_field BALLAST_FIELDS[] = {
    {"stiffness", YAML_TABLE, AT(trk_text_ballast, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL,
     "of a whole sleeper; left, middle and right each take a third, of a moving mass left and right a half", NULL, NULL},
    {"damping", YAML_TABLE, AT(trk_text_ballast, damping), 0, 1e9, "N.s/m", NULL, "of a whole sleeper, likewise", NULL, NULL},
    {"edge", YAML_NUM, AT(trk_text_ballast, edge), 0, 10, "m", "0.35", "outer springs, from the ends of the sleeper", NULL, NULL},
    {"gap", YAML_TABLE, AT(trk_text_ballast, gap), 0, 0.05, "m", "0", "void under the unloaded sleeper; where there is one, ballast pushes only", NULL,
     NULL},
    {"tension", YAML_BOOL, AT(trk_text_ballast, tension), 0, 0, "", "true", "whether ballast without a void holds both ways", NULL, NULL},
    {"left", YAML_MAP, AT(trk_text_ballast, left), 0, 0, "", YAML_ABSENT, "what is different in the left spring", &SPRING, NULL},
    {"middle", YAML_MAP, AT(trk_text_ballast, middle), 0, 0, "", YAML_ABSENT, "what is different in the middle spring", &SPRING, NULL},
    {"right", YAML_MAP, AT(trk_text_ballast, right), 0, 0, "", YAML_ABSENT, "what is different in the right spring", &SPRING, NULL},
    {"lateral_stiffness", YAML_TABLE, AT(trk_text_ballast, lateral_stiffness), YAML_POSITIVE, 1e12, "N/m", YAML_ABSENT,
     "of a whole sleeper, at its centre, spatial only, where it must be given", NULL, NULL},
    {"lateral_damping", YAML_TABLE, AT(trk_text_ballast, lateral_damping), 0, 1e9, "N.s/m", YAML_ABSENT, "likewise", NULL, NULL},
    {"longitudinal_stiffness", YAML_TABLE, AT(trk_text_ballast, longitudinal_stiffness), YAML_POSITIVE, 1e12, "N/m", YAML_ABSENT,
     "of a whole sleeper, even along it, against its yaw, spatial only, where it must be given", NULL, NULL},
    {"longitudinal_damping", YAML_TABLE, AT(trk_text_ballast, longitudinal_damping), 0, 1e9, "N.s/m", YAML_ABSENT, "likewise", NULL, NULL},
    {0}};

static const struct yaml_field BEAM_FIELDS[] = {
    {"from", YAML_NUM, AT(trk_text_beam, from), -1e6, 1e6, "m", NULL, "station from which it stands on every sleeper", NULL, NULL},
    {"to", YAML_NUM, AT(trk_text_beam, to), -1e6, 1e6, "m", NULL, "station up to which it does", NULL, NULL},
    {"side", YAML_NUM, AT(trk_text_beam, side), -10, 10, "m", NULL, "lateral position of its centroid, right of the track's centre line",
     NULL, NULL},
    {"bending_stiffness", YAML_NUM, AT(trk_text_beam, bending_stiffness), YAML_POSITIVE, 1e12, "N.m2", NULL, "vertical EI", NULL, NULL},
    {"lateral_bending_stiffness", YAML_NUM, AT(trk_text_beam, lateral_bending_stiffness), YAML_POSITIVE, 1e12, "N.m2", NULL, "lateral EI",
     NULL, NULL},
    {"torsional_stiffness", YAML_NUM, AT(trk_text_beam, torsional_stiffness), YAML_POSITIVE, 1e12, "N.m2", NULL, "GJ", NULL, NULL},
    {"mass", YAML_NUM, AT(trk_text_beam, mass), YAML_POSITIVE, 1e5, "kg/m", NULL, "of the check rail", NULL, NULL},
    {"polar_inertia", YAML_NUM, AT(trk_text_beam, polar_inertia), YAML_POSITIVE, 1e5, "kg.m", NULL, "rho Ip", NULL, NULL},
    {"head_height", YAML_NUM, AT(trk_text_beam, head_height), YAML_POSITIVE, 1, "m", NULL, "where flanges rub, above its centroid", NULL, NULL},
    {"foot_depth", YAML_NUM, AT(trk_text_beam, foot_depth), YAML_POSITIVE, 1, "m", NULL, "its fastenings below its centroid", NULL, NULL},
    {"stiffness", YAML_NUM, AT(trk_text_beam, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL, "of a fastening, on each sleeper", NULL, NULL},
    {"damping", YAML_NUM, AT(trk_text_beam, damping), 0, 1e9, "N.s/m", NULL, "of a fastening", NULL, NULL},
    {"lateral_stiffness", YAML_NUM, AT(trk_text_beam, lateral_stiffness), YAML_POSITIVE, 1e12, "N/m", YAML_ABSENT,
     "of a fastening; absent: as its stiffness", NULL, NULL},
    {"lateral_damping", YAML_NUM, AT(trk_text_beam, lateral_damping), YAML_POSITIVE, 1e9, "N.s/m", YAML_ABSENT,
     "of a fastening; absent: as its damping", NULL, NULL},
    {0}};

static const struct yaml_schema BEAM = {"beam", sizeof(struct trk_text_beam), BEAM_FIELDS};

static const struct yaml_field CHECK_FIELDS[] = {
    {"rail", YAML_CHOICE, AT(trk_text_check, rail), 0, 0, "", NULL, "beside which rail it stands", NULL, SIDES},
    {"play", YAML_TABLE, AT(trk_text_check, play), -0.1, 1, "m", NULL,
     "free play of the flange's back, wheelset centred, over station; no check rail beyond the ends", NULL, NULL},
    {"stiffness", YAML_NUM, AT(trk_text_check, stiffness), YAML_POSITIVE, 1e12, "N/m", NULL, "lateral, against the ground, or the beam", NULL, NULL},
    {"damping", YAML_NUM, AT(trk_text_check, damping), 0, 1e9, "N.s/m", "0", "lateral, against the ground, or the beam", NULL, NULL},
    {"beam", YAML_MAP, AT(trk_text_check, beam), 0, 0, "", YAML_ABSENT, "the check rail on its sleepers, spatial only", &BEAM, NULL},
    {0}};

static const struct yaml_field CURVE_FIELDS[] = {
    {"from", YAML_NUM, AT(trk_text_curve, from), -1e6, 1e6, "m", NULL, "station from which it holds, to the next one", NULL, NULL},
    {"curvature", YAML_NUM, AT(trk_text_curve, curvature), -1, 1, "1/m", NULL, "positive to the right", NULL, NULL},
    {0}};

static const struct yaml_field ZONE_PAD_FIELDS[] = {
    {"stiffness", YAML_NUM, AT(trk_text_zone_pad, stiffness), YAML_POSITIVE, 1e12, "N/m", YAML_ABSENT, "instead of the reference",
     NULL, NULL},
    {"damping", YAML_NUM, AT(trk_text_zone_pad, damping), YAML_POSITIVE, 1e9, "N.s/m", YAML_ABSENT, "instead of the reference", NULL,
     NULL},
    {"lateral_stiffness", YAML_NUM, AT(trk_text_zone_pad, lateral_stiffness), YAML_POSITIVE, 1e12, "N/m", YAML_ABSENT,
     "instead of the reference", NULL, NULL},
    {"lateral_damping", YAML_NUM, AT(trk_text_zone_pad, lateral_damping), YAML_POSITIVE, 1e9, "N.s/m", YAML_ABSENT,
     "instead of the reference", NULL, NULL},
    {0}};

static const struct yaml_schema RAIL = {"rail", sizeof(struct trk_text_rail), RAIL_FIELDS};
static const struct yaml_schema SLEEPER = {"sleeper", sizeof(struct trk_text_sleeper), SLEEPER_FIELDS};
static const struct yaml_schema PAD = {"railpad", sizeof(struct trk_text_pad), PAD_FIELDS};
static const struct yaml_schema BALLAST = {"ballast", sizeof(struct trk_text_ballast), BALLAST_FIELDS};
static const struct yaml_schema CHECK = {"check_rail", sizeof(struct trk_text_check), CHECK_FIELDS};
static const struct yaml_schema CURVE = {"curve", sizeof(struct trk_text_curve), CURVE_FIELDS};
static const struct yaml_schema ZONE_PAD = {"railpad", sizeof(struct trk_text_zone_pad), ZONE_PAD_FIELDS};

static const struct yaml_field ZONE_FIELDS[] = {
    {"name", YAML_TEXT, AT(trk_text_zone, name), 0, 0, "", NULL, "of the zone, up to 31 letters", NULL, NULL},
    {"sleepers", YAML_PAIRS, AT(trk_text_zone, sleepers), -1e6, 1e6, "1", NULL, "numbers of the first and the last, each range a pair",
     NULL, NULL},
    {"rail", YAML_CHOICE, AT(trk_text_zone, rail), 0, 0, "", "both", "whose railpads", NULL, RAILS},
    {"railpad", YAML_MAP, AT(trk_text_zone, railpad), 0, 0, "", YAML_ABSENT, "of this zone", &ZONE_PAD, NULL},
    {0}};

static const struct yaml_schema ZONE = {"zone", sizeof(struct trk_text_zone), ZONE_FIELDS};

static const struct yaml_field TRACK_FIELDS[] = {
    {"name", YAML_TEXT, AT(trk_text, name), 0, 0, "", NULL, "of the track, up to 63 letters", NULL, NULL},
    {"model", YAML_CHOICE, AT(trk_text, model), 0, 0, "", "fixed", "fixed in space, or one sleeper and its rails that follow a wheelset", NULL,
     MODELS},
    {"dofs", YAML_CHOICE, AT(trk_text, dofs), 0, 0, "", "vertical", "whether rails and sleepers move sideways and twist too", NULL, DOFS},
    {"from", YAML_NUM, AT(trk_text, from), -1e6, 1e6, "m", NULL, "station where the bay of the first sleeper begins", NULL, NULL},
    {"length", YAML_NUM, AT(trk_text, length), YAML_POSITIVE, 1e5, "m", NULL, "a whole number of sleeper spacings; of a moving mass one", NULL, NULL},
    {"first_sleeper", YAML_NUM, AT(trk_text, first_sleeper), -1e6, 1e6, "m", "0", "station where the bay of sleeper number 1 begins",
     NULL, NULL},
    {"rail_spacing", YAML_NUM, AT(trk_text, rail_spacing), 0.1, 10, "m", "1.5", "between the contact lines", NULL, NULL},
    {"rail", YAML_MAP, AT(trk_text, rail), 0, 0, "", NULL, "both rails", &RAIL, NULL},
    {"sleeper", YAML_MAP, AT(trk_text, sleeper), 0, 0, "", NULL, "a rigid bar", &SLEEPER, NULL},
    {"railpad", YAML_MAP, AT(trk_text, railpad), 0, 0, "", NULL, "the reference, where no zone says otherwise", &PAD, NULL},
    {"ballast", YAML_MAP, AT(trk_text, ballast), 0, 0, "", NULL, "three springs and dampers under a sleeper", &BALLAST, NULL},
    {"check_rail", YAML_LIST, AT(trk_text, check_rail), 0, 0, "", YAML_ABSENT, "one at most: guides the flange's back at a crossing", &CHECK,
     NULL},
    {"curve", YAML_LIST, AT(trk_text, curve), 0, 0, "", YAML_ABSENT, "curvature along the track; straight before the first", &CURVE,
     NULL},
    {"cant", YAML_TABLE, AT(trk_text, cant), -0.3, 0.3, "m", "0",
     "height of the left rail over the right one, straight over station; positive in a curve to the right", NULL, NULL},
    {"zone", YAML_LIST, AT(trk_text, zone), 0, 0, "", YAML_ABSENT, "railpads of their own", &ZONE, NULL},
    {0}};

const struct yaml_schema trk_text_schema = {"track", sizeof(struct trk_text), TRACK_FIELDS};
