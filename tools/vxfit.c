/* vxfit: railpads and ballast of a track from a measured receptance.
 *
 * In: a .trk to start from, and a table of frequency, real and imaginary part.  Out: the fitted values with their uncertainty as text, and
 * with -o the fitted .trk.  z down, H = motion over force for exp(+i omega t), SI units. */
#include "tools/cli/cli.h"

#include <string.h>

#include "formats/columns.h"
#include "formats/frf.h"
#include "formats/trk.h"
#include "tools/receptance/calibrate.h"
#include "tools/receptance/place.h"

static const char usage[] =
    "vxfit --measured FILE [--excite left|right|both|sleeper] [--at sleeper|midspan|M] [--x M] [--motion left|right|sleeper] "
    "[--motion-at sleeper|midspan|M] [--quantity receptance|mobility|accelerance] [--from HZ] [--to HZ] [--fix NAME]... [--bounds LO,HI] "
    "[-o FILE] TRACK";

static struct {
    const char *measured, *at, *motion_at, *bounds, *out;
    int excite, motion, quantity;
    double x;                        /* m */
    double from, to;                 /* Hz */
    double bound[2];                 /* of the factors */
    struct cli_list fix;
    int fit[CALIBRATE_N];
} opt = {.excite = PLACE_BOTH, .motion = -1, .at = "sleeper", .x = PLACE_MIDDLE, .to = 1e6, .bound = {0.05, 20}, .fit = {1, 1, 1, 1}};

static const char *const motions[] = {"left", "right", "sleeper", NULL};
static const char *const quantities[] = {"receptance", "mobility", "accelerance", NULL};

static const struct cli_option options[] = {
    {.name = "measured", .type = CLI_TEXT, .value = &opt.measured},
    {.name = "excite", .type = CLI_CHOICE, .value = &opt.excite, .choice = place_on},
    {.name = "at", .type = CLI_TEXT, .value = &opt.at},
    {.name = "x", .letter = 1, .type = CLI_NUM, .value = &opt.x, .lo = -1e6, .hi = 1e6},
    {.name = "motion", .type = CLI_CHOICE, .value = &opt.motion, .choice = motions},
    {.name = "motion-at", .type = CLI_TEXT, .value = &opt.motion_at},
    {.name = "quantity", .type = CLI_CHOICE, .value = &opt.quantity, .choice = quantities},
    {.name = "from", .type = CLI_NUM, .value = &opt.from, .lo = 0, .hi = 1e6},
    {.name = "to", .type = CLI_NUM, .value = &opt.to, .lo = 0, .hi = 1e6},
    {.name = "fix", .type = CLI_LIST, .value = &opt.fix},
    {.name = "bounds", .type = CLI_TEXT, .value = &opt.bounds},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxfit",
    .purpose = "Find the stiffness and damping of a track's railpads and ballast from a measured receptance.",
    .usage = usage,
    .option = options,
};

static const char *parse(int argc, char **argv)
{
    int n, left = CALIBRATE_N;
    char **operand = cli_begin(&program, argc, argv, 1, 1, &n);

    if (!opt.measured)
        cli_misuse("--measured is wanted: a table of frequency, real and imaginary part");
    if (opt.bounds && cli_numbers("bounds", opt.bounds, 1e-6, 1e6, opt.bound, 2) != 2)
        cli_misuse("--bounds wants two factors, not \"%s\"", opt.bounds);
    if (opt.bound[0] > 1 || opt.bound[1] < 1)
        cli_misuse("--bounds must hold 1, where the fit begins");
    for (int k = 0; k < opt.fix.n; k++) {
        int p = 0;
        while (calibrate_name[p] && strcmp(opt.fix.item[k], calibrate_name[p]))
            p++;
        if (p == CALIBRATE_N)
            cli_misuse("--fix must be railpad_stiffness, railpad_damping, ballast_stiffness or ballast_damping, not \"%s\"", opt.fix.item[k]);
        left -= opt.fit[p];
        opt.fit[p] = 0;
    }
    if (left == 0)
        cli_misuse("nothing is left to fit");
    return operand[0];
}

static struct place locate(const struct trk *t, int on, const char *option, const char *where)
{
    struct place p;
    const char *why = place_near(t, opt.x);

    if (why)
        cli_misuse("--x: %s", why);
    if ((why = place_named(&p, t, on, where, opt.x, 0)))
        cli_misuse("--%s: %s", option, why);
    return p;
}

/* What the method needs of each row: a frequency above the last one, a motion other than zero, as its logarithm is taken. */
static void check_rows(const struct columns *table)
{
    const double *const *v = (const double *const *)table->value;

    if (columns_find(table, "frequency") != 0)
        cli_die("%s: the first column is called \"%s\", frequency is wanted", opt.measured, table->name[0]);
    if (table->n < 3)
        cli_die("%s: %d columns, three are wanted: frequency, real and imaginary part", opt.measured, table->n);
    for (int64_t i = 0; i < table->rows; i++) {
        if (!(v[0][i] > 0))
            cli_die("%s:%lld: error: the frequency must be above 0 Hz, not %g", opt.measured, (long long)table->line[i], v[0][i]);
        if (i && !(v[0][i] > v[0][i - 1]))
            cli_die("%s:%lld: error: the frequency must be above %g Hz, that of the row before, not %g", opt.measured,
                    (long long)table->line[i], v[0][i - 1], v[0][i]);
        if (v[0][i] >= opt.from && v[0][i] <= opt.to && v[1][i] == 0 && v[2][i] == 0)
            cli_die("%s:%lld: error: %g %+gi at %g Hz: the fit takes its logarithm, it must not be zero", opt.measured,
                    (long long)table->line[i], v[1][i], v[2][i], v[0][i]);
    }
}

/* The rows of the table from --from to --to, at the places that the options name on t. */
static struct measured choose(const struct columns *table, const struct trk *t)
{
    static const int on[] = {PLACE_LEFT, PLACE_RIGHT, PLACE_SLEEPER};
    const int seen = opt.motion >= 0 ? on[opt.motion] : opt.excite == PLACE_BOTH ? PLACE_LEFT : opt.excite;
    struct measured m = {.quantity = opt.quantity};
    int64_t first = 0;

    check_rows(table);
    while (first < table->rows && table->value[0][first] < opt.from)
        first++;
    while (first + m.n < table->rows && table->value[0][first + m.n] <= opt.to)
        m.n++;
    m.frequency = table->value[0] + first;
    m.re = table->value[1] + first;
    m.im = table->value[2] + first;
    m.force = locate(t, opt.excite, "at", opt.at);
    m.motion = locate(t, seen, opt.motion_at ? "motion-at" : "at", opt.motion_at ? opt.motion_at : opt.at);
    return m;
}

static void print(const struct calibration *c, const struct trk *t, int64_t n)
{
    static const char *const unit[CALIBRATE_N] = {"N/m", "N.s/m", "N/m", "N.s/m"};
    double value[CALIBRATE_N];

    calibrate_values(t, value);
    printf("# %lld frequencies, %lld steps; rms of |ln(H / measured)| %.4g, at the start %.4g\n", (long long)n, (long long)c->steps, c->after,
           c->before);
    printf("%-18s %5s %12s %12s %12s %10s %s\n", "parameter", "unit", "start", "fitted", "uncertainty", "factor", "state");
    for (int p = 0; p < CALIBRATE_N; p++) {
        const char *state = !opt.fit[p] ? "fixed" : c->bound[p] < 0 ? "lower" : c->bound[p] > 0 ? "upper" : "free";
        const double fitted = c->factor[p] * value[p];
        char uncertainty[32] = "-";
        if (opt.fit[p] && c->bound[p] == 0)
            snprintf(uncertainty, sizeof uncertainty, "%.3g", c->uncertainty[p] * fitted);
        printf("%-18s %5s %12.5g %12.5g %12s %10.5f %s\n", calibrate_name[p], unit[p], value[p], fitted, uncertainty, c->factor[p], state);
        if (c->bound[p] != 0)
            cli_note("%s ends at its %s bound, %g times what it was: no optimum; --bounds or --fix", calibrate_name[p], state, c->factor[p]);
    }
}

static void write_track(const struct vxf *f, const struct trk *t, const double *factor, const char *name)
{
    struct vxf_out o;
    struct trk fitted;

    cli_check(name, calibrate_apply(&fitted, t, factor));
    vxf_out_begin(&o, "trk");
    vxf_put_input(&o, f);
    cli_check(name, trk_put(&fitted, &o));
    cli_write(&o, opt.out);
    vxf_out_free(&o);
    trk_free(&fitted);
}

int main(int argc, char **argv)
{
    const char *path = parse(argc, argv), *name = strcmp(path, "-") ? path : "standard input";
    struct calibration c;
    struct columns table;
    struct trk t;
    struct vxf f;

    cli_check(opt.measured, columns_read(&table, opt.measured));
    cli_open(&f, path, NULL);
    cli_check(name, trk_read(&t, &f));
    const struct measured m = choose(&table, &t);
    cli_check(opt.measured, calibrate_track(&c, &t, &m, opt.fit, opt.bound[0], opt.bound[1]));
    if (opt.out)
        write_track(&f, &t, c.factor, name);
    print(&c, &t, m.n);
    trk_free(&t);
    columns_free(&table);
    vxf_close(&f);
    return cli_end();
}
