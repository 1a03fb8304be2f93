/* Two arrays of one shape compared element by element. */
#ifndef VX_FORMATS_VXF_COMPARE_H
#define VX_FORMATS_VXF_COMPARE_H

#include "formats/vxf.h"

/* An element is off where |a - b| > max(absolute, relative max(|a|, |b|)); an array differs where an element is off and the root
 * mean square of a - b is larger than rms.  Whole numbers must agree exactly.  All zero: the bits must agree. */
struct vxf_tolerance {
    double relative;       /* 1 */
    double absolute, rms;  /* in the unit of the array */
};

struct vxf_difference {
    int64_t off;           /* elements off */
    int64_t at;            /* of the largest difference among them, counted from 0 in storage order */
    double largest, rms;   /* largest |a - b| among them; over all elements */
    double a[2], b[2];     /* the elements there, real and imaginary part */
};

/* Same type, unit and dims; else the reason says what differs. */
const char *vxf_compare_shape(const struct vxf_array *a, const struct vxf_array *b);

/* 1 where the arrays, alike in shape, differ. */
int vxf_compare(const struct vxf_array *a, const struct vxf_array *b, const struct vxf_tolerance *t, struct vxf_difference *d);

#endif
