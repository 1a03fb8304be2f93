/* How far a long job is, on a terminal. */
#ifndef VX_CLI_PROGRESS_H
#define VX_CLI_PROGRESS_H

#include <stdint.h>

struct progress {
    double (*seconds)(void);     /* that the job has taken */
    int quiet;                   /* other jobs go on beside this one */
    int64_t shown, first;        /* steps done when last told, and at the beginning; 0 before */
    double began;                /* s */
};

/* After a step, `done` of `all`; each fiftieth is told, with where it is. */
void progress_show(struct progress *p, int64_t done, int64_t all, const char *name, double value, const char *unit);

#endif
