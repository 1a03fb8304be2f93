/* Plain points of a profile: text, two columns y z (a third, a weight, may follow) between blanks or commas, '#' comments:
 * profile-input(5).  A heading "y (mm),z (mm)" says the unit of the columns; else it is the caller's to say. */
#ifndef VX_FORMATS_POINTS_H
#define VX_FORMATS_POINTS_H

#include <stdint.h>

struct points {
    int64_t n;
    double *y, *z;       /* m [n] */
    double *weight;      /* 1 [n] */
};

/* unit: metres per unit of the columns, 0 where a heading must say it.  path "-" is standard input. */
const char *points_read(struct points *p, const char *path, double unit);
void points_free(struct points *p);

/* One more point; *room is the capacity of the arrays. */
const char *points_add(struct points *p, int64_t *room, double y, double z, double weight);

/* Reads one decimal number, blanks before it skipped; no hex, NaN or infinity.  NULL where there is none, else what follows it. */
const char *points_number(const char *text, double *x);

#endif
