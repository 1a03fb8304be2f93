/* Samples through the low-pass: records under way take in every step their window reaches, and go out complete. */
#include "tools/integrate/record.h"

#include <string.h>

/* What leaps from contact to contact stays as it is, and so do time and place. */
static int is_filtered(enum run_channel c)
{
    return c != RUN_TIME && c != RUN_STATION && (c < RUN_N || c > RUN_BODY) && c != RUN_BODY_OFFSET && c != RUN_BODY_HEADING;
}

/* Row `to` of channel c += w times row `from`, or a times itself where from is to. */
static void blend(struct record *r, enum run_channel c, int64_t to, int64_t from, double w)
{
    const int64_t n = r->size[c];
    double *x = r->buffer[c];
    float *f = r->buffer[c];

    if (run_channels[c].type == VXF_F64)
        for (int64_t i = 0; i < n; i++)
            x[to * n + i] += w * x[from * n + i];
    else
        for (int64_t i = 0; i < n; i++)
            f[to * n + i] += (float)w * f[from * n + i];
}

/* The present step, in the last row, goes into row `to`, whose own step is `away` steps before it. */
static void add_step(struct record *r, int64_t to, int64_t away)
{
    const int64_t now = RECORD_ROOM - 1;
    const double w = r->lowpass[away + LOWPASS_HALF * r->every];

    for (enum run_channel c = 0; c < RUN_CHANNELS; c++)
        if (r->buffer[c] && is_filtered(c))
            blend(r, c, to, now, w);
        else if (r->buffer[c] && away == 0)
            memcpy((char *)r->buffer[c] + (size_t)(to * r->size[c]) * vxf_type_size(run_channels[c].type),
                   (char *)r->buffer[c] + (size_t)(now * r->size[c]) * vxf_type_size(run_channels[c].type),
                   (size_t)r->size[c] * vxf_type_size(run_channels[c].type));
    r->weight[to] += w;
}

/* The first record under way has all its steps: at the ends of the run these are fewer. */
static void complete(struct record *r)
{
    const int64_t row = r->held++;

    for (enum run_channel c = 0; c < RUN_CHANNELS; c++)
        if (r->buffer[c] && is_filtered(c))
            blend(r, c, row, row, 1 / r->weight[row] - 1);
    r->begun--;
    r->first += r->every;
}

static void clear(struct record *r, int64_t row)
{
    for (enum run_channel c = 0; c < RUN_CHANNELS; c++)
        if (r->buffer[c]) {
            const size_t size = (size_t)r->size[c] * vxf_type_size(run_channels[c].type);
            memset((char *)r->buffer[c] + (size_t)row * size, 0, size);
        }
    r->weight[row] = 0;
}

/* Records whose window reaches this step begin, all take it in, and those it is the last of are complete. */
void record_filter(struct record *r, int64_t n)
{
    const int64_t half = LOWPASS_HALF * r->every;

    if (r->held + r->begun == 0)
        r->first = (n + r->every - 1) / r->every * r->every;
    while (r->first + r->begun * r->every - half <= n)
        clear(r, r->held + r->begun++);
    for (int64_t k = 0; k < r->begun; k++)
        add_step(r, r->held + k, n - (r->first + k * r->every));
    while (r->begun && r->first + half <= n)
        complete(r);
}

/* Samples beyond the last step are none. */
void record_filter_end(struct record *r, int64_t n)
{
    while (r->begun && r->first <= n)
        complete(r);
    r->begun = 0;
}

void record_empty(struct record *r)
{
    for (int c = 0; c < RUN_CHANNELS && r->begun; c++)
        if (r->buffer[c]) {
            const size_t size = (size_t)r->size[c] * vxf_type_size(run_channels[c].type);
            memmove(r->buffer[c], (char *)r->buffer[c] + (size_t)r->held * size, (size_t)r->begun * size);
        }
    if (r->begun)
        memmove(r->weight, r->weight + r->held, (size_t)r->begun * sizeof *r->weight);
    r->held = 0;
}
