/* Bodies of one section: the pieces of its polyline that a wheel can reach, cut where the surface is deep (a flangeway) or where the
 * declared features end.
 *
 * Lengths count along the section's curve from its end of least y. */
#ifndef VX_PROFILE_PIECE_H
#define VX_PROFILE_PIECE_H

#include "tools/profile/curve.h"

enum { PIECE_FEATURES = 32, PIECES_MOST = 8 };

struct piece {
    double from, to;                      /* m, along the curve */
    int cut[2];                           /* an end is where the surface gets too deep, not where the polyline or a feature ends */
    double y_least, y_most;               /* m */
    int features;
    double feature[PIECE_FEATURES];       /* m, along the curve, inside the piece and increasing; NAN where not there */
};

/* Pieces between `from` and `to` above z = deepest (m) and longer than 5 mm, from the left; how many.  Features are found by the
 * inclination of `shape`, the same section smoothed until its direction is clear. */
int piece_cut(const struct curve *c, const struct curve *shape, double from, double to, double deepest, struct piece piece[PIECES_MOST]);

/* Features declared at at[n] (m, n <= PIECE_FEATURES, negative: not there) instead; those outside the piece fall away. */
void piece_declare(struct piece *p, int n, const double *at);

#endif
