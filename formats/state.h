/* .state: everything a passage carries from step to step, at one station, so that a run goes on from there: state(5).
 *
 * Numbers are SI, in the order of the program that wrote them; the track's arrays stand beside them, so that a track that differs can be
 * told from the one the state belongs to. */
#ifndef VX_FORMATS_STATE_H
#define VX_FORMATS_STATE_H

#include "formats/vxf.h"

enum { STATE_PARTS = 24, STATE_DIFFERENCES = 64 };

struct state_part {
    const char *name;              /* the array's */
    int64_t n;
    double *x;                     /* [n] */
};

struct state {
    char scheme[16];               /* explicit or implicit */
    char direction[16];            /* facing or trailing */
    char failed[256];              /* why the run ended there; empty where it went on */
    double speed, step;            /* m/s, s */
    double start, station;         /* m, of the front wheelset: where the run began, where it is */
    double steps;                  /* done */
    double reach[2];               /* m, stations between which the track moves or bends more than by its own weight */
    uint64_t vehicle, contact[2], text; /* contents of vehicle, tables and case */
    int64_t dofs;                  /* of the track */
    const double *rest;            /* m, rad [dofs] the track under its own weight */
    const struct vxf *track;       /* what holds the track's arrays: a .trk to write, the .state when read */
    const struct vxf *file;        /* the .state when read */
};

/* Points into f, which must outlive s. */
const char *state_read(struct state *s, const struct vxf *f);
/* parts [n] beside what s says. */
void state_put(const struct state *s, int n, const struct state_part *part, struct vxf_out *o);
/* Copies the state's numbers into the parts, which must be those it was written with. */
const char *state_get(const struct state *s, int n, const struct state_part *part);

/* An array of the track that is not as the state has it. */
struct state_difference {
    char name[VXF_NAME];
    double from, to;               /* m, stations; -infinity to infinity where it has none */
};

/* What differs between the state's track and this .trk, into d [STATE_DIFFERENCES]; *n of them.  Fails where the tracks are not
 * of one shape. */
const char *state_compare(const struct state *s, const struct vxf *track, struct state_difference *d, int *n);

#endif
