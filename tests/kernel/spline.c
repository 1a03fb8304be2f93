/* The smoothing spline: exact on lines, fourth order on a sine, half the amplitude at the wavelength it is named after. */
#include "tests/kernel/tap.h"

#include <stdlib.h>

#include "tools/profile/curve.h"
#include "tools/profile/spline.h"

/* Greatest error of value, slope and curvature inside [1, 2 pi - 1] for sin through n points. */
static void sine_error(int64_t n, double error[3])
{
    double *s = calloc((size_t)n, sizeof *s), *x = calloc((size_t)n, sizeof *x), out[3];
    struct spline p;

    for (int64_t i = 0; i < n; i++) {
        s[i] = 2 * M_PI * (double)i / (double)(n - 1);
        x[i] = sin(s[i]);
    }
    spline_fit(&p, n, s, x, NULL, 0);
    error[0] = error[1] = error[2] = 0;
    for (double t = 1; t < 2 * M_PI - 1; t += 0.001) {
        spline_at(&p, t, out);
        error[0] = fmax(error[0], fabs(out[0] - sin(t)));
        error[1] = fmax(error[1], fabs(out[1] - cos(t)));
        error[2] = fmax(error[2], fabs(out[2] + sin(t)));
    }
    spline_free(&p);
    free(s);
    free(x);
}

static void test_order(void)
{
    double coarse[3], fine[3];

    sine_error(41, coarse);
    sine_error(81, fine);
    near(log2(coarse[0] / fine[0]), 4, 0.1, "value of an interpolated sine is of fourth order");
    near(log2(coarse[1] / fine[1]), 3, 0.1, "slope is of third order");
    near(log2(coarse[2] / fine[2]), 2, 0.1, "second derivative is of second order");
}

/* A line is its own smoothing spline, whatever lambda, spacing and weights are. */
static void test_line(void)
{
    double s[] = {0, 0.1, 0.4, 0.5, 1.1, 1.15, 2}, x[7], w[] = {1, 3, 0.2, 1, 7, 1, 2}, out[3], worst = 0;
    struct spline p;

    for (int i = 0; i < 7; i++)
        x[i] = 3 - 2 * s[i];
    spline_fit(&p, 7, s, x, w, 10);
    for (double t = -1; t < 3; t += 0.01) {
        spline_at(&p, t, out);
        worst = fmax(worst, fmax(fabs(out[0] - 3 + 2 * t), fmax(fabs(out[1] + 2), fabs(out[2]))));
    }
    near(worst, 0, 1e-13, "a line stays a line, and goes on beyond its ends");
    spline_free(&p);
}

/* The minimum's equations: the weighted residuals have neither sum nor moment. */
static void test_balance(void)
{
    double s[] = {0, 0.2, 0.5, 0.9, 1.4, 1.5, 2.1, 2.2}, x[] = {0, 1, -1, 2, 0.5, 0.7, -2, 1}, w[] = {1, 2, 1, 1, 5, 1, 1, 1};
    double sum = 0, moment = 0;
    struct spline p;

    spline_fit(&p, 8, s, x, w, 0.01);
    for (int i = 0; i < 8; i++) {
        double length = (i < 7 ? s[i + 1] - s[i] : 0) + (i > 0 ? s[i] - s[i - 1] : 0);
        sum += w[i] * length / 2 * (x[i] - p.f[i]);
        moment += w[i] * length / 2 * (x[i] - p.f[i]) * s[i];
    }
    near(sum, 0, 1e-14, "weighted residuals sum to zero");
    near(moment, 0, 1e-14, "weighted residuals have no moment");
    spline_free(&p);
}

/* A wave of length L keeps 1/(1 + (L_filt/L)^4) of its amplitude away from the ends. */
static void test_filter(void)
{
    enum { N = 2001 };
    static double s[N], x[N];
    double lengths[] = {2.0, 1.0, 0.5}, out[3];

    for (int k = 0; k < 3; k++) {
        double L = lengths[k], top = 0;
        struct spline p;
        for (int i = 0; i < N; i++) {
            s[i] = 0.01 * i;
            x[i] = sin(2 * M_PI * s[i] / L);
        }
        spline_fit(&p, N, s, x, NULL, spline_lambda(1.0));
        for (double t = 8; t < 12; t += 0.001) {
            spline_at(&p, t, out);
            top = fmax(top, out[0]);
        }
        near(top, 1 / (1 + pow(1 / L, 4)), 2e-4, "amplitude kept at wavelengths 2, 1 and 0.5 of the smoothing's");
        spline_free(&p);
    }
}

/* Curvature of a circle from its points, also where it stands upright. */
static void test_circle(void)
{
    enum { N = 201 };
    double y[N], z[N], weight[N], worst = 0, Y, Z, slope, curvature;
    struct points points = {N, y, z, weight};
    struct curve c;

    for (int i = 0; i < N; i++) {
        double angle = -1.7 + 3.4 * i / (N - 1);
        y[i] = 0.013 * sin(angle);
        z[i] = 0.013 - 0.013 * cos(angle);
        weight[i] = 1;
    }
    curve_fit(&c, &points, 0);
    for (double s = 0.1 * c.length; s < 0.9 * c.length; s += 1e-5) {
        curve_at(&c, s, &Y, &Z, &slope, &curvature);
        worst = fmax(worst, fabs(curvature * 0.013 - 1));
    }
    near(worst, 0, 1e-3, "curvature of a circle of radius 13 mm, positive with the centre below");
    near(curve_compare(&c, &points).worst, 0, 1e-12, "without smoothing the curve passes through the points");
    curve_free(&c);
}

int main(void)
{
    test_order();
    test_line();
    test_balance();
    test_filter();
    test_circle();
    return done();
}
