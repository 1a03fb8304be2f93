/* Four-linear interpolation of what the linear theory leaves. */
#include "tools/creep/table.h"

#include <math.h>

#include "tools/creep/kalker.h"

double creep_spin(const double C[4], double shorter)
{
    return C[KALKER_C23] + C[KALKER_C11]*shorter/3;
}

void creep_linear(const double C[4], double x, double y, double s, double linear[3])
{
    linear[0] = x;
    linear[1] = y + s;
    linear[2] = s*C[KALKER_C33]/C[KALKER_C23] - y*C[KALKER_C23]/C[KALKER_C22];
}

/* Of n nodes the one below x, 0 to 1 along the axis, and the share of the node above; beyond its ends the end. */
static int64_t axis_find(int64_t n, double x, double *share)
{
    double at = x > 0 ? x*(double)(n - 1) : 0;
    int64_t i = at < (double)(n - 2) ? (int64_t)at : n - 2;

    *share = fmin(at - (double)i, 1);
    return i;
}

/* The rest, times size, at the four coordinates, each 0 to 1 along its axis. */
static void interpolate(const struct creep *t, const double at[CREEP_AXES], double rest[CREEP_FORCES])
{
    const int64_t down[3] = {t->n[1]*t->n[2]*t->n[3]*CREEP_FORCES, t->n[2]*t->n[3]*CREEP_FORCES, t->n[3]*CREEP_FORCES};
    double f[CREEP_AXES];
    const double *p = t->rest + axis_find(t->n[0], at[0], &f[0])*down[0] + axis_find(t->n[1], at[1], &f[1])*down[1] +
                      axis_find(t->n[2], at[2], &f[2])*down[2] + axis_find(t->n[3], at[3], &f[3])*CREEP_FORCES;

    rest[0] = rest[1] = rest[2] = 0;
    for (int corner = 0; corner < 8; corner++) {
        int i = corner >> 2, j = corner >> 1 & 1, k = corner & 1;
        double w = at[1]*(i ? f[0] : 1 - f[0])*(j ? f[1] : 1 - f[1])*(k ? f[2] : 1 - f[2]), above = w*f[3], below = w - above;
        const double *q = p + i*down[0] + j*down[1] + k*down[2];
        for (int m = 0; m < CREEP_FORCES; m++)
            rest[m] += below*q[m] + above*q[m + CREEP_FORCES];
    }
}

void creep_table(const struct creep *t, double a, double b, double N, double mu, double G, double nu, double xi, double eta, double phi,
                 double force[3])
{
    double C[KALKER_COEFFICIENTS], linear[3], rest[3];

    force[0] = force[1] = force[2] = 0;
    if (!(a > 0 && b > 0 && N > 0 && mu > 0))
        return;
    kalker(a/b, nu, C);
    double most = mu*N, k = G*a*b/most, c = sqrt(a*b);
    double x = k*C[KALKER_C11]*xi, y = k*C[KALKER_C22]*eta, s = k*c*C[KALKER_C23]*phi, z = fabs(k*c*creep_spin(C, b/c)*phi);
    double turn = s < 0 ? -1 : 1, across = fabs(x) + fabs(y), r = across + z;
    if (!(r > 0))
        return;
    double base = CREEP_SIZE_HALF/(CREEP_SIZE_HALF + r);
    double shape = (a/(a + b) - t->axis[CREEP_SHAPE][0])/(t->axis[CREEP_SHAPE][t->n[CREEP_SHAPE] - 1] - t->axis[CREEP_SHAPE][0]);
    interpolate(t, (const double[]){shape, 1 - base, z/r, across > 0 ? 0.5 + 0.5*turn*y/across : 0.5}, rest);
    creep_linear(C, x, y, s, linear);
    double Fx = linear[0]*base + (x < 0 ? -rest[0] : rest[0]), Fy = linear[1]*base + turn*rest[1];
    double square = Fx*Fx + Fy*Fy, cut = square > 1 ? most/sqrt(square) : most;
    force[0] = cut*Fx;
    force[1] = cut*Fy;
    force[2] = most*c*(linear[2]*base + turn*rest[2]);
}
