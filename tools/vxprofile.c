/* vxprofile: cross-sections of a wheel, of a rail, of the rails of a turnout, or measured along the track.
 *
 * In: the profile input (YAML), a profile file of another program (formats/shape.h), a CONTACT .slcs, or plain points.  Out: .prof of one
 * side: polylines with slope, curvature and fall, y to the right, z down, y increasing.
 * Method: points turned to a right side, ordered and inclined, a smoothing spline over the length along them, resampled evenly, what
 * overhangs cut off; between measured sections a surface of lines along the track (profile/loft.h). */
#include "tools/cli/cli.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "formats/prof.h"
#include "formats/prof_text.h"
#include "formats/reason.h"
#include "tools/profile/dimensions.h"
#include "tools/profile/gauge.h"
#include "tools/profile/orient.h"
#include "tools/profile/measured_input.h"
#include "tools/profile/turnout.h"
#include "tools/profile/zones.h"

static const char usage[] =
    "vxprofile [--side l|r] [--part wheel|rail --unit m|mm] [--set KEY=VALUE]...\n"
    "          [--check] [-o OUT.prof] IN\n"
    "vxprofile --schema | --master";

static const char *const sides[] = {"r", "l", NULL};
static const char *const part_words[] = {"", "wheel", "rail", NULL};
static const char *const unit_words[] = {"", "m", "mm", NULL};

static int side, part, unit, check, schema, master;
static struct cli_list set;
static const char *output;
static struct shape shape;        /* as it was read; its kind is NULL for zones */
static struct orient orient;      /* which way round it was */

static const struct cli_option options[] = {
    {.name = "side", .type = CLI_CHOICE, .value = &side, .choice = sides},
    {.name = "part", .type = CLI_CHOICE, .value = &part, .choice = part_words},
    {.name = "unit", .type = CLI_CHOICE, .value = &unit, .choice = unit_words},
    {.name = "set", .type = CLI_LIST, .value = &set},
    {.name = "check", .type = CLI_FLAG, .value = &check},
    {.name = "schema", .type = CLI_FLAG, .value = &schema},
    {.name = "master", .type = CLI_FLAG, .value = &master},
    {.name = "o", .type = CLI_TEXT, .value = &output},
    {0},
};

static const struct cli_program program = {
    .name = "vxprofile",
    .purpose = "Make the cross-sections of a wheel, a rail or a turnout, or of rails measured along the track.",
    .usage = usage,
    .option = options,
};

static int ends(const char *path, const char *ending)
{
    size_t n = strlen(path), m = strlen(ending);
    return n > m && strcmp(path + n - m, ending) == 0;
}

/* The ending says what a file is; of plain points the command line says it. */
static void input_read(const char *path, struct prof_text *t, uint64_t *hash)
{
    const struct shape_kind *k = shape_kind(path);

    if (ends(path, ".yaml") || (strcmp(path, "-") == 0 && !part)) {
        if (part || unit)
            cli_misuse("--part and --unit are for plain points, %s says its own", path);
        cli_check(path, prof_text_read(t, path, set.item, set.n, hash));
        return;
    }
    if (ends(path, ".slcs") || ends(path, ".slcw")) {
        if (part || unit)
            cli_misuse("--part and --unit are for plain points; --set unit=mm where the sections are");
        cli_check(path, prof_text_file(t, path, PROF_SECTIONS, PROF_UNSTATED, set.item, set.n, hash));
        return;
    }
    if ((k->part && part) || (k->unit > 0 && unit))
        cli_misuse("--part and --unit are for plain points, %s says its own", path);
    if (!k->part && !part)
        cli_misuse("%s: %s need --part wheel|rail%s", path, k->name, k->unit > 0 ? "" : " and --unit m|mm");
    cli_check(path, prof_text_file(t, path, part == 1 || k->part == 'w' ? PROF_WHEEL : PROF_RAIL,
                                   unit == 1 ? PROF_M : unit == 2 ? PROF_MM : PROF_UNSTATED, set.item, set.n, hash));
}

/* *hash goes on over the points. */
static void shape_make(const char *path, const struct prof_text *t, const struct section_options *o, struct section *s,
                       uint64_t *hash)
{
    struct points *p = &shape.points;

    if (t->zones.n) {
        cli_check(path, zones_points(t->zones.n, t->zones.item, t->symmetric, t->spacing, p));
    } else {
        cli_check(t->file ? t->file : path, prof_text_shape(t, &shape));
        cli_check(t->file ? t->file : path, orient_shape(&shape, t, &orient));
    }
    *hash = XXH64(p->y, (size_t)p->n * sizeof *p->y, *hash);
    *hash = XXH64(p->z, (size_t)p->n * sizeof *p->z, *hash);
    cli_check(path, section_make(s, p, o));
    shape_free(&shape);
}

/* The shape of the wheel or rail, or of the rail a turnout is made of. */
static void section_read(const char *path, const struct prof_text *t, struct section *s, uint64_t *hash)
{
    struct section_options o = {t->part == PROF_WHEEL, t->cant, t->gauge_depth, t->smoothing, t->spacing};
    struct prof_text rail;

    if (t->part != PROF_TURNOUT) {
        shape_make(path, t, &o, s, hash);
        return;
    }
    cli_check(path, prof_text_read(&rail, t->file, NULL, 0, NULL));
    if (rail.part != PROF_RAIL)
        cli_die("%s: a turnout is made of a rail", t->file);
    shape_make(t->file, &rail, &o, s, hash);
    prof_text_free(&rail);
}

/* Sections measured along the track; what they have in common is told by *s. */
static void sections_measure(const char *path, const struct prof_text *t, struct section *s, struct set *sections, uint64_t *hash)
{
    const struct sections_extra *extra = t->sections.extra.item;
    int64_t n = t->sections.extra.n + 1;
    struct sections *list = calloc((size_t)n, sizeof *list);

    for (int64_t i = 0; list && i < n; i++)
        cli_check(path, sections_read(&list[i], t, i ? &extra[i - 1].from : &t->sections.from, hash));
    cli_check(path, list ? measured_input(t, list, s, sections) : REASON_MEMORY);
    for (int64_t i = 0; i < n; i++)
        sections_free(&list[i]);
    free(list);
}

/* The outline is taken over by the set. */
static void sections_gather(const char *path, const struct prof_text *t, struct section *s, struct set *sections)
{
    static const char *const wheel[] = {"wheel"}, *const rail[] = {"rail"};
    char which = side ? 'l' : 'r';

    if (t->part == PROF_TURNOUT) {
        cli_check(path, turnout_sections(&t->turnout, t->gauge, t->smoothing, t->spacing, which, s, sections));
        return;
    }
    *sections = (struct set){.bodies = 1, .body = t->part == PROF_WHEEL ? wheel : rail};
    cli_check(path, set_section(sections, 0));
    cli_check(path, set_body(sections, 0, &s->outline));
}

/* What a file held and which way round it was. */
static void print_shape(void)
{
    printf("kind\t%s\n", shape.kind->name);
    if (shape.side)
        printf("side_said\t%c\n", shape.side);
    printf("mirror_y\t%s\t%s\nmirror_z\t%s\t%s\nshift_y\t%.6f\tm\t%s\n", orient.mirror_y ? "true" : "false", orient.by_y,
           orient.mirror_z ? "true" : "false", orient.by_z, orient.shift_y, orient.by_shift);
    if (shape.flange_height > 0)
        printf("flange_said\t%.6f\t%.6f\t%.6f\tm, Sh Sd qR\n", shape.flange_height, shape.flange_width, shape.flange_slope);
}

static void print_measures(const struct prof_text *t, const struct section *s, const struct dimensions *c, const struct prof *p)
{
    double sign = p->side == 'l' ? -1 : 1;

    if (p->part == 'r')
        printf("gauge_face\t%.6f\tm\ncant\t%.6f\t1\n", sign * s->gauge_face, t->cant);
    if (p->part == 'r' && isfinite(s->cant))
        printf("cant_found\t%.5f\t1\tslope of the top 10 mm to both sides of the middle between the side faces\n", s->cant);
    if (p->part == 'w' && isfinite(c->flange_slope))
        printf("flange_height\t%.6f\tm\nflange_thickness\t%.6f\tm\nflange_slope\t%.6f\tm\n", c->flange_height, c->flange_thickness,
               c->flange_slope);
    printf("kinks\t%" PRId64 "\t1\tturns of more than 30 degrees over 2 mm\n", s->kinks.n);
    for (int64_t i = 0; i < s->kinks.n && i < KINKS_TOLD; i++)
        printf("kink\t%.6f\tm\t%.4f\trad\n", sign * s->kinks.y[i], sign * s->kinks.turn[i]);
}

static void print_check(const struct prof_text *t, const struct section *s, const struct dimensions *c, const struct prof *p)
{
    printf("name\t%s\npart\t%s\nside\t%c\nposition\t%.6f\tm\n", p->name, p->part == 'w' ? "wheel" : "rail", p->side, p->position);
    if (shape.kind)
        print_shape();
    print_measures(t, s, c, p);
    printf("points_read\t%" PRId64 "\t1\ndoubles\t%" PRId64 "\t1\nzigzags\t%" PRId64 "\t1\nlongest_gap\t%.3e\tm\n",
           s->points, s->clean.doubles, s->clean.zigzags, s->clean.longest_gap);
    printf("residual_worst\t%.3e\tm\nresidual_worst_y\t%.6f\tm\nresidual_rms\t%.3e\tm\n", s->residual.worst,
           p->side == 'l' ? -s->residual.worst_y : s->residual.worst_y, s->residual.rms);
    printf("# station m, body, points, y m from to, z m least greatest, slope from to, curvature 1/m least greatest\n");
    for (int64_t i = 0; i < p->polys; i++) {
        int64_t first = p->poly_first[i], last = p->poly_first[i + 1] - 1;
        double z[2] = {p->z[first], p->z[first]}, k[2] = {p->curvature[first], p->curvature[first]};
        for (int64_t j = first; j <= last; j++) {
            z[0] = p->z[j] < z[0] ? p->z[j] : z[0];
            z[1] = p->z[j] > z[1] ? p->z[j] : z[1];
            k[0] = p->curvature[j] < k[0] ? p->curvature[j] : k[0];
            k[1] = p->curvature[j] > k[1] ? p->curvature[j] : k[1];
        }
        printf("%.3f\t%s\t%" PRId64 "\t%.6f\t%.6f\t%.6f\t%.6f\t%.4f\t%.4f\t%.2f\t%.2f\n", p->station[p->poly_section[i]],
               p->body[p->poly_body[i]], last - first + 1, p->y[first], p->y[last], z[0], z[1], p->slope[first],
               p->slope[last], k[0], k[1]);
    }
}

static void prof_save(const struct prof *p, uint64_t hash)
{
    struct vxf_out o;

    vxf_out_begin(&o, "prof");
    cli_check(p->name, prof_put(p, &o));
    vxf_put_key(&o, "INPUT", "profile %016" PRIx64, hash);
    cli_write(&o, output);
    vxf_out_free(&o);
}

int main(int argc, char **argv)
{
    int n;
    char **path = cli_begin(&program, argc, argv, 0, 1, &n);
    struct prof_text text;
    struct section section;
    struct dimensions measures = {0};
    struct set sections;
    struct prof prof = {0};
    uint64_t hash;

    if (schema + master + (n == 1) != 1)
        cli_misuse("one input, or --schema or --master");
    if (schema)
        yaml_print_schema(&prof_text_schema, stdout);
    if (master)
        yaml_print_master(&prof_text_schema, stdout);
    if (n == 0)
        return cli_end();
    input_read(path[0], &text, &hash);
    if (text.part == PROF_SECTIONS) {
        sections_measure(path[0], &text, &section, &sections, &hash);
    } else {
        section_read(path[0], &text, &section, &hash);
        dimensions_wheel(&section.outline, text.flange_back, &measures);
        sections_gather(path[0], &text, &section, &sections);
    }

    strncpy(prof.name, text.name, sizeof prof.name - 1);
    prof.part = text.part == PROF_WHEEL ? 'w' : 'r';
    prof.radius = text.part == PROF_WHEEL ? text.radius : 0;
    prof.position = text.part == PROF_WHEEL ? gauge_wheel_position(text.back_to_back, text.flange_back)
                                            : gauge_rail_position(section.gauge_face, text.gauge);
    cli_check(path[0], set_prof(&sections, side ? 'l' : 'r', &prof));
    if (check)
        print_check(&text, &section, &measures, &prof);
    else
        prof_save(&prof, hash);
    prof_free(&prof);
    set_free(&sections);
    section_free(&section);
    prof_text_free(&text);
    return cli_end();
}
