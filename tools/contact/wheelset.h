/* How a wheelset rests on its two rails: height and roll from the contact tables of both sides.
 *
 * x forward, y to the right, z down; right-handed angles.  z is that of the running circles' lowest points at roll 0, the
 * mean of both where their radii differ. */
#ifndef VX_CONTACT_WHEELSET_H
#define VX_CONTACT_WHEELSET_H

#include "tools/contact/lookup.h"

enum { WHEELSET_LEFT, WHEELSET_RIGHT };

struct wheelset_side {
    double u;                              /* m, displacement against the rail */
    double z;                              /* m, of the running circle's lowest point */
    int n;                                 /* contacts, the first to touch first */
    struct contact contact[CONTACT_MAX];
    double force[CONTACT_MAX];             /* N, normal force of each; 0 when rigid */
    double radius;                         /* m, rolling radius: of the touching contact, or the mean by force */
};

struct wheelset {
    double z, roll;                        /* m, rad */
    struct wheelset_side side[2];
    double radius_difference;              /* m, right minus left */
};

/* Rests the wheelset displaced by y (m), yawed (rad), at station s (m): rigid where load is 0, else with elastic contacts that carry
 * `load` (N) vertically on each wheel.  roll_free 0 keeps the roll at 0, each side at its own height, as EN 15302 does. */
const char *wheelset_rest(const struct ctab *left, const struct ctab *right, double s, double yaw, double y, double load,
                          int roll_free, struct wheelset *w);

/* One position of a sweep. */
struct wheelset_point {
    double y, z, roll;                     /* m, m, rad */
    double radius_difference;              /* m */
    double rail_y[2], wheel_y[2];          /* m, touching contact on rail and wheel, left and right */
    double angle[2];                       /* rad, slope angle of its contact plane: negative on a right rail's gauge side */
};

/* Rigid rest positions at y = k step (m), from as far left to as far right as both tables reach, into p[most].  *n of them. */
const char *wheelset_sweep(const struct ctab *left, const struct ctab *right, double s, double yaw, double step, int roll_free,
                           struct wheelset_point *p, int64_t most, int64_t *n);

#endif
