/* vxpost: the numbers of a passage, as CSV.
 *
 * In: a .run.  Out: a table with a header line of names and units: extremes over every step by zone of the railpads, by sleeper or by
 * wheel, or the balance of wheel forces against weight and accelerations.  Forces are those of the wheel on the rail, z down.
 * Arrays read: see run(5). */
#include "formats/run.h"
#include "tools/cli/cli.h"
#include "tools/post/balance.h"
#include "tools/post/zones.h"

#include <math.h>
#include <stdlib.h>

static const char usage[] = "vxpost [--table | --sleepers | --wheels] [-o OUT.csv] FILE.run\n"
                            "vxpost --balance [--from M] [--to M] [-o OUT.csv] FILE.run";

static struct {
    int table, sleepers, wheels, balance;
    double from, to; /* m */
    const char *out;
} opt = {.from = -HUGE_VAL, .to = HUGE_VAL};

static const struct cli_option options[] = {
    {.name = "table", .type = CLI_FLAG, .value = &opt.table},
    {.name = "sleepers", .type = CLI_FLAG, .value = &opt.sleepers},
    {.name = "wheels", .type = CLI_FLAG, .value = &opt.wheels},
    {.name = "balance", .type = CLI_FLAG, .value = &opt.balance},
    {.name = "from", .type = CLI_NUM, .value = &opt.from, .lo = -1e6, .hi = 1e6},
    {.name = "to", .type = CLI_NUM, .value = &opt.to, .lo = -1e6, .hi = 1e6},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxpost",
    .purpose = "Print extremes or the balance of a passage as CSV.",
    .usage = usage,
    .option = options,
};

static void print_extreme(FILE *f, const struct zone_extreme *e)
{
    fprintf(f, ",%.9g,%lld", e->value, (long long)e->sleeper);
}

static void print_zones(const struct run *r, const char *name, FILE *f)
{
    struct zone *zone = calloc((size_t)r->zones + 1, sizeof *zone);

    if (!zone)
        cli_die(REASON_MEMORY);
    cli_check(name, zones_find(r, zone));
    fputs("zone,name,seats,Q (N),Q at sleeper,Y (N),Y at sleeper,pad force (N),pad force at sleeper,pad compression (m),"
          "pad compression at sleeper,ballast force (N),ballast force at sleeper\n", f);
    for (int64_t i = 0; i <= r->zones; i++) {
        fprintf(f, "%lld,%s,%lld", (long long)i, zone[i].name, (long long)zone[i].sleepers);
        print_extreme(f, &zone[i].Q);
        print_extreme(f, &zone[i].Y);
        print_extreme(f, &zone[i].pad);
        print_extreme(f, &zone[i].compression);
        print_extreme(f, &zone[i].ballast);
        fputc('\n', f);
    }
    free(zone);
}

static void print_sleepers(const struct run *r, FILE *f)
{
    int64_t n = r->sleepers;

    fputs("sleeper,station (m),Q left (N),Q right (N),pad force left (N),pad force right (N),pad compression left (m),"
          "pad compression right (m),ballast left (N),ballast middle (N),ballast right (N),acceleration (m/s2)\n", f);
    for (int64_t i = 0; i < n; i++)
        fprintf(f, "%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", (long long)r->sleeper_number[i],
                r->sleeper_x[i], r->extreme[RUN_SLEEPER_MAX_Q][i], r->extreme[RUN_SLEEPER_MAX_Q][n + i],
                r->extreme[RUN_MAX_PAD][i], r->extreme[RUN_MAX_PAD][n + i], r->extreme[RUN_MAX_PAD_COMPRESSION][i],
                r->extreme[RUN_MAX_PAD_COMPRESSION][n + i], r->extreme[RUN_MAX_BALLAST][i],
                r->extreme[RUN_MAX_BALLAST][n + i], r->extreme[RUN_MAX_BALLAST][2 * n + i],
                r->extreme[RUN_MAX_SLEEPER_A][i]);
}

static void print_wheels(const struct run *r, FILE *f)
{
    fputs("wheelset,side,static Q (N),largest Q (N),at station (m),smallest Q (N),largest Y (N)\n", f);
    for (int64_t k = 0; k < 2 * r->wheelsets; k++)
        fprintf(f, "%lld,%c,%.9g,%.9g,%.9g,%.9g,%.9g\n", (long long)(k / 2 + 1), k % 2 ? 'r' : 'l', r->static_q[k],
                r->extreme[RUN_MAX_Q][k], r->extreme[RUN_AT_MAX_Q][k], r->extreme[RUN_MIN_Q][k],
                r->extreme[RUN_MAX_Y][k]);
}

static void print_balance(const struct run *r, const char *name, FILE *f)
{
    struct balance b;

    cli_check(name, balance_find(r, opt.from, opt.to, &b));
    fputs("quantity,value,unit\n", f);
    fprintf(f, "samples,%lld,1\n", (long long)b.samples);
    fprintf(f, "weight,%.9g,N\n", b.weight);
    fprintf(f, "largest vertical residual over weight,%.3g,1\n", b.vertical / b.weight);
    fprintf(f, "largest lateral residual over weight,%.3g,1\n", b.lateral / b.weight);
    fprintf(f, "largest roll residual over weight,%.3g,m\n", b.roll / b.weight);
    fprintf(f, "mean sum of Q left,%.9g,N\n", b.mean_q[0]);
    fprintf(f, "mean sum of Q right,%.9g,N\n", b.mean_q[1]);
    fprintf(f, "mean load moved to the left,%.9g,N\n", b.transfer);
    fprintf(f, "the same from the moments of the bodies,%.9g,N\n", b.expected);
    fprintf(f, "mean sum of Y,%.9g,N\n", b.mean_y);
}

int main(int argc, char **argv)
{
    struct vxf file;
    struct run r;
    struct cli_out out;
    int n;
    char **path = cli_begin(&program, argc, argv, 1, 1, &n);

    if (opt.table + opt.sleepers + opt.wheels + opt.balance > 1)
        cli_misuse("--table, --sleepers, --wheels and --balance exclude each other");
    if (!opt.balance && (isfinite(opt.from) || isfinite(opt.to)))
        cli_misuse("--from and --to go with --balance");
    cli_open(&file, path[0], "run");
    cli_check(path[0], run_read(&r, &file));
    if ((opt.sleepers || opt.wheels) && !r.complete)
        cli_die("%s: the run is not complete, so its extremes are missing", path[0]);
    cli_create(&out, opt.out, 0);
    if (opt.balance)
        print_balance(&r, path[0], out.file);
    else if (opt.sleepers)
        print_sleepers(&r, out.file);
    else if (opt.wheels)
        print_wheels(&r, out.file);
    else
        print_zones(&r, path[0], out.file);
    cli_close(&out);
    vxf_close(&file);
    return cli_end();
}
