/* A yawed wheel after Lau (doctoral thesis, NTNU 2018:210, section 2.3), the method `thesis`: the profile itself, turned in two
 * dimensions, without the short section between tread and flange contact that yaw makes the rail pass over.
 *
 * x forward, y to the right, z down, of a right wheel, whose flange has negative y.  a, the coordinate along the axle, counts from the
 * wheelset's centre, about which it yaws; z from the running circle's lowest point. */
#ifndef VX_CONTACT_THESIS_H
#define VX_CONTACT_THESIS_H

#include "tools/contact/locus.h"

/* The section removed; zeroed, none. */
struct thesis_cut {
    double y;          /* m, in the wheel's profile axes: its end at the tread */
    double dy, dz;     /* m, what lies beyond it moves dy out to the rail and dz up to close the profile */
};

/* The section to be removed at this yaw (rad); y of the wheel increases. */
const char *thesis_section(const struct locus_wheel *w, double yaw, struct thesis_cut *cut);

/* The profile turned by yaw and closed over the cut, as locus_silhouette gives a silhouette.  Points of the section removed all fall on its
 * end at the tread. */
void thesis_profile(const struct locus_wheel *w, double yaw, const struct thesis_cut *cut, const struct locus *o);

/* The wheel's point seen at x, y, z, all from the wheelset's centre, where that profile has this slope; wheel as of locus_wheel. */
void thesis_invert(double x, double y, double z, double slope, double position, double radius, double yaw, const struct thesis_cut *cut,
                   struct locus_point *p);

/* Largest yaw (rad) of a wheelset that moves by `clearance` (m) to either side before a flange touches. */
double thesis_yaw(double clearance);

#endif
