/* Hertz against the classical table of m, n, r (Johnson 1985; Harris 1966), four wheels on rails, and closed forms. */
#include "tools/contact/hertz.h"

#include "tests/kernel/tap.h"

#define STEEL_G 82e9
#define STEEL_NU 0.28

/* a = m c, b = n c with c^3 = 3 F/(4 (A + B) E*), and d = r (9 F^2 (A + B)/(16 E*^2))^(1/3); cos(theta) = (B - A)/(A + B). */
static void classical_table(void)
{
    static const double row[][4] = {
        {90, 1, 1, 1},                {80, 1.1278, 0.8927, 0.9932}, {70, 1.2851, 0.7999, 0.9726}, {60, 1.4858, 0.7171, 0.9376},
        {50, 1.7541, 0.6407, 0.8867}, {45, 1.9265, 0.6038, 0.8547}, {40, 2.1357, 0.5673, 0.8177}, {30, 2.7306, 0.4931, 0.7263},
        {20, 3.8160, 0.4121, 0.6038}, {10, 6.6115, 0.3110, 0.4280}, {5, 11.238, 0.2381, 0.2969},
    };
    double worst = 0, modulus = STEEL_G / (1 - STEEL_NU), sum = 400;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        double c = cos(row[i][0] * M_PI / 180), unit = cbrt(3 / (4 * sum * modulus));
        struct hertz h;
        hertz_contact(0.5 * sum * (1 - c), 0.5 * sum * (1 + c), STEEL_G, STEEL_NU, &h);
        worst = fmax(worst, fabs(h.a1 / unit / row[i][1] - 1));
        worst = fmax(worst, fabs(h.b1 / unit / row[i][2] - 1));
        worst = fmax(worst, fabs(pow(h.C, -2.0 / 3) / cbrt(9 * sum / (16 * modulus * modulus)) / row[i][3] - 1));
    }
    ok(worst < 2.5e-4, "m, n, r of the classical table within its digits (%.2g)", worst);
}

/* Rail radius and wheel's transverse curvature under 100 kN, rolling radius 460 mm: a, b (mm), p0 (MPa), d (mm), C (N/mm^1.5). */
static void wheels_on_rails(void)
{
    static const double row[][7] = {
        {0.300, 0, 7.193, 5.411, 1226.8, 0.10503, 2.938e6},
        {0.080, 0, 8.579, 2.713, 2051.7, 0.12599, 2.236e6},
        {0.013, 0, 10.121, 1.0318, 4572, 0.15229, 1.683e6},
        {0.300, -1 / 0.4, 5.661, 10.699, 788.4, 0.08253, 4.218e6},
    };
    double worst = 0, N = 100e3;
    for (int i = 0; i < 4; i++) {
        double A, B;
        struct hertz h;
        hertz_curvatures(row[i][1], 1 / 0.46, 1 / row[i][0], 0, &A, &B);
        hertz_contact(A, B, STEEL_G, STEEL_NU, &h);
        double a = h.a1 * cbrt(N), b = h.b1 * cbrt(N);
        double got[5] = {a * 1e3, b * 1e3, 1.5 * N / (M_PI * a * b) * 1e-6, pow(N / h.C, 2.0 / 3) * 1e3, h.C * pow(1e-3, 1.5)};
        for (int k = 0; k < 5; k++)
            worst = fmax(worst, fabs(got[k] / row[i][k + 2] - 1));
    }
    ok(worst < 3e-4, "semi-axes, pressure, approach and C of four wheels on rails (%.2g)", worst);
}

int main(void)
{
    struct hertz h, g;
    double modulus = STEEL_G / (1 - STEEL_NU), R = 0.2, A, B;

    classical_table();
    wheels_on_rails();

    hertz_contact(0.5 / R, 0.5 / R, STEEL_G, STEEL_NU, &h);
    near(h.C / (4.0 / 3 * modulus * sqrt(R)), 1, 1e-14, "sphere on plane: C = 4/3 E* sqrt R");
    near(h.a1 / cbrt(0.75 * R / modulus), 1, 1e-14, "sphere on plane: a = (3 N R/(4 E*))^(1/3)");
    near(h.b1 / h.a1, 1, 1e-14, "sphere on plane: the patch is a circle");

    hertz_contact(1.1, 37, STEEL_G, STEEL_NU, &h);
    hertz_contact(37, 1.1, STEEL_G, STEEL_NU, &g);
    ok(h.a1 == g.b1 && h.b1 == g.a1 && h.C == g.C && h.a1 > h.b1, "A and B exchanged exchange a and b");

    double worst = 0;
    for (int i = 0; i <= 60; i++) {
        double ratio = pow(10, i / 10.0), scale = 4;
        hertz_contact(1, ratio, STEEL_G, STEEL_NU, &h);
        hertz_contact(scale, scale * ratio, STEEL_G, STEEL_NU, &g);
        worst = fmax(worst, fabs(g.a1 / h.a1 * cbrt(scale) - 1));
        worst = fmax(worst, fabs(g.C / h.C * sqrt(scale) - 1));
    }
    ok(worst < 1e-12, "lengths scale by similarity for ratios up to 1e6 (%.1e)", worst);

    hertz_contact(1, 1 + 1e-9, STEEL_G, STEEL_NU, &g);
    hertz_contact(1, 1, STEEL_G, STEEL_NU, &h);
    near(g.C / h.C, 1, 1e-9, "no jump where the ellipse becomes a circle");

    hertz_contact(1, -3, STEEL_G, STEEL_NU, &g);
    hertz_contact(1, 0.1, STEEL_G, STEEL_NU, &h);
    ok(g.C == h.C, "a gap flatter than 0.1 1/m counts as 0.1 1/m");

    hertz_curvatures(-2.5, 2, 3.3, 0, &A, &B);
    ok(fabs(A - 1) < 1e-15 && fabs(B - 0.4) < 1e-15, "A and B keep their axes where A > B");
    hertz_curvatures(70, 0.8, -10, 0.05, &A, &B);
    near(A + B, 0.5 * (70 + 0.8 - 10), 1e-12, "A + B does not depend on the angle between the bodies");
    near(4 * A * B, (0.8 + 69.2 * pow(sin(0.05), 2)) * (60 - 69.2 * pow(sin(0.05), 2)) - pow(69.2 * sin(0.05) * cos(0.05), 2), 1e-10,
         "A B is the determinant of the sum of both curvature tensors");
    return done();
}
