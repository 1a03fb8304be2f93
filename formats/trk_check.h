/* What every user of a track relies on: increasing stations, positive masses, sleepers below their nodes, degrees of freedom in
 * their order, a symmetric pattern with symmetric values. */
#ifndef VX_FORMATS_TRK_CHECK_H
#define VX_FORMATS_TRK_CHECK_H

#include "formats/trk.h"

/* entries: of the array A.i as it is stored. */
const char *trk_check(const struct trk *t, int64_t entries);

#endif
