/* What a passage leaves behind: samples of its channels in blocks, and extremes over every step. */
#ifndef VX_INTEGRATE_RECORD_H
#define VX_INTEGRATE_RECORD_H

#include "formats/run.h"
#include "tools/integrate/extremes.h"
#include "tools/integrate/lowpass.h"

enum { RECORD_BLOCK = 256 };             /* records gathered before a block is written */
enum { RECORD_ROOM = RECORD_BLOCK + 2 * LOWPASS_HALF + 2 }; /* those, what the low-pass has under way, and the present step */

struct record {
    struct run run;                      /* what the file says of the passage; its arrays are those of the inputs and wheelset_x */
    int recorded[RUN_CHANNELS];          /* channels kept */
    int64_t every;                       /* steps between samples */
    int64_t held;                        /* records in the buffers that are complete */
    int64_t begun;                       /* records that the low-pass has under way, behind them */
    int64_t first;                       /* step of the first of these */
    int64_t row;                         /* where samples go */
    double *lowpass;                     /* [2 LOWPASS_HALF every + 1] weights; NULL: samples are those of their step alone */
    double *weight;                      /* [RECORD_ROOM] their sum so far, by row */
    int64_t size[RUN_CHANNELS];          /* elements of a record */
    void *buffer[RUN_CHANNELS];          /* [RECORD_ROOM][size] double or float by run_channels; NULL where not kept */
    const void *series[RUN_CHANNELS];    /* the buffers kept, in the order of run_put: for vxf_stream_block */
    struct extremes extremes;
    int64_t force_on;                    /* of the exciter */
    double *wheelset_x;                  /* m [wheelsets] */
    double *cg;                          /* m [bodies][3] */
    double *static_q;                    /* N [wheelsets][2] */
    double *node_x;                      /* m [nodes] of a track that follows a trailing train; else NULL */
    int trailing, follows;               /* samples are turned, and extremes at the end: facing.h */
};

/* groups[RUN_GROUPS]: which groups of channels to keep; every >= 1 steps between samples; lowpass: forces, motions and accelerations are
 * filtered around their sample (lowpass.h; at the ends of the run by what there is), contacts and creepages, which leap, are not. */
const char *record_new(struct record *r, const struct passage *p, const int *groups, int64_t every, int lowpass);
void record_free(struct record *r);

/* Of one record. */
double record_bytes(const struct record *r);

/* Takes in the present step: extremes always, a sample where it is due.  Returns 1 when the buffers are full and must be
 * written and emptied before the next call. */
int record_step(struct record *r, const struct passage *p);

/* The records held have been written. */
void record_empty(struct record *r);

/* After step n, the last one: what the low-pass has under way is complete. */
void record_end(struct record *r, int64_t n);

/* Of these two: the present step n, in the last row, into the records under way; and those that the last step leaves under way. */
void record_filter(struct record *r, int64_t n);
void record_filter_end(struct record *r, int64_t n);

#endif
