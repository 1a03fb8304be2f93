/* Outlines of rail bodies over stations, gathered into a .prof. */
#ifndef VX_PROFILE_SET_H
#define VX_PROFILE_SET_H

#include "formats/prof.h"
#include "tools/profile/outline.h"

struct set {
    int64_t bodies;
    const char *const *body;       /* [bodies] names, those of others */
    char (*names)[PROF_NAME];      /* [bodies] instead, its own */
    int64_t sections, polys;
    double *station;               /* m [sections] */
    struct set_poly {
        int64_t section, body;
        struct outline outline;
    } *poly;                       /* [polys] */
};

/* A section further on; then its bodies in order.  The set takes the outline over, also when it fails. */
const char *set_section(struct set *t, double station);
const char *set_body(struct set *t, int64_t body, struct outline *o);
void set_free(struct set *t);

/* Gathers all of it, mirrored for side 'l'; name, part, position and radius are already there, the position of the right side. */
const char *set_prof(const struct set *t, char side, struct prof *p);

#endif
