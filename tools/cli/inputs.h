/* The files a case names, or options in their place. */
#ifndef VX_CLI_INPUTS_H
#define VX_CLI_INPUTS_H

#include "formats/case_text.h"
#include "formats/creep.h"
#include "formats/ctab.h"
#include "formats/irregularity.h"
#include "formats/trk.h"
#include "formats/veh.h"
#include "tools/cli/cli.h"

/* Go before what the case names; NULL where not given. */
struct inputs_options {
    const char *track, *vehicle, *left, *right, *creep;
    struct cli_list set;             /* KEY=VALUE of the case */
};

/* In the order they are read in; a prescribed force wants the first alone. */
enum { INPUT_TRACK, INPUT_VEHICLE, INPUT_LEFT, INPUT_RIGHT, INPUT_CREEP, INPUTS_MOST };

struct inputs {
    struct case_text text;
    uint64_t hash;                   /* of the case */
    int files;                       /* how many of the inputs there are, from the first on */
    struct vxf file[INPUTS_MOST];
    char *name[INPUTS_MOST];         /* of the files */
    struct trk track;
    struct veh vehicle;
    struct ctab table[2];
    struct creep creep;
    struct irregularity measured;    /* where the case names a file of it */
};

/* Reads the case and all it names, or dies.  A file named by the case lies beside the case.  What `kept`, which may be NULL, holds of the same name is
 * taken from there; it must outlive in. */
void inputs_read(struct inputs *in, const char *path, const struct inputs_options *opt, const struct inputs *kept);

/* Whether a train runs: else a prescribed force stands for it. */
int inputs_have_train(const struct inputs *in);

/* Whether creep forces come from a table. */
int inputs_have_creep(const struct inputs *in);

/* Histories and hashes of all of them into a header. */
void inputs_put(const struct inputs *in, struct vxf_out *o);

void inputs_release(struct inputs *in);

#endif
