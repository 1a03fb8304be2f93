/* Track irregularity as people bring it: a text table of measured track geometry over the station: case-input(5).
 *
 * A heading of names with units, then a line of numbers each: "station (m), longitudinal_level (mm), cross_level (mm)".  Columns in any
 * order, between commas; station is required, and at least one quantity.  Quantities are those of EN 13848-1, in its axes: y to
 * the right, z down. */
#ifndef VX_FORMATS_IRREGULARITY_H
#define VX_FORMATS_IRREGULARITY_H

#include <stdint.h>

enum irregularity_quantity {
    IRREGULARITY_LEVEL,        /* m, longitudinal level: mean of both rails, down */
    IRREGULARITY_ALIGNMENT,    /* m, mean of both rails, to the right */
    IRREGULARITY_CROSS_LEVEL,  /* m, the right rail below the left one */
    IRREGULARITY_GAUGE,        /* m, wider than nominal */
    IRREGULARITY_QUANTITIES
};
extern const char *const irregularity_name[IRREGULARITY_QUANTITIES];

struct irregularity {
    int64_t n;
    double *x;                                  /* m [n] station, increasing */
    double *value[IRREGULARITY_QUANTITIES];     /* m [n]; NULL where the table has no such column */
    uint64_t hash;                              /* of the numbers */
};

/* At least two lines of numbers; refuses with the line's number. */
const char *irregularity_read(struct irregularity *t, const char *path);
void irregularity_free(struct irregularity *t);

#endif
