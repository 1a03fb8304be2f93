/* Measured sections along the track, cut into bodies that go on from section to section, as a set.
 *
 * All sections of a list share their axes: y to the right, z down, of a right rail. */
#ifndef VX_PROFILE_MEASURED_H
#define VX_PROFILE_MEASURED_H

#include "tools/profile/clean.h"
#include "tools/profile/loft.h"
#include "tools/profile/set.h"

struct measured_section {
    double station;                  /* m */
    struct curve curve, shape;       /* shape: smoothed until its direction is clear */
    double *feature;                 /* m [features] */
};

struct measured {
    int64_t n, features;             /* features: declared of each section, 0 for none */
    struct measured_section *section;
    int64_t points;                  /* that the sections had */
    struct clean_count clean;        /* of all */
    struct curve_residual residual;  /* worst of all; rms over all points */
    double worst_station;            /* m, of the worst */
    int64_t bodies;
    struct loft *body;               /* [bodies] in the order in which they begin, from the left */
};

/* A section further on, feature[m->features] (m, negative: not there) along it.  Orders the points in place. */
const char *measured_add(struct measured *m, double station, struct points *p, const double *feature, double smoothing);

/* Cuts all sections at z = deepest (m) and joins the pieces that lie over one another into bodies, named "`name`", "`name` 2", ... */
const char *measured_join(struct measured *m, double deepest, const char *name);
void measured_free(struct measured *m);

struct measured_options {
    double smoothing, spacing;       /* m */
    double every;                    /* m, most between two sections that differ; 0 by how far bodies move */
    double top;                      /* m, z that becomes 0 */
    double at;                       /* m, added to stations */
};

/* Sections of the bodies of list[lists]; set->bodies and names are those of all in turn. */
const char *measured_set(const struct measured *list, int64_t lists, const struct measured_options *o, struct set *set);

#endif
