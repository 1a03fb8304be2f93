/* How long a run needs until what its start stirred up has died away.
 *
 * On uniform track the wheel force of a settled train repeats from bay to bay.  Settled is the run from the first of RUN_IN_BAYS bays on, each
 * of which has the mean and the largest Q of the bay before it within RUN_IN_TOLERANCE of the static load. */
#ifndef VX_INTEGRATE_RUN_IN_H
#define VX_INTEGRATE_RUN_IN_H

#include <stdint.h>

enum { RUN_IN_BAYS = 5 };
#define RUN_IN_TOLERANCE 1e-3 /* 1 */

struct run_in {
    double x0, bay;             /* m, where bays begin and how long they are */
    double load;                /* N static */
    double settled;             /* m, station; NAN until it is */
    int64_t at;                 /* the present bay */
    int64_t steps;              /* in it */
    double sum, most;           /* N of them */
    double mean_before, most_before; /* N of the bay before */
    int alike;                  /* bays in a row that are like the one before them */
    double since;               /* m, where the first of these began */
};

void run_in_begin(struct run_in *r, double x0, double bay, double load, double station);

/* Q N of a wheel at its station. */
void run_in_step(struct run_in *r, double station, double Q);

#endif
