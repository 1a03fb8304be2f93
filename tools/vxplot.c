/* vxplot: a picture of what a Veksel file holds.
 *
 * In: files of the kinds a figure takes, or a table as text.  Out: PNG.  The figure is the first that takes these kinds, or the one
 * named.  Arrays read: those of frf(5), prof(5), ctab(5), run(5).  Numbers are shown in the units of the field: mm, kN, degrees. */
#include "tools/cli/cli.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tools/draw/figure.h"
#include "tools/draw/png.h"
#include "tools/draw/sequence.h"

static const char usage[] =
    "vxplot [--figure NAME] [--size WxH] [--title TEXT] [--from X] [--to X]\n"
    "       [--label TEXT]... [--mark X=TEXT]... [--station M] [--yaw RAD] [--u M]\n"
    "       [--pairs N] [--stations N] [--each] [--wheelset N] [--sleeper N]... [-o OUT.png] FILE...\n"
    "vxplot --list";

enum { FILES = 8 };

static struct {
    const char *figure, *size, *title, *out;
    double from, to;                     /* in the SI unit of x */
    struct cli_list label, mark, sleeper;
    struct contact_place at;
    int64_t pairs, stations, wheelset;
    int each, list;
} opt = {.size = "1600x900", .from = -INFINITY, .to = INFINITY, .pairs = 40, .stations = 12, .wheelset = 1};

#define ANY .lo = -1e9, .hi = 1e9

static const struct cli_option option[] = {
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
    {.name = "stations", .type = CLI_INT, .value = &opt.stations, .lo = 1, .hi = SEQUENCE_MOST},
    {.name = "wheelset", .type = CLI_INT, .value = &opt.wheelset, .lo = 1, .hi = 1000},
    {.name = "sleeper", .type = CLI_LIST, .value = &opt.sleeper},
    {.name = "each", .type = CLI_FLAG, .value = &opt.each},
    {.name = "list", .type = CLI_FLAG, .value = &opt.list},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxplot",
    .purpose = "Draw what Veksel files hold as a PNG picture.",
    .usage = usage,
    .option = option,
};

struct operands {
    int n;
    char **path;                         /* [n] */
    struct vxf file[FILES];              /* [n] empty where the operand is text */
    struct columns table[FILES];         /* [n] empty where it is not */
    struct figure_input in[FILES];       /* [n] */
};

/* Standard input is text where the figure named takes nothing else; a file where its first byte is not that of a container. */
static int is_text(const char *path)
{
    int text = 0;

    if (strcmp(path, "-") == 0) {
        for (const struct figure *f = figures; f->name && opt.figure; f++)
            text |= strcmp(f->name, opt.figure) == 0 && strncmp(f->kinds, "text", 4) == 0;
        return text;
    }
    FILE *file = fopen(path, "rb");
    int first = file ? fgetc(file) : EOF;
    if (file)
        fclose(file);
    return first != EOF && first < 0x80;
}

/* By file; of a measurement and its curves, figure fit, the curves alone where there are fewer labels than files. */
static void label_operands(struct operands *o)
{
    const int first = o->n > 1 && o->in[0].table && o->in[1].file && opt.label.n < o->n;

    for (int k = 0; k < opt.label.n && first + k < o->n; k++)
        o->in[first + k].label = opt.label.item[k];
    if (opt.label.n > o->n)
        cli_misuse("--label %d times for %d files", opt.label.n, o->n);
}

static void open_operands(struct operands *o)
{
    for (int k = 0; k < o->n; k++) {
        const char *slash = strrchr(o->path[k], '/');
        o->in[k].name = slash ? slash + 1 : o->path[k];
        if (is_text(o->path[k])) {
            cli_check(o->path[k], columns_read(&o->table[k], o->path[k]));
            o->in[k].table = &o->table[k];
        } else {
            cli_open(&o->file[k], o->path[k], NULL);
            o->in[k].file = &o->file[k];
        }
    }
    label_operands(o);
}

static void close_operands(struct operands *o)
{
    for (int k = 0; k < o->n; k++) {
        if (o->in[k].file)
            vxf_close(&o->file[k]);
        columns_free(&o->table[k]);
    }
}

static void parse_size(int *width, int *height)
{
    char rest;

    if (sscanf(opt.size, "%4dx%4d%c", width, height, &rest) != 2 || *width < CANVAS_LEAST || *height < CANVAS_LEAST ||
        *width > CANVAS_MOST || *height > CANVAS_MOST)
        cli_misuse("--size must be WIDTHxHEIGHT with sides from %d to %d, not \"%s\"", CANVAS_LEAST, CANVAS_MOST, opt.size);
}

static void parse_sleepers(struct runs_choice *r, int64_t number[CHART_PANELS])
{
    if (opt.sleeper.n > CHART_PANELS)
        cli_misuse("--sleeper at most %d times", CHART_PANELS);
    for (int k = 0; k < opt.sleeper.n; k++) {
        char *end;
        number[k] = strtol(opt.sleeper.item[k], &end, 10);
        if (end == opt.sleeper.item[k] || *end)
            cli_misuse("--sleeper must be a whole number, not \"%s\"", opt.sleeper.item[k]);
    }
    if (opt.sleeper.n > 0) {
        r->asked = 1;
        r->sleepers = opt.sleeper.n;
        r->sleeper = number;
    }
}

static void add_marks(struct chart *c)
{
    for (int k = 0; k < opt.mark.n; k++) {
        char *end;
        double x = strtod(opt.mark.item[k], &end);
        if (end == opt.mark.item[k] || *end != '=' || !isfinite(x))
            cli_misuse("--mark must be a number, = and words, not \"%s\"", opt.mark.item[k]);
        chart_add_line(c, x, end + 1);
    }
}

static void paint(const struct chart *c, const char *path, int width, int height)
{
    struct canvas canvas;
    struct cli_out out;

    cli_create(&out, path, 1);
    cli_check("picture", canvas_new(&canvas, width, height));
    cli_check("picture", chart_draw(c, &canvas));
    cli_check(path ? path : "standard output", png_put(out.file, width, height, canvas.rgb, cli_command()));
    cli_close(&out);
    canvas_free(&canvas);
}

/* The chart of one figure, or of one frame, painted; 0 behind the last frame. */
static int draw(const struct figure *figure, struct operands *o, const struct figure_options *options, const char *path, int width,
                int height)
{
    struct chart c;

    chart_begin(&c);
    add_marks(&c);
    cli_check(o->path[0], figure_make(figure, &c, o->n, o->in, options));
    int drawn = c.panels > 0;
    if (opt.title)
        c.title = opt.title;
    if (drawn)
        paint(&c, path, width, height);
    chart_free(&c);
    return drawn;
}

/* OUT.png becomes OUT-01.png and so on. */
static void draw_frames(const struct figure *figure, struct operands *o, struct figure_options *options, int width, int height)
{
    char path[4096];
    size_t length = strlen(opt.out);
    int stem = (int)(length > 4 && strcmp(opt.out + length - 4, ".png") == 0 ? length - 4 : length);

    for (int drawn = 1; drawn; options->frame++) {
        if (snprintf(path, sizeof path, "%.*s-%02d.png", stem, opt.out, options->frame + 1) >= (int)sizeof path)
            cli_die("%s: the name is too long", opt.out);
        drawn = draw(figure, o, options, path, width, height);
    }
}

static int list_figures(void)
{
    for (const struct figure *f = figures; f->name; f++)
        printf("%-12s %-16s %s\n", f->name, f->kinds, f->shows);
    return cli_end();
}

int main(int argc, char **argv)
{
    static const int64_t panels[] = {2, 40, 80};   /* a sleeper in the switch, closure and crossing panel */
    static struct operands o;
    int64_t number[CHART_PANELS];
    int width, height;
    const char *why;

    o.path = cli_begin(&program, argc, argv, 0, FILES, &o.n);
    if (opt.list)
        return list_figures();
    if (o.n == 0)
        cli_misuse("which file?");
    if (opt.figure && !figure_known(opt.figure))
        cli_misuse("no figure is called %s: vxplot --list names them", opt.figure);
    if (opt.each && !(opt.out && opt.figure && strcmp(opt.figure, "sequence") == 0))
        cli_misuse("--each is of --figure sequence, with -o");
    parse_size(&width, &height);
    struct figure_options options = {opt.from, opt.to, (double)width / height, opt.at, (int)opt.pairs, (int)opt.stations, opt.each - 1,
                                     {opt.wheelset, 3, panels, 0}};
    parse_sleepers(&options.runs, number);
    open_operands(&o);
    const struct figure *figure = figure_choose(opt.figure, o.n, o.in, &why);
    if (!figure)
        cli_die("%s; vxplot --list says what each figure takes", why);
    if (opt.each)
        draw_frames(figure, &o, &options, width, height);
    else
        draw(figure, &o, &options, opt.out, width, height);
    close_operands(&o);
    return cli_end();
}
