/* A semidefinite matrix with a zero pivot has a zero column below it, so the factorisation goes on without that unknown. */
#include "tools/vehicle/semidefinite.h"

#include <float.h>
#include <math.h>

int64_t semidefinite_factor(int64_t n, double *A)
{
    int64_t singular = -1;

    for (int64_t j = 0; j < n; j++) {
        double d = A[j*n + j], noise = 64*(double)n*DBL_EPSILON*fabs(d);
        for (int64_t k = 0; k < j; k++)
            d -= A[j*n + k]*A[j*n + k]*A[k*n + k];           /* D_j = A_jj - sum L_jk^2 D_k */
        int free = d <= noise;
        if (free && singular < 0)
            singular = j;
        A[j*n + j] = fabs(d) <= noise ? 0 : d;
        if (d < -noise)
            return singular;
        for (int64_t i = j + 1; i < n; i++) {
            double l = A[i*n + j];
            for (int64_t k = 0; k < j; k++)
                l -= A[i*n + k]*A[j*n + k]*A[k*n + k];
            A[i*n + j] = free ? 0 : l/d;
        }
    }
    return singular;
}

void semidefinite_solve(int64_t n, const double *A, double *x, double *left)
{
    for (int64_t i = 0; i < n; i++) {
        for (int64_t k = 0; k < i; k++)
            x[i] -= A[i*n + k]*x[k];                         /* L y = x, row by row */
        left[i] = A[i*n + i] == 0 ? x[i] : 0;
    }
    for (int64_t i = n - 1; i >= 0; i--) {
        if (A[i*n + i] == 0) {
            x[i] = 0;
            continue;
        }
        x[i] /= A[i*n + i];                                  /* L' x = D^-1 y */
        for (int64_t k = i + 1; k < n; k++)
            x[i] -= A[k*n + i]*x[k];
    }
}
