/* With the disc's half height d_k = sqrt(r^2 - (k step)^2), the free centres and then the edge of the discs around them are
 *
 *     c_i = max_k (z_{i+k} + d_k),   z_i <- min_k (c_{i+k} - d_k),   |k step| <= r.
 *
 * The loops run over the columns inside, so that they need no order of sums and go through lanes. */
#include "tools/profile/opening.h"

#include <math.h>

/* a_i := max(a_i, b_{i+k} + d), i = first .. end - 1 */
static void columns_lower(int64_t first, int64_t end, int64_t k, double d, const double *restrict b, double *restrict a)
{
    for (int64_t i = first; i < end; i++) {
        double c = b[i + k] + d;
        a[i] = c > a[i] ? c : a[i];
    }
}

/* a_i := min(a_i, b_{i+k} - d), i = first .. end - 1 */
static void columns_raise(int64_t first, int64_t end, int64_t k, double d, const double *restrict b, double *restrict a)
{
    for (int64_t i = first; i < end; i++) {
        double c = b[i + k] - d;
        a[i] = c < a[i] ? c : a[i];
    }
}

void opening_round(int64_t n, double step, double r, double *z, double *work)
{
    int64_t m = (int64_t)(r / step * (1 + 1e-12));
    double *centre = work, *disc = work + n;

    m = m < n ? m : n - 1;
    for (int64_t k = 0; k <= m; k++)
        disc[k] = sqrt(fmax(r * r - (double)(k * k) * step * step, 0));
    for (int64_t i = 0; i < n; i++)
        centre[i] = i < m || i >= n - m ? INFINITY : -INFINITY;
    for (int64_t k = -m; k <= m; k++)
        columns_lower(m, n - m, k, disc[k < 0 ? -k : k], z, centre);
    for (int64_t i = 0; i < n; i++)
        z[i] = INFINITY;
    for (int64_t k = -m; k <= m; k++)
        columns_raise(k < 0 ? -k : 0, k < 0 ? n : n - k, k, disc[k < 0 ? -k : k], centre, z);
}
