/* The schema of the profile input, and what one key cannot check alone. */
#include "formats/prof_text.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "formats/simpack.h"

#define ANY (-YAML_NO_LIMIT), YAML_NO_LIMIT

static const char *const parts[] = {"wheel", "rail", "turnout", NULL};
static const char *const units[] = {"unstated", "m", "mm", NULL};
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
    {"raise", YAML_PAIRS, offsetof(struct turnout_text, wing.raise) - offsetof(struct turnout_text, wing), 0, 1, "m", NULL,
     "[distance from the running edge, top above the plain rail's]", NULL, NULL},
    {0}}};

static const struct yaml_schema nose_schema = {"nose", sizeof ((struct turnout_text *)0)->nose, (const struct yaml_field[]){
    {"edge_radius", YAML_NUM, offsetof(struct turnout_text, nose.edge_radius) - offsetof(struct turnout_text, nose),
     YAML_POSITIVE, 0.013, "m", "0.008", "rounding of its edges", NULL, NULL},
    {"lowering", YAML_PAIRS, offsetof(struct turnout_text, nose.lowering) - offsetof(struct turnout_text, nose), 0, 1, "m", NULL,
     "[width of the nose, its top below the plain rail's]; it begins at the first width", NULL, NULL},
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
    {0}}};

const struct yaml_schema prof_text_schema = {"profile", sizeof(struct prof_text), (const struct yaml_field[]){
    {"name", YAML_TEXT, offsetof(struct prof_text, name), ANY, "", NULL, "kept in the .prof", NULL, NULL},
    {"source", YAML_TEXT, offsetof(struct prof_text, source), ANY, "", YAML_ABSENT, "standard or measurement it comes from", NULL,
     NULL},
    {"part", YAML_CHOICE, offsetof(struct prof_text, part), ANY, "", NULL, "what it is", NULL, parts},
    {"unit", YAML_CHOICE, offsetof(struct prof_text, unit), ANY, "", "unstated", "of zones, points or a plain file", NULL, units},
    {"file", YAML_TEXT, offsetof(struct prof_text, file), ANY, "", YAML_ABSENT,
     "of points (.prr, .prw, else plain y z); for a turnout the .yaml of its rail", NULL, NULL},
    {"zones", YAML_LIST, offsetof(struct prof_text, zones), ANY, "", YAML_ABSENT, "published pieces of the shape", &zone_schema,
     NULL},
    {"points", YAML_PAIRS, offsetof(struct prof_text, points), ANY, "unit", YAML_ABSENT, "[y, z] along the shape", NULL, NULL},
    {"symmetric", YAML_BOOL, offsetof(struct prof_text, symmetric), ANY, "", "false", "zones are given for y >= 0 only", NULL, NULL},
    {"mirror_y", YAML_BOOL, offsetof(struct prof_text, mirror_y), ANY, "", "false", "the shape has y towards the track's centre",
     NULL, NULL},
    {"mirror_z", YAML_BOOL, offsetof(struct prof_text, mirror_z), ANY, "", "false", "the shape has z upwards", NULL, NULL},
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
    {0}}};

static int file_ends(const char *file, const char *ending)
{
    size_t n = strlen(file), m = strlen(ending);
    return n > m && strcmp(file + n - m, ending) == 0;
}

static int file_own_unit(const char *file)
{
    return file_ends(file, ".prr") || file_ends(file, ".prw");
}

static const char *table_check(const char *name, const struct yaml_nums *pairs)
{
    if (pairs->n < 4)
        return reason("%s: at least two pairs are wanted", name);
    for (int64_t i = 2; i < pairs->n; i += 2)
        if (pairs->x[i] <= pairs->x[i - 2])
            return reason("%s: first numbers must increase, %g does not", name, pairs->x[i]);
    return NULL;
}

static const char *turnout_check(const struct turnout_text *t)
{
    const struct turnout_stations *s = t->stations.item;
    const char *why;

    if (t->stations.n == 0)
        return "stations: none given";
    for (int64_t i = 0; i < t->stations.n; i++)
        if (s[i].to < s[i].from || (i && s[i].from < s[i - 1].to))
            return reason("stations: %g to %g does not follow on", s[i].from, s[i].to);
    if ((why = table_check("switch_rail.lowering", &t->blade.lowering)) ||
        (why = table_check("wing_rail.raise", &t->wing.raise)))
        return why;
    return table_check("nose.lowering", &t->nose.lowering);
}

static const char *zones_check(const struct prof_text *t)
{
    const struct prof_zone *z = t->zones.item;

    for (int64_t i = 0; i < t->zones.n; i++) {
        int arc = z[i].centre.n == 2 && z[i].radius != 0 && z[i].polynomial.n == 0;
        int polynomial = z[i].polynomial.n > 0 && z[i].centre.n == 0 && z[i].radius == 0;
        if (!arc && !polynomial)
            return reason("zone %lld: either polynomial, or centre [y, z] and radius", (long long)i + 1);
        if (z[i].to <= z[i].from || (i && z[i].from != z[i - 1].to))
            return reason("zone %lld: zones must follow one another with y increasing", (long long)i + 1);
    }
    if (t->zones.n && (t->mirror_y || t->mirror_z || t->shift_y != 0))
        return "mirror_y, mirror_z, shift_y: zones have y to the right, z down and their own origin";
    if (t->symmetric && (t->zones.n == 0 || z[0].from != 0))
        return "symmetric: zones must begin at y = 0";
    return NULL;
}

static const char *text_check(const struct prof_text *t)
{
    int turnout = t->part == PROF_TURNOUT, stated = t->unit != PROF_UNSTATED;

    if ((t->file != NULL) + (t->zones.n > 0) + (t->points.n > 0) != 1)
        return "one of file, zones and points must give the shape";
    if (turnout && (t->turnout.length == 0 || !t->file || !file_ends(t->file, ".yaml")))
        return "a turnout needs the key turnout, and as file the .yaml of its rail";
    if (turnout && t->cant != 0)
        return "cant: the rails of a turnout stand upright";
    if (!turnout && t->turnout.length != 0)
        return "turnout: only with part: turnout";
    if (t->file && (turnout || file_own_unit(t->file)) && stated)
        return reason("unit: %s says its own", t->file);
    if (!(t->file && (turnout || file_own_unit(t->file))) && !stated)
        return "unit: must be stated, m or mm";
    return turnout ? turnout_check(&t->turnout) : zones_check(t);
}

/* c_k in mm^(1-k) becomes m^(1-k). */
static void shape_scale(struct prof_text *t, double unit)
{
    struct prof_zone *z = t->zones.item;

    for (int64_t i = 0; i < t->points.n; i++)
        t->points.x[i] *= unit;
    for (int64_t i = 0; i < t->zones.n; i++) {
        double factor = unit;
        z[i].from *= unit, z[i].to *= unit, z[i].radius *= unit;
        for (int64_t k = 0; k < z[i].centre.n; k++)
            z[i].centre.x[k] *= unit;
        for (int64_t k = 0; k < z[i].polynomial.n; k++, factor /= unit)
            z[i].polynomial.x[k] *= factor;
    }
}

/* A file named by an input lies beside it, unless its name begins at the root. */
static const char *file_place(char **file, const char *beside)
{
    const char *slash = strrchr(beside, '/');
    if (!slash || **file == '/')
        return NULL;
    size_t n = (size_t)(slash - beside) + 1, m = strlen(*file);
    char *path = calloc(n + m + 1, 1);
    if (!path)
        return REASON_MEMORY;
    memcpy(path, beside, n);
    memcpy(path + n, *file, m);
    free(*file);
    *file = path;
    return NULL;
}

static double unit_of(const struct prof_text *t)
{
    return t->unit == PROF_MM ? 1e-3 : 1;
}

const char *prof_text_read(struct prof_text *t, const char *path, char *const *set, int sets, uint64_t *hash)
{
    const char *why = yaml_read(path, &prof_text_schema, set, sets, t, hash);
    if (why)
        return why;
    if (!(why = text_check(t)) && t->file)
        why = file_place(&t->file, path);
    if (why)
        prof_text_free(t);
    else
        shape_scale(t, unit_of(t));
    return why;
}

const char *prof_text_file(struct prof_text *t, const char *file, enum prof_part part, enum prof_unit unit,
                           char *const *set, int sets, uint64_t *hash)
{
    char text[128];
    const char *slash = strrchr(file, '/'), *why;

    snprintf(text, sizeof text, "profile: {name: shape, part: %s, unit: %s}", parts[part], units[unit]);
    if ((why = yaml_read_text(text, &prof_text_schema, set, sets, t, hash)))
        return why;
    free(t->name);
    t->name = strdup(slash ? slash + 1 : file);
    if (t->file || t->zones.n || t->points.n)
        why = "--set: file, zones and points belong to a .yaml input";
    else if (!t->name || !(t->file = strdup(file)))
        why = REASON_MEMORY;
    else
        why = text_check(t);
    if (why)
        prof_text_free(t);
    return why;
}

void prof_text_free(struct prof_text *t)
{
    yaml_release(&prof_text_schema, t);
}

static const char *file_points(const struct prof_text *t, struct points *p)
{
    struct simpack s;
    const char *why;

    if (!file_own_unit(t->file))
        return (why = points_read(p, t->file, unit_of(t))) ? reason("%s: %s", t->file, why) : NULL;
    if ((why = simpack_read(&s, t->file)))
        return reason("%s: %s", t->file, why);
    *p = s.points;
    if ((s.part == 'w') != (t->part == PROF_WHEEL))
        return reason("%s: holds a %s, not a %s", t->file, s.part == 'w' ? "wheel" : "rail", parts[t->part]);
    return NULL;
}

const char *prof_text_points(const struct prof_text *t, struct points *p)
{
    const char *why = NULL;
    int64_t room = 0;

    *p = (struct points){0};
    if (t->file)
        why = file_points(t, p);
    for (int64_t i = 0; !why && i + 1 < t->points.n; i += 2)
        why = points_add(p, &room, t->points.x[i], t->points.x[i + 1], 1);
    for (int64_t i = 0; i < p->n; i++) {
        p->y[i] = (t->mirror_y ? -p->y[i] : p->y[i]) + t->shift_y;
        p->z[i] = t->mirror_z ? -p->z[i] : p->z[i];
    }
    if (why)
        points_free(p);
    return why;
}
