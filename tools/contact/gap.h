/* Local minima of the gap between a rail and a wheel, both tabulated on one even lateral grid.
 *
 * y to the right, z down, x forward from the section.  The rail's surface near x = x_t(y) is z_r(y) + e(y) q + k(y) q^2/2, q = x - x_t, e
 * its fall and k its bend along the track; the wheel's near its silhouette z_w(y), which lies at x = X(y), is
 * z_w - b(y) (x - X)^2/2.  In each plane y = const they come nearest at
 *
 *     q = (b (X - x_t) - e)/(b + k),    gap(y) = z_r - z_w + e q + k q^2/2 + b (x_t + q - X)^2/2
 *
 * where q stays within X +- reach(y), as far as the rail is known to run so.  A wheel whose running circle hangs at height H touches where
 * gap(y) = H, and touches first where that is smallest.  Node j of the grid is y = j step, so u that is a multiple of the step
 * shifts by whole nodes. */
#ifndef VX_CONTACT_GAP_H
#define VX_CONTACT_GAP_H

#include <stdint.h>

/* A polyline or a silhouette, [n] each; NaN in y leaves a point out. */
struct gap_line {
    int64_t n;
    double *y, *z;           /* m */
    double *slope;           /* 1 dz/dy */
    double *k;               /* 1/m curvature, handed through */
    double *along;           /* rail: 1 e; wheel: m X */
    double *bend;            /* 1/m, rail: k; wheel: b */
};

/* On the grid.  A node that nothing covers has the slope NaN. */
struct gap_curve {
    int64_t first, n;        /* nodes first .. first + n - 1 of the grid */
    double *z, *slope, *k;   /* as above [n] */
    double *along, *along_y; /* e or X, and its derivative by y [n] */
    double *bend, *bend_y;   /* k or b, the same [n] */
    double *at, *reach;      /* m [n] rail: x_t, and how far q may be from X; a wheel's are not read */
    int level;               /* the section as it is: e is handed through, k and x_t are 0 */
};

enum { GAP_LINE_ARRAYS = 6, GAP_ARRAYS = 9 };     /* of n doubles in a gap_line and in a gap_curve */

enum { GAP_LEFT_END = 1, GAP_RIGHT_END = 2 };

#define GAP_APART 4e-3       /* m: nearer minima on one body are one patch (D_COMB of CONTACT, Vollebregt 2022) */

struct gap_minimum {
    double y;                /* m, on the rail */
    double gap;              /* m */
    double x;                /* m, ahead of the section */
    double z, slope;         /* m, 1, of the rail there, at x; the wheel's slope at an end of the rail */
    double fall;             /* 1, of the rail there, e + k q */
    double rail_k, wheel_k;  /* 1/m, as handed through */
    int end;                 /* the end of the rail's polyline, not a smooth minimum */
};

/* Most nodes a polyline y[n] (m, NaN ignored) covers on the grid of this step (m). */
int64_t gap_nodes(const double *y, int64_t n, double step);

/* The line by cubic Hermite on the grid, into arrays of c with room for gap_nodes.  Only pieces of increasing y count; where pieces
 * overlap the lowest (greatest z) is kept. */
void gap_tabulate(const struct gap_line *line, double step, struct gap_curve *c);

/* Takes over from `from`, the curve of a section x (m) further on, the nodes at which a wheel that stands over this section, of bend b
 * (1/m), is nearer to that one. */
void gap_join(struct gap_curve *c, const struct gap_curve *from, double x, double b);

struct gap_search {
    double step;             /* m, of the grid */
    double apart;            /* m: of minima nearer to each other the lowest counts */
    double *work;            /* [n of the longest rail] */
};

/* Minima for the wheel moved right by `shift` nodes into m[most], by increasing y.  At ends (GAP_LEFT_END | GAP_RIGHT_END) of the rail a
 * smallest gap counts too, and at the left end of the wheel where that is the back of its flange.  More than `most`: the lowest are kept. */
int gap_minima(const struct gap_search *s, const struct gap_curve *rail, const struct gap_curve *wheel, int64_t shift, int ends,
               struct gap_minimum *m, int most);

/* A rail and a wheel moved right by `shift` nodes. */
struct gap_pair {
    const struct gap_curve *rail, *wheel;
    int64_t shift;
    double step;             /* m, of the grid */
};

struct gap_place {
    double gap, z;           /* m, z of the rail */
    double slope, rail;      /* 1, of the gap and of the rail */
    double bend;             /* 1/m, of both along the track, b + k */
};

/* The gap (m) at node i of the rail, over which lies node j of the wheel. */
double gap_node(const struct gap_curve *rail, const struct gap_curve *wheel, int64_t i, int64_t j);

/* What lies at y (m, on the rail): 1, or 0 where one of the curves does not reach. */
int gap_at(const struct gap_pair *pair, double y, struct gap_place *p);

#endif
