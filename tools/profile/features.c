#include "tools/profile/features.h"

#include <math.h>

#define STEP 1e-4            /* m */
#define GENTLE (M_PI / 9)    /* 20 degrees */
#define STEEP (M_PI / 4)
#define RIDGE_SIDE 3e-3      /* m, to either side of a ridge */
#define RIDGE_TURN (M_PI / 36)

static double inclination(const struct curve *c, double s)
{
    double y[3], z[3];

    spline_at(&c->y, s, y);
    spline_at(&c->z, s, z);
    return atan2(z[1], y[1]);
}

static double height(const struct curve *c, double s)
{
    double z[3];

    spline_at(&c->z, s, z);
    return z[0];
}

static double top_find(const struct curve *c, double from, double to)
{
    double top = from, least = height(c, from);

    for (int64_t i = 1; from + (double)i * STEP < to; i++) {
        double z = height(c, from + (double)i * STEP);
        if (z < least) {
            least = z;
            top = from + (double)i * STEP;
        }
    }
    return top;
}

/* First place from s towards `end` where the inclination, times the direction of travel, exceeds `angle`. */
static double place_find(const struct curve *c, double s, double end, double angle)
{
    double way = end < s ? -1 : 1, before = way * inclination(c, s);

    for (; way * (end - s) > STEP; s += way * STEP) {
        double after = way * inclination(c, s + way * STEP);
        if (before < angle && after >= angle)
            return s + way * STEP * (angle - before) / (after - before);
        before = after;
    }
    return NAN;
}

void features_find(const struct curve *c, double from, double to, double *s)
{
    double top = top_find(c, from, to), left = top - RIDGE_SIDE, right = top + RIDGE_SIDE;

    s[FEATURE_LEFT_45] = place_find(c, top, from, STEEP);
    s[FEATURE_LEFT_20] = place_find(c, top, from, GENTLE);
    s[FEATURE_RIGHT_20] = place_find(c, top, to, GENTLE);
    s[FEATURE_RIGHT_45] = place_find(c, top, to, STEEP);
    s[FEATURE_RIDGE] = left > from && right < to && inclination(c, right) - inclination(c, left) > RIDGE_TURN ? top : NAN;
}
