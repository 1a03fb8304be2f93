/* Kinks of a line of points: where it turns by more than pi/6 over 2 mm (the rule of the program CONTACT for where a profile's spline
 * is cut; Vollebregt, User guide for CONTACT). */
#ifndef VX_PROFILE_KINKS_H
#define VX_PROFILE_KINKS_H

#include "formats/points.h"

#define KINK_TURN (M_PI / 6)
#define KINK_WINDOW 2e-3     /* m */

enum { KINKS_TOLD = 8 };

struct kinks {
    int64_t n;
    double y[KINKS_TOLD];    /* m, of the first of them */
    double turn[KINKS_TOLD]; /* rad, positive where the line turns down to +y, as over an edge of a rail */
};

/* The turn at a point is that between the chords over half the window before and after it; a kink is where it is greatest within
 * a window.  y increases along the points over all, z points down. */
void kinks_find(const struct points *p, struct kinks *k);

#endif
