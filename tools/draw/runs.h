/* Figures of passages: forces of wheels, railpads and ballast and how a wheelset runs, over the station, and maxima along the track.
 *
 * Several runs go into one chart, one after the other, named by `label`, which is NULL where there is one alone.  A run must
 * live until the chart is drawn. */
#ifndef VX_DRAW_RUNS_H
#define VX_DRAW_RUNS_H

#include "formats/run.h"
#include "tools/draw/chart.h"

struct runs_choice {
    int64_t wheelset;                /* from 1 */
    int sleepers;
    const int64_t *sleeper;          /* [sleepers] numbers, a panel each */
    int asked;                       /* by the user; else those that a run does not have are left out, and one is shown at least */
};

/* Adds run r to c, which the first call of a chart gives its axes. */
typedef const char *runs_add(struct chart *c, const struct run *r, const char *label, const struct runs_choice *choice);

runs_add runs_vertical;              /* Q of the wheelset, left and right, over its own station */
runs_add runs_lateral;               /* Y, the same */
runs_add runs_wheelset;              /* yaw and lateral displacement of the wheelset, place of its most loaded contacts on wheels and rails */
runs_add runs_pads;                  /* forces of the railpads at the sleepers chosen, over the station of the front wheelset */
runs_add runs_ballast;               /* forces on the ballast there, left, middle, right */
runs_add runs_max_pads;              /* largest force of each railpad, over sleeper number */
runs_add runs_max_ballast;           /* largest force on the ballast at each sleeper */

#endif
