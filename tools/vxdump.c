/* vxdump: arrays of a Veksel file as text columns, or as a MAT or HDF5 file.
 *
 * In: any container.  Out: CSV (RFC 4180, lines end in LF), MAT version 5, or HDF5.  Numbers are those of the file, in SI units; none
 * is rounded. */
#include "tools/cli/cli.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "formats/export_csv.h"
#include "formats/export_hdf5.h"
#include "formats/export_mat.h"

static const char usage[] = "vxdump [--csv | --mat | --hdf5] [-o FILE] INPUT [ARRAY ...]";

static struct {
    int csv, mat, hdf5;
    const char *out;
} opt;

static const struct cli_option options[] = {
    {.name = "csv", .type = CLI_FLAG, .value = &opt.csv},
    {.name = "mat", .type = CLI_FLAG, .value = &opt.mat},
    {.name = "hdf5", .type = CLI_FLAG, .value = &opt.hdf5},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxdump",
    .purpose = "Export arrays of a Veksel file to CSV, MAT or HDF5.",
    .usage = usage,
    .option = options,
};

static char **parse(int argc, char **argv, int *arrays)
{
    char **operand = cli_begin(&program, argc, argv, 1, 1 << 20, arrays);

    if (opt.csv + opt.mat + opt.hdf5 > 1)
        cli_misuse("--csv, --mat and --hdf5 exclude each other");
    --*arrays;
    return operand;
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
    else
        why = export_csv(&list, out.file);
    cli_check(operand[0], why);
    cli_close(&out);
    free(list.item);
    vxf_close(&f);
    return cli_end();
}
