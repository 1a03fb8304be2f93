/* vxtransfer: the receptance of a track from a run with a prescribed force.
 *
 * In: a .run with force and probes.  Out: a .frf, motion of one probe over the force, with its coherence.
 * z down, H = motion over force for exp(+i omega t), SI units.  Method: H1 by averaged spectra (receptance/transfer.h).
 * Arrays read: time, force.F, probe.z, force.x, force.on, probe.x, probe.on, probe.held of run(5).  Arrays written: frf(5). */
#include "formats/frf.h"
#include "formats/run.h"
#include "tools/cli/cli.h"
#include "tools/receptance/transfer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "vxtransfer [--probe N] [--segment S] [--window none|hann] [--from HZ] [--to HZ] [--step HZ] [-o OUT.frf] FILE.run";

static struct {
    int64_t probe;
    double segment;                  /* s; 0 is the whole run */
    int window;
    struct sweep sweep;              /* Hz */
    const char *out;
} opt = {.probe = 1, .window = TRANSFER_NONE, .sweep = {10, 1500, 1}};

static const char *const windows[] = {"none", "hann", NULL};

static const struct cli_option options[] = {
    {.name = "probe", .type = CLI_INT, .value = &opt.probe, .lo = 1, .hi = 1e6},
    {.name = "segment", .type = CLI_NUM, .value = &opt.segment, .lo = 1e-6, .hi = 1e6},
    {.name = "window", .type = CLI_CHOICE, .value = &opt.window, .choice = windows},
    {.name = "from", .type = CLI_NUM, .value = &opt.sweep.from, .lo = 0, .hi = 1e6},
    {.name = "to", .type = CLI_NUM, .value = &opt.sweep.to, .lo = 0, .hi = 1e6},
    {.name = "step", .type = CLI_NUM, .value = &opt.sweep.step, .lo = 1e-6, .hi = 1e6},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxtransfer",
    .purpose = "Estimate the receptance of a track from a run with a prescribed force.",
    .usage = usage,
    .option = options,
};

static void name_place(struct frf_place *p, int64_t on, double x)
{
    static const char *const word[] = {[RUN_ON_LEFT] = "left", [RUN_ON_RIGHT] = "right", [RUN_ON_BOTH] = "both", [RUN_ON_SLEEPER] = "sleeper"};

    snprintf(p->on, sizeof p->on, "%s", word[on]);
    snprintf(p->at, sizeof p->at, "%s", on == RUN_ON_SLEEPER ? "sleeper" : "station");
    p->x = x;
}

/* Column `probe` of the deflections; the caller frees it. */
static double *take_probe(const struct run *r, int64_t probe)
{
    const double *all = r->channel[RUN_PROBE];
    double *z = calloc((size_t)r->records, sizeof *z);

    if (!z)
        cli_die(REASON_MEMORY);
    for (int64_t i = 0; i < r->records; i++)
        z[i] = all[i * r->probes + probe];
    return z;
}

/* The last record begins a period that the run does not have. */
static void estimate(struct frf *f, const struct run *r, const char *name)
{
    const int64_t probe = opt.probe - 1, n = r->records - 1;
    const double *time = r->channel[RUN_TIME];
    double *z = take_probe(r, probe);
    struct transfer t = {.n = n, .step = (time[n] - time[0]) / (double)n, .F = r->channel[RUN_FORCE], .z = z, .held = r->probe_held[probe],
                         .window = opt.window};

    t.segment = opt.segment > 0 ? (int64_t)rint(opt.segment / t.step) : n;
    memset(f, 0, sizeof *f);
    name_place(&f->force, *r->force_on, *r->force_x);
    name_place(&f->motion, r->probe_on[probe], r->probe_x[probe]);
    cli_check(name, transfer_estimate(f, &t, &opt.sweep));
    free(z);
    const int64_t wanted = (int64_t)floor((opt.sweep.to - opt.sweep.from) / opt.sweep.step + 1e-9) + 1;
    if (f->n < wanted)
        cli_note("%lld of %lld frequencies are left out, where the force has less than 1e-4 of its largest power: the rest are from %g to %g Hz",
                 (long long)(wanted - f->n), (long long)wanted, f->frequency[0], f->frequency[f->n - 1]);
}

int main(int argc, char **argv)
{
    struct vxf file;
    struct vxf_out o;
    struct run r;
    struct frf f;
    int n;
    char **path = cli_begin(&program, argc, argv, 1, 1, &n);

    if (opt.sweep.to < opt.sweep.from)
        cli_misuse("--to %g Hz lies below --from %g Hz", opt.sweep.to, opt.sweep.from);
    cli_open(&file, path[0], "run");
    cli_check(path[0], run_read(&r, &file));
    if (!r.forces || !r.channel[RUN_FORCE] || !r.channel[RUN_PROBE])
        cli_die("%s: a train ran here, and no prescribed force (force of the case)", path[0]);
    if (opt.probe > r.probes)
        cli_die("%s: --probe %lld: the run has %lld", path[0], (long long)opt.probe, (long long)r.probes);
    if (r.records < 3)
        cli_die("%s: %lld records, 3 at least are wanted", path[0], (long long)r.records);
    estimate(&f, &r, path[0]);
    vxf_out_begin(&o, "frf");
    vxf_put_input(&o, &file);
    cli_check(path[0], frf_put(&f, &o));
    cli_write(&o, opt.out);
    vxf_out_free(&o);
    frf_free(&f);
    vxf_close(&file);
    return cli_end();
}
