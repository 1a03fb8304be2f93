/* .mod: natural modes of a track or a vehicle: mod(5). */
#ifndef VX_FORMATS_MOD_H
#define VX_FORMATS_MOD_H

#include "formats/vxf.h"

struct mod {
    char of[8];                   /* trk or veh */
    int64_t n, dofs;
    int64_t imaginaries;          /* n where the modes are damped ones, else 0 */
    const double *frequency;      /* Hz [n] increasing: undamped, or |s|/2pi of damped modes */
    const double *damping;        /* 1 [n] ratio, of the complex eigenvalue */
    const char (*name)[32];       /* [n] bounce, pitch, ..., or empty */
    const double *shape;          /* [n][dofs] scaled to unit modal mass; of damped modes the real part */
    const double *imaginary;      /* [imaginaries][dofs] */
    void *store;
};

const char *mod_read(struct mod *m, const struct vxf *f);
const char *mod_put(const struct mod *m, struct vxf_out *o);
void mod_free(struct mod *m);

#endif
