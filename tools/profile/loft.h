/* The surface of one rail body between measured sections.
 *
 * Consecutive sections are joined by lines along the track: a link pairs lengths along one curve with lengths along the next at features
 * they share, and proportionally between these.  Along a line y and z are cubics of the station.  Its slopes at a section are those of the
 * parabola through it and its neighbours, along the section and normal to it, limited so that the cubic is monotone where the sections are
 * (de Boor and Swartz, J. Approx. Theory 21 (1977) 411): nothing overshoots by more than 10 um, and the surface has no crease at a
 * section.  Where a body begins or ends they are one-sided.
 *
 * y to the right, z down, x and stations forward. */
#ifndef VX_PROFILE_LOFT_H
#define VX_PROFILE_LOFT_H

#include "formats/prof.h"
#include "tools/profile/link.h"
#include "tools/profile/outline.h"

struct loft_section {
    double station;                   /* m */
    const struct curve *curve;
    struct piece piece;
};

struct loft {
    char name[PROF_NAME];
    int64_t n;
    struct loft_section *section;     /* [n] */
    struct link *link;                /* [n - 1] used */
};

/* A section further on; the curve must outlive the loft. */
const char *loft_add(struct loft *l, double station, const struct curve *c, const struct piece *p);
void loft_free(struct loft *l);

/* The most a point of the surface moves (m) from section i to i + 1. */
double loft_motion(const struct loft *l, int64_t i);

/* The outline at station s between the first and the last section, n = 0 elsewhere: points `spacing` (m) apart; a spline that halves
 * waves of length `smoothing` (m) takes out what the lines leave uneven.  fall = dz/dx at fixed y = dZ/ds - slope dY/ds. */
const char *loft_outline(const struct loft *l, double s, double spacing, double smoothing, struct outline *o);

#endif
