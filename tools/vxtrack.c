/* vxtrack: a track as degrees of freedom and sparse matrices.
 *
 * In: the track input of track-input(5).  Out: .trk, trk(5): masses, Euler-Bernoulli rails, springs and dampers, and K, C and M on
 * one pattern.  Lumped masses after Lau and Hoff 2018.  x forward, y to the right, z down, SI units. */
#include "tools/cli/cli.h"

#include <string.h>

#include "formats/trk.h"
#include "formats/trk_text.h"
#include "tools/track/assemble.h"
#include "tools/track/doubt.h"
#include "tools/track/equilibrium.h"
#include "tools/track/layout.h"

static const char usage[] =
    "vxtrack [--set KEY=VALUE]... [-o FILE] INPUT\n"
    "vxtrack --schema | --master";

static struct {
    struct cli_list set;
    int schema, master;
    const char *out;
} opt;

static const struct cli_option options[] = {
    {.name = "set", .type = CLI_LIST, .value = &opt.set},
    {.name = "schema", .type = CLI_FLAG, .value = &opt.schema},
    {.name = "master", .type = CLI_FLAG, .value = &opt.master},
    {.name = "o", .type = CLI_TEXT, .value = &opt.out},
    {0},
};

static const struct cli_program program = {
    .name = "vxtrack",
    .purpose = "Build the matrices of a railway track from its description.",
    .usage = usage,
    .option = options,
};

/* The operand, or NULL where the schema or the master file is asked for. */
static const char *parse(int argc, char **argv)
{
    int n;
    char **operand = cli_begin(&program, argc, argv, 0, 1, &n);
    const int asks = opt.schema + opt.master;

    if (asks > 1)
        cli_misuse("--schema and --master exclude each other");
    if (asks && (n || opt.set.n || opt.out))
        cli_misuse("--%s stands alone", opt.schema ? "schema" : "master");
    if (!asks && !n)
        cli_misuse("an input is missing (-h shows the usage)");
    return asks ? NULL : operand[0];
}

int main(int argc, char **argv)
{
    const char *path = parse(argc, argv), *why;
    struct trk_text in;
    struct trk t;
    struct vxf_out o;
    uint64_t hash;
    char words[DOUBT_TRACK_MOST][DOUBT_TRACK_WORDS];

    if (!path) {
        (opt.schema ? yaml_print_schema : yaml_print_master)(&trk_text_schema, stdout);
        return cli_end();
    }
    if ((why = trk_text_read(&in, path, opt.set.item, opt.set.n, &hash)))
        cli_die("%s", why);
    if ((why = layout_track(&t, &in)))
        cli_die("%s", yaml_blame(path, &trk_text_schema, opt.set.item, opt.set.n, why));
    path = strcmp(path, "-") ? path : "standard input";
    cli_check(path, assemble_track(&t));
    cli_check(path, equilibrium_settle(&t, EQUILIBRIUM_GRAVITY));
    const int doubts = doubt_track(&t, words);
    for (int k = 0; k < doubts; k++)
        cli_note("doubt: %s", words[k]);
    vxf_out_begin(&o, "trk");
    vxf_put_key(&o, "INPUT", "track %016llx", (unsigned long long)hash);
    cli_check(path, trk_put(&t, &o));
    cli_write(&o, opt.out);
    vxf_out_free(&o);
    trk_free(&t);
    trk_text_free(&in);
    return cli_end();
}
