/* Johnson, Contact Mechanics (1985), section 4.2.  With k the ratio of the axes, K and E the complete elliptic integrals of
 * modulus e = sqrt(1 - k^2), and s = (K - E)/(e^2 K),
 *
 *     larger/smaller of A, B = (1 - s)/(k^2 s)       p0 = 3 N/(2 pi a b)
 *     smaller A = p0 b s K/(E* a^2)                  d = p0 b K/E*            E* = G/(1 - nu) for like bodies
 *
 * K and s come from the arithmetic-geometric mean (Abramowitz and Stegun 17.6), without cancellation at k = 1. */
#include "tools/contact/hertz.h"

#include <math.h>

/* K (1), and s of the text above, for axis ratio 0 < k <= 1. */
static double elliptic(double k, double *s)
{
    double a = 0.5 * (1 + k), g = sqrt(k), c = 0.5 * (1 - k), power = 1, sum = 0;

    while (c > 1e-9 * a) {                                        /* c^2 enters */
        double next = 0.5 * (a + g);
        c = 0.5 * (a - g);
        g = sqrt(a * g);
        a = next;
        power *= 2;
        sum += power * c * c;                                     /* 2^(n-1) c_n^2, n >= 2 */
    }
    *s = 0.5 + 0.25 * (1 - k) / (1 + k) + (k < 1 ? sum / ((1 - k) * (1 + k)) : 0);
    return M_PI_2 / a;
}

/* Axis ratio k with (1 - s)/(k^2 s) = ratio >= 1: Newton's method in logarithms, where the function f is nearly straight.  It falls from k = 1
 * as -3/2 log k, and as -2 log k far from there, which the first guess fits between.  With q = E/K = 1 - e^2 s,
 *
 *     k ds/dk = (k^2 - q^2)/e^4,    k df/dk = (q^2 - k^2)/(e^4 s (1 - s)) - 2,    (q^2 - k^2)/e^4 = s^2 - (2 s - 1)/e^2. */
static double axis_ratio(double ratio, double *K, double *s)
{
    double want = log(ratio), x = -want * (0.5 + 1 / (6 * sqrt(1 + 0.0335 * want * want)));

    for (int i = 0; ; i++) {
        double k = exp(x), e2 = (1 - k) * (1 + k);
        *K = elliptic(k, s);
        double off = log((1 - *s) / *s) - 2 * x - want;
        if (fabs(off) < 1e-13 * (1 + want) || i == 20)
            return k;
        double near = e2 > 1e-6 ? (2 * *s - 1) / e2 : 0.125;
        x -= off / ((*s * *s - near) / (*s * (1 - *s)) - 2);
        x = x > 0 ? 0 : x;
    }
}

void hertz_contact(double A, double B, double G, double nu, struct hertz *h)
{
    A = A > HERTZ_FLATTEST ? A : HERTZ_FLATTEST;
    B = B > HERTZ_FLATTEST ? B : HERTZ_FLATTEST;

    double low = A < B ? A : B, high = A < B ? B : A, K, s;
    double k = axis_ratio(high / low, &K, &s);
    double modulus = G / (1 - nu);
    double major = cbrt(3 * K * s / (2 * M_PI * modulus * low));  /* a^3 = 3 N s K/(2 pi E* A) */
    double stiff = 2 * M_PI * modulus * major / (3 * K);          /* d = 3 N K/(2 pi E* a) */

    h->C = stiff * sqrt(stiff);
    h->a1 = A < B ? major : k * major;
    h->b1 = A < B ? k * major : major;
}

void hertz_curvatures(double meridian, double around, double rail, double beta, double *A, double *B)
{
    double c = cos(beta), s = sin(beta);
    double xx = around * c * c + meridian * s * s;                /* sum of the curvature tensors of both bodies */
    double yy = around * s * s + meridian * c * c + rail;
    double xy = (meridian - around) * c * s;
    double mean = 0.5 * (xx + yy), half = hypot(0.5 * (yy - xx), xy);

    *A = 0.5 * (xx <= yy ? mean - half : mean + half);
    *B = 0.5 * (xx <= yy ? mean + half : mean - half);
}
