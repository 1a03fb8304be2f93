/* vxrun: one train through one track.
 *
 * In: a case (YAML), a track (.trk), a vehicle (.veh), contact tables of both sides (.ctab), perhaps creep forces (.creep).  Out: a .run, written while
 * the train runs and renamed when it is complete.  Axes: x forward, y to the right, z down; forces are those of the wheel on the rail.
 * Method: integrate/passage.h, integrate/way.h.  Arrays read: all of the inputs.  Arrays written: run(5). */
#include "formats/beside.h"
#include "formats/case_text.h"
#include "formats/ctab.h"
#include "tools/cli/cli.h"
#include "tools/integrate/options.h"
#include "tools/integrate/record.h"
#include "tools/integrate/start.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static const char usage[] =
    "vxrun [-v] [--track T.trk] [--vehicle V.veh] [--contact-left L.ctab] [--contact-right R.ctab]\n"
    "      [--creep C.creep] [--set KEY=VALUE]... [-o OUT.run] CASE.yaml\n"
    "vxrun --schema | --master";

static struct {
    const char *track, *vehicle, *left, *right, *creep, *out;
    struct cli_list set;
    int verbose, schema, master;
} opt;

static const struct cli_option options[] = {
    {.name = "track", .type = CLI_TEXT, .value = &opt.track},
    {.name = "vehicle", .type = CLI_TEXT, .value = &opt.vehicle},
    {.name = "contact-left", .type = CLI_TEXT, .value = &opt.left},
    {.name = "contact-right", .type = CLI_TEXT, .value = &opt.right},
    {.name = "creep", .type = CLI_TEXT, .value = &opt.creep},
    {.name = "set", .type = CLI_LIST, .value = &opt.set},
    {.name = "schema", .type = CLI_FLAG, .value = &opt.schema},
    {.name = "master", .type = CLI_FLAG, .value = &opt.master},
    {.name = "v", .type = CLI_FLAG, .value = &opt.verbose},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxrun",
    .purpose = "Run a train over a track and write the history of the passage.",
    .usage = usage,
    .option = options,
};

/* The operand, or NULL where the schema or the master file is asked for. */
static const char *parse(int argc, char **argv)
{
    int n, asks;
    char **operand = cli_begin(&program, argc, argv, 0, 1, &n);

    asks = opt.schema + opt.master;
    if (asks > 1)
        cli_misuse("--schema and --master exclude each other");
    if (asks && (n || opt.track || opt.vehicle || opt.left || opt.right || opt.creep || opt.set.n || opt.out))
        cli_misuse("--%s stands alone", opt.schema ? "schema" : "master");
    if (!asks && !n)
        cli_misuse("the case is missing (-h shows the usage)");
    return asks ? NULL : operand[0];
}

struct inputs {
    struct case_text text;
    uint64_t hash;               /* of the case */
    int files;                   /* 1 with a prescribed force, else 4, and one of creep forces */
    struct vxf file[5];
    struct trk track;
    struct veh vehicle;
    struct ctab table[2];
    struct creep creep;
    struct irregularity measured;    /* where the case names a file of it */
};

/* The option goes before the case.  Returns the name, for messages. */
static char *open_input(struct vxf *f, const char *option, const char *spelled, const char *case_path, const char *named,
                        const char *kind)
{
    char *path;

    if (!option && !named)
        cli_misuse("the case names no .%s file, and %s is not given", kind, spelled);
    if (!(path = option ? strdup(option) : beside_path(named, case_path)))
        cli_die(REASON_MEMORY);
    cli_open(f, path, kind);
    return path;
}

static void check_side(const char *path, const struct ctab *t, char side)
{
    if (t->side != side)
        cli_die("%s: is of side %c, but %s wants side %c", path, t->side, side == 'l' ? "--contact-left" : "--contact-right", side);
}

/* A track has no name of its route; one without a curve is not that of a diverging route.  */
static void check_track(const char *path, const struct case_text *c, const struct trk *t)
{
    int curved = 0;

    if (trk_is_spatial(t))
        cli_die("%s: a spatial track has receptance, modes and statics; a train wants dofs: vertical", path);
    for (int64_t i = 0; i < t->curves; i++)
        curved |= fabs(t->curvature[i]) > 0;
    if (c->route == CASE_DIVERGING && !curved)
        cli_die("%s: the route is diverging, but this track has no curve", path);
}

static void read_irregularity(struct inputs *in, const char *path)
{
    char **file = &in->text.irregularity.file;

    cli_check(path, beside_place(file, path));
    if (*file)
        cli_check(*file, irregularity_read(&in->measured, *file));
}

static void read_creep(struct inputs *in, const char *path)
{
    if (!opt.creep && !in->text.creep)
        return;
    char *name = open_input(&in->file[in->files++], opt.creep, "--creep", path, in->text.creep, "creep");
    cli_check(name, creep_read(&in->creep, &in->file[4]));
    free(name);
}

static void read_train(struct inputs *in, const char *path)
{
    const struct case_text *c = &in->text;
    char *name[4];

    if (!(c->speed > 0))
        cli_die("%s: speed_kmh: missing", path);
    name[1] = open_input(&in->file[1], opt.vehicle, "--vehicle", path, c->vehicle, "veh");
    name[2] = open_input(&in->file[2], opt.left, "--contact-left", path, c->contact_left, "ctab");
    name[3] = open_input(&in->file[3], opt.right, "--contact-right", path, c->contact_right, "ctab");
    cli_check(name[1], veh_read(&in->vehicle, &in->file[1]));
    cli_check(name[2], ctab_read(&in->table[0], &in->file[2]));
    cli_check(name[3], ctab_read(&in->table[1], &in->file[3]));
    check_side(name[2], &in->table[0], 'l');
    check_side(name[3], &in->table[1], 'r');
    read_irregularity(in, path);
    read_creep(in, path);
    for (int i = 1; i < 4; i++)
        free(name[i]);
}

/* A prescribed force stands for vehicle and contact. */
static void read_inputs(struct inputs *in, const char *path)
{
    const struct case_text *c = &in->text;
    const char *why;
    char *name;

    if ((why = yaml_read(path, &case_text_schema, opt.set.item, opt.set.n, &in->text, &in->hash)))
        cli_die("%s", why); /* begins with its place */
    if (strlen(c->name) >= sizeof ((struct run *)NULL)->name)
        cli_die("%s: name: longer than %zu letters", path, sizeof ((struct run *)NULL)->name - 1);
    in->files = c->force.amplitude > 0 ? 1 : 4;
    if (in->files == 1 && (c->vehicle || c->contact_left || c->contact_right || opt.vehicle || opt.left || opt.right || opt.creep))
        cli_die("%s: force: a prescribed force stands instead of vehicle and contact tables", path);
    name = open_input(&in->file[0], opt.track, "--track", path, c->track, "trk");
    cli_check(name, trk_read(&in->track, &in->file[0]));
    check_track(name, c, &in->track);
    free(name);
    if (in->files > 1)
        read_train(in, path);
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void show_progress(const struct passage *p)
{
    static int64_t shown;

    if (isatty(STDERR_FILENO) && (p->n - shown) * 50 >= p->steps) {
        shown = p->n;
        fprintf(stderr, "\r%s %3.0f %%  s = %.1f m  %s", program.name, 100.0 * (double)p->n / (double)p->steps, p->station,
                p->n == p->steps ? "\n" : "");
    }
}

/* The header goes out first, then blocks as they fill, then the extremes.  A passage that fails leaves its samples up to there. */
static void write_run(struct passage *p, struct record *r, struct vxf_out *head, struct cli_out *out)
{
    struct vxf_stream stream;
    const char *why = vxf_stream_begin(&stream, head, out->file), *failed = NULL;
    int full = record_step(r, p);

    for (; !why && p->n < p->steps; full = record_step(r, p)) {
        if (full) {
            why = vxf_stream_block(&stream, r->held, r->series);
            r->held = 0;
        }
        if (why || (failed = passage_step(p)))
            break;
        show_progress(p);
    }
    if (!why)
        why = vxf_stream_block(&stream, r->held, r->series);
    if (!why && !failed)
        why = vxf_stream_end(&stream, (const void *const *)r->extreme);
    cli_check(opt.out ? opt.out : "standard output", why);
    cli_check("run", failed);
}

static void describe(const struct inputs *in, struct record *r, struct vxf_out *head)
{
    static const char *const route[] = {"through", "diverging"};

    vxf_out_begin(head, "run");
    for (int i = 0; i < in->files; i++)
        vxf_put_input(head, &in->file[i]);
    vxf_put_key(head, "INPUT", "case %016llx", (unsigned long long)in->hash);
    if (in->text.irregularity.file)
        vxf_put_key(head, "INPUT", "irregularity %016llx", (unsigned long long)in->measured.hash);
    vxf_put_key(head, "CMD", "%s", cli_command());
    snprintf(r->run.name, sizeof r->run.name, "%s", in->text.name);
    snprintf(r->run.route, sizeof r->run.route, "%s", route[in->text.route]);
    run_put(&r->run, r->recorded, head);
}

static void account(const struct passage *p, double begun, double started, double residual)
{
    struct rusage used;

    getrusage(RUSAGE_SELF, &used);
    cli_note("%lld steps of %g s, limit %.3g s; at the start no body accelerates by more than %.1e g", (long long)p->steps,
             p->o.step, p->limit, residual);
    cli_note("track %s, %lld degrees of freedom, %.2f rounds of forces a step: %s", p->rails.scheme == WAY_EXPLICIT ? "explicit" : "implicit",
             (long long)p->track->dofs, (double)p->rounds / (double)(p->steps + 1), p->rails.because);
    if (p->energy.counted) {
        double stored, lost, missing = energy_end(&p->energy, &p->rails, &stored, &lost);
        cli_note("wheels' work on the track %.6g J: lost %.6g, stored %.6g, missing %.1e of the loss", p->energy.work, lost, stored, missing);
    }
    cli_note("start %.3f s, passage %.3f s (%.2f us a step), peak memory %ld MB", started - begun, seconds() - started,
             1e6 * (seconds() - started) / (double)p->steps, used.ru_maxrss / 1024);
}

int main(int argc, char **argv)
{
    static struct inputs in;
    static struct passage p;
    static struct record r;
    static struct exciter e;
    struct passage_options o;
    struct vxf_out head;
    struct cli_out out;
    double begun = seconds(), started, residual;
    int64_t every;
    const char *path = parse(argc, argv);

    if (!path) {
        (opt.schema ? yaml_print_schema : yaml_print_master)(&case_text_schema, stdout);
        return cli_end();
    }
    read_inputs(&in, path);
    cli_check("case", options_read(&o, &in.text, in.text.speed / 3.6, in.text.irregularity.file ? &in.measured : NULL));
    if (in.files > 4)
        cli_check("case", options_creep(&o, &in.creep, in.table));
    if (in.text.force.amplitude > 0) {
        cli_check("case", options_exciter(&e, &in.text, &in.track));
        o.exciter = &e;
    }
    cli_check("case", options_sampling(&in.text, &every));
    o.account = opt.verbose && !o.exciter;
    cli_check("case", passage_new(&p, &o, &in.track, &in.vehicle, &in.table[0], &in.table[1]));
    cli_check("start", passage_start(&p, &residual));
    cli_check("run", record_new(&r, &p, in.text.channels.group, every));
    describe(&in, &r, &head);
    started = seconds();
    cli_create_part(&out, opt.out);
    write_run(&p, &r, &head, &out);
    cli_close(&out);
    if (opt.verbose)
        account(&p, begun, started, residual);
    vxf_out_free(&head);
    record_free(&r);
    passage_free(&p);
    exciter_free(&e);
    for (int i = 0; i < in.files; i++)
        vxf_close(&in.file[i]);
    irregularity_free(&in.measured);
    yaml_release(&case_text_schema, &in.text);
    return cli_end();
}
