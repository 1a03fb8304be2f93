/* Kalker's coefficients: table, interpolation, asymptotes. */
#include "tools/creep/kalker.h"

#include "tests/kernel/tap.h"

static const char *const NAME[KALKER_COEFFICIENTS] = {"C11", "C22", "C23", "C33"};

/* Rows of table E.3. */
static void test_table(void)
{
    static const struct { double ratio, nu, C[4]; } row[] = {
        {0.1, 0.25, {3.31, 2.52, 0.473, 8.28}}, {0.5, 0, {2.88, 2.88, 0.827, 1.74}},  {0.7, 0.5, {4.97, 3.48, 1.29, 1.60}},
        {1, 0.25, {4.12, 3.67, 1.47, 1.19}},    {1/0.6, 0.25, {4.78, 4.50, 2.23, 0.892}}, {10, 0.5, {12.9, 16.0, 18.0, 0.228}}};
    double C[4];

    for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
        kalker(row[i].ratio, row[i].nu, C);
        for (int k = 0; k < KALKER_COEFFICIENTS; k++)
            ok(fabs(C[k] - row[i].C[k]) < 1e-12*C[k], "%s of table E.3 at a/b = %g, nu = %g", NAME[k], row[i].ratio, row[i].nu);
    }
}

/* C33 by a boundary element solution (CONTACT, linear spin, nu = 0.25, extrapolated in the mesh). */
static void test_spin(void)
{
    static const double at[][2] = {{0.1, 8.31}, {0.2, 4.28}, {0.5, 1.94}, {1, 1.18}, {2, 0.815}, {5, 0.602}, {10, 0.528}};
    double C[4];

    for (size_t i = 0; i < sizeof at/sizeof *at; i++) {
        kalker(at[i][0], 0.25, C);
        ok(fabs(C[KALKER_C33] - at[i][1]) < 0.011*at[i][1], "C33 of an independent solution at a/b = %g", at[i][0]);
    }
}

static void test_edges(void)
{
    double below[4], above[4];

    for (double ratio = 0.1; ratio < 20; ratio *= 10) {
        kalker(ratio*(1 - 1e-9), 0.28, below);
        kalker(ratio*(1 + 1e-9), 0.28, above);
        for (int k = 0; k < KALKER_COEFFICIENTS; k++)
            ok(fabs(below[k] - above[k]) < 1e-7*above[k], "%s does not jump at a/b = %g", NAME[k], ratio);
    }
}

static void test_order(void)
{
    double C[4], last[4];
    int rises = 1;

    kalker(1e-3, 0.28, last);
    for (double ratio = 1.1e-3; ratio < 1000; ratio *= 1.1) {
        kalker(ratio, 0.28, C);
        for (int k = 0; k < KALKER_C33; k++)
            rises &= C[k] > last[k];
        rises &= C[KALKER_C33] > 0 && (ratio > 10 || C[KALKER_C33] < last[KALKER_C33]);
        for (int k = 0; k < KALKER_COEFFICIENTS; k++)
            last[k] = C[k];
    }
    ok(rises, "C11, C22, C23 rise with a/b from 0.001 to 1000, C33 falls up to 10");
}

static void test_slender(void)
{
    double C[4];

    kalker(1e-6, 0.28, C);
    near(C[KALKER_C11], M_PI*M_PI/(4*(1 - 0.28)), 1e-4, "a much shorter than b: C11 = pi^2/(4(1 - nu))");
    near(C[KALKER_C22], M_PI*M_PI/4, 1e-4, "and C22 = pi^2/4, the line contact");
}

/* Each row against the cubic in ln(a/b) through its four neighbours, ln C: a misprint of 1.5 per cent would show. */
static void test_smooth(void)
{
    enum { ROWS = 19 };
    double x[ROWS], y[ROWS][4], most = 0;

    for (int column = 0; column < 3; column++) {
        for (int i = 0; i < ROWS; i++) {
            double ratio = i < 10 ? (i + 1)/10.0 : 10.0/(19 - i);
            kalker(ratio, 0.25*column, y[i]);
            x[i] = log(ratio);
        }
        for (int i = 2; i < ROWS - 2; i++)
            for (int k = 0; k < KALKER_COEFFICIENTS; k++) {
                double sum = 0;
                for (int j = i - 2; j <= i + 2; j++) {
                    double weight = j != i;
                    for (int m = i - 2; m <= i + 2; m++)
                        if (m != j && m != i)
                            weight *= (x[i] - x[m])/(x[j] - x[m]);
                    sum += weight*log(y[j][k]);
                }
                most = fmax(most, fabs(log(y[i][k]) - sum));
            }
    }
    ok(most < 0.012, "no row of the table stands out from its neighbours: %.1f %% at most", 100*most);
}

int main(void)
{
    test_table();
    test_spin();
    test_smooth();
    test_edges();
    test_order();
    test_slender();
    return done();
}
