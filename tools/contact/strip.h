/* Normal contact of two bodies of like material whose patch need not be an ellipse, strip by strip along the track: ANALYN.
 *
 * y across the contact plane, x along the track.  A strip is a line of the patch along x; the undeformed gap is A x^2 + g(y). */
#ifndef VX_CONTACT_STRIP_H
#define VX_CONTACT_STRIP_H

#include <stdint.h>

enum { STRIP_RATIOS = 641 };

/* Hertz's results over B/A, for one material. */
struct strip_law {
    double modulus;                   /* Pa, G/(1 - nu) */
    double value[STRIP_RATIOS][3];    /* 1, over log(B/A) */
};

struct strip {
    double y, gap;                    /* m, given, y increasing */
    double A;                         /* 1/m, given */
    double share, stiff, reach, peak; /* 1, Pa, m, Pa/m^0.5: by strip_prepare */
    double half, pressure;            /* m, Pa, half length and highest pressure: by strip_patch */
};

struct strip_patch {
    double approach, force;           /* m, N */
    double area, pressure;            /* m^2, Pa, the highest */
    double y;                         /* m, of the force */
    double a, b;                      /* m, semi-axes along x and y of the ellipse of the same area and length over width */
    int parts;
};

/* G in Pa. */
void strip_law(double G, double nu, struct strip_law *law);

/* Takes the gap's curvature from its neighbours; n >= 3 strips. */
void strip_prepare(const struct strip_law *law, struct strip *strip, int64_t n);

/* N under an approach (m) of prepared strips. */
double strip_force(const struct strip *strip, int64_t n, double approach);

/* Approach (m) under a load (N > 0). */
double strip_approach(const struct strip *strip, int64_t n, double load);

void strip_patch(struct strip *strip, int64_t n, double approach, struct strip_patch *p);

#endif
