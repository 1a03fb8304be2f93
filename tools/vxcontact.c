/* vxcontact: where and how hard a wheel can touch its rails.
 *
 * In: .prof of one wheel and one rail, or .ctab.  Out: .ctab, ctab(5), or text: a patch, contacts of a wheel at one place, along the track
 * or over the displacement, of a wheelset at rest, rolling radius difference, equivalent conicity.  Or the cache of tables is looked after.
 * Rigid contacts of a surface of revolution (contact locus) or of a profile turned after Lau (thesis.h); patches of Hertz or of ANALYN;
 * Klingel's motion after EN 15302.  x forward, y to the right, z down, SI units. */
#include "tools/cli/cache.h"
#include "tools/cli/cli.h"
#include "tools/cli/table.h"

#include "formats/ctab.h"
#include "formats/prof.h"
#include "tools/contact/report.h"
#include "tools/contact/spot.h"
#include "tools/contact/sweep.h"
#include "tools/contact/table.h"

enum { AMPLITUDES = 100 };

static const char usage[] =
    "vxcontact --wheel FILE --rail FILE --yaw none|thesis|exact [--u-max M] [--u-step M]\n"
    "          [--yaw-max RAD] [--yaws N] [--shear-modulus PA] [--poisson NU]\n"
    "          [--normal hertz|strip] [--load N] [-o FILE]\n"
    "vxcontact --patch u=M,load=N[,yaw=RAD][,s=M] --wheel FILE --rail FILE [--shear-modulus PA] [--poisson NU]\n"
    "vxcontact --query u=M[,yaw=RAD][,s=M][,roll=RAD] TABLE\n"
    "vxcontact --path u=M,from=M,to=M,step=M[,yaw=RAD][,roll=RAD] TABLE\n"
    "vxcontact --sweep yaw=RAD[,s=M] TABLE...\n"
    "vxcontact --wheelset y=M[,yaw=RAD][,s=M][,load=N] [--no-roll] LEFT RIGHT\n"
    "vxcontact --conicity M[,M]... [--no-roll] LEFT RIGHT\n"
    "vxcontact --rolling-radius [--no-roll] LEFT RIGHT\n"
    "vxcontact --cache-list | --cache-verify | --cache-prune days=N[,size=GB]";

static const char *const yaw_methods[] = {"none", "thesis", "exact", NULL};
static const char *const normal_laws[] = {"hertz", "strip", NULL};

static struct {
    const char *wheel, *rail, *patch, *query, *path, *sweep, *wheelset, *conicity, *out;
    int yaw, rolling_radius, no_roll, amplitudes;
    double amplitude[AMPLITUDES];    /* m, of --conicity */
    struct table_grid grid;
    struct cli_cache_care cache;
} opt = {
    .yaw = -1,
    .grid = {.u_max = 0.012, .u_step = 1e-4, .shear_modulus = 82e9, .poisson = 0.28, .load = TABLE_LOAD},
};

static const struct cli_option options[] = {
    {.name = "wheel", .type = CLI_TEXT, .value = &opt.wheel},
    {.name = "rail", .type = CLI_TEXT, .value = &opt.rail},
    {.name = "yaw", .type = CLI_CHOICE, .value = &opt.yaw, .choice = yaw_methods},
    {.name = "u-max", .type = CLI_NUM, .value = &opt.grid.u_max, .lo = 1e-3, .hi = 0.05},
    {.name = "u-step", .type = CLI_NUM, .value = &opt.grid.u_step, .lo = 1e-5, .hi = 1e-3},
    {.name = "yaw-max", .type = CLI_NUM, .value = &opt.grid.yaw_max, .lo = 1e-4, .hi = 0.1},
    {.name = "yaws", .type = CLI_INT, .value = &opt.grid.yaws, .lo = 2, .hi = 401},
    {.name = "shear-modulus", .type = CLI_NUM, .value = &opt.grid.shear_modulus, .lo = 1e6, .hi = 1e13},
    {.name = "poisson", .type = CLI_NUM, .value = &opt.grid.poisson, .lo = 0, .hi = 0.5},
    {.name = "normal", .type = CLI_CHOICE, .value = &opt.grid.normal, .choice = normal_laws},
    {.name = "load", .type = CLI_NUM, .value = &opt.grid.load, .lo = 1e2, .hi = 1e6},
    {.name = "patch", .type = CLI_TEXT, .value = &opt.patch},
    {.name = "query", .type = CLI_TEXT, .value = &opt.query},
    {.name = "path", .type = CLI_TEXT, .value = &opt.path},
    {.name = "sweep", .type = CLI_TEXT, .value = &opt.sweep},
    {.name = "wheelset", .type = CLI_TEXT, .value = &opt.wheelset},
    {.name = "conicity", .type = CLI_TEXT, .value = &opt.conicity},
    {.name = "rolling-radius", .type = CLI_FLAG, .value = &opt.rolling_radius},
    {.name = "no-roll", .type = CLI_FLAG, .value = &opt.no_roll},
    {.name = "cache-list", .type = CLI_FLAG, .value = &opt.cache.list},
    {.name = "cache-verify", .type = CLI_FLAG, .value = &opt.cache.verify},
    {.name = "cache-prune", .type = CLI_TEXT, .value = &opt.cache.prune},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxcontact",
    .purpose = "Compute the contacts of wheel and rail.",
    .usage = usage,
    .option = options,
};

static const struct report_printer printer = {cli_header, cli_row};

/* Exactly one of the forms of the usage. */
static char **parse(int argc, char **argv)
{
    int n, build, care, forms;
    char **operand = cli_begin(&program, argc, argv, 0, SWEEP_TABLES, &n);

    build = !opt.patch && (opt.wheel || opt.rail || opt.yaw >= 0);
    care = opt.cache.list + opt.cache.verify + !!opt.cache.prune;
    forms = build + care + !!opt.patch + !!opt.query + !!opt.path + !!opt.sweep + !!opt.wheelset + !!opt.conicity + opt.rolling_radius;
    if (forms != 1)
        cli_misuse("give either --wheel, --rail and --yaw, or one of --patch, --query, --path, --sweep, --wheelset, --conicity, --rolling-radius, --cache-...");
    if (opt.patch && !(opt.wheel && opt.rail && opt.yaw < 0))
        cli_misuse("--patch needs --wheel and --rail, and takes its yaw as an item");
    if (build && !(opt.wheel && opt.rail && opt.yaw >= 0))
        cli_misuse("--wheel, --rail and --yaw must all be given");
    if (!build && opt.out)
        cli_misuse("-o is for a new table");
    if (opt.no_roll && (build || opt.query || opt.path || opt.sweep || care))
        cli_misuse("--no-roll is for a wheelset");
    if (opt.sweep ? n == 0 : n != (build || care || opt.patch ? 0 : opt.query || opt.path ? 1 : 2))
        cli_misuse("%d operands, must be %s", n,
                   build || care || opt.patch ? "none" : opt.sweep ? "one table or more" : opt.query || opt.path ? "one table" : "a left and a right table");
    if (opt.conicity)
        opt.amplitudes = cli_numbers("conicity", opt.conicity, 1e-6, 0.05, opt.amplitude, AMPLITUDES);
    return operand;
}

static void open_table(struct vxf *f, struct ctab *t, const char *path, char side)
{
    cli_open(f, path, "ctab");
    cli_check(path, ctab_read(t, f));
    if (side && t->side != side)
        cli_die("%s: is of side %c, must be %c", path, t->side, side);
}

static void open_prof(struct vxf *f, struct prof *p, const char *path)
{
    cli_open(f, path, "prof");
    cli_check(path, prof_read(p, f));
}

static void print_patch(void)
{
    struct spot_place at = {.shear_modulus = opt.grid.shear_modulus, .poisson = opt.grid.poisson};
    const struct cli_item item[] = {{"u", &at.u, -0.05, 0.05, 1}, {"load", &at.load, 1, 1e7, 1}, {"yaw", &at.yaw, -0.1, 0.1, 0}, {"s", &at.s, -1e5, 1e5, 0}};
    static struct spot spot;
    struct vxf wheel_file, rail_file;
    struct prof wheel, rail;

    cli_items("patch", opt.patch, item, 4);
    open_prof(&wheel_file, &wheel, opt.wheel);
    open_prof(&rail_file, &rail, opt.rail);
    cli_check(opt.rail, spot_find(&wheel, &rail, &at, &spot));
    spot_report(&spot, at.load, &printer);
    prof_free(&wheel);
    prof_free(&rail);
    vxf_close(&wheel_file);
    vxf_close(&rail_file);
}

static void build_table(void)
{
    struct cli_cache cache;
    struct vxf wheel_file, rail_file;
    struct prof wheel, rail;
    struct ctab t;
    struct vxf_out o;

    open_prof(&wheel_file, &wheel, opt.wheel);
    open_prof(&rail_file, &rail, opt.rail);
    if (!cli_cache_find(&cache, options, TABLE_REVISION, &wheel_file, &rail_file, &t)) {
        cli_check(opt.rail, table_fill(&t, &wheel, &rail, opt.yaw, &opt.grid));
        cli_cache_keep(&cache, &t);
    }
    vxf_out_begin(&o, "ctab");
    vxf_put_input(&o, &wheel_file);
    vxf_put_input(&o, &rail_file);
    vxf_put_key(&o, "REVISION", "%d", TABLE_REVISION);
    cli_check("contact table", ctab_put(&t, &o));
    cli_write(&o, opt.out);
    vxf_out_free(&o);
    ctab_free(&t);
    vxf_close(&cache.entry);
    prof_free(&wheel);
    prof_free(&rail);
    vxf_close(&wheel_file);
    vxf_close(&rail_file);
}

static void print_query(const char *path)
{
    double u = 0, yaw = 0, s = 0, roll = 0;
    const struct cli_item item[] = {{"u", &u, -1, 1, 1}, {"yaw", &yaw, -0.1, 0.1, 0}, {"s", &s, -1e5, 1e5, 0}, {"roll", &roll, -0.1, 0.1, 0}};
    struct vxf f;
    struct ctab t;

    cli_items("query", opt.query, item, 4);
    open_table(&f, &t, path, 0);
    cli_check(path, report_query(&t, s, yaw, u, roll, &printer));
    vxf_close(&f);
}

static void print_path(const char *path)
{
    double u = 0, from = 0, to = 0, step = 0, yaw = 0, roll = 0;
    const struct cli_item item[] = {{"u", &u, -1, 1, 1}, {"from", &from, -1e5, 1e5, 1}, {"to", &to, -1e5, 1e5, 1}, {"step", &step, 1e-5, 1e5, 1},
                                    {"yaw", &yaw, -0.1, 0.1, 0}, {"roll", &roll, -0.1, 0.1, 0}};
    struct vxf f;
    struct ctab t;

    cli_items("path", opt.path, item, 6);
    open_table(&f, &t, path, 0);
    cli_check(path, report_path(&t, from, to, step, yaw, u, roll, &printer));
    vxf_close(&f);
}

static void print_sweep(char **path)
{
    double yaw = 0, s = 0;
    const struct cli_item item[] = {{"yaw", &yaw, -0.1, 0.1, 1}, {"s", &s, -1e5, 1e5, 0}};
    struct vxf f[SWEEP_TABLES];
    struct ctab t[SWEEP_TABLES];
    int n = 0;

    cli_items("sweep", opt.sweep, item, 2);
    for (; path[n]; n++)
        open_table(&f[n], &t[n], path[n], n ? t[0].side : 0);
    cli_check("sweep", report_sweep(t, n, s, yaw, &printer));
    while (n > 0)
        vxf_close(&f[--n]);
}

static void print_pair(char **path)
{
    double y = 0, load = 0;
    struct ctab t[2];
    struct report_pair pair = {.left = &t[0], .right = &t[1], .roll_free = !opt.no_roll};
    const struct cli_item item[] = {{"y", &y, -1, 1, 1}, {"yaw", &pair.yaw, -0.1, 0.1, 0}, {"s", &pair.s, -1e5, 1e5, 0}, {"load", &load, 0, 1e7, 0}};
    struct vxf f[2];

    if (opt.wheelset)
        cli_items("wheelset", opt.wheelset, item, 4);
    open_table(&f[0], &t[0], path[0], 'l');
    open_table(&f[1], &t[1], path[1], 'r');
    if (opt.wheelset)
        cli_check("wheelset", report_wheelset(&pair, y, load, &printer));
    else if (opt.rolling_radius)
        cli_check("wheelset", report_rolling_radius(&pair, &printer));
    else
        cli_check("conicity", report_conicity(&pair, opt.amplitude, opt.amplitudes, &printer));
    vxf_close(&f[0]);
    vxf_close(&f[1]);
}

int main(int argc, char **argv)
{
    char **operand = parse(argc, argv);

    if (opt.cache.list || opt.cache.verify || opt.cache.prune)
        cli_cache_care(&opt.cache);
    else if (opt.patch)
        print_patch();
    else if (opt.query)
        print_query(operand[0]);
    else if (opt.path)
        print_path(operand[0]);
    else if (opt.sweep)
        print_sweep(operand);
    else if (opt.wheelset || opt.rolling_radius || opt.conicity)
        print_pair(operand);
    else
        build_table();
    return cli_end();
}
