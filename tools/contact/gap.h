/* Local minima of the gap between a rail and a wheel, both tabulated on one even lateral grid.
 *
 * y to the right, z down: a wheel whose running circle hangs at height H touches where z_rail(y) - z_wheel(y - u) = H, and touches
 * first where that is smallest.  Node j of the grid is y = j step, so u that is a multiple of the step shifts by whole nodes. */
#ifndef VX_CONTACT_GAP_H
#define VX_CONTACT_GAP_H

#include <stdint.h>

struct gap_curve {
    int64_t first, n;        /* nodes first .. first + n - 1 of the grid */
    double *z;               /* m [n] */
    double *slope;           /* 1 [n] dz/dy */
    double *k;               /* 1/m [n] curvature handed through */
};

enum { GAP_LEFT_END = 1, GAP_RIGHT_END = 2 };

struct gap_minimum {
    double y;                /* m, on the rail */
    double gap;              /* m */
    double z, slope;         /* m, 1, of the rail; the wheel's slope at an end of the rail */
    double rail_k, wheel_k;  /* 1/m, as handed through */
    int end;                 /* the end of the rail's polyline, not a smooth minimum */
};

/* Most nodes a polyline y[n] (m, NaN ignored) covers on the grid of this step (m). */
int64_t gap_nodes(const double *y, int64_t n, double step);

/* Polyline y, z, slope, curvature k [n] by cubic Hermite on the grid, into arrays of c with room for gap_nodes.  Only pieces of
 * increasing y count; where pieces overlap the lowest (greatest z) is kept, where some are missing the longest run. */
void gap_tabulate(const double *y, const double *z, const double *slope, const double *k, int64_t n, double step, struct gap_curve *c);

/* Minima for the wheel moved right by `shift` nodes into m[most], by increasing y; of minima nearer to each other than `apart` (m) the
 * lowest.  At ends (GAP_LEFT_END | GAP_RIGHT_END) of the rail a smallest gap counts too.  More than `most`: the lowest are kept. */
int gap_minima(const struct gap_curve *rail, const struct gap_curve *wheel, int64_t shift, double step, double apart, int ends,
               struct gap_minimum *m, int most);

#endif
