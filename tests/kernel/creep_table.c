/* The table of creep forces: linear theory, saturation, bounds, symmetry, its theory between the nodes, the published points. */
#include "tools/creep/table.h"


#include "tests/kernel/creep_points.h"
#include "tests/kernel/tap.h"
#include "tools/creep/compare.h"
#include "tools/creep/kalker.h"

static void test_linear(const struct creep *t)
{
    double C[KALKER_COEFFICIENTS], F[3], tiny = 1e-9;

    for (int k = 0; k < KINDS; k++) {
        double a = CONTACTS[k].a, b = a/CONTACTS[k].ratio;
        kalker(a/b, NU, C);
        creep_table(t, a, b, N, MU, G, NU, tiny, 0, 0, F);
        near(F[0]/(G*a*b*C[KALKER_C11]*tiny), 1, 1e-4, "small xi: Fx = G a b C11 xi");
        creep_table(t, a, b, N, MU, G, NU, 0, tiny, 0, F);
        near(F[1]/(G*a*b*C[KALKER_C22]*tiny), 1, 1e-4, "small eta: Fy = G a b C22 eta");
        near(-F[2]/(G*pow(a*b, 1.5)*C[KALKER_C23]*tiny), 1, 1e-4, "and Mz = -G (a b)^1.5 C23 eta");
        creep_table(t, a, b, N, MU, G, NU, 0, 0, tiny, F);
        near(F[1]/(G*pow(a*b, 1.5)*C[KALKER_C23]*tiny), 1, 1e-4, "small phi: Fy = G (a b)^1.5 C23 phi");
        near(F[2]/(G*a*b*a*b*C[KALKER_C33]*tiny), 1, 1e-4, "and Mz = G (a b)^2 C33 phi");
    }
}

static void test_saturation(const struct creep *t)
{
    double F[3], last = 0;
    int rises = 1;

    for (double xi = 1e-5; xi < 1; xi *= 1.1) {
        creep_table(t, 5e-3, 3e-3, N, MU, G, NU, xi, 0, 0, F);
        rises &= F[0] >= last - 1e-3*MU*N;
        last = F[0];
    }
    ok(rises, "the force rises with xi, or falls by less than 0.001 mu N");
    near(last, MU*N, 0.003, "to mu N");
    creep_table(t, 5e-3, 3e-3, N, MU, G, NU, 0.6, -0.8, 0, F);
    ok(hypot(F[0]/(MU*N) - 0.6, F[1]/(MU*N) + 0.8) < 0.015, "along the creepage within 0.015 mu N");
    creep_table(t, 5e-3, 3e-3, N, MU, G, NU, 0, 0, 0, F);
    ok(F[0] == 0 && F[1] == 0 && F[2] == 0, "no creepage, no force");
    creep_table(t, 0, 0, 0, MU, G, NU, 1e-3, 0, 0, F);
    ok(F[0] == 0 && F[1] == 0 && F[2] == 0, "no contact, no force");
}

static double published(const struct creep *t, double *most)
{
    double sum = 0;

    *most = 0;
    for (size_t i = 0; i < POINTS; i++) {
        double a, b, c[3], F[3];
        point(i, &a, &b, c);
        creep_table(t, a, b, N, MU, G, NU, c[0], c[1], c[2], F);
        double off = hypot(F[0]/(MU*N) - PUBLISHED[i].full[0], F[1]/(MU*N) - PUBLISHED[i].full[1]);
        sum += off*off;
        *most = fmax(*most, off);
    }
    return sqrt(sum/POINTS);
}

int main(void)
{
    struct creep t;
    struct creep_difference d;
    double most;

    ok(!tabulate(&t, CREEP_FASTSIM, 50, NU), "a table of FASTSIM");
    test_linear(&t);
    test_saturation(&t);
    ok(!creep_compare(&t, CREEP_FASTSIM, 50, 10000, 1, &d), "compared with its theory");
    ok(d.rms < 0.012 && d.most < 0.1,
       "10 000 random contacts within %.4f mu N rms of FASTSIM, %.3f at most", d.rms, d.most);
    double rms = published(&t, &most);
    ok(rms < 0.03 && most < 0.09, "%d published points of the exact theory within %.4f mu N rms, %.3f at most", POINTS, rms, most);
    creep_free(&t);
    ok(!tabulate(&t, CREEP_EXACT, 8, NU), "a table of the exact theory on 8 elements");
    rms = published(&t, &most);
    ok(rms < 0.025 && most < 0.07, "the same within %.4f mu N rms, %.3f at most", rms, most);
    creep_free(&t);
    return done();
}
