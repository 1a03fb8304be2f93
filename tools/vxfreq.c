/* vxfreq: a track or a vehicle in the frequency domain.
 *
 * In: .trk, or .veh for modes.  Out: .frf, receptance by direct solution at each frequency; .mod, natural modes, undamped and with the
 * damping of the complex eigenvalue; or text.  z down, H = motion over force for exp(+i omega t), SI units. */
#include "tools/cli/cli.h"
#include "tools/cli/table.h"

#include <stdlib.h>
#include <string.h>

#include "formats/frf.h"
#include "formats/mod.h"
#include "formats/trk.h"
#include "formats/veh.h"
#include "tools/receptance/damped.h"
#include "tools/receptance/dense.h"
#include "tools/receptance/modes.h"
#include "tools/receptance/peaks.h"
#include "tools/receptance/preload.h"
#include "tools/receptance/stiffness.h"
#include "tools/receptance/sweep.h"
#include "tools/track/seat.h"

static const char usage[] =
    "vxfreq --receptance [--excite left|right|both|sleeper] [--at sleeper|midspan|M] [--x M] [--motion left|right|sleeper] "
    "[--motion-at sleeper|midspan|M] [--direction vertical|lateral] [--motion-direction vertical|lateral] "
    "[--quantity receptance|mobility|accelerance] [--from HZ] [--to HZ] [--step HZ] [--peaks [--hermite]] [--preload N] [-o FILE] TRACK\n"
    "vxfreq --modes N [--near HZ] [--damped] [--text] [-o FILE] TRACK|VEHICLE\n"
    "vxfreq --static --load N [--excite left|right|both] [--at sleeper|midspan|M] [--x M] [-o FILE] TRACK\n"
    "vxfreq --static --load N --axles M,... [--excite left|right|both] [--every M] TRACK\n"
    "vxfreq --static --load N --axles M,... --bearers [--excite left|right|both] TRACK\n"
    "vxfreq --stiffness [--load N] [--every M] TRACK";

enum { AXLES_MOST = 64 };

static struct {
    int receptance, statics, stiffness, peaks, hermite, damped, text, bearers;
    int excite, motion, quantity, lateral, motion_lateral;
    const char *at, *motion_at;      /* NULL: where the force is */
    int64_t modes;
    double x;                        /* m */
    double load, preload;            /* N on each loaded rail */
    const char *axles;               /* m, stations */
    double every;                    /* m, of a table along the track */
    double near;                     /* Hz */
    struct sweep sweep;              /* Hz */
    const char *out;
} opt = {.excite = PLACE_BOTH, .motion = -1, .motion_lateral = -1, .at = "sleeper", .x = PLACE_MIDDLE, .every = 0.1, .sweep = {10, 1500, 1}};

static const char *const motions[] = {"left", "right", "sleeper", NULL};
static const char *const directions[] = {"vertical", "lateral", NULL};
static const char *const quantities[] = {"receptance", "mobility", "accelerance", NULL};

static const struct cli_option options[] = {
    {.name = "receptance", .type = CLI_FLAG, .value = &opt.receptance},
    {.name = "modes", .type = CLI_INT, .value = &opt.modes, .lo = 1, .hi = 1e6},
    {.name = "static", .type = CLI_FLAG, .value = &opt.statics},
    {.name = "stiffness", .type = CLI_FLAG, .value = &opt.stiffness},
    {.name = "excite", .type = CLI_CHOICE, .value = &opt.excite, .choice = place_on},
    {.name = "at", .type = CLI_TEXT, .value = &opt.at},
    {.name = "motion", .type = CLI_CHOICE, .value = &opt.motion, .choice = motions},
    {.name = "motion-at", .type = CLI_TEXT, .value = &opt.motion_at},
    {.name = "direction", .type = CLI_CHOICE, .value = &opt.lateral, .choice = directions},
    {.name = "motion-direction", .type = CLI_CHOICE, .value = &opt.motion_lateral, .choice = directions},
    {.name = "quantity", .type = CLI_CHOICE, .value = &opt.quantity, .choice = quantities},
    {.name = "x", .letter = 1, .type = CLI_NUM, .value = &opt.x, .lo = -1e6, .hi = 1e6},
    {.name = "from", .type = CLI_NUM, .value = &opt.sweep.from, .lo = 0, .hi = 1e6},
    {.name = "to", .type = CLI_NUM, .value = &opt.sweep.to, .lo = 0, .hi = 1e6},
    {.name = "step", .type = CLI_NUM, .value = &opt.sweep.step, .lo = 1e-6, .hi = 1e6},
    {.name = "peaks", .type = CLI_FLAG, .value = &opt.peaks},
    {.name = "hermite", .type = CLI_FLAG, .value = &opt.hermite},
    {.name = "near", .type = CLI_NUM, .value = &opt.near, .lo = 0, .hi = 1e6},
    {.name = "damped", .type = CLI_FLAG, .value = &opt.damped},
    {.name = "text", .type = CLI_FLAG, .value = &opt.text},
    {.name = "load", .type = CLI_NUM, .value = &opt.load, .lo = 1e-6, .hi = 1e9},
    {.name = "preload", .type = CLI_NUM, .value = &opt.preload, .lo = 1e-6, .hi = 1e9},
    {.name = "axles", .type = CLI_TEXT, .value = &opt.axles},
    {.name = "bearers", .type = CLI_FLAG, .value = &opt.bearers},
    {.name = "every", .type = CLI_NUM, .value = &opt.every, .lo = 1e-3, .hi = 1e3},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxfreq",
    .purpose = "Receptance, natural modes and static deflection of a track; natural modes of a vehicle.",
    .usage = usage,
    .option = options,
};

static const char *parse(int argc, char **argv)
{
    int n;
    char **operand = cli_begin(&program, argc, argv, 1, 1, &n);
    const struct { int asked; const char *what; } form[] = {{opt.receptance, "--receptance"}, {opt.modes > 0, "--modes"},
        {opt.statics && !opt.axles, "--static at one place"}, {opt.statics && opt.axles && !opt.bearers, "--static --axles"},
        {opt.statics && opt.axles && opt.bearers, "--static --axles --bearers"}, {opt.stiffness, "--stiffness"}};

    if (opt.receptance + opt.statics + opt.stiffness + (opt.modes > 0) != 1)
        cli_misuse("one of --receptance, --modes, --static and --stiffness is wanted");
    for (int k = 0; k < (int)(sizeof form / sizeof *form); k++)
        if (form[k].asked)
            cli_form(&program, k, form[k].what);
    if (opt.statics && !(opt.load > 0))
        cli_misuse("--static needs --load, the force in N on each rail that --excite names");
    if (opt.sweep.to < opt.sweep.from)
        cli_misuse("--to %g Hz lies below --from %g Hz", opt.sweep.to, opt.sweep.from);
    if (opt.hermite && !(opt.peaks && strcmp(opt.at, "sleeper")))
        cli_misuse("--hermite goes with --peaks, and --at midspan or a station");
    if (opt.statics && opt.excite == PLACE_SLEEPER)
        cli_misuse("--static loads rails: --excite left, right or both");
    return operand[0];
}

static struct place locate(const struct trk *t, int on, const char *option, const char *where, int lateral)
{
    struct place p;
    const char *why = place_near(t, opt.x);

    if (why)
        cli_misuse("--x: %s", why);
    if (lateral && !trk_is_spatial(t))
        cli_misuse("--direction lateral: a vertical track does not move sideways, one of dofs: spatial does");
    if ((why = place_named(&p, t, on, where, opt.x, lateral)))
        cli_misuse("--%s: %s", option, why);
    return p;
}

static struct place locate_force(const struct trk *t)
{
    return locate(t, opt.excite, "at", opt.at, opt.lateral);
}

/* Where the motion is read: where the force acts, but for what is said otherwise. */
static struct place locate_motion(const struct trk *t)
{
    static const int on[] = {PLACE_LEFT, PLACE_RIGHT, PLACE_SLEEPER};

    return locate(t, opt.motion < 0 ? opt.excite : on[opt.motion], opt.motion_at ? "motion-at" : "at", opt.motion_at ? opt.motion_at : opt.at,
                  opt.motion_lateral < 0 ? opt.lateral : opt.motion_lateral);
}

static void print_peaks(const struct frf *r)
{
    struct peak *p = calloc((size_t)r->n, sizeof *p);
    struct cli_out out;

    if (!p)
        cli_die(REASON_MEMORY);
    int64_t n = peaks_find(r->n, r->frequency, opt.hermite && r->hermites ? r->hermite : r->H, p);
    cli_create(&out, opt.out, 0);
    for (int64_t i = 0; i < n; i++)
        fprintf(out.file, "%s  %.2f  %.4e\n", p[i].is_dip ? "dip" : "peak", p[i].frequency, p[i].amplitude);
    cli_close(&out);
    free(p);
}

static void run_receptance(const struct vxf *f, const char *name)
{
    struct vxf_out o;
    struct trk t, loaded = {0};
    struct frf r;

    cli_check(name, trk_read(&t, f));
    const struct place force = locate_force(&t), motion = locate_motion(&t);
    if (opt.preload > 0)
        cli_check(name, preload_track(&loaded, &t, &force, opt.preload));
    cli_check(name, sweep_places(&r, opt.preload > 0 ? &loaded : &t, &force, &motion, opt.quantity, &opt.sweep));
    if (opt.peaks)
        print_peaks(&r);
    else {
        vxf_out_begin(&o, "frf");
        vxf_put_input(&o, f);
        cli_check(name, frf_put(&r, &o));
        cli_write(&o, opt.out);
        vxf_out_free(&o);
    }
    frf_free(&r);
    trk_free(&loaded);
    trk_free(&t);
}

static void run_static(const struct vxf *f, const char *name)
{
    struct cli_out out;
    struct seat s[TRK_RAILS];
    struct trk t;

    cli_check(name, trk_read(&t, f));
    const struct place p = locate_force(&t);
    cli_check(name, seat_load(s, &t, &p.point, opt.excite, opt.load));
    cli_create(&out, opt.out, 0);
    const int alike = point_loads(opt.excite, TRK_LEFT) && point_loads(opt.excite, TRK_RIGHT) && seat_alike(&s[TRK_LEFT], &s[TRK_RIGHT]);
    for (int rail = 0; rail < (alike ? 1 : TRK_RAILS); rail++)
        if (point_loads(opt.excite, rail)) {
            const char *on = alike ? "each" : place_on[rail];
            fprintf(out.file, "deflection       %.6g m  %s rail at %.6g m\n", s[rail].deflection, on, p.x);
            fprintf(out.file, "seat force       %.6g N  %s rail on sleeper %lld\n", s[rail].force, on, (long long)s[rail].number);
            fprintf(out.file, "pad compression  %.6g m  %s rail on sleeper %lld\n", s[rail].compression, on, (long long)s[rail].number);
        }
    cli_close(&out);
    trk_free(&t);
}

static void run_along(const struct vxf *f, const char *name)
{
    static const struct column stiffness[] = {{"station", "m", 6}, {"left_alone", "N/m", 6}, {"right_alone", "N/m", 6}, {"left", "N/m", 6},
                                              {"right", "N/m", 6}};
    static const struct column bowl[] = {{"station", "m", 6}, {"left", "m", 6}, {"right", "m", 6}};
    static const struct column bearers[] = {{"station", "m", 6}, {"sleeper", "1", 6}, {"left", "N", 6}, {"right", "N", 6}, {"ballast", "N", 6}};
    double axle[AXLES_MOST], *x;
    struct trk t;
    int64_t n;

    cli_check(name, trk_read(&t, f));
    cli_check(name, stiffness_stations(&t, opt.every, &n, &x));
    const int axles = opt.axles ? cli_numbers("axles", opt.axles, t.x[0], t.x[t.nodes - 1], axle, AXLES_MOST) : 0;
    double *value = calloc((size_t)(n + t.sleepers), STIFFNESS_N * sizeof *value);
    if (!value)
        cli_die(REASON_MEMORY);
    if (opt.stiffness) {
        cli_check(name, stiffness_along(&t, opt.load, n, x, value));
        cli_table(stiffness, 1 + STIFFNESS_N, n, x, value);
    } else if (opt.bearers) {
        cli_check(name, seat_bearers(&t, opt.excite, opt.load, axles, axle, value));
        cli_table(bearers, 1 + SEAT_BEARS, t.sleepers, t.sleeper_x, value);
    } else {
        cli_check(name, stiffness_bowl(&t, opt.excite, opt.load, axles, axle, n, x, value));
        cli_table(bowl, 1 + TRK_RAILS, n, x, value);
    }
    free(x);
    free(value);
    trk_free(&t);
}

static void print_modes(const struct mod *m)
{
    struct cli_out out;

    cli_create(&out, opt.out, 0);
    for (int64_t i = 0; i < m->n; i++)
        fprintf(out.file, "%lld  %.4f  %.5f  %s\n", (long long)i + 1, m->frequency[i], m->damping[i], *m->name[i] ? m->name[i] : "-");
    cli_close(&out);
}

static void run_modes(const struct vxf *f, const char *name)
{
    struct vxf_out o;
    struct trk t = {0};
    struct veh v = {0};
    struct mod m;

    if (vxf_is(f, "veh") == NULL) {
        if (opt.damped)
            cli_die("%s: --damped modes are of a track", name);
        cli_check(name, veh_read(&v, f));
        cli_check(name, dense_vehicle(&m, &v, opt.modes, opt.near));
    } else {
        cli_check(name, trk_read(&t, f));
        cli_check(name, (opt.damped ? damped_track : modes_track)(&m, &t, opt.modes, opt.near));
    }
    if (opt.text)
        print_modes(&m);
    else {
        vxf_out_begin(&o, "mod");
        vxf_put_input(&o, f);
        cli_check(name, mod_put(&m, &o));
        cli_write(&o, opt.out);
        vxf_out_free(&o);
    }
    mod_free(&m);
    veh_free(&v);
    trk_free(&t);
}

int main(int argc, char **argv)
{
    const char *path = parse(argc, argv), *name = strcmp(path, "-") ? path : "standard input";
    struct vxf f;

    cli_open(&f, path, NULL);
    if (opt.receptance)
        run_receptance(&f, name);
    else if (opt.stiffness || opt.axles)
        run_along(&f, name);
    else if (opt.statics)
        run_static(&f, name);
    else
        run_modes(&f, name);
    vxf_close(&f);
    return cli_end();
}
