/* A matrix of the track while it is assembled: entries are added to its values, or marked where the pattern is still sought. */
#ifndef VX_TRACK_MATRIX_H
#define VX_TRACK_MATRIX_H

#include "tools/track/pattern.h"

struct matrix {
    struct pattern *pattern;           /* where entries are marked; NULL: they are added to x */
    const int64_t *Ap, *Ai;            /* [dofs + 1], [Ap[dofs]] by column, as pattern_list gives them */
    double *x;                         /* [Ap[dofs]] */
};

/* An entry outside the pattern is passed over. */
void matrix_add(const struct matrix *X, int64_t i, int64_t j, double value);

/* k d d', of a spring of stiffness k (or a damper) whose extension is d.u: dof, d [n]. */
void matrix_add_spring(const struct matrix *X, double k, int n, const int64_t *dof, const double *d);

#endif
