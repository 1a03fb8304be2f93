/* An axis of a chart: from numbers to places along it, round numbers to mark, and how they are written. */
#ifndef VX_DRAW_SCALE_H
#define VX_DRAW_SCALE_H

#include <stddef.h>

enum { SCALE_TICKS = 64, SCALE_MINORS = 256, SCALE_LABEL = 32 };

struct scale {
    int log;                              /* logarithmic: lo and hi are positive */
    double lo, hi;                        /* lo < hi */
    int ticks, minors;
    double tick[SCALE_TICKS];             /* [ticks] labelled, within lo..hi */
    char label[SCALE_TICKS][SCALE_LABEL]; /* [ticks] UTF-8 */
    double minor[SCALE_MINORS];           /* [minors] marked without a label: logarithmic axes */
};

/* The smallest of 1, 2 and 5 times a power of ten that divides range into at most `most` steps. */
double scale_step(double range, int most);

/* Widens lo..hi to round numbers: multiples of the step, chosen where it is 0; 1, 2 or 5 times a power of ten where log. */
void scale_widen(double *lo, double *hi, int log, double step, int most);

/* An axis over lo..hi with about `most` labelled ticks, `step` apart where that is not 0. */
void scale_set(struct scale *s, double lo, double hi, int log, double step, int most);

/* The place of v: 0 at lo, 1 at hi, beyond outside; NaN where a logarithm has none. */
double scale_place(const struct scale *s, double v);

/* Writes v, one of numbers up to `largest` that lie `step` apart: 0.25, 1000, 2×10⁻⁹ in superscript. */
void scale_format(char label[SCALE_LABEL], double v, double step, double largest);

#endif
