/* Plan of a tangential turnout: a straight track and one that leaves it from s = 0 on an arc of radius R (its centre line) up
 * to the crossing angle atan(1/n), then straight.
 *
 * Seen from the route a train takes, s along its centre line, on the side that carries switch rail and nose.  Distances
 * count outwards from the route's running edge (half a gauge from its centre line), perpendicular to the route. */
#ifndef VX_PROFILE_PLAN_H
#define VX_PROFILE_PLAN_H

struct plan {
    double radius;       /* m, of the diverging centre line */
    double angle;        /* rad, where the arc ends */
    double gauge;        /* m */
    int diverging;       /* the route taken, else through */
};

/* To the gauge face of the stock rail, which the other route runs on: 0 before the front, then s^2/2R and more. */
double plan_stock(const struct plan *p, double s);

/* To the running edge of the other route's inner rail: minus the gauge at the front, 0 where both edges meet in the mathematical
 * point of the crossing, behind it the width between the edges of the nose. */
double plan_separation(const struct plan *p, double s);

/* Station where the separation has this value. */
double plan_separation_station(const struct plan *p, double separation);

#endif
