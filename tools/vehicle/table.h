/* Piecewise-linear laws: force over deflection or rate. */
#ifndef VX_VEHICLE_TABLE_H
#define VX_VEHICLE_TABLE_H

#include <stdint.h>

/* Straight between the knots x[n] increasing, F[n]; beyond them the first and last slopes go on. */
double table_at(int64_t n, const double *x, const double *F, double at);

/* Its slope, to the right of a knot. */
double table_slope(int64_t n, const double *x, const double *F, double at);

/* Where it has the force `at`: of rising tables. */
double table_inverse(int64_t n, const double *x, const double *F, double at);

/* Odd tables, x[0] >= 0 and F[0] = 0: zero up to the first knot. */
double table_odd(int64_t n, const double *x, const double *F, double at);

#endif
