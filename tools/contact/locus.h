/* Where a wheel turned by yaw can touch a prismatic rail: its silhouette along the track.
 *
 * x forward, y to the right, z down.  A wheel is a surface of revolution; a, the coordinate along its axle, and y count from the
 * wheelset's centre, about which it yaws; z from the running circle's lowest point. */
#ifndef VX_CONTACT_LOCUS_H
#define VX_CONTACT_LOCUS_H

#include <stdint.h>

/* Silhouette of a wheel profile: points y, z (m) and slopes dz/dy [n] in the wheel's profile axes, its origin at `position` (m) on
 * the axle, rolling radius `radius` (m), yaw (rad), into ly, lz (m) and lslope [n].  A point too steep to be on the silhouette
 * becomes NaN.  Where the silhouette folds, ly goes back; what lies lowest there is for gap_tabulate to keep. */
void locus_silhouette(const double *y, const double *z, const double *slope, int64_t n, double position, double radius, double yaw,
                      double *ly, double *lz, double *lslope);

struct locus_point {
    double a;          /* m, along the axle */
    double r;          /* m, distance from the axle's axis */
    double rate;       /* 1, dr/da */
    double turn;       /* rad, from the lowest point of its circle, positive ahead */
    double x;          /* m, ahead of the wheelset's centre */
};

/* The wheel's point that appears at y, z with this slope in the silhouette. */
void locus_invert(double y, double z, double slope, double radius, double yaw, struct locus_point *p);

#endif
