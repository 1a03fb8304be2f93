/* .frf: receptances of a track, H(f) = displacement over force, exp(+i w t): frf(5). */
#ifndef VX_FORMATS_FRF_H
#define VX_FORMATS_FRF_H

#include "formats/vxf.h"

struct frf {
    char excite[8];               /* left, right, both: the rails loaded, each by the same force */
    char at[12];                  /* sleeper or midspan */
    double x;                     /* m, station of force and response */
    int64_t n;
    const double *frequency;      /* Hz [n] increasing */
    const double *receptance;     /* m/N [n][2] real and imaginary part, of the loaded rail (left where both) */
    const double *hermite;        /* m/N [n][2] the same by equations 7 to 9 of Lau and Hoff 2018; [0] above a sleeper */
    int64_t hermites;             /* n or 0 */
    void *store;
};

const char *frf_read(struct frf *r, const struct vxf *f);
const char *frf_put(const struct frf *r, struct vxf_out *o);
void frf_free(struct frf *r);

#endif
