/* MiniProf profiles: .ban and .bnd (rail), .whl (wheel), .mpt (several sections): profile-input(5).
 *
 * New files begin with Key=Value lines, old ones with MINIPROF or #MINIWHEELPROF and free text up to an empty line; then the points, in the
 * columns of ColumnDef.  The points come out as they stand, in metres. */
#ifndef VX_FORMATS_MINIPROF_H
#define VX_FORMATS_MINIPROF_H

#include "formats/points.h"

struct miniprof {
    char part;                       /* 'w' where the header is that of a wheel, else 0 */
    char side;                       /* 'l' or 'r' of Side, else 0 */
    double height, width, slope;     /* m, Sh, Sd and qR of the header; 0 where it does not say */
    struct points points;
};

/* section: of a .mpt, from 1; 0 where there is one.  path "-" is standard input. */
const char *miniprof_read(struct miniprof *m, const char *path, int64_t section);
void miniprof_free(struct miniprof *m);

#endif
