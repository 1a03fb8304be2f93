/* vxcreep: creep force of a wheel on a rail: one evaluation, the table of the fast path, and how far that lies from a theory.
 *
 * In: options, the contact ellipse, its load and its creepages; a .creep file.  Out: text, a line of names and units and a line of Fx, Fy,
 * Mz; or a .creep file.  FASTSIM after Kalker 1982, the exact theory after Kalker 1990 and Vollebregt 1995.  x forward, y lateral along the
 * contact plane, z into the rail; forces of the wheel on the rail.  Arrays read and written: creep(5). */
#include "tools/cli/cli.h"

#include <math.h>

#include "tools/creep/compare.h"
#include "tools/creep/exact.h"
#include "tools/creep/fastsim.h"
#include "tools/creep/table.h"
#include "tools/creep/tabulate.h"

static const char usage[] =
    "vxcreep --a M --b M --N N --mu X --xi X --eta X --phi RADPM [--shear PA] [--poisson X] [--grid N]\n"
    "        [--method fastsim|exact|table] [FILE.creep]\n"
    "vxcreep --table [--method fastsim|exact] [--grid N] [--poisson X] [-o FILE.creep]\n"
    "vxcreep --check N [--seed N] [--method fastsim|exact] [--grid N] FILE.creep";

enum { METHOD_TABLE = CREEP_THEORIES, METHODS };
static const char *const methods[] = {"fastsim", "exact", "table", NULL};

static struct {
    double a, b, N, mu, xi, eta, phi;           /* NAN: not given */
    double shear, poisson;
    int64_t grid, check, seed;                  /* grid 0: not given */
    int method, table;
    const char *out;
} opt = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, .shear = 82e9, .poisson = 0.28, .seed = 1};

static const struct cli_option options[] = {
    {.name = "a", .letter = 1, .type = CLI_NUM, .value = &opt.a, .lo = 1e-6, .hi = 1},
    {.name = "b", .letter = 1, .type = CLI_NUM, .value = &opt.b, .lo = 1e-6, .hi = 1},
    {.name = "N", .letter = 1, .type = CLI_NUM, .value = &opt.N, .lo = 0, .hi = 1e9},
    {.name = "mu", .type = CLI_NUM, .value = &opt.mu, .lo = 0, .hi = 10},
    {.name = "xi", .type = CLI_NUM, .value = &opt.xi, .lo = -10, .hi = 10},
    {.name = "eta", .type = CLI_NUM, .value = &opt.eta, .lo = -10, .hi = 10},
    {.name = "phi", .type = CLI_NUM, .value = &opt.phi, .lo = -1e4, .hi = 1e4},
    {.name = "shear", .type = CLI_NUM, .value = &opt.shear, .lo = 1e6, .hi = 1e13},
    {.name = "poisson", .type = CLI_NUM, .value = &opt.poisson, .lo = 0, .hi = 0.5},
    {.name = "grid", .type = CLI_INT, .value = &opt.grid, .lo = 1, .hi = FASTSIM_MOST},
    {.name = "method", .type = CLI_CHOICE, .value = &opt.method, .choice = methods},
    {.name = "table", .type = CLI_FLAG, .value = &opt.table},
    {.name = "check", .type = CLI_INT, .value = &opt.check, .lo = 1, .hi = 1e9},
    {.name = "seed", .type = CLI_INT, .value = &opt.seed, .lo = 0, .hi = 1e15},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxcreep",
    .purpose = "Evaluate or tabulate the creep force of a wheel on a rail.",
    .usage = usage,
    .option = options,
};

/* A force, where neither a table nor a check is asked for, needs all options that begin as NAN. */
static void parse_contact(void)
{
    int given = 0, missing = 0;
    const char *first = NULL;

    for (const struct cli_option *o = options; o->name; o++)
        if (o->type == CLI_NUM && o->value != &opt.shear && o->value != &opt.poisson) {
            int absent = isnan(*(const double *)o->value);
            given += !absent;
            missing += absent;
            if (absent && !first)
                first = o->name;
        }
    if (!opt.table && !opt.check && missing)
        cli_misuse("--%s is missing", first);
    if ((opt.table || opt.check) && given)
        cli_misuse("--%s takes no contact", opt.table ? "table" : "check");
}

/* The operand, or NULL. */
static const char *parse(int argc, char **argv)
{
    static const int grids[] = {10, 15}, fine[] = {50, 12};
    int n;
    char **operand = cli_begin(&program, argc, argv, 0, 1, &n);

    if (opt.table && opt.check)
        cli_misuse("--table and --check exclude each other");
    cli_form(&program, opt.table ? 1 : opt.check ? 2 : 0, opt.table ? "--table" : opt.check ? "--check" : "a force");
    parse_contact();
    if (opt.method == METHOD_TABLE && (opt.table || opt.check || opt.grid))
        cli_misuse("--method table is for a force, without --grid");
    if (n != (opt.check || opt.method == METHOD_TABLE))
        cli_misuse(n ? "no file is read here" : "FILE.creep is missing");
    if (!opt.grid && opt.method != METHOD_TABLE)
        opt.grid = (opt.table || opt.check ? fine : grids)[opt.method];
    if (opt.method == CREEP_EXACT && (opt.grid < 2 || opt.grid > EXACT_MOST))
        cli_misuse("--grid of the exact theory goes from 2 to %d", EXACT_MOST);
    return n ? operand[0] : NULL;
}

static void read_table(struct creep *t, struct vxf *f, const char *path)
{
    cli_open(f, path, "creep");
    cli_check(path, creep_read(t, f));
}

static void find_exact(double force[3])
{
    double c = sqrt(opt.a*opt.b), most = opt.mu*opt.N, k = opt.shear*c*c/most;
    struct exact e;

    force[0] = force[1] = force[2] = 0;
    if (most <= 0)
        return;
    cli_check("exact theory", exact_begin(&e, (int)opt.grid, opt.a/opt.b, opt.poisson));
    if (!exact_force(&e, (const double[]){k*opt.xi, k*opt.eta, k*c*opt.phi}, force))
        cli_die("the exact theory does not come to rest");
    exact_free(&e);
    force[0] *= most;
    force[1] *= most;
    force[2] *= most*c;
}

static void print_force(const char *path)
{
    static struct fastsim f;
    struct vxf file;
    struct creep t;
    double force[3];

    if (opt.method == METHOD_TABLE) {
        read_table(&t, &file, path);
        creep_table(&t, opt.a, opt.b, opt.N, opt.mu, opt.shear, opt.poisson, opt.xi, opt.eta, opt.phi, force);
        vxf_close(&file);
    } else if (opt.method == CREEP_EXACT) {
        find_exact(force);
    } else {
        fastsim_begin(&f, (int)opt.grid);
        fastsim(&f, opt.a, opt.b, opt.N, opt.mu, opt.shear, opt.poisson, opt.xi, opt.eta, opt.phi, force);
    }
    printf("Fx[N]\tFy[N]\tMz[N.m]\n");
    printf("%.9g\t%.9g\t%.9g\n", force[0], force[1], force[2]);
}

static void write_table(void)
{
    struct vxf_out head;
    struct creep t;

    cli_check("table", tabulate(&t, opt.method == CREEP_EXACT ? CREEP_EXACT : CREEP_FASTSIM, (int)opt.grid, opt.poisson));
    vxf_out_begin(&head, "creep");
    cli_check("table", creep_put(&t, &head));
    cli_write(&head, opt.out);
    vxf_out_free(&head);
    creep_free(&t);
}

static void print_check(const char *path)
{
    struct vxf file;
    struct creep t;
    struct creep_difference d;

    read_table(&t, &file, path);
    cli_check(path, creep_compare(&t, opt.method == CREEP_EXACT ? CREEP_EXACT : CREEP_FASTSIM, (int)opt.grid, opt.check, (uint64_t)opt.seed, &d));
    printf("contacts\trms[mu N]\tmost[mu N]\ta/b\txi\teta\tphi\n");
    printf("%lld\t%.5f\t%.5f\t%.4g\t%.4g\t%.4g\t%.4g\n", (long long)opt.check, d.rms, d.most, d.ratio, d.creep[0], d.creep[1], d.creep[2]);
    vxf_close(&file);
}

int main(int argc, char **argv)
{
    const char *path = parse(argc, argv);

    if (opt.table)
        write_table();
    else if (opt.check)
        print_check(path);
    else
        print_force(path);
    return cli_end();
}
