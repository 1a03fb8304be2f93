/* What contact tables say as rows of numbers to print: contacts at one place or along the track, a wheelset at rest, its sweep, its
 * conicity.
 *
 * x forward, y to the right, z down, SI units, as in lookup.h and wheelset.h. */
#ifndef VX_CONTACT_ROWS_H
#define VX_CONTACT_ROWS_H

#include "formats/columns.h"
#include "formats/ctab.h"

/* Who prints: columns [n], and the values [n] of one row. */
struct rows_printer {
    void (*header)(const struct column *c, int n);
    void (*row)(const struct column *c, int n, const double *value);
};

/* Contacts at station s, yaw, u and roll, the first to touch first. */
const char *rows_query(const struct ctab *t, double s, double yaw, double u, double roll,
                      const struct rows_printer *out);

/* The contact that touches, at stations from .. to; where there is none, no row. */
const char *rows_path(const struct ctab *t, double from, double to, double step, double yaw, double u, double roll,
                      const struct rows_printer *out);

/* The contact that touches in each of n tables, over the first one's u. */
const char *rows_tables(const struct ctab *t, int n, double s, double yaw, const struct rows_printer *out);

/* Two wheels of a wheelset, left and right; roll_free 0 keeps it level. */
struct rows_pair {
    const struct ctab *left, *right;
    double s, yaw;                   /* m, rad */
    int roll_free;
};

/* Height and roll at y (m) under load (N, 0 is rigid), then the contacts of both sides. */
const char *rows_wheelset(const struct rows_pair *p, double y, double load, const struct rows_printer *out);

/* Rest positions over y as far as both tables reach. */
const char *rows_rolling_radius(const struct rows_pair *p, const struct rows_printer *out);

/* Conicity and the other parameters at amplitudes [n] (m). */
const char *rows_conicity(const struct rows_pair *p, const double *amplitude, int n, const struct rows_printer *out);

#endif
