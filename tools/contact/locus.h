/* Where a wheel turned by yaw can touch a rail that runs on unchanged: its silhouette along the track.
 *
 * x forward, y to the right, z down.  A wheel is a surface of revolution; a, the coordinate along its axle, and y count from the
 * wheelset's centre, about which it yaws; x from the wheel's own centre, the running circle's; z from that circle's lowest point. */
#ifndef VX_CONTACT_LOCUS_H
#define VX_CONTACT_LOCUS_H

#include <stdint.h>

struct locus_wheel {
    int64_t n;
    const double *y, *z;       /* m [n] points in the wheel's profile axes */
    const double *slope;       /* 1 [n] dz/dy */
    const double *k;           /* 1/m [n] curvature, z''/(1 + z'^2)^1.5 */
    double position;           /* m, of the profile's origin on the axle */
    double radius;             /* m, of the running circle */
};

struct locus {
    double *y, *z;             /* m [n] */
    double *slope;             /* 1 [n] dz/dy of the silhouette */
    double *x;                 /* m [n] how far ahead it lies */
    double *bend;              /* 1/m [n] b: in the plane y = const the wheel's surface is z - b (x' - x)^2/2 */
};

/* Turned by yaw (rad).  A point too steep to be on the silhouette has y NaN.  Where the silhouette folds, y goes back; what lies lowest
 * there is for gap_tabulate to keep. */
void locus_silhouette(const struct locus_wheel *w, double yaw, const struct locus *o);

struct locus_point {
    double a;                  /* m, along the axle */
    double r;                  /* m, distance from the axle's axis */
    double rate;               /* 1, dr/da */
    double turn;               /* rad, from the lowest point of its circle, positive ahead */
};

/* The wheel's point seen at x, y, z, all from the wheelset's centre, where the wheel's surface has this slope dz/dy at x = const. */
void locus_invert(double x, double y, double z, double slope, double radius, double yaw, struct locus_point *p);

#endif
