#include "tools/profile/cant.h"

#include <math.h>

void cant_rotate(int64_t n, double *y, double *z, double cant)
{
    double c = 1 / hypot(1, cant), s = cant * c;      /* cos, sin of atan cant */

    for (int64_t i = 0; i < n; i++) {
        double y0 = y[i], z0 = z[i];
        y[i] = y0 * c + z0 * s;
        z[i] = z0 * c - y0 * s;
    }
}
