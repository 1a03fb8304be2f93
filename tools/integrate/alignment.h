/* The track centre line in plan, curvature, heading and offset from the tangent at its beginning; and its cant.
 *
 * x forward, y to the right, yaw right-handed about z down, so curvature is positive to the right.  With stations s_i,
 *   heading(s) = integral of curvature,   offset(s) = integral of heading,
 * a point of the centre line at s lies offset(s) - offset(s0) - heading(s0)(s - s0) to the right of the tangent at s0, for the small
 * angles between the ends of a coupling.  So a train whose lateral positions and yaws count from here runs on this alignment as on a
 * straight track, and the curve enters where wheel meets rail and nowhere else.  The beginning is that of the first curve, or a station
 * beyond it, as the rear of a train that starts there.
 *
 * Cant rolls the plane of the rails about the centre line, right-handed about x: the left rail rises in a curve to the right.  Rolls and
 * places count from the level plane likewise, so that a ramp asks for no forces of its own frame. */
#ifndef VX_INTEGRATE_ALIGNMENT_H
#define VX_INTEGRATE_ALIGNMENT_H

#include <stdint.h>

struct alignment {
    int64_t n;
    const double *x;         /* m [n] stations, increasing; curvature 0 before the first */
    const double *curvature; /* 1/m [n] from x[i] to x[i + 1] */
    double *heading;         /* rad [n] at x[i] */
    double *offset;          /* m [n] at x[i] */
    double *own;             /* [2][n] x and curvature where alignment_begin has put in a station, else NULL */
    int64_t cants;
    const double *cant_x;    /* m [cants] stations, increasing */
    const double *cant;      /* m [cants] of the left rail over the right one; straight between, constant beyond */
    double base;             /* m, lateral distance of the rails it is measured over */
};

struct alignment_point {
    double curvature, heading, offset; /* 1/m, rad, m */
    double cant, twist;                /* rad, rad/m */
};

/* x and curvature must outlive a. */
const char *alignment_new(struct alignment *a, int64_t n, const double *x, const double *curvature);
/* Headings and offsets count from the tangent at station s, where that lies beyond the beginning: so they are small around a train that starts
 * in a curve.  At most once. */
const char *alignment_begin(struct alignment *a, double s);
/* Cants a, level before; x, cant [n] must outlive it. */
void alignment_raise(struct alignment *a, int64_t n, const double *x, const double *cant, double base);
void alignment_free(struct alignment *a);

struct alignment_point alignment_at(const struct alignment *a, double s);

#endif
