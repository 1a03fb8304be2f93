/* vxcreep: creep force of a wheel on a rail, one evaluation.
 *
 * In: options, the contact ellipse, its load and its creepages.  Out: text, a line of names and units and a line of Fx, Fy, Mz.  FASTSIM
 * after Kalker 1982.  x forward, y lateral along the contact plane, z into the rail; forces of the wheel on the rail. */
#include "tools/cli/cli.h"

#include <math.h>

#include "tools/creep/fastsim.h"

static const char usage[] =
    "vxcreep --a M --b M --N N --mu X --xi X --eta X --phi RADPM [--shear PA] [--poisson X] [--grid N] [--method fastsim]";

static const char *const methods[] = {"fastsim", NULL};

static struct {
    double a, b, N, mu, xi, eta, phi;           /* NAN: not given */
    double shear, poisson;
    int64_t grid;
    int method;
} opt = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, .shear = 82e9, .poisson = 0.28, .grid = 10};

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
    {0},
};

static const struct cli_program program = {
    .name = "vxcreep",
    .purpose = "Evaluate the creep force of a wheel on a rail.",
    .usage = usage,
    .option = options,
};

static void parse(int argc, char **argv)
{
    int n;

    cli_begin(&program, argc, argv, 0, 0, &n);
    for (const struct cli_option *o = options; o->name; o++)
        if (o->type == CLI_NUM && isnan(*(const double *)o->value))
            cli_misuse("--%s is missing", o->name);
}

int main(int argc, char **argv)
{
    static struct fastsim f;
    double force[3];

    parse(argc, argv);
    fastsim_begin(&f, (int)opt.grid);
    fastsim(&f, opt.a, opt.b, opt.N, opt.mu, opt.shear, opt.poisson, opt.xi, opt.eta, opt.phi, force);
    printf("Fx[N]\tFy[N]\tMz[N.m]\n");
    printf("%.9g\t%.9g\t%.9g\n", force[0], force[1], force[2]);
    return cli_end();
}
