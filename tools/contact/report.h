/* What contact tables say as rows of numbers to print: contacts at one place or along the track, a wheelset at rest, its sweep, its
 * conicity.
 *
 * x forward, y to the right, z down, SI units, as in lookup.h and wheelset.h. */
#ifndef VX_CONTACT_REPORT_H
#define VX_CONTACT_REPORT_H

#include "formats/columns.h"
#include "formats/ctab.h"

/* Who prints: columns [n], and the values [n] of one row. */
struct report_printer {
    void (*header)(const struct column *c, int n);
    void (*row)(const struct column *c, int n, const double *value);
};

/* Contacts at station s, yaw, u and roll, the first to touch first. */
const char *report_query(const struct ctab *t, double s, double yaw, double u, double roll, const struct report_printer *out);

/* The contact that touches, at stations from .. to, which increase; where there is none, no row. */
const char *report_path(const struct ctab *t, double from, double to, double step, double yaw, double u, double roll,
                        const struct report_printer *out);

/* The contact that touches in each of n tables, over the first one's u. */
const char *report_sweep(const struct ctab *t, int n, double s, double yaw, const struct report_printer *out);

/* Two wheels of a wheelset, left and right; roll_free 0 keeps it level. */
struct report_pair {
    const struct ctab *left, *right;
    double s, yaw;                   /* m, rad */
    int roll_free;
};

/* Height and roll at y (m) under load (N, 0 is rigid), then the contacts of both sides. */
const char *report_wheelset(const struct report_pair *p, double y, double load, const struct report_printer *out);

/* Rest positions over y as far as both tables reach. */
const char *report_rolling_radius(const struct report_pair *p, const struct report_printer *out);

/* Conicity and the other parameters at amplitudes [n] (m). */
const char *report_conicity(const struct report_pair *p, const double *amplitude, int n, const struct report_printer *out);

#endif
