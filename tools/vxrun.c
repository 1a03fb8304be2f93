/* vxrun: one train through one track.
 *
 * In: a case (YAML), a track (.trk), a vehicle (.veh), contact tables of both sides (.ctab), perhaps creep forces (.creep).  Out: a .run, written while
 * the train runs and renamed when it is complete.  Axes: x forward, y to the right, z down; forces are those of the wheel on the rail.
 * Method: integrate/passage.h, integrate/way.h.  Arrays read: all of the inputs.  Arrays written: run(5). */
#include "tools/cli/inputs.h"
#include "tools/cli/states.h"
#include "tools/integrate/options.h"
#include "tools/integrate/record.h"
#include "tools/integrate/start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static const char usage[] =
    "vxrun [-v] [--track T.trk] [--vehicle V.veh] [--contact-left L.ctab] [--contact-right R.ctab]\n"
    "      [--creep C.creep] [--set KEY=VALUE]... [--start STATE] [--save-state STATION] [-o OUT.run] CASE.yaml\n"
    "vxrun --schema | --master";

static struct {
    struct inputs_options in;
    const char *start, *out;
    double save;                 /* m; NAN where no state is wanted */
    int verbose, schema, master;
} opt = {.save = NAN};

static const struct cli_option options[] = {
    {.name = "track", .type = CLI_TEXT, .value = &opt.in.track},
    {.name = "vehicle", .type = CLI_TEXT, .value = &opt.in.vehicle},
    {.name = "contact-left", .type = CLI_TEXT, .value = &opt.in.left},
    {.name = "contact-right", .type = CLI_TEXT, .value = &opt.in.right},
    {.name = "creep", .type = CLI_TEXT, .value = &opt.in.creep},
    {.name = "set", .type = CLI_LIST, .value = &opt.in.set},
    {.name = "start", .type = CLI_TEXT, .value = &opt.start},
    {.name = "save-state", .type = CLI_NUM, .value = &opt.save, .lo = -1e9, .hi = 1e9},
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
    if (asks && (n || opt.in.track || opt.in.vehicle || opt.in.left || opt.in.right || opt.in.creep || opt.in.set.n || opt.out))
        cli_misuse("--%s stands alone", opt.schema ? "schema" : "master");
    if (!asks && !n)
        cli_misuse("the case is missing (-h shows the usage)");
    if (!isnan(opt.save) && !opt.out)
        cli_misuse("--save-state wants -o: the state goes beside the run");
    return asks ? NULL : operand[0];
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void show_progress(const struct passage *p)
{
    static int64_t shown, first;
    static double began;

    if (!shown) {
        shown = first = p->n - 1;
        began = seconds();
    }
    if ((p->n - shown) * 50 >= p->steps && isatty(STDERR_FILENO)) {
        shown = p->n;
        fprintf(stderr, "\r%s %3.0f %%  s = %.1f m  %.0f s left  %s", program.name, 100.0 * (double)p->n / (double)p->steps, p->station,
                (seconds() - began) * (double)(p->steps - p->n) / (double)(p->n - first), p->n == p->steps ? "\n" : "");
    }
}

/* The header goes out first, then blocks as they fill, then the extremes.  A passage that fails leaves its samples up to there. */
static void write_run(struct passage *p, const struct inputs *in, struct record *r, struct vxf_out *head, struct cli_out *out)
{
    struct vxf_stream stream;
    char reason_kept[256];
    const char *why = vxf_stream_begin(&stream, head, out->file), *failed = NULL;
    int full = opt.start ? 0 : record_step(r, p), saved = isnan(opt.save) || p->station > opt.save;

    for (; !why && p->n < p->steps; full = record_step(r, p)) {
        if (full) {
            why = vxf_stream_block(&stream, r->held, r->series);
            record_empty(r);
        }
        if (why || (failed = passage_step(p)))
            break;
        if (!saved && (saved = p->station >= opt.save))
            states_save(p, in, opt.out, NULL);
        show_progress(p);
    }
    record_end(r, p->n);
    if (!why)
        why = vxf_stream_block(&stream, r->held, r->series);
    if (!why && !failed)
        why = vxf_stream_end(&stream, (const void *const *)r->extreme);
    cli_check(opt.out ? opt.out : "standard output", why);
    if (failed) {
        snprintf(reason_kept, sizeof reason_kept, "%s", failed);
        states_leave(p, in, opt.out, reason_kept);
        cli_die("run: %s", reason_kept);
    }
}

static void describe(const struct inputs *in, struct record *r, struct vxf_out *head)
{
    static const char *const route[] = {"through", "diverging"};

    vxf_out_begin(head, "run");
    inputs_put(in, head);
    vxf_put_key(head, "CMD", "%s", cli_command());
    snprintf(r->run.name, sizeof r->run.name, "%s", in->text.name);
    snprintf(r->run.route, sizeof r->run.route, "%s", route[in->text.route]);
    run_put(&r->run, r->recorded, head);
}

/* first: steps done before this run. */
static void account(const struct passage *p, int64_t first, double begun, double started, double residual)
{
    struct rusage used;

    getrusage(RUSAGE_SELF, &used);
    const int64_t done = p->n - first;
    cli_note("%lld steps of %g s, limit %.3g s; at the start no body accelerates by more than %.1e g", (long long)done,
             p->o.step, p->limit, residual);
    cli_note("track %s, %lld degrees of freedom, %.2f rounds of forces a step: %s", p->rails.scheme == WAY_EXPLICIT ? "explicit" : "implicit",
             (long long)p->track->dofs, (double)p->rounds / (double)(done + 1), p->rails.because);
    if (!isnan(p->run_in.settled))
        cli_note("run-in: Q repeats from bay to bay from %.1f m on", p->run_in.settled);
    if (p->energy.counted) {
        double stored, lost, missing = energy_end(&p->energy, &p->rails, &stored, &lost);
        cli_note("wheels' work on the track %.6g J: lost %.6g, stored %.6g, missing %.1e of the loss", p->energy.work, lost, stored, missing);
    }
    cli_note("start %.3f s, passage %.3f s (%.2f us a step), peak memory %ld MB", started - begun, seconds() - started,
             1e6 * (seconds() - started) / (double)done, used.ru_maxrss / 1024);
}

int main(int argc, char **argv)
{
    static struct inputs in;
    static struct passage p;
    static struct record r;
    static struct exciter e;
    struct passage_options o;
    struct vxf state = {0};
    struct vxf_out head;
    struct cli_out out;
    double begun = seconds(), started, residual = 0;
    int64_t every, first;
    const char *path = parse(argc, argv);

    if (!path) {
        (opt.schema ? yaml_print_schema : yaml_print_master)(&case_text_schema, stdout);
        return cli_end();
    }
    inputs_read(&in, path, &opt.in);
    if (in.files == 1 && (opt.start || !isnan(opt.save)))
        cli_misuse("a state is of a train: --start and --save-state do not go with a prescribed force");
    if (opt.start) {
        cli_open(&state, opt.start, "state");
        cli_check(opt.start, vxf_number(&state, "START", &in.text.start));
    }
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
    if (opt.start)
        states_resume(&p, &in, opt.start, &state);
    else
        cli_check("start", passage_start(&p, &residual));
    cli_check("run", record_new(&r, &p, in.text.channels.group, every, in.text.filter));
    if (opt.verbose)
        cli_note("writes %.1f MB", 1e-6 * record_bytes(&r) * (double)((p.steps - p.n) / every + 1));
    describe(&in, &r, &head);
    first = p.n;
    started = seconds();
    cli_create_part(&out, opt.out);
    write_run(&p, &in, &r, &head, &out);
    cli_close(&out);
    if (opt.verbose)
        account(&p, first, begun, started, residual);
    vxf_out_free(&head);
    record_free(&r);
    passage_free(&p);
    exciter_free(&e);
    vxf_close(&state);
    inputs_release(&in);
    return cli_end();
}
