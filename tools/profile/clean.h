/* What measured points need before a curve can go through them, and what a curve needs before it is a function of y. */
#ifndef VX_PROFILE_CLEAN_H
#define VX_PROFILE_CLEAN_H

#include "formats/points.h"
#include "tools/profile/outline.h"

struct clean_count { int64_t doubles, zigzags; double longest_gap; };

/* Orders the points with y increasing over all, drops points nearer than 1 um to the one before and points where the
 * line turns back by more than 120 degrees.  Refuses a shape shorter than 5 mm or longer than 500 mm: a wrong unit. */
const char *clean_points(struct points *p, struct clean_count *count);

/* Keeps the longest piece along which y increases and |slope| stays below 60 (89 degrees): overhang and side faces fall away. */
const char *clean_outline(struct outline *o);

#endif
