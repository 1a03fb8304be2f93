/* Which lengths along a section's curve belong to which along the next one's. */
#ifndef VX_PROFILE_LINK_H
#define VX_PROFILE_LINK_H

#include "tools/profile/piece.h"

enum { LINK_MOST = PIECE_FEATURES + 2 };

struct link {
    int n;
    double a[LINK_MOST];     /* m [n] along the curve of a section, increasing */
    double b[LINK_MOST];     /* m [n] along that of the next */
};

/* Joined at the features that both pieces have at like distances.  Ends that are not cut are joined where they lie about as far from the
 * last feature; else the link goes as far from there as the shorter piece. */
void link_make(const struct piece *a, const struct piece *b, struct link *link);

/* to at `from`, by a table from[n], to[n]; NAN beyond it. */
double link_map(int n, const double *from, const double *to, double at);

#endif
