/* Simpack profiles .prr (rail) and .prw (wheel): profile-input(5).
 *
 * The points come out in metres after the file's own keys were applied in their order: point.dist.min, shift.y, shift.z,
 * rotate (about x, right-handed: y towards z), bound.*, mirror.y, mirror.z, inversion, units.  approx.smooth is told, not applied. */
#ifndef VX_FORMATS_SIMPACK_H
#define VX_FORMATS_SIMPACK_H

#include "formats/points.h"

struct simpack {
    char part;               /* 'w' wheel or 'r' rail */
    double smooth;           /* approx.smooth as in the file */
    struct points points;
};

const char *simpack_read(struct simpack *s, const char *path);
void simpack_free(struct simpack *s);

#endif
