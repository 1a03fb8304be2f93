/* The wheel's silhouettes and the rail bodies of one section on a common grid, and the contacts found between them.
 *
 * x forward, y to the right, z down, of the right side: profiles of a left side are mirrored in. */
#ifndef VX_CONTACT_SEARCH_H
#define VX_CONTACT_SEARCH_H

#include "formats/prof.h"
#include "tools/contact/gap.h"
#include "tools/contact/locus.h"
#include "tools/contact/thesis.h"

/* Sections as they are, the wheel orthogonal or turned after thesis.h; or silhouettes, and rails that fall along the track. */
enum search_method { SEARCH_PLANE, SEARCH_THESIS, SEARCH_EXACT };

enum { SEARCH_MOST = 8, SEARCH_BODY_MOST = 3, SEARCH_BODIES = 8, SEARCH_KEPT = 64 };

struct search {
    int mirror;                              /* the profiles are those of a left side */
    double wheel_position, rail_position;    /* m, mirrored with the profiles */
    struct gap_search gap;
    void *store;
    struct gap_line line;                    /* room for the longest polyline */
    struct gap_line silhouette;              /* room for the wheel's */
    enum search_method method;
    double radius;                           /* m, of the wheel */
    struct thesis_cut *cut;                  /* [yaws] by SEARCH_THESIS */
    struct gap_curve *wheel;                 /* [yaws] y from the rail's origin */
    struct gap_curve rail[SEARCH_BODIES];
    struct search_kept {                     /* curves of sections nearby, tabulated once */
        int64_t poly;                        /* 1 + number of the polyline, 0 none yet */
        struct gap_curve curve;
    } kept[SEARCH_KEPT];
    int body[SEARCH_BODIES], ends[SEARCH_BODIES], bodies;
};

struct search_contact {
    struct gap_minimum at;
    int body;
    struct gap_pair pair;                    /* the curves it lies between */
    const struct thesis_cut *cut;            /* of the wheel's profile, NULL where it is a silhouette */
};

/* Tabulates the silhouettes, or profiles as of thesis.h, for yaw[yaws] (rad, even about 0); to be released by search_free, also after a failure. */
const char *search_begin(struct search *s, const struct prof *wheel, const struct prof *rail, const double *yaw, int64_t yaws,
                         enum search_method method, double step);
void search_free(struct search *s);

/* Tabulates the rail bodies of a section. */
const char *search_section(struct search *s, const struct prof *rail, int64_t section);

/* Contacts at the iy-th yaw with the wheel moved right by `shift` nodes, the first to touch first. */
int search_contacts(const struct search *s, int64_t iy, int64_t shift, struct search_contact c[SEARCH_MOST]);

#endif
