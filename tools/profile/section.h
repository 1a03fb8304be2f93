/* From the points of a shape to the outline of a .prof: order, incline, smooth, resample, find the gauge face, cut the overhang. */
#ifndef VX_PROFILE_SECTION_H
#define VX_PROFILE_SECTION_H

#include "formats/points.h"
#include "tools/profile/clean.h"
#include "tools/profile/curve.h"
#include "tools/profile/kinks.h"

struct section_options {
    int wheel;                /* else a rail */
    double cant;              /* 1, rail */
    double gauge_depth;       /* m, rail */
    double smoothing;         /* m */
    double spacing;           /* m */
};

struct section {
    struct outline outline;   /* right side; rail: top at z = 0; wheel: z = 0 at y = 0, its running circle */
    double gauge_face;        /* m, y of it; rail */
    double cant;              /* 1, the inclination found, dimensions.h; rail */
    int64_t points;           /* that the shape had */
    struct clean_count clean;
    struct kinks kinks;       /* of the points as read, before smoothing */
    struct curve_residual residual;
};

/* Orders and turns the points in place. */
const char *section_make(struct section *s, struct points *p, const struct section_options *o);
void section_free(struct section *s);

#endif
