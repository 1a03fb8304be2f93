/* What a passage leaves behind: samples of its channels in blocks, and extremes over every step. */
#ifndef VX_INTEGRATE_RECORD_H
#define VX_INTEGRATE_RECORD_H

#include "formats/run.h"
#include "tools/integrate/passage.h"

enum { RECORD_BLOCK = 256 };             /* records gathered before a block is written */

struct record {
    struct run run;                      /* what the file says of the passage; its arrays are those of the inputs and wheelset_x */
    int recorded[RUN_CHANNELS];          /* channels kept */
    int64_t every;                       /* steps between samples */
    int64_t held;                        /* records in the buffers, at most RECORD_BLOCK */
    int64_t size[RUN_CHANNELS];          /* elements of a record */
    void *buffer[RUN_CHANNELS];          /* [RECORD_BLOCK][size] double or float by run_channels; NULL where not kept */
    const void *series[RUN_CHANNELS];    /* the buffers kept, in the order of run_put: for vxf_stream_block */
    double *extreme[RUN_EXTREMES];       /* as run.h */
    int64_t force_on;                    /* of the exciter */
    double *moment;                      /* N m [nodes] */
    double *wheelset_x;                  /* m [wheelsets] */
};

/* groups[RUN_GROUPS]: which groups of channels to keep; every >= 1 steps between samples. */
const char *record_new(struct record *r, const struct passage *p, const int *groups, int64_t every);
void record_free(struct record *r);

/* Takes in the present step: extremes always, a sample where it is due.  Returns 1 when the buffers are full and must be
 * written and emptied (held = 0) before the next call. */
int record_step(struct record *r, const struct passage *p);

#endif
