/* .frf: receptances, mobilities or accelerances of a track, H(f) = motion over force, exp(+i w t): frf(5). */
#ifndef VX_FORMATS_FRF_H
#define VX_FORMATS_FRF_H

#include "formats/vxf.h"

enum { FRF_RECEPTANCE, FRF_MOBILITY, FRF_ACCELERANCE, FRF_QUANTITIES };

/* [FRF_QUANTITIES] what H is: displacement, velocity or acceleration over force, (i w)^n times the receptance. */
extern const struct frf_quantity { const char *name, *unit; } frf_quantity[];

struct frf_place {
    char on[8];                   /* left, right, both (rails, each loaded by the same force), or sleeper */
    char at[12];                  /* sleeper, midspan or station */
    double x;                     /* m */
    int lateral;                  /* sideways, else vertical */
};

struct frf {
    int quantity;
    struct frf_place force, motion;
    int64_t n;
    const double *frequency;      /* Hz [n] increasing */
    const double *H;              /* [n][2] real and imaginary part, in the unit of its quantity */
    const double *hermite;        /* [n][2] the same by equations 7 to 9 of Lau and Hoff 2018; [0] where nothing differs */
    int64_t hermites;             /* n or 0 */
    const double *coherence;      /* 1 [n] of a receptance estimated from histories, 0 to 1; [0] where there is none */
    int64_t coherences;           /* n or 0 */
    void *store;
};

const char *frf_read(struct frf *r, const struct vxf *f);
const char *frf_put(const struct frf *r, struct vxf_out *o);
void frf_free(struct frf *r);

#endif
