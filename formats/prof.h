/* .prof: cross-sections of one side, of a wheel or of a rail along the track: prof(5).
 *
 * Profile axes: y to the right, z down (track axes), on both sides; nothing is mirrored, so the field side
 * of a left rail has negative y.  The origin of a rail lies on the rail's top centre line, that of a wheel
 * on its nominal running circle (70 mm from the flange back).  `position` is the origin's y in track axes with
 * the wheelset centred, so that a wheel's point y touches the rail's point y + wheel position - rail position. */
#ifndef VX_FORMATS_PROF_H
#define VX_FORMATS_PROF_H

#include "formats/vxf.h"

enum { PROF_NAME = 32 };

struct prof {
    char name[64];
    char side;                       /* 'l' or 'r' */
    char part;                       /* 'w' wheel or 'r' rail */
    double position;                 /* m, y of the origin in track axes: negative on the left */
    double radius;                   /* m, of the wheel at its running circle; 0 for a rail */
    int64_t sections, bodies, polys, points;
    const double *station;           /* m [sections], increasing; one section is the same everywhere */
    const char (*body)[PROF_NAME];   /* [bodies] "rail", "stock rail", "switch and wing rail", "nose", ... */
    const int64_t *poly_section;     /* [polys] section of a polyline, not decreasing */
    const int64_t *poly_body;        /* [polys] its body, each at most once a section */
    const int64_t *poly_first;       /* [polys + 1] its first point; the last entry is points */
    const double *y, *z;             /* m [points], y increasing within a polyline */
    const double *slope;             /* 1 [points] dz/dy */
    const double *curvature;         /* 1/m [points] z''/(1 + z'^2)^1.5: positive where the centre lies below */
    const double *fall;              /* 1 [points] dz/dx along the track at this y: positive where the surface falls ahead; a wheel's is 0 */
    void *store;                     /* what prof_free releases; NULL where the arrays belong to a file */
};

/* The section nearest to station s (m). */
int64_t prof_nearest(const struct prof *p, double s);

/* Points into f, which must outlive p.  Checks everything stated above. */
const char *prof_read(struct prof *p, const struct vxf *f);
const char *prof_put(const struct prof *p, struct vxf_out *o);
void prof_free(struct prof *p);

#endif
