/* vxdump: arrays of a Veksel file as text columns, or as a MAT or HDF5 file; a profile as points for other programs.
 *
 * In: any container.  Out: CSV (RFC 4180, lines end in LF), MAT version 5, or HDF5.  Numbers are those of the file, in SI units; none
 * is rounded.  Of a .prof also y z text, Simpack .prr or .prw, and CONTACT .slcs with its slices, in mm and as on a right side. */
#include "tools/cli/cli.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/export_csv.h"
#include "formats/export_hdf5.h"
#include "formats/export_mat.h"
#include "formats/export_points.h"
#include "formats/export_simpack.h"
#include "formats/export_slices.h"

static const char usage[] =
    "vxdump [--csv | --mat | --hdf5] [-o FILE] INPUT [ARRAY ...]\n"
    "vxdump --yz | --simpack [--at M] [--body NAME] [-o FILE] INPUT.prof\n"
    "vxdump --slices [--body NAME] -o FILE.slcs INPUT.prof";

static struct {
    int csv, mat, hdf5, yz, simpack, slices;
    double at;               /* m; infinite where not given */
    const char *body, *out;
} opt = {.at = INFINITY};

static const struct cli_option options[] = {
    {.name = "csv", .type = CLI_FLAG, .value = &opt.csv},
    {.name = "mat", .type = CLI_FLAG, .value = &opt.mat},
    {.name = "hdf5", .type = CLI_FLAG, .value = &opt.hdf5},
    {.name = "yz", .type = CLI_FLAG, .value = &opt.yz},
    {.name = "simpack", .type = CLI_FLAG, .value = &opt.simpack},
    {.name = "slices", .type = CLI_FLAG, .value = &opt.slices},
    {.name = "at", .type = CLI_NUM, .value = &opt.at, .lo = -1e6, .hi = 1e6},
    {.name = "body", .type = CLI_TEXT, .value = &opt.body},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxdump",
    .purpose = "Export arrays of a Veksel file to CSV, MAT or HDF5, a profile to other programs.",
    .usage = usage,
    .option = options,
};

static char **parse(int argc, char **argv, int *arrays)
{
    char **operand = cli_begin(&program, argc, argv, 1, 1 << 20, arrays);

    if (opt.csv + opt.mat + opt.hdf5 + opt.yz + opt.simpack + opt.slices > 1)
        cli_misuse("--csv, --mat, --hdf5, --yz, --simpack and --slices exclude each other");
    if ((opt.yz || opt.simpack || opt.slices) && *arrays > 1)
        cli_misuse("--yz, --simpack and --slices take no arrays");
    if ((isfinite(opt.at) && !opt.yz && !opt.simpack) || (opt.body && !opt.yz && !opt.simpack && !opt.slices))
        cli_misuse("--at is for --yz and --simpack, --body for these and --slices");
    if (opt.slices && !opt.out)
        cli_misuse("--slices needs -o FILE.slcs, the slices go into a folder beside it");
    --*arrays;
    return operand;
}

static const char *profile_export(const struct vxf *f, FILE *out)
{
    struct prof p;
    int64_t poly;
    const char *why = prof_read(&p, f);

    if (why)
        return why;
    if (opt.slices)
        return export_slices(&p, opt.body, opt.out, out);
    if ((why = export_poly(&p, isfinite(opt.at) ? &opt.at : NULL, opt.body, &poly)))
        return why;
    if (opt.yz)
        export_points(&p, poly, out);
    else
        export_simpack(&p, poly, out);
    return NULL;
}

int main(int argc, char **argv)
{
    struct vxf_list list;
    struct cli_out out;
    struct vxf f;
    const char *why;
    int n;
    char **operand = parse(argc, argv, &n);

    cli_open(&f, operand[0], NULL);
    cli_check(operand[0], vxf_select(&f, n, operand + 1, &list));
    cli_create(&out, opt.out, opt.mat || opt.hdf5);
    errno = 0;
    if (opt.mat)
        why = export_mat(&list, f.header, out.file);
    else if (opt.hdf5)
        why = export_hdf5(&list, f.header, out.file);
    else if (opt.yz || opt.simpack || opt.slices)
        why = profile_export(&f, out.file);
    else
        why = export_csv(&list, out.file);
    cli_check(operand[0], why);
    cli_close(&out);
    free(list.item);
    vxf_close(&f);
    return cli_end();
}
