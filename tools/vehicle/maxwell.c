/* With the same force in both, F' = k (V - v(F)), V = de/h and v(F) the rate of the damper.  Where v(F) = v_i + (F - G_i)/c,
 *
 *   F(t) = F* + (F - F*) exp(-k t/c),   F* = G_i + c (V - v_i),
 *
 * exact, and stable for any step.  F moves towards the damper's force at V without passing it, piece by piece of the table. */
#include "tools/vehicle/maxwell.h"

#include <math.h>

/* The piece of F >= 0 on which it goes on, up or down. */
static int64_t piece(double F, int up, int64_t n, const double *G)
{
    int64_t i = 0;

    while (i < n - 2 && (up ? F >= G[i + 1] : F > G[i + 1]))
        i++;
    return i;
}

double maxwell_step(double F, double de, double h, double k, int64_t n, const double *v, const double *G)
{
    double left = h, V = de/h;

    for (int64_t round = 0; round <= 2*n; round++) {        /* at most down all pieces of one sign and up those of the other */
        double sign = F != 0 ? copysign(1, F) : copysign(1, V);
        double f = sign*F, rate = sign*V;                   /* as if F were positive */
        int64_t j = piece(f, 1, n, G);
        double there = v[j] + (f - G[j])*(v[j + 1] - v[j])/(G[j + 1] - G[j]);
        int up = rate > there;
        int64_t i = piece(f, up, n, G);
        double c = (G[i + 1] - G[i])/(v[i + 1] - v[i]), goal = G[i] + c*(rate - v[i]);
        double edge = up ? (i < n - 2 ? G[i + 1] : HUGE_VAL) : G[i];
        if (up ? goal <= edge : goal >= edge)
            return sign*(goal + (f - goal)*exp(-k*left/c));
        double time = c/k*log((f - goal)/(edge - goal));
        if (time >= left)
            return sign*(goal + (f - goal)*exp(-k*left/c));
        left -= time;
        F = sign*edge;
    }
    return F;
}
