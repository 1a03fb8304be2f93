/* Lists of cross-sections along the track: CONTACT .slcs, or an index beside numbered files: profile-input(5).
 *
 * Only the list is read here; the files it names hold the sections.  Features are places that lines along the track join from section
 * to section, as lengths along the polyline from its end of least y. */
#ifndef VX_FORMATS_SLICES_H
#define VX_FORMATS_SLICES_H

#include <stdint.h>

struct slices {
    int64_t n;
    double *station;         /* m [n], increasing */
    char **file;             /* [n] a relative name counts from the list's folder */
    int64_t features;        /* 0 where none are declared */
    double *feature;         /* m [n][features]; negative: not there; may lie beyond the polyline's end */
};

/* CONTACT .slcs; kinks and accelerations between parts are checked and not kept.  Refuses .slcw, a wheel out of round. */
const char *slices_read(struct slices *s, const char *path);

/* Two columns, number and station (m); the number takes the place of the '*' in files.  The numbers are as written: 01 stays 01. */
const char *slices_index(struct slices *s, const char *path, const char *files);

/* One more section, no features; station must lie beyond the last. */
const char *slices_add(struct slices *s, double station, const char *file);
void slices_free(struct slices *s);

#endif
