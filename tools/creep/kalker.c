/* Kalker's creep coefficients from table E.3, with its asymptotes outside.
 *
 * Between the rows and over nu the reciprocals are interpolated, as C behaves like 1/(1 - nu) and like powers of the ratio: straight
 * over g = min(a/b, b/a), by the parabola through nu = 0, 1/4, 1/2.  Below g = 0.1 the asymptotes of the table take over, each
 * times a factor that starts at the quotient table/asymptote at 0.1 and tends to 1, so that nothing jumps. */
#include "tools/creep/kalker.h"

#include <math.h>

enum { ROWS = 10, SIDES = 2 };  /* g = 0.1, 0.2 ... 1 for a < b, then for a > b */
enum { NUS = 3 };               /* 0, 1/4, 1/2 */

/* 1/C */
#define C(zero, quarter, half) {1/zero, 1/quarter, 1/half}
static const double inverse[SIDES][ROWS][KALKER_COEFFICIENTS][NUS] = {
    {
        {C(2.51, 3.31, 4.85), C(2.51, 2.52, 2.53), C(0.334, 0.473, 0.731), C(6.42, 8.28, 11.7)},
        {C(2.59, 3.37, 4.81), C(2.59, 2.63, 2.66), C(0.483, 0.603, 0.809), C(3.46, 4.27, 5.66)},
        {C(2.68, 3.44, 4.80), C(2.68, 2.75, 2.81), C(0.607, 0.715, 0.889), C(2.49, 2.96, 3.72)},
        {C(2.78, 3.53, 4.82), C(2.78, 2.88, 2.98), C(0.720, 0.823, 0.977), C(2.02, 2.32, 2.77)},
        {C(2.88, 3.62, 4.83), C(2.88, 3.01, 3.14), C(0.827, 0.929, 1.07), C(1.74, 1.93, 2.22)},
        {C(2.98, 3.72, 4.91), C(2.98, 3.14, 3.31), C(0.930, 1.03, 1.18), C(1.56, 1.68, 1.86)},
        {C(3.09, 3.81, 4.97), C(3.09, 3.28, 3.48), C(1.03, 1.14, 1.29), C(1.43, 1.50, 1.60)},
        {C(3.19, 3.91, 5.05), C(3.19, 3.41, 3.65), C(1.13, 1.25, 1.40), C(1.34, 1.37, 1.42)},
        {C(3.29, 4.01, 5.12), C(3.29, 3.54, 3.82), C(1.23, 1.36, 1.51), C(1.27, 1.27, 1.27)},
        {C(3.40, 4.12, 5.20), C(3.40, 3.67, 3.98), C(1.33, 1.47, 1.63), C(1.21, 1.19, 1.16)},
    }, {
        {C(10.7, 11.7, 12.9), C(10.7, 12.8, 16.0), C(12.2, 14.6, 18.0), C(0.795, 0.526, 0.228)},
        {C(6.96, 7.78, 8.82), C(6.96, 8.14, 9.79), C(5.72, 6.63, 7.89), C(0.828, 0.601, 0.341)},
        {C(5.57, 6.34, 7.34), C(5.57, 6.40, 7.51), C(3.79, 4.32, 5.01), C(0.868, 0.674, 0.446)},
        {C(4.84, 5.57, 6.57), C(4.84, 5.48, 6.31), C(2.88, 3.24, 3.70), C(0.912, 0.747, 0.549)},
        {C(4.37, 5.10, 6.11), C(4.37, 4.90, 5.56), C(2.35, 2.62, 2.96), C(0.958, 0.819, 0.650)},
        {C(4.06, 4.78, 5.80), C(4.06, 4.50, 5.04), C(2.01, 2.23, 2.50), C(1.01, 0.892, 0.751)},
        {C(3.82, 4.54, 5.58), C(3.82, 4.21, 4.67), C(1.76, 1.95, 2.18), C(1.05, 0.965, 0.852)},
        {C(3.65, 4.36, 5.42), C(3.65, 3.99, 4.39), C(1.58, 1.75, 1.94), C(1.10, 1.04, 0.954)},
        {C(3.51, 4.22, 5.30), C(3.51, 3.81, 4.16), C(1.44, 1.59, 1.77), C(1.16, 1.11, 1.06)},
        {C(3.40, 4.12, 5.20), C(3.40, 3.67, 3.98), C(1.33, 1.47, 1.63), C(1.21, 1.19, 1.16)},
    }
};
#undef C

#define LOWEST 0.1              /* g of the first row */

/* C[4] at 0.1 <= g <= 1: 1/C straight over g, parabola over nu. */
static void interpolate(int side, double g, double nu, double C[KALKER_COEFFICIENTS])
{
    double at = fmin(g*ROWS - 1, ROWS - 1);
    int row = at < ROWS - 2 ? (int)at : ROWS - 2;
    double t = at - row;
    double lagrange[NUS] = {(1 - 4*nu)*(1 - 2*nu), 8*nu*(1 - 2*nu), 2*nu*(4*nu - 1)};

    for (int k = 0; k < KALKER_COEFFICIENTS; k++) {
        double sum = 0;
        for (int m = 0; m < NUS; m++)
            sum += lagrange[m]*((1 - t)*inverse[side][row][k][m] + t*inverse[side][row + 1][k][m]);
        C[k] = 1/sum;
    }
}

/* C[4] as g -> 0, a << b or a >> b. */
static void asymptote(int side, double g, double nu, double C[KALKER_COEFFICIENTS])
{
    if (side == 0) {
        C[KALKER_C11] = M_PI*M_PI/(4*(1 - nu));
        C[KALKER_C22] = M_PI*M_PI/4;
        C[KALKER_C23] = M_PI*sqrt(g)/(3*(1 - nu))*(1 + nu*(log(16/g) - 5));
        C[KALKER_C33] = M_PI*M_PI/(16*(1 - nu)*g);
    } else {
        double Lambda = log(16/(g*g));
        double l1 = Lambda - 2*nu, l2 = (1 - nu)*Lambda + 2*nu, l3 = (1 - nu)*Lambda - 2 + 4*nu;
        C[KALKER_C11] = 2*M_PI/(l1*g)*(1 + (3 - log(4))/l1);
        C[KALKER_C22] = 2*M_PI/(l2*g)*(1 + (1 - nu)*(3 - log(4))/l2);
        C[KALKER_C23] = 2*M_PI/(3*g*sqrt(g)*l3);
        C[KALKER_C33] = M_PI/4*(1 - nu*(Lambda - 2)/l3);
    }
}

void kalker(double ratio, double nu, double C[KALKER_COEFFICIENTS])
{
    int side = ratio > 1;
    double g = side ? 1/ratio : ratio;

    if (g >= LOWEST) {
        interpolate(side, g, nu, C);
        return;
    }
    double edge[KALKER_COEFFICIENTS], row[KALKER_COEFFICIENTS];
    asymptote(side, g, nu, C);
    asymptote(side, LOWEST, nu, edge);
    interpolate(side, LOWEST, nu, row);
    for (int k = 0; k < KALKER_COEFFICIENTS; k++)
        C[k] *= 1 + (row[k]/edge[k] - 1)*g/LOWEST;
}
