#include "tools/draw/figure.h"

#include <math.h>
#include <string.h>

#include "tools/draw/limits.h"
#include "tools/draw/modes.h"
#include "tools/draw/path.h"
#include "tools/draw/radius.h"
#include "tools/draw/receptance.h"
#include "tools/draw/sections.h"
#include "tools/draw/sequence.h"
#include "tools/draw/shapes.h"
#include "tools/draw/tables.h"
#include "tools/draw/vehicle.h"
#include "tools/draw/yaw.h"

/* With the values by Hermite's polynomials where hermite is true; *quantity is that of all. */
static const char *add_receptances(struct chart *c, int n, const struct figure_input *in, int hermite, int *quantity)
{
    const char *why = NULL;

    for (int k = 0; k < n && !why; k++) {
        struct frf r;
        if ((why = frf_read(&r, in[k].file)))
            break;
        if (k == 0)
            receptance_begin(c, *quantity = r.quantity);
        r.hermites = hermite ? r.hermites : 0;
        why = r.quantity == *quantity ? receptance_add(c, &r, in[k].label) : reason("%s and %s do not share an axis",
                                                                                    frf_quantity[*quantity].name, frf_quantity[r.quantity].name);
    }
    return why;
}

static const char *make_receptance(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    int quantity;

    (void)o;
    return add_receptances(c, n, in, 1, &quantity);
}

/* A measurement, and receptances to hold against it. */
static const char *make_fit(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    int quantity;
    const char *why = add_receptances(c, n - 1, in + 1, 0, &quantity);

    (void)o;
    return why ? why : receptance_add_measured(c, in[0].table, quantity, in[0].label);
}

static const char *make_sections(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct prof p;
    const char *why = prof_read(&p, in[0].file);

    (void)n;
    if (why)
        return why;
    c->title = chart_words(c, "%s, %s side", p.name, p.side == 'l' ? "left" : "right");
    return sections_chart(c, &p, o->from, o->to, o->shape);
}

/* Wheel, rail and table of a figure of contacts. */
static const char *read_contacts(const struct figure_input *in, struct prof *wheel, struct prof *rail, struct ctab *t)
{
    const char *why = prof_read(wheel, in[0].file);

    why = why ? why : prof_read(rail, in[1].file);
    return why ? why : ctab_read(t, in[2].file);
}

static const char *make_contact(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct prof wheel, rail;
    struct ctab t;
    const char *why = read_contacts(in, &wheel, &rail, &t);

    (void)n;
    return why ? why : contact_chart(c, &wheel, &rail, &t, &o->at);
}

static const char *make_sequence(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct prof wheel, rail;
    struct ctab t;
    const char *why = read_contacts(in, &wheel, &rail, &t);

    (void)n;
    const struct sequence_choice choice = {o->from, o->to, o->stations, o->frame};
    return why ? why : sequence_chart(c, &wheel, &rail, &t, &o->at, &choice, o->shape);
}

static const char *make_pairs(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct prof wheel, rail;
    struct ctab t;
    const char *why = read_contacts(in, &wheel, &rail, &t);

    (void)n;
    return why ? why : contact_pairs_chart(c, &wheel, &rail, &t, &o->at, o->pairs);
}

static const char *make_radius(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct ctab left, right;
    const char *why = ctab_read(&left, in[0].file);

    (void)n;
    why = why ? why : ctab_read(&right, in[1].file);
    return why ? why : radius_chart(c, &left, &right, o->at.station, o->at.yaw);
}

static const char *add_modes(struct chart *c, const struct vxf *file, const struct trk *t, int most)
{
    struct mod m;
    const char *why = mod_read(&m, file);

    return why ? why : modes_add(c, &m, t, most);
}

static const char *make_modes(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct trk t;
    const char *why = trk_read(&t, in[1].file);

    (void)n;
    (void)o;
    if (why)
        return why;
    modes_begin(c, &t);
    return add_modes(c, in[0].file, &t, 4);
}

static const char *make_chosen_modes(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct trk t;
    const char *why = trk_read(&t, in[0].file);

    (void)o;
    if (!why)
        modes_begin(c, &t);
    for (int k = 1; k < n && !why; k++)
        why = add_modes(c, in[k].file, &t, 1);
    return why;
}

static const char *make_vehicle(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct veh v;
    const char *why = veh_read(&v, in[0].file);

    (void)n;
    return why ? why : vehicle_chart(c, &v, o->from, o->to);
}

static const char *make_shapes(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    struct mod m;
    struct veh v;
    const char *why = mod_read(&m, in[0].file);

    (void)n;
    (void)o;
    why = why ? why : veh_read(&v, in[1].file);
    return why ? why : shapes_chart(c, &m, &v);
}

static const char *make_rolling_radius(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    (void)n;
    (void)o;
    return tables_rolling_radius(c, in[0].table);
}

static const char *make_conicity(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    (void)n;
    (void)o;
    return tables_conicity(c, in[0].table);
}

static const char *make_stiffness(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    (void)n;
    (void)o;
    return tables_stiffness(c, in[0].table);
}

static const char *make_bowl(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    (void)n;
    (void)o;
    return tables_bowl(c, in[0].table);
}

static const char *make_table(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    (void)n;
    (void)o;
    return tables_chart(c, in[0].table);
}

static const char *make_yaw(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    const char *why = NULL;

    (void)o;
    for (int k = 0; k < n && !why; k++)
        why = yaw_add(c, in[k].table, k, n, in[k].label ? in[k].label : in[k].name);
    return why;
}

static const char *make_path(struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    const char *why = NULL;

    (void)o;
    for (int k = 0; k < n && !why; k++)
        why = path_add(c, in[k].table, k, in[k].label ? in[k].label : in[k].name);
    return why;
}

static const char *make_runs(runs_add *add, struct chart *c, int n, const struct figure_input *in, const struct figure_options *o)
{
    const char *why = NULL;

    for (int k = 0; k < n && !why; k++) {
        struct run r;
        why = run_read(&r, in[k].file);
        if (!why)
            why = add(c, &r, in[k].label || n == 1 ? in[k].label : in[k].name, &o->runs);
    }
    return why;
}

const struct figure figures[] = {
    {"receptance", "frf ...", "magnitude with peaks, and phase", make_receptance, NULL},
    {"fit", "text frf ...", "a measured receptance as dots, and receptances", make_fit, NULL},
    {"modes", "mod trk", "natural modes of a track, the first four of the file", make_modes, NULL},
    {"modes", "trk mod ...", "the first mode of each file", make_chosen_modes, NULL},
    {"modes", "mod veh", "natural modes of a vehicle, the first twelve of the file", make_shapes, NULL},
    {"vehicle", "veh", "a vehicle from the right, above and behind, with its couplings", make_vehicle, NULL},
    {"sections", "prof", "cross-sections along the track", make_sections, NULL},
    {"contact", "prof prof ctab", "wheel on rail and its contact points, at --station --yaw --u", make_contact, NULL},
    {"pairs", "prof prof ctab", "points of wheel and rail that touch, over all displacements", make_pairs, NULL},
    {"sequence", "prof prof ctab", "wheel on rail at --stations of the track", make_sequence, NULL},
    {"radius", "ctab ctab", "rolling radius difference over lateral displacement", make_radius, NULL},
    {"radius", "text", "the same from vxcontact --rolling-radius, with roll", make_rolling_radius, NULL},
    {"yaw", "text ...", "the contact that touches, from vxcontact --sweep, by method", make_yaw, NULL},
    {"path", "text ...", "height of a wheel and place of its contact, from vxcontact --path", make_path, NULL},
    {"conicity", "text", "equivalent conicity over amplitude, from vxcontact --conicity", make_conicity, NULL},
    {"stiffness", "text", "static stiffness along the track, from vxfreq --stiffness", make_stiffness, NULL},
    {"bowl", "text", "static deflection under axles, from vxfreq --static --axles", make_bowl, NULL},
    {"table", "text", "columns of numbers over the first, a panel for each unit", make_table, NULL},
    {"vertical", "run ...", "vertical force Q of --wheelset, left and right", NULL, runs_vertical},
    {"lateral", "run ...", "lateral force Y of --wheelset, left and right", NULL, runs_lateral},
    {"wheelset", "run ...", "yaw, lateral displacement and contacts of --wheelset", NULL, runs_wheelset},
    {"pads", "run ...", "force of the railpads on each --sleeper", NULL, runs_pads},
    {"ballast", "run ...", "force on the ballast under each --sleeper", NULL, runs_ballast},
    {"max-pads", "run ...", "largest force of each railpad, over sleeper number", NULL, runs_max_pads},
    {"max-ballast", "run ...", "largest force on the ballast under each sleeper", NULL, runs_max_ballast},
    {0},
};

/* The k-th input is of the kind named by the first `length` bytes of word. */
static int is_kind(const struct figure_input *in, const char *word, size_t length)
{
    const char *kind = in->file ? in->file->kind : "text";

    return strlen(kind) == length && strncmp(kind, word, length) == 0;
}

static int takes(const struct figure *f, int n, const struct figure_input *in)
{
    const char *word = f->kinds, *before = word;

    for (int k = 0; k < n; k++) {
        if (strcmp(word, "...") == 0)
            word = before;
        size_t length = strcspn(word, " ");
        if (!is_kind(&in[k], word, length))
            return 0;
        before = word;
        word += length + (word[length] == ' ');
    }
    return n > 0 && (*word == '\0' || strcmp(word, "...") == 0);
}

int figure_known(const char *name)
{
    int known = 0;

    for (const struct figure *f = figures; f->name; f++)
        known |= strcmp(f->name, name) == 0;
    return known;
}

const struct figure *figure_choose(const char *name, int n, const struct figure_input *in, const char **why)
{
    const struct figure *last = NULL;

    for (const struct figure *f = figures; f->name; f++) {
        if (name && strcmp(name, f->name) != 0)
            continue;
        if (takes(f, n, in))
            return f;
        last = f;
    }
    *why = last && name ? reason("figure %s takes: %s", name, last->kinds) : "no figure takes these kinds of file together";
    return NULL;
}

/* The window asked for; beyond it the axis keeps the limits it has, or those of the data. */
static const char *set_window(struct chart *c, double from, double to)
{
    double lo, hi;

    limits_x(c, &lo, &hi);
    lo = isfinite(from) ? from : lo;
    hi = isfinite(to) ? to : hi;
    if (lo >= hi || (c->x.log && lo <= 0))
        return reason("nothing can be drawn from %g to %g", lo, hi);
    c->x.lo = lo;
    c->x.hi = hi;
    return NULL;
}

const char *figure_make(const struct figure *f, struct chart *c, int n, const struct figure_input *in,
                        const struct figure_options *o)
{
    const char *why = f->runs ? make_runs(f->runs, c, n, in, o) : f->make(c, n, in, o);

    /* of sections and a sequence the window is along the track, not along x; a vehicle has it set or none */
    if (why || f->make == make_sections || f->make == make_sequence || f->make == make_vehicle || f->make == make_shapes)
        return why;
    return set_window(c, o->from, o->to);
}
