#include "tools/vehicle/table.h"

#include <math.h>

/* Number of the piece, from 0 to n - 2, on which `at` lies; a knot belongs to the piece that begins there. */
static int64_t piece(int64_t n, const double *x, double at)
{
    int64_t k = 0;

    while (k < n - 2 && at >= x[k + 1])
        k++;
    return k;
}

double table_slope(int64_t n, const double *x, const double *F, double at)
{
    int64_t k = piece(n, x, at);

    return (F[k + 1] - F[k])/(x[k + 1] - x[k]);
}

double table_at(int64_t n, const double *x, const double *F, double at)
{
    int64_t k = piece(n, x, at);

    return F[k] + (F[k + 1] - F[k])/(x[k + 1] - x[k])*(at - x[k]);
}

double table_inverse(int64_t n, const double *x, const double *F, double at)
{
    return table_at(n, F, x, at);
}

double table_odd(int64_t n, const double *x, const double *F, double at)
{
    return fabs(at) <= x[0] ? 0 : copysign(table_at(n, x, F, fabs(at)), at);
}
