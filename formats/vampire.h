/* Vampire profiles: .whe (wheels) and .rai (rails), left and right side by side: profile-input(5).
 *
 * Lines 1 to 4: WHEELPROFILE or RAILPROFILE; a title; TREADDATUM or GAUGEPOINT; FLANGEBACK or GAUGE.  Then yl zl yr zr in mm, y from the
 * track's centre, z down for wheels and up for rails.  The points come out as those of the right side, in metres, z down; those of a wheel
 * from its tread datum. */
#ifndef VX_FORMATS_VAMPIRE_H
#define VX_FORMATS_VAMPIRE_H

#include "formats/points.h"

struct vampire {
    char part;               /* 'w' wheel or 'r' rail */
    double distance;         /* m, between the flange backs, or the gauge */
    double datum;            /* m, from the flange back to the tread datum, or from the top down to the gauge point */
    struct points points;
};

/* side: 1 right, 2 left (mirrored), 0 where they are alike.  path "-" is standard input. */
const char *vampire_read(struct vampire *v, const char *path, int side);
void vampire_free(struct vampire *v);

#endif
