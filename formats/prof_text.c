/* What one key of the profile input cannot check alone, and where its shape comes from. */
#include "formats/prof_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/beside.h"
#include "formats/reason.h"

#define SAME 1e-5            /* m */

static int file_ends(const char *file, const char *ending)
{
    size_t n = strlen(file), m = strlen(ending);
    return n > m && strcmp(file + n - m, ending) == 0;
}

static int file_own_unit(const char *file)
{
    return shape_kind(file)->unit > 0;
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

static const char *wing_check(const struct turnout_text *t)
{
    if (t->wing.end == 0 && (t->wing.flare != 0 || t->wing.opening != 0))
        return "wing_rail: flare and opening want its end";
    if ((t->wing.flare == 0) != (t->wing.opening == 0))
        return "wing_rail: flare and opening go together";
    if (t->wing.flare > t->wing.end || (t->wing.opening != 0 && t->wing.opening < t->wing.flangeway))
        return reason("wing_rail: opens by %g m over %g m, but ends %g m behind the mathematical point",
                      t->wing.opening - t->wing.flangeway, t->wing.flare, t->wing.end);
    return NULL;
}

static const char *check_rail_check(const struct turnout_text *t)
{
    const struct yaml_nums *f = &t->check.flangeway;
    const char *why = f->n ? table_check("check_rail.flangeway", f) : NULL;

    for (int64_t i = 1; !why && i < f->n; i += 2)
        if (!(f->x[i] > 0 && f->x[i] < 0.2))
            why = reason("check_rail.flangeway: %g m, should be up to 0.2 m", f->x[i]);
    return why;
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
        (why = table_check("wing_rail.raise", &t->wing.raise)) || (why = wing_check(t)) || (why = check_rail_check(t)))
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

    if ((t->part == PROF_SECTIONS) != (t->sections.reference > 0))
        return "part: sections and the key sections belong together";
    if (t->part == PROF_SECTIONS)
        return t->file || t->zones.n || t->points.n || t->cant != 0 || t->turnout.length != 0
            ? "file, zones, points, cant, turnout: not with part: sections" : sections_text_check(&t->sections);
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
    if (!t->file && !stated)
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

static double unit_of(const struct prof_text *t)
{
    return t->unit == PROF_MM ? 1e-3 : 1;
}

const char *prof_text_read(struct prof_text *t, const char *path, char *const *set, int sets, uint64_t *hash)
{
    const char *why = yaml_read(path, &prof_text_schema, set, sets, t, hash);
    if (why)
        return why;
    if (!(why = text_check(t)) && !(why = beside_place(&t->file, path)))
        why = sections_text_place(&t->sections, path);
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

    snprintf(text, sizeof text, "profile: {name: shape, part: %s, unit: %s%s}", prof_part_names[part], prof_unit_names[unit],
             part == PROF_SECTIONS ? ", sections: {reference: 1}" : "");
    if ((why = yaml_read_text(text, &prof_text_schema, set, sets, t, hash)))
        return why;
    free(t->name);
    t->name = strdup(slash ? slash + 1 : file);
    if (t->file || t->zones.n || t->points.n)
        why = "--set: file, zones and points belong to a .yaml input";
    else if (part == PROF_SECTIONS && (t->sections.from.file || t->sections.from.index || t->sections.from.list.n))
        why = "--set: the sections are those of the .slcs";
    else if (!t->name || !(*(part == PROF_SECTIONS ? &t->sections.from.file : &t->file) = strdup(file)))
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

/* What a file says of the track's measures is not to differ from the keys. */
static const char *distance_check(const struct prof_text *t, const struct shape *s)
{
    int wheel = t->part == PROF_WHEEL;
    double distance = wheel ? t->back_to_back : t->gauge, datum = wheel ? t->flange_back : t->gauge_depth;

    if (s->distance > 0 && fabs(s->distance - distance) > SAME)
        return reason("%s: the file says %.4f, the input %.4f: state it", wheel ? "back_to_back" : "gauge", s->distance, distance);
    if (s->datum > 0 && fabs(s->datum - datum) > SAME)
        return reason("%s: the file says %.5f, the input %.5f: state it", wheel ? "flange_back" : "gauge_depth", s->datum, datum);
    return NULL;
}

/* Points of the input itself stand in our axes, unless it says otherwise. */
const char *prof_text_shape(const struct prof_text *t, struct shape *s)
{
    static const struct shape_kind own = {"", "points of the input", 0, 0, 0, 0, 1, 0};
    struct shape_choice c = {t->part == PROF_WHEEL ? 'w' : 'r', t->unit == PROF_UNSTATED ? 0 : unit_of(t), t->section, t->file_side};
    const char *why = NULL;
    int64_t room = 0;

    *s = (struct shape){.kind = &own};
    if (t->file && !(why = shape_read(s, t->file, &c)))
        why = distance_check(t, s);
    for (int64_t i = 0; !why && i + 1 < t->points.n; i += 2)
        why = points_add(&s->points, &room, t->points.x[i], t->points.x[i + 1], 1);
    if (why)
        shape_free(s);
    return why;
}
