/* vxplot: a picture of what a Veksel file holds.
 *
 * In: .frf, .prof, .ctab files as the figure wants them.  Out: PNG.  The figure is the one that takes these kinds, or the one named.
 * Arrays read: those of frf(5), prof(5), ctab(5).  Numbers are shown in the units of the field (mm, kN, degrees). */
#include "tools/cli/cli.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/ctab.h"
#include "formats/frf.h"
#include "formats/prof.h"
#include "tools/draw/contact.h"
#include "tools/draw/png.h"
#include "tools/draw/radius.h"
#include "tools/draw/receptance.h"
#include "tools/draw/sections.h"

static const char usage[] =
    "vxplot [--figure NAME] [--size WxH] [--title TEXT] [--from X] [--to X]\n"
    "       [--label TEXT]... [--mark X=TEXT]... [--station M] [--yaw RAD] [--u M]\n"
    "       [--pairs N] [-o OUT.png] FILE...\n"
    "vxplot --list";

static struct {
    const char *figure, *size, *title, *out;
    double from, to;                     /* SI unit of x */
    struct cli_list label, mark;
    struct contact_place at;
    int64_t pairs;
    int list;
} opt = {.size = "1600x900", .from = -INFINITY, .to = INFINITY, .pairs = 40};

#define ANY .lo = -1e9, .hi = 1e9

static const struct cli_option options[] = {
    {.name = "figure", .type = CLI_TEXT, .value = &opt.figure},
    {.name = "size", .type = CLI_TEXT, .value = &opt.size},
    {.name = "title", .type = CLI_TEXT, .value = &opt.title},
    {.name = "from", .type = CLI_NUM, .value = &opt.from, ANY},
    {.name = "to", .type = CLI_NUM, .value = &opt.to, ANY},
    {.name = "label", .type = CLI_LIST, .value = &opt.label},
    {.name = "mark", .type = CLI_LIST, .value = &opt.mark},
    {.name = "station", .type = CLI_NUM, .value = &opt.at.station, ANY},
    {.name = "yaw", .type = CLI_NUM, .value = &opt.at.yaw, .lo = -1, .hi = 1},
    {.name = "u", .letter = 1, .type = CLI_NUM, .value = &opt.at.u, .lo = -1, .hi = 1},
    {.name = "pairs", .type = CLI_INT, .value = &opt.pairs, .lo = 1, .hi = 1000},
    {.name = "list", .type = CLI_FLAG, .value = &opt.list},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxplot",
    .purpose = "Draw what Veksel files hold as a PNG picture.",
    .usage = usage,
    .option = options,
};

enum { FILES = 8 };

struct input {
    int n;
    char **path;                         /* [n] */
    struct vxf file[FILES];              /* [n] */
    int width, height;                   /* px */
};

static const char *label(int k)
{
    return k < opt.label.n ? opt.label.item[k] : NULL;
}

/* What options say about any chart, then the picture. */
static void paint(struct chart *c, const struct input *in)
{
    struct canvas canvas;
    struct cli_out out;

    if (opt.title)
        c->title = opt.title;
    for (int k = 0; k < opt.mark.n; k++) {
        char *end;
        double x = strtod(opt.mark.item[k], &end);
        if (end == opt.mark.item[k] || *end != '=' || !isfinite(x))
            cli_misuse("--mark must be a number, = and words, not \"%s\"", opt.mark.item[k]);
        chart_add_line(c, x, end + 1);
    }
    cli_create(&out, opt.out, 1);
    cli_check("picture", canvas_new(&canvas, in->width, in->height));
    cli_check("picture", chart_draw(c, &canvas));
    cli_check(opt.out ? opt.out : "standard output",
              png_put(out.file, canvas.width, canvas.height, canvas.rgb, cli_command()));
    cli_close(&out);
    canvas_free(&canvas);
    chart_free(c);
}

/* --from and --to where given, else the limits lo and hi of the data. */
static void window(struct chart_axis *x, double lo, double hi)
{
    if (opt.from >= opt.to)
        cli_misuse("--from must be less than --to");
    if (x->log && opt.from <= 0 && isfinite(opt.from))
        cli_misuse("--from must be greater than 0 on a logarithmic axis");
    x->lo = isfinite(opt.from) ? opt.from : lo;
    x->hi = isfinite(opt.to) ? opt.to : hi;
}

static void figure_receptance(const struct input *in)
{
    struct chart c;
    struct frf frf[FILES];
    double lo = INFINITY, hi = 0;

    receptance_begin(&c);
    for (int k = 0; k < in->n; k++) {
        cli_check(in->path[k], frf_read(&frf[k], &in->file[k]));
        cli_check(in->path[k], receptance_add(&c, &frf[k], label(k)));
        lo = fmin(lo, frf[k].frequency[frf[k].frequency[0] == 0 && frf[k].n > 1]);
        hi = fmax(hi, frf[k].frequency[frf[k].n - 1]);
    }
    window(&c.x, lo, hi);
    paint(&c, in);
    for (int k = 0; k < in->n; k++)
        frf_free(&frf[k]);
}

static void figure_sections(const struct input *in)
{
    struct chart c;
    struct prof prof;

    cli_check(in->path[0], prof_read(&prof, &in->file[0]));
    chart_begin(&c);
    c.title = prof.name;
    cli_check(in->path[0], sections_chart(&c, &prof, opt.from, opt.to, (double)in->width / in->height));
    paint(&c, in);
    prof_free(&prof);
}

/* The contact of a wheel on a rail, at one displacement or as pairs over all. */
static void contacts(const struct input *in, int pairs)
{
    struct chart c;
    struct prof wheel, rail;
    struct ctab table;

    cli_check(in->path[0], prof_read(&wheel, &in->file[0]));
    cli_check(in->path[1], prof_read(&rail, &in->file[1]));
    cli_check(in->path[2], ctab_read(&table, &in->file[2]));
    chart_begin(&c);
    cli_check(in->path[2], pairs ? contact_pairs_chart(&c, &wheel, &rail, &table, &opt.at, (int)opt.pairs)
                                 : contact_chart(&c, &wheel, &rail, &table, &opt.at));
    window(&c.x, c.x.lo, c.x.hi);
    paint(&c, in);
    prof_free(&wheel);
    prof_free(&rail);
    ctab_free(&table);
}

static void figure_contact(const struct input *in)
{
    contacts(in, 0);
}

static void figure_pairs(const struct input *in)
{
    contacts(in, 1);
}

static void figure_radius(const struct input *in)
{
    struct chart c;
    struct ctab left, right;

    cli_check(in->path[0], ctab_read(&left, &in->file[0]));
    cli_check(in->path[1], ctab_read(&right, &in->file[1]));
    chart_begin(&c);
    cli_check(in->path[0], radius_chart(&c, &left, &right, opt.at.station, opt.at.yaw));
    window(&c.x, left.u[0], left.u[left.us - 1]);
    paint(&c, in);
    ctab_free(&left);
    ctab_free(&right);
}

/* kinds: of the operands in order; a last "..." means more of the one before. */
static const struct figure {
    const char *name, *kinds;
    void (*draw)(const struct input *in);
    const char *shows;
} figures[] = {
    {"receptance", "frf ...", figure_receptance, "magnitude with peaks, and phase"},
    {"sections", "prof", figure_sections, "cross-sections along the track"},
    {"contact", "prof prof ctab", figure_contact, "wheel on rail with contact points, at --station --yaw --u"},
    {"pairs", "prof prof ctab", figure_pairs, "points of wheel and rail that touch, over all displacements"},
    {"radius", "ctab ctab", figure_radius, "rolling radius difference over lateral displacement"},
};
enum { FIGURES = sizeof figures / sizeof *figures };

static int takes(const struct figure *f, const struct input *in)
{
    const char *kind = f->kinds, *before = kind;

    for (int k = 0; k < in->n; k++) {
        if (strncmp(kind, "...", 3) == 0)
            kind = before;
        size_t length = strcspn(kind, " ");
        if (strlen(in->file[k].kind) != length || strncmp(kind, in->file[k].kind, length) != 0)
            return 0;
        before = kind;
        kind += length + (kind[length] == ' ');
    }
    return *kind == '\0' || strncmp(kind, "...", 3) == 0;
}

static const struct figure *choose(const struct input *in)
{
    for (int k = 0; k < FIGURES; k++)
        if (opt.figure ? !strcmp(opt.figure, figures[k].name) : takes(&figures[k], in)) {
            if (!takes(&figures[k], in))
                cli_die("figure %s takes: %s", figures[k].name, figures[k].kinds);
            return &figures[k];
        }
    if (opt.figure)
        cli_misuse("no figure \"%s\": vxplot --list names them", opt.figure);
    cli_die("%s: no figure takes a .%s with these operands: vxplot --list names them", in->path[0], in->file[0].kind);
}

static void parse_size(int *width, int *height)
{
    char rest;

    if (sscanf(opt.size, "%4dx%4d%c", width, height, &rest) != 2 || *width < CANVAS_LEAST || *height < CANVAS_LEAST ||
        *width > CANVAS_MOST || *height > CANVAS_MOST)
        cli_misuse("--size must be WIDTHxHEIGHT with sides from %d to %d, not \"%s\"", CANVAS_LEAST, CANVAS_MOST, opt.size);
}

int main(int argc, char **argv)
{
    struct input in = {0};

    in.path = cli_begin(&program, argc, argv, 0, FILES, &in.n);
    for (int k = 0; k < FIGURES && opt.list; k++)
        printf("%-12s %-16s %s\n", figures[k].name, figures[k].kinds, figures[k].shows);
    if (opt.list)
        return cli_end();
    if (in.n == 0)
        cli_misuse("which file?");
    parse_size(&in.width, &in.height);
    for (int k = 0; k < in.n; k++)
        cli_open(&in.file[k], in.path[k], NULL);
    choose(&in)->draw(&in);
    for (int k = 0; k < in.n; k++)
        vxf_close(&in.file[k]);
    return cli_end();
}
