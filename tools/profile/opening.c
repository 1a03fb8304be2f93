/* With d(y) = sqrt(r^2 - y^2), the free centres and then the edge of the discs around them are
 *
 *     c(y) = max_k (z_k + d(y - y_k)),   z(y) <- min_c (c - d(y - y_c)).
 *
 * The loops run over the columns inside, so that they need no order of sums and go through lanes.  Between the columns z and c are straight:
 * down a steep face columns lie so far apart that discs would reach through between them.  Where c has a kink a disc touches two surfaces and
 * rounds their edge: it is found between the columns by the arms to either side. */
#include "tools/profile/opening.h"

#include <math.h>

#define KINK 0.05            /* rad, between the arms */
#define KINKS 8              /* most, and one at the wall */

struct place { double y, z; };

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

/* Where a disc below a line of slope m touches it, sideways of the disc's centre.  At the same y centre and line are r sqrt(1 + m^2) apart. */
static double touch_beside(double r, double m)
{
    return r * m / sqrt(1 + m * m);
}

/* The columns a[n] of discs that touch the line between two places; r < 0 for the line above them. */
static void line_touch(int64_t n, double step, double r, struct place from, struct place to, double *a)
{
    double m = (to.z - from.z) / (to.y - from.y), beside = touch_beside(r, m);

    if (!isfinite(m))
        return;
    for (int64_t i = (int64_t)fmax(ceil((from.y - beside) / step), 0); i < n && (double)i * step <= to.y - beside; i++) {
        double c = from.z + m * ((double)i * step - from.y) + r * sqrt(1 + m * m);
        a[i] = r > 0 ? fmax(a[i], c) : fmin(a[i], c);
    }
}

static struct place column(const double *z, double step, int64_t i)
{
    return (struct place){(double)i * step, z[i]};
}

static void lines_touch(int64_t n, double step, double r, const double *b, double *a)
{
    for (int64_t i = 0; i + 1 < n; i++)
        line_touch(n, step, r, column(b, step, i), column(b, step, i + 1), a);
}

/* The columns under or above a disc at y. */
static void disc_columns(int64_t n, double step, double r, double y, int64_t *first, int64_t *end)
{
    *first = (int64_t)fmax(ceil((y - r) / step), 0);
    *end = (int64_t)fmin(floor((y + r) / step) + 1, (double)n);
}

static double half_height(double r, double d)
{
    return sqrt(fmax(r * r - d * d, 0));
}

static struct place centre_at(int64_t n, double step, double r, const double *z, double y)
{
    struct place c = {y, -INFINITY};
    int64_t first, end;

    disc_columns(n, step, r, y, &first, &end);
    for (int64_t i = first; i < end; i++) {
        double m = i + 1 < n ? (z[i + 1] - z[i]) / step : INFINITY, along = y + touch_beside(r, m) - (double)i * step;
        c.z = fmax(c.z, z[i] + half_height(r, (double)i * step - y));
        if (isfinite(m) && along >= 0 && along <= step)
            c.z = fmax(c.z, z[i] + m * (y - (double)i * step) + r * sqrt(1 + m * m));
    }
    return c;
}

/* Where the arms of c[n] meet within a step, first .. last; and at the wall. */
static int centres_between(int64_t n, double step, double wall, double r, const double *z, const double *c, int64_t first, int64_t last,
                           struct place *found)
{
    int count = 0;

    for (int64_t i = first + 1; i + 2 <= last && count < KINKS; i++) {
        double before = c[i] - c[i - 1], after = c[i + 2] - c[i + 1], t = (c[i] - c[i + 1] + after) / (after - before);
        if (atan(after / step) - atan(before / step) > KINK && t >= 0 && t <= 1)
            found[count++] = centre_at(n, step, r, z, ((double)i + t) * step);
    }
    if (last * step < wall - r && wall - r < (double)(n - 1) * step)
        found[count++] = centre_at(n, step, r, z, wall - r);
    return count;
}

/* The disc around a centre between the columns, and those between it and them. */
static void disc_raise(int64_t n, double step, double r, const double *c, struct place centre, double *z)
{
    int64_t first, end, beside = (int64_t)floor(centre.y / step);

    disc_columns(n, step, r, centre.y, &first, &end);
    for (int64_t i = first; i < end; i++)
        z[i] = fmin(z[i], centre.z - half_height(r, (double)i * step - centre.y));
    line_touch(n, step, -r, column(c, step, beside), centre, z);
    line_touch(n, step, -r, centre, column(c, step, beside + 1), z);
}

void opening_round(int64_t n, double step, double wall, double r, double *z, double *work)
{
    int64_t m = (int64_t)(r / step), last = (int64_t)floor(fmin((wall - r) / step, (double)(n - 1 - m)));
    double *c = work, *disc = work + n;
    struct place between[KINKS + 1];

    m = m < n ? m : n - 1;
    for (int64_t k = 0; k <= m; k++)
        disc[k] = half_height(r, (double)k * step);
    for (int64_t i = 0; i < n; i++)
        c[i] = i < m || i > last ? INFINITY : -INFINITY;
    for (int64_t k = -m; k <= m; k++)
        columns_lower(m, last + 1, k, disc[k < 0 ? -k : k], z, c);
    lines_touch(n, step, r, z, c);
    int extra = centres_between(n, step, wall, r, z, c, m, last, between);
    for (int64_t i = 0; i < n; i++)
        z[i] = INFINITY;
    for (int64_t k = -m; k <= m; k++)
        columns_raise(k < 0 ? -k : 0, k < 0 ? n : n - k, k, disc[k < 0 ? -k : k], c, z);
    lines_touch(n, step, -r, c, z);
    for (int e = 0; e < extra; e++)
        disc_raise(n, step, r, c, between[e], z);
}
