#include "formats/case_text.h"

#include "formats/reason.h"

#define AT(member) offsetof(struct case_text, member)

static const char *const routes[] = {"through", "diverging", NULL};
static const char *const directions[] = {"facing", "trailing", NULL};
static const char *const schemes[] = {"explicit", "implicit", "auto", NULL};
static const char *const shapes[] = {"fresh", "worn", NULL};
static const char *const spectra[] = {"none", "erri-low", "erri-high", NULL};
static const char *const rails[] = {"left", "right", "both", NULL};
static const char *const kinds[] = {"impulse", "sweep", "noise", NULL};
static const char *const places[] = {"left", "right", "sleeper", NULL};
static const char *const filters[] = {"none", "lowpass", NULL};
static const char *const train_schemes[] = {"explicit", "implicit", NULL};
static const char *const laws[] = {"hertz", "linear", NULL};
static const char *const sides[] = {"both", "left", "right", NULL};

#define IN_CONTACT(member) (AT(contact.member) - AT(contact))
static const struct yaml_schema contact_schema = {
    "contact", sizeof((struct case_text *)0)->contact, (const struct yaml_field[]){
        {"law", YAML_CHOICE, IN_CONTACT(law), 0, 0, "", "hertz",
         "normal force: Hertz, or a linear spring and damper", NULL, laws},
        {"stiffness", YAML_NUM, IN_CONTACT(stiffness), YAML_POSITIVE, YAML_NO_LIMIT, "N/m", "141e6",
         "linear law: wheel to massless point", NULL, NULL},
        {"damping", YAML_NUM, IN_CONTACT(damping), 0, YAML_NO_LIMIT, "N.s/m", "30e3",
         "linear law: beside that spring", NULL, NULL},
        {"series", YAML_NUM, IN_CONTACT(series), YAML_POSITIVE, YAML_NO_LIMIT, "N/m", "5000e6",
         "linear law: massless point to rail, condensed with the two before", NULL, NULL},
        {"hertz_damping", YAML_NUM, IN_CONTACT(hertz_damping), 0, 10, "s/m", "0",
         "Hertz law: N = C d^1.5 (1 + this times the rate of d)", NULL, NULL},
        {"grid", YAML_INT, IN_CONTACT(grid), 2, 200, "1", "10", "strips of FASTSIM, and steps of a strip", NULL, NULL},
        {0},
    }};

#define IN_CHANNELS(g) ((g) * sizeof(int))
#define CHANNELS(key, g, text) {key, YAML_BOOL, IN_CHANNELS(g), 0, 0, "", "true", text, NULL, NULL}
static const struct yaml_schema channels_schema = {
    "channels", sizeof((struct case_text *)0)->channels, (const struct yaml_field[]){
        CHANNELS("wheels", RUN_WHEELS, "wheel forces, contacts, creepages"),
        CHANNELS("bodies", RUN_BODIES, "displacement, velocity, acceleration of every body"),
        CHANNELS("pads", RUN_PADS, "force in every railpad"),
        CHANNELS("ballast", RUN_BALLAST, "force in every ballast element"),
        CHANNELS("sleepers", RUN_SLEEPERS, "deflection, roll, acceleration of every sleeper"),
        CHANNELS("rails", RUN_RAILS, "deflection, acceleration, bending moment at every rail node"),
        {0},
    }};

static const struct yaml_schema dip_schema = {
    "dip", sizeof(struct case_dip), (const struct yaml_field[]){
        {"from", YAML_NUM, offsetof(struct case_dip, from), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", NULL,
         "station where it begins", NULL, NULL},
        {"length", YAML_NUM, offsetof(struct case_dip, length), YAML_POSITIVE, YAML_NO_LIMIT, "m", NULL,
         "its length", NULL, NULL},
        {"depth", YAML_NUM, offsetof(struct case_dip, depth), -0.05, 0.05, "m", NULL,
         "depth/2 (1 - cos), down", NULL, NULL},
        {"rail", YAML_CHOICE, offsetof(struct case_dip, rail), 0, 0, "", "both", "which rail", NULL, sides},
        {0},
    }};

static const struct yaml_schema joint_schema = {
    "joint", sizeof(struct case_joint), (const struct yaml_field[]){
        {"at", YAML_NUM, offsetof(struct case_joint, at), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", NULL, "station of the gap", NULL, NULL},
        {"length", YAML_NUM, offsetof(struct case_joint, length), YAML_POSITIVE, YAML_NO_LIMIT, "m", NULL,
         "over which both rail ends are bent down", NULL, NULL},
        {"depth", YAML_NUM, offsetof(struct case_joint, depth), 0, 0.05, "m", NULL,
         "depth (1 - |s - at|/(length/2))^2, down", NULL, NULL},
        {"rail", YAML_CHOICE, offsetof(struct case_joint, rail), 0, 0, "", "both", "which rail", NULL, sides},
        {0},
    }};

static const struct yaml_schema flat_schema = {
    "wheel_flat", sizeof(struct case_flat), (const struct yaml_field[]){
        {"wheelset", YAML_INT, offsetof(struct case_flat, wheelset), 1, 1000, "1", NULL, "number of the wheelset, from the front", NULL, NULL},
        {"side", YAML_CHOICE, offsetof(struct case_flat, side), 0, 0, "", "both", "which wheel", NULL, sides},
        {"length", YAML_NUM, offsetof(struct case_flat, length), YAML_POSITIVE, 0.2, "m", NULL, "of the chord worn off, at most", NULL, NULL},
        {"shape", YAML_CHOICE, offsetof(struct case_flat, shape), 0, 0, "", "worn", "a chord with its edges, or rounded by rolling", NULL, shapes},
        {"at", YAML_NUM, offsetof(struct case_flat, at), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", "0", "a station where it meets the rail", NULL, NULL},
        {0},
    }};

#define IN_IRREGULARITY(member) (AT(irregularity.member) - AT(irregularity))
static const struct yaml_schema irregularity_schema = {
    "irregularity", sizeof((struct case_text *)0)->irregularity, (const struct yaml_field[]){
        {"file", YAML_TEXT, IN_IRREGULARITY(file), 0, 0, "", YAML_ABSENT, "measured track geometry, relative to the case", NULL, NULL},
        {"spectrum", YAML_CHOICE, IN_IRREGULARITY(spectrum), 0, 0, "", "none", "random, of the spectra of ERRI B 176", NULL, spectra},
        {"seed", YAML_INT, IN_IRREGULARITY(seed), 0, 1e9, "1", "1", "of the random phases", NULL, NULL},
        {"shortest", YAML_NUM, IN_IRREGULARITY(shortest), 0.1, 100, "m", "3", "wavelength of the spectrum", NULL, NULL},
        {"longest", YAML_NUM, IN_IRREGULARITY(longest), 0.1, 1e3, "m", "70", "and", NULL, NULL},
        {"scale", YAML_NUM, IN_IRREGULARITY(scale), -100, 100, "1", "1", "factor on the irregularity", NULL, NULL},
        {"fade", YAML_NUM, IN_IRREGULARITY(fade), 1e-3, 1e3, "m", "10", "over which it comes up from the start", NULL, NULL},
        {0},
    }};

#define IN_FALLING(member) (AT(falling.member) - AT(falling))
static const struct yaml_schema falling_schema = {
    "falling", sizeof((struct case_text *)0)->falling, (const struct yaml_field[]){
        {"limit", YAML_NUM, IN_FALLING(limit), 0.01, 1, "1", "1", "share of friction left at large slip; 1 is constant friction", NULL, NULL},
        {"decay", YAML_NUM, IN_FALLING(decay), 0, 1e3, "s/m", "0.6", "over the velocity of slip", NULL, NULL},
        {0},
    }};

static const struct yaml_schema friction_schema = {
    "friction_on", sizeof(struct case_friction), (const struct yaml_field[]){
        {"friction", YAML_NUM, offsetof(struct case_friction, friction), 0.01, 1, "1", NULL,
         "coefficient of friction of these contacts", NULL, NULL},
        {"side", YAML_CHOICE, offsetof(struct case_friction, side), 0, 0, "", "both", "which rail", NULL, sides},
        {"body", YAML_INT, offsetof(struct case_friction, body), -1, 1e6, "1", "-1",
         "number of the rail body in the contact table, from 0; -1 is any", NULL, NULL},
        {"from", YAML_NUM, offsetof(struct case_friction, from), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", "-1e9",
         "station of the wheel", NULL, NULL},
        {"to", YAML_NUM, offsetof(struct case_friction, to), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", "1e9", "and up to", NULL, NULL},
        {"angle", YAML_NUM, offsetof(struct case_friction, angle), 0, 1.6, "rad", "0",
         "contact angle from which on, either way", NULL, NULL},
        {0},
    }};

#define IN_FORCE(member) (AT(force.member) - AT(force))
static const struct yaml_schema force_schema = {
    "force", sizeof(struct case_force), (const struct yaml_field[]){
        {"rail", YAML_CHOICE, IN_FORCE(rail), 0, 0, "", "left", "which rail it acts on; both: the whole force on each", NULL, rails},
        {"at", YAML_NUM, IN_FORCE(at), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", NULL, "station where it acts", NULL, NULL},
        {"kind", YAML_CHOICE, IN_FORCE(kind), 0, 0, "", "impulse", "blows of a hammer, a sine of rising frequency, or noise", NULL, kinds},
        {"amplitude", YAML_NUM, IN_FORCE(amplitude), YAML_POSITIVE, 1e9, "N", NULL, "largest force, of noise its root mean square", NULL, NULL},
        {"width", YAML_NUM, IN_FORCE(width), YAML_POSITIVE, 1, "s", "0.5e-3", "of an impulse, amplitude/2 (1 - cos)", NULL, NULL},
        {"blows", YAML_INT, IN_FORCE(blows), 1, 1e6, "1", "1", "impulses, evenly over the duration", NULL, NULL},
        {"from", YAML_NUM, IN_FORCE(from), 0, 1e6, "Hz", "20", "sweep and noise: lowest frequency", NULL, NULL},
        {"to", YAML_NUM, IN_FORCE(to), 0, 1e6, "Hz", "2000", "and highest", NULL, NULL},
        {"duration", YAML_NUM, IN_FORCE(duration), YAML_POSITIVE, 1e6, "s", NULL, "of the whole run", NULL, NULL},
        {"rest", YAML_NUM, IN_FORCE(rest), 0, 1e6, "s", "0", "sweep and noise: without force at its end", NULL, NULL},
        {"seed", YAML_INT, IN_FORCE(seed), 0, 9e15, "1", "1", "noise: another seed, another noise", NULL, NULL},
        {0},
    }};

static const struct yaml_schema probe_schema = {
    "probe", sizeof(struct case_probe), (const struct yaml_field[]){
        {"on", YAML_CHOICE, offsetof(struct case_probe, on), 0, 0, "", "left", "rail or sleeper whose deflection is recorded", NULL, places},
        {"at", YAML_NUM, offsetof(struct case_probe, at), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", NULL,
         "station there; of a sleeper, the nearest one", NULL, NULL},
        {0},
    }};

#define FILE_FIELD(key, text) {#key, YAML_TEXT, AT(key), 0, 0, "", YAML_ABSENT, text, NULL, NULL}
const struct yaml_schema case_text_schema = {
    "case", sizeof(struct case_text), (const struct yaml_field[]){
        {"name", YAML_TEXT, AT(name), 0, 0, "", NULL, "of the case, for titles", NULL, NULL},
        FILE_FIELD(track, ".trk file, relative to the case"),
        FILE_FIELD(vehicle, ".veh file"),
        FILE_FIELD(contact_left, ".ctab file of the left side"),
        FILE_FIELD(contact_right, ".ctab file of the right side"),
        FILE_FIELD(creep, ".creep file of creep forces; absent: FASTSIM"),
        {"speed_kmh", YAML_NUM, AT(speed), 1, 500, "km/h", YAML_ABSENT, "speed, the one key that is not SI; a vehicle needs it", NULL, NULL},
        {"route", YAML_CHOICE, AT(route), 0, 0, "", "through", "which route track and sections describe", NULL, routes},
        {"direction", YAML_CHOICE, AT(direction), 0, 0, "", "facing",
         "facing: with increasing station, start below end; trailing: back, start above end", NULL, directions},
        {"friction", YAML_NUM, AT(friction), 0.01, 1, "1", "0.30", "coefficient of friction", NULL, NULL},
        {"falling", YAML_MAP, AT(falling), 0, 0, "", "{}", "friction that falls with slip", &falling_schema, NULL},
        {"friction_on", YAML_LIST, AT(friction_on), 0, 0, "", "[]", "contacts with a friction of their own", &friction_schema, NULL},
        {"start", YAML_NUM, AT(start), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", "-60",
         "station of the front wheelset at the start", NULL, NULL},
        {"end", YAML_NUM, AT(end), -YAML_NO_LIMIT, YAML_NO_LIMIT, "m", "60", "and at the end", NULL, NULL},
        {"step", YAML_NUM, AT(step), 1e-7, 1e-3, "s", "1e-4", "time step", NULL, NULL},
        {"scheme", YAML_CHOICE, AT(scheme), 0, 0, "", "auto", "of the track: explicit where that holds, or implicit", NULL, schemes},
        {"train_scheme", YAML_CHOICE, AT(train_scheme), 0, 0, "", "explicit", "of the train; implicit wants an implicit track", NULL, train_schemes},
        {"contact", YAML_MAP, AT(contact), 0, 0, "", "{}", "wheel on rail", &contact_schema, NULL},
        {"sampling", YAML_NUM, AT(sampling), 1, 1e7, "Hz", "1000",
         "records a second; 1/step or more is every step", NULL, NULL},
        {"filter", YAML_CHOICE, AT(filter), 0, 0, "", "none", "of the samples against aliases; extremes never have one", NULL, filters},
        {"channels", YAML_MAP, AT(channels), 0, 0, "", "{}", "groups of channels to record", &channels_schema, NULL},
        {"dip", YAML_LIST, AT(dip), 0, 0, "", "[]", "dips of the rails", &dip_schema, NULL},
        {"joint", YAML_LIST, AT(joint), 0, 0, "", "[]", "dipped rail joints", &joint_schema, NULL},
        {"wheel_flat", YAML_LIST, AT(flat), 0, 0, "", "[]", "flats of wheels", &flat_schema, NULL},
        {"irregularity", YAML_MAP, AT(irregularity), 0, 0, "", "{}", "of the track's geometry", &irregularity_schema, NULL},
        {"force", YAML_MAP, AT(force), 0, 0, "", YAML_ABSENT, "prescribed force on the rails, instead of a vehicle", &force_schema, NULL},
        {"probe", YAML_LIST, AT(probe), 0, 0, "", "[]", "what a prescribed force moves; none: the place of the force", &probe_schema, NULL},
        {0},
    }};

const char *case_text_check(const struct case_text *c)
{
    const struct case_friction *f = c->friction_on.item;

    for (int64_t i = 0; i < c->friction_on.n; i++)
        if (f[i].from > f[i].to)
            return reason("friction_on.%lld.from: %g m lies beyond to, %g m", (long long)i + 1, f[i].from, f[i].to);
    return NULL;
}
