/* Each sample beyond both its neighbours is refined by the parabola through the three. */
#include "tools/receptance/peaks.h"

#include <math.h>

/* Vertex of the parabola through (x[k], y[k]), y[1] beyond the others: y = y1 + slope (x - x1) + curvature (x - x1)^2. */
static void vertex(const double x[3], const double y[3], double *at, double *value)
{
    const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]);
    const double curvature = (right - left) / (x[2] - x[0]);
    const double slope = left + curvature * (x[1] - x[0]);

    *at = x[1] - slope / (2 * curvature);
    *value = y[1] - slope * slope / (4 * curvature);
}

int64_t peaks_find(int64_t n, const double *frequency, const double *H, struct peak *peak)
{
    int64_t found = 0;

    for (int64_t i = 1; i < n - 1; i++) {
        double y[3];
        for (int k = 0; k < 3; k++)
            y[k] = hypot(H[2 * (i + k - 1)], H[2 * (i + k - 1) + 1]);
        int dip = y[1] < y[0] && y[1] <= y[2];
        if (!dip && !(y[1] > y[0] && y[1] >= y[2]))
            continue;
        peak[found].is_dip = dip;
        vertex(&frequency[i - 1], y, &peak[found].frequency, &peak[found].amplitude);
        found++;
    }
    return found;
}
