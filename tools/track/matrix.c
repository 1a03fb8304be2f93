#include "tools/track/matrix.h"

void matrix_add(const struct matrix *X, int64_t i, int64_t j, double value)
{
    if (X->pattern) {
        pattern_mark(X->pattern, i, j);
        return;
    }
    for (int64_t p = X->Ap[j]; p < X->Ap[j + 1]; p++)
        if (X->Ai[p] == i)
            X->x[p] += value;
}

void matrix_add_spring(const struct matrix *X, double k, int n, const int64_t *dof, const double *d)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            matrix_add(X, dof[i], dof[j], k * (d[i] * d[j]));
}
