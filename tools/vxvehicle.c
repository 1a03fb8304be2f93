/* vxvehicle: a vehicle as rigid bodies, couplings and matrices, at rest.
 *
 * In: the vehicle input of vehicle-input(5).  Out: .veh, veh(5): bodies, couplings with their static preloads, wheel loads, and K, C, M
 * about rest.  x forward from the first wheelset, y to the right, z down, SI units. */
#include "tools/cli/cli.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/veh.h"
#include "formats/veh_text.h"
#include "tools/vehicle/check.h"
#include "tools/vehicle/doubt.h"
#include "tools/vehicle/join.h"
#include "tools/vehicle/vehicle.h"

static const char usage[] =
    "vxvehicle [--set KEY=VALUE]... [--check] [-o FILE] INPUT\n"
    "vxvehicle --join GAP [--coupler STIFFNESS] [--coupler-damping DAMPING] [-o FILE] FRONT.veh REAR.veh...\n"
    "vxvehicle --schema | --master";

enum { DOUBTS = 200, TRAIN_MOST = 100 };     /* printed at most, vehicles of a train */
#define COUPLER_LENGTH 1.0              /* m, engineering estimate */
#define COUPLER_HEIGHT 1.06             /* m, buffers of UIC 526 */
static const double PUSH = 1;           /* m/s2, for the clearances */

static struct {
    struct cli_list set;
    int check, schema, master;
    struct join join;
    const char *out;
} opt = {.join = {.gap = NAN, .length = COUPLER_LENGTH, .height = COUPLER_HEIGHT}};

static const struct cli_option options[] = {
    {.name = "set", .type = CLI_LIST, .value = &opt.set},
    {.name = "check", .type = CLI_FLAG, .value = &opt.check},
    {.name = "join", .type = CLI_NUM, .value = &opt.join.gap, .lo = 1, .hi = 1e3},
    {.name = "coupler", .type = CLI_NUM, .value = &opt.join.stiffness, .lo = 0, .hi = 1e12},
    {.name = "coupler-damping", .type = CLI_NUM, .value = &opt.join.damping, .lo = 0, .hi = 1e9},
    {.name = "schema", .type = CLI_FLAG, .value = &opt.schema},
    {.name = "master", .type = CLI_FLAG, .value = &opt.master},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxvehicle",
    .purpose = "Build a vehicle at rest, with its matrices, from its description.",
    .usage = usage,
    .option = options,
};

/* The operands, or NULL where the schema or the master file is asked for. */
static char **parse(int argc, char **argv, int *n)
{
    char **operand = cli_begin(&program, argc, argv, 0, TRAIN_MOST, n);
    const int asks = opt.schema + opt.master, joins = !isnan(opt.join.gap);

    if (asks > 1)
        cli_misuse("--schema and --master exclude each other");
    if (asks && (*n || opt.set.n || opt.check || opt.out || joins))
        cli_misuse("--%s stands alone", opt.schema ? "schema" : "master");
    if (opt.check && opt.out)
        cli_misuse("--check writes text and no -o FILE");
    if (!asks && !*n)
        cli_misuse("an input is missing (-h shows the usage)");
    if (!joins && *n > 1)
        cli_misuse("one input at a time; --join takes several vehicles");
    if (joins && (*n < 2 || opt.set.n || opt.check))
        cli_misuse("--join takes two .veh files or more, without --set and --check");
    if (!joins && (opt.join.stiffness > 0 || opt.join.damping > 0))
        cli_misuse("--coupler and --coupler-damping go with --join");
    if (joins && opt.join.gap <= opt.join.length && opt.join.stiffness > 0)
        cli_misuse("--coupler is %g m long, the gap %g m", opt.join.length, opt.join.gap);
    return asks ? NULL : operand;
}

/* What each vertical spring carries at rest and how far that bends it; of one in a table, its place there. */
static void print_loads(const struct veh *v)
{
    for (int64_t c = 0; c < v->couplings; c++) {
        const double load = v->preload[3*c + VEH_Z], k = v->stiffness[VEH_DOFS*c + VEH_Z];
        if (load != 0)
            printf("coupling   %-16s carries %.1f N  bent by %.3f mm\n", v->coupling_name[c], load,
                   1e3*(v->type[c] == VEH_SPRING ? v->rest[c] : load/k));
    }
}

static void print_stops(const struct veh *v)
{
    double *deflection = calloc((size_t)v->couplings + 1, sizeof *deflection);

    if (!deflection)
        cli_die(REASON_MEMORY);
    cli_check(v->name, check_sideways(v, PUSH, deflection));
    for (int64_t c = 0; c < v->couplings; c++)
        if (v->type[c] == VEH_STOP)
            printf("stop       %-16s along %c  clearance %.4g mm  used at rest 0 mm, by the springs alone at %g m/s2 sideways %.3g mm\n", v->coupling_name[c],
                   "xyz"[v->axis[c]], 1e3*v->knot_at[v->knot_first[c]], PUSH, 1e3*fabs(deflection[c]));
    free(deflection);
}

static void print_doubts(const struct veh *v)
{
    static char words[DOUBTS][DOUBT_WORDS];
    struct doubts d = {.room = DOUBTS, .words = words};

    doubt_find(v, &d);
    for (int64_t k = 0; k < d.n && k < d.room; k++)
        printf("doubt      %s\n", words[k]);
    printf("doubts     %lld\n", (long long)d.n);
}

static void print_check(const struct veh *v)
{
    struct check k;

    check_balance(v, &k);
    printf("vehicle    %s\n", v->name);
    printf("mass       %.10g kg\n", k.mass);
    printf("cg         x %.6g m  y %.6g m  height %.6g m\n", k.cg[0], k.cg[1], -k.cg[2]);
    for (int64_t i = 0; i < v->bodies; i++)
        if (!veh_is_wheelset(v, i))
            printf("body       %-16s %.10g kg  alone on its springs %.3f Hz\n", v->body_name[i], v->mass[i], doubt_bounce(v, i));
    for (int64_t w = 0; w < v->wheelsets; w++)
        printf("wheelset   %-16s left %.1f N  right %.1f N\n", v->body_name[v->wheelset[w]], v->wheel_load[2*w], v->wheel_load[2*w + 1]);
    printf("balance    weight %.1f N  wheels %.1f N\n", k.weight, k.wheels);
    printf("support    every body is held in all directions, wheelsets held\n");
    print_loads(v);
    print_stops(v);
    print_doubts(v);
}

/* At the line of what is wrong, where it has one. */
static void refuse(const char *path, int line, const char *why)
{
    if (line == 0)
        cli_check(path, why);
    cli_die("%s:%d: error: %s", strcmp(path, "-") ? path : "standard input", line, why);
}

static void write_vehicle(const struct veh *v, uint64_t hash, const char *path)
{
    struct vxf_out o;

    vxf_out_begin(&o, "veh");
    vxf_put_key(&o, "INPUT", "vehicle %016llx", (unsigned long long)hash);
    cli_check(path, veh_put(v, &o));
    cli_write(&o, opt.out);
    vxf_out_free(&o);
}

static void join(char **path, int n)
{
    static struct vxf file[TRAIN_MOST];
    static struct veh part[TRAIN_MOST];
    struct vxf_out o;
    struct veh v;

    for (int i = 0; i < n; i++) {
        cli_open(&file[i], path[i], "veh");
        cli_check(path[i], veh_read(&part[i], &file[i]));
    }
    cli_check("train", join_vehicles(&v, part, n, &opt.join));
    vxf_out_begin(&o, "veh");
    for (int i = 0; i < n; i++)
        vxf_put_input(&o, &file[i]);
    cli_check("train", veh_put(&v, &o));
    cli_write(&o, opt.out);
    vxf_out_free(&o);
    veh_free(&v);
    for (int i = 0; i < n; i++)
        vxf_close(&file[i]);
}

int main(int argc, char **argv)
{
    int n;
    char **operand = parse(argc, argv, &n);
    const char *path = operand ? operand[0] : NULL, *why;
    struct veh_text in;
    struct veh v;
    uint64_t hash;

    if (!path) {
        (opt.schema ? yaml_print_schema : yaml_print_master)(&veh_text_schema, stdout);
        return cli_end();
    }
    if (!isnan(opt.join.gap)) {
        join(operand, n);
        return cli_end();
    }
    if ((why = veh_text_read(&in, path, opt.set.item, opt.set.n, &hash)))
        cli_die("%s", why);
    why = vehicle_build(&v, &in);
    if (why && opt.check && v.M && !veh_check(&v)) {    /* doubts may say why it does not stand */
        print_doubts(&v);
        fflush(stdout);
    }
    if (why)
        refuse(path, veh_text_line(&in, why), why);
    if (opt.check)
        print_check(&v);
    else
        write_vehicle(&v, hash, path);
    veh_free(&v);
    veh_text_free(&in);
    return cli_end();
}
