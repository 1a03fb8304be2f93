/* Where a wheel stands on its rail: between which nodes, and the element's shapes there.
 *
 * x forward, z down, pitch t = -dw/dx. */
#ifndef VX_INTEGRATE_WHEEL_PLACE_H
#define VX_INTEGRATE_WHEEL_PLACE_H

#include "formats/trk.h"
#include "tools/integrate/head.h"
#include "tools/track/beam.h"

struct wheel_place {
    int64_t node;         /* ahead of the wheel is node + 1 */
    double shape[4];      /* of [w t w t] */
    double slope[4];      /* 1/m their derivatives by x */
    double compliance;    /* m/N of the loaded element with held ends */
    struct head_place head;    /* of a spatial rail, by way_find alone */
};

/* beam [nodes - 1]: the elements of the rail; x must lie between the first and the last node. */
struct wheel_place wheel_place_find(const struct trk *t, const struct beam *beam, double x);

#endif
