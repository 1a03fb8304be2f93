/* One polyline of a .prof: y to the right, z down, y increasing. */
#ifndef VX_PROFILE_OUTLINE_H
#define VX_PROFILE_OUTLINE_H

#include <stdint.h>

struct outline {
    int64_t n;
    double *y, *z;        /* m [n] */
    double *slope;        /* 1 [n] dz/dy */
    double *curvature;    /* 1/m [n] z''/(1 + z'^2)^1.5 */
    double *fall;         /* 1 [n] dz/dx along the track at this y, positive where the surface falls ahead; 0 as made */
};

const char *outline_new(struct outline *o, int64_t n);
void outline_free(struct outline *o);

void outline_shift(struct outline *o, double dy, double dz);

/* The other side of the track: y -> -y, exactly. */
void outline_mirror(struct outline *o);

/* Keeps points first .. end - 1. */
void outline_keep(struct outline *o, int64_t first, int64_t end);

#endif
