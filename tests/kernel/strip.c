/* ANALYN: Hertz's forces and patches for elliptic gaps, to rounding where strips can be summed in closed form and in second order of the
 * spacing; superposition of parts, mirror images, monotone force. */
#include "tools/contact/strip.h"

#include "tests/kernel/tap.h"
#include "tools/contact/hertz.h"

#define STEEL_G 82e9
#define STEEL_NU 0.28
enum { MOST = 4001 };

static struct strip_law law;
static struct strip strip[MOST];

/* n strips evenly over -half .. half of gap(y). */
static void fill(int n, double half, double A, double (*gap)(double y, double p), double p)
{
    for (int i = 0; i < n; i++) {
        double y = half * (2.0 * i / (n - 1) - 1);
        strip[i] = (struct strip){.y = y, .gap = gap(y, p), .A = A};
    }
    strip_prepare(&law, strip, n);
}

static double parabola(double y, double B) { return B * y * y; }

/* Two parabolas of B = 20 1/m, 2 p apart. */
static double pair(double y, double p)
{
    double left = 20 * (y + p) * (y + p), right = 20 * (y - p) * (y - p);
    return fmin(left, right);
}

/* A gap that is not symmetric and not elliptic. */
static double lopsided(double y, double p) { return 8 * y * y + (p > 0 ? 1 : -1) * 900 * y * y * y + 9e4 * y * y * y * y; }

static void elliptic(void)
{
    double worst_strip = 0, worst[2][4] = {{0}};

    for (int k = -8; k <= 16; k++) {
        double A = 1.1, B = A * pow(10, k / 8.0), N = 50e3;
        struct hertz h;
        struct strip_patch p;
        hertz_contact(A, B, STEEL_G, STEEL_NU, &h);
        double a = h.a1 * cbrt(N), b = h.b1 * cbrt(N), d = pow(N / h.C, 2.0 / 3);
        for (int fine = 0; fine < 2; fine++) {
            fill(fine ? 129 : 65, 1.6 * b, A, parabola, B);
            int n = fine ? 129 : 65;
            double off[4];
            strip_patch(strip, n, strip_approach(strip, n, N), &p);
            off[0] = fabs(p.approach / d - 1);
            off[1] = fabs(p.area / (M_PI * a * b) - 1);
            off[2] = fabs(p.a / a - 1);
            off[3] = fabs(p.pressure / (1.5 * N / (M_PI * a * b)) - 1);
            for (int i = 0; i < 4; i++)
                worst[fine][i] = fmax(worst[fine][i], off[i]);
            ok(p.parts == 1 && fabs(p.force / N - 1) < 1e-12 && fabs(p.y) < 1e-9 * b, "B/A = %.3g, %d strips: one patch, centred, of the load", B / A, n);
        }
        strip_patch(strip, 129, d, &p);
        for (int i = 0; i < 129; i++) {
            double t = strip[i].y / b, round = fmax(1 - t * t, 0);
            worst_strip = fmax(worst_strip, fabs(pow(strip[i].half / a, 2) - round));
            worst_strip = fmax(worst_strip, fabs(pow(strip[i].pressure * M_PI * a * b / (1.5 * N), 2) - round));
        }
    }
    ok(worst_strip < 5e-9, "squares of each strip's half length and pressure are those of Hertz's ellipse (%.1e)", worst_strip);
    for (int i = 0; i < 4; i++) {
        static const char *const what[4] = {"approach", "area", "semi-axis", "pressure"};
        ok(worst[1][i] < 1.5e-3 && worst[1][i] < 0.35 * worst[0][i], "%s: Hertz's within %.1e of 129 strips, %.1e of 65", what[i], worst[1][i], worst[0][i]);
    }
}

static void shapes(void)
{
    const double half = 8e-3;
    struct strip_patch p, q;
    int falls = 0;
    double last = 0;

    fill(801, half, 1.1, lopsided, 1);
    for (int i = 0; i <= 300; i++) {
        double N = strip_force(strip, 801, i * 1e-6);
        falls += N < last;
        last = N;
        if (i > 0 && fabs(strip_approach(strip, 801, N) / (i * 1e-6) - 1) > 1e-11)
            falls++;
    }
    ok(falls == 0 && strip_force(strip, 801, 0) == 0, "the force grows with the approach, and leads back to it");
    strip_patch(strip, 801, 60e-6, &p);
    fill(801, half, 1.1, lopsided, -1);
    strip_patch(strip, 801, 60e-6, &q);
    ok(fabs(p.force / q.force - 1) < 1e-12 && fabs(p.y + q.y) < 1e-15 && fabs(p.area / q.area - 1) < 1e-12 && p.y < -5e-5,
       "the mirrored gap has the mirrored patch");

    fill(2001, half, 1.1, parabola, 20);
    strip_patch(strip, 2001, 50e-6, &p);
    fill(4001, 2 * half, 1.1, pair, half);
    strip_patch(strip, 4001, 50e-6, &q);
    ok(p.parts == 1 && q.parts == 2, "two equal parts apart are two");
    ok(fabs(q.force / p.force - 2) < 1e-9 && fabs(q.area / p.area - 2) < 1e-9 && fabs(q.pressure / p.pressure - 1) < 1e-9,
       "they carry twice the force on twice the area at the same pressure");
    near(q.a * q.b * M_PI / q.area, 1, 1e-12, "the equivalent ellipse has the area");
    near(q.a / q.b, 0.5 * p.a / p.b, 1e-6, "and the length over the width of all parts");

    strip_patch(strip, 4001, 0, &q);
    ok(q.force == 0 && q.area == 0 && q.parts == 0 && q.pressure == 0, "no approach, no patch");
}

int main(void)
{
    strip_law(STEEL_G, STEEL_NU, &law);
    elliptic();
    shapes();
    return done();
}
