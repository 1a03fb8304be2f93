/* vxrun: one train through one track.
 *
 * In: a case (YAML), a track (.trk), a vehicle (.veh), contact tables of both sides (.ctab), perhaps creep forces (.creep).  Out: a .run, written while
 * the train runs and renamed when it is complete.  Axes: x forward, y to the right, z down; forces are those of the wheel on the rail.
 * Method: integrate/passage.h, integrate/way.h.  Arrays read: all of the inputs.  Arrays written: run(5). */
#include "tools/cli/batch.h"
#include "tools/cli/inputs.h"
#include "tools/cli/progress.h"
#include "tools/integrate/facing.h"
#include "tools/integrate/options.h"
#include "tools/integrate/record.h"
#include "tools/integrate/start.h"
#include "tools/integrate/state_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static const char usage[] =
    "vxrun [-v] [--track T.trk] [--vehicle V.veh] [--contact-left L.ctab] [--contact-right R.ctab]\n"
    "      [--creep C.creep] [--set KEY=VALUE]... [--start STATE] [--save-state STATION] [-o OUT.run] CASE.yaml\n"
    "vxrun --batch FILE [--jobs N] [OPTION]... CASE.yaml\n"
    "vxrun --schema | --master";

static struct {
    struct inputs_options in;
    const char *start, *out, *batch;
    double save;                 /* m; NAN where no state is wanted */
    int64_t jobs;
    int verbose, schema, master;
} opt;

static const struct cli_option options[] = {
    {.name = "track", .type = CLI_TEXT, .value = &opt.in.track},
    {.name = "vehicle", .type = CLI_TEXT, .value = &opt.in.vehicle},
    {.name = "contact-left", .type = CLI_TEXT, .value = &opt.in.left},
    {.name = "contact-right", .type = CLI_TEXT, .value = &opt.in.right},
    {.name = "creep", .type = CLI_TEXT, .value = &opt.in.creep},
    {.name = "set", .type = CLI_LIST, .value = &opt.in.set},
    {.name = "start", .type = CLI_TEXT, .value = &opt.start},
    {.name = "save-state", .type = CLI_NUM, .value = &opt.save, .lo = -1e9, .hi = 1e9},
    {.name = "batch", .type = CLI_TEXT, .value = &opt.batch},
    {.name = "jobs", .type = CLI_INT, .value = &opt.jobs, .lo = 1, .hi = 64},
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

/* The case, or NULL where the schema or the master file is asked for. */
static const char *parse(int argc, char **argv)
{
    int n, asks;
    char **operand;

    memset(&opt, 0, sizeof opt);
    opt.save = NAN;
    operand = cli_begin(&program, argc, argv, 0, 1, &n);
    asks = opt.schema + opt.master;
    if (asks > 1)
        cli_misuse("--schema and --master exclude each other");
    if (!opt.batch || asks)
        cli_form(&program, asks ? 2 : 0, opt.schema ? "--schema" : opt.master ? "--master" : "a run");
    if (opt.batch && opt.out)
        cli_misuse("--batch: every line names its own -o");
    if ((n == 0) != asks)
        cli_misuse(asks ? "--schema and --master stand alone" : "the case is missing (-h shows the usage)");
    if (!isnan(opt.save) && !opt.out && !opt.batch)
        cli_misuse("--save-state wants -o: the state goes beside the run");
    return asks ? NULL : operand[0];
}

static struct state_file_origin origin(const struct inputs *in)
{
    return (struct state_file_origin){vxf_content(&in->file[INPUT_VEHICLE]), {vxf_content(&in->file[INPUT_LEFT]), vxf_content(&in->file[INPUT_RIGHT])},
                                      in->hash, &in->file[INPUT_TRACK]};
}

/* Into the .state beside the .run. */
static void save_state(struct passage *p, const struct inputs *in, const char *failed)
{
    const size_t n = strlen(opt.out), end = n > 4 && strcmp(opt.out + n - 4, ".run") == 0 ? n - 4 : n;
    const struct state_file_origin from = origin(in);
    char *path = calloc(end + sizeof ".state", 1);
    double *rest = NULL;
    struct vxf_out o;

    if (!path)
        cli_die(REASON_MEMORY);
    snprintf(path, end + sizeof ".state", "%.*s.state", (int)end, opt.out);
    vxf_out_begin(&o, "state");
    inputs_put(in, &o);
    cli_check(path, state_file_put(p, &from, failed, &o, &rest));
    cli_write(&o, path);
    vxf_out_free(&o);
    free(rest);
    free(path);
}

/* What differs is told; what must not, refused. */
static void resume(struct passage *p, const struct inputs *in, const struct vxf *file)
{
    const struct state_file_origin from = origin(in);
    struct state_difference differs[STATE_DIFFERENCES];
    struct state s;
    int n;

    cli_check(opt.start, state_file_resume(p, &from, file, &s, differs, &n));
    for (int k = 0; k < n; k++)
        cli_note("%s of the track differs from %.2f to %.2f m, beyond the state's reach from %.2f to %.2f m", differs[k].name,
                 differs[k].from, differs[k].to, s.reach[0], s.reach[1]);
    for (int side = 0; side < 2; side++)
        if (s.contact[side] != from.contact[side])
            cli_note("the %s contact table is not that of the state", side ? "right" : "left");
    if (s.text != from.text)
        cli_note("the case is not that of the state");
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static struct progress progress = {seconds, 0, 0, 0, 0};

/* The header goes out first, then blocks as they fill, then the extremes.  A passage that fails leaves its samples up to there. */
static void write_run(struct passage *p, const struct inputs *in, struct record *r, struct vxf_out *head, struct cli_out *out)
{
    struct vxf_stream stream;
    char reason_kept[256];
    const char *why = vxf_stream_begin(&stream, head, out->file), *failed = NULL;
    int full = opt.start ? 0 : record_step(r, p), saved = isnan(opt.save) || p->station > facing_station(p, opt.save);

    for (; !why && p->n < p->steps; full = record_step(r, p)) {
        if (full) {
            why = vxf_stream_block(&stream, r->held, r->series);
            record_empty(r);
        }
        if (why || (failed = passage_step(p)))
            break;
        if (!saved && (saved = p->station >= facing_station(p, opt.save)))
            save_state(p, in, NULL);
        progress_show(&progress, p->n, p->steps, "s", facing_station(p, p->station), "m");
    }
    record_end(r, p->n);
    if (!why)
        why = vxf_stream_block(&stream, r->held, r->series);
    if (!why && !failed)
        why = vxf_stream_end(&stream, (const void *const *)r->extremes.of);
    cli_check(opt.out ? opt.out : "standard output", why);
    if (failed) {
        snprintf(reason_kept, sizeof reason_kept, "%s", failed);
        if (opt.out && inputs_have_train(in) && state_file_is_finite(p))      /* for a post-mortem */
            save_state(p, in, reason_kept);
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
        cli_note("run-in: Q repeats from bay to bay from %.1f m on", facing_station(p, p->run_in.settled));
    if (p->energy.counted) {
        double work, stored, lost, missing = energy_end(&p->energy, &p->rails, &work, &stored, &lost);
        cli_note("wheels' work on the track %.6g J: lost %.6g, stored %.6g, missing %.1e of the loss", work, lost, stored, missing);
    }
    cli_note("start %.3f s, passage %.3f s (%.2f us a step), peak memory %ld MB", started - begun, seconds() - started,
             1e6 * (seconds() - started) / (double)done, used.ru_maxrss / 1024);
}

/* The passage of the command as parsed.  What `kept`, or NULL, has read already is taken from there. */
static void run(const char *path, const struct inputs *kept)
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

    inputs_read(&in, path, &opt.in, kept);
    if (!inputs_have_train(&in) && (opt.start || !isnan(opt.save)))
        cli_misuse("a state is of a train: --start and --save-state do not go with a prescribed force");
    if (opt.start) {
        cli_open(&state, opt.start, "state");
        cli_check(opt.start, vxf_number(&state, "START", &in.text.start));
    }
    cli_check("case", options_read(&o, &in.text, in.text.speed / 3.6, in.text.irregularity.file ? &in.measured : NULL));
    if (inputs_have_creep(&in))
        cli_check("case", options_creep(&o, &in.creep, in.table));
    if (in.text.force.amplitude > 0) {
        cli_check("case", options_exciter(&e, &in.text, &in.track));
        o.exciter = &e;
    }
    cli_check("case", options_sampling(&in.text, &every));
    o.account = opt.verbose && !o.exciter;
    cli_check("case", passage_new(&p, &o, &in.track, &in.vehicle, &in.table[0], &in.table[1]));
    if (opt.start)
        resume(&p, &in, &state);
    else
        cli_check("start", passage_start(&p, &residual));
    if (!isnan(opt.save) && !(facing_station(&p, opt.save) > p.station && facing_station(&p, opt.save) <= p.o.end))
        cli_die("--save-state: %g m is not on the way from %g to %g m", opt.save, facing_station(&p, p.station), facing_station(&p, p.o.end));
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
}

/* In the child of a line, its command and then its passage; in the parent whether all went well. */
static int run_batch(const char *path, int argc, char **argv)
{
    static const char *const own[] = {"--batch", "--jobs", NULL};
    static struct inputs kept;
    struct batch batch;
    int failed, n, operand = argc - 1;

    batch_read(&batch, opt.batch);
    inputs_read(&kept, path, &opt.in, NULL);
    const struct batch_line *line = batch_run(&batch, opt.jobs ? opt.jobs : 1, &failed);
    if (line) {
        char **words = batch_command(line, argc, argv, operand, own, &n);
        path = parse(n, words);
        if (!path || opt.batch)
            cli_misuse("%s: line %ld: asks for more than a run", batch.path, line->number);
        progress.quiet = 1;
        run(path, &kept);
        free(words);
    }
    batch_free(&batch);
    if (!line)
        inputs_release(&kept);
    return !line && failed > 0;
}

int main(int argc, char **argv)
{
    const char *path = parse(argc, argv);
    int failed = 0;

    if (!path)
        (opt.schema ? yaml_print_schema : yaml_print_master)(&case_text_schema, stdout);
    else if (opt.batch)
        failed = run_batch(path, argc, argv);
    else
        run(path, NULL);
    const int status = cli_end();
    return failed ? EXIT_FAILURE : status;
}
