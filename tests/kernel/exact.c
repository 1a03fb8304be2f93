/* The exact theory: published points, linear theory, saturation, symmetry. */
#include "tools/creep/exact.h"

#include <math.h>

#include "tests/kernel/creep_points.h"
#include "tests/kernel/tap.h"
#include "tools/creep/kalker.h"

static void test_published(int m, double rms_within)
{
    double sum = 0, most = 0, moment = 0;

    for (size_t i = 0; i < POINTS; i++) {
        struct exact e;
        double a, b, creep[3], force[3];
        point(i, &a, &b, creep);
        double c = sqrt(a*b), k = G*c*c/(MU*N);
        const char *why = exact_begin(&e, m, a/b, NU);
        int steps = why ? 0 : exact_force(&e, (const double[]){k*creep[0], k*creep[1], k*c*creep[2]}, force);
        if (!steps)
            ok(0, "point %zu comes to rest", i);
        double off = hypot(force[0] - PUBLISHED[i].full[0], force[1] - PUBLISHED[i].full[1]);
        sum += off*off;
        most = fmax(most, off);
        moment = fmax(moment, fabs(force[2] - PUBLISHED[i].full[2]));
        exact_free(&e);
    }
    ok(sqrt(sum/POINTS) < rms_within && most < 4*rms_within, "%d across: %d points of CONTACT within %.4f mu N rms, %.4f at most, moment %.3f", m,
       POINTS, sqrt(sum/POINTS), most, moment);
}

static void test_linear(void)
{
    double C[KALKER_COEFFICIENTS], F[3];

    for (double ratio = 0.25; ratio < 5; ratio *= 2) {
        struct exact e;
        ok(!exact_begin(&e, 15, ratio, NU), "a/b = %g", ratio);
        kalker(ratio, NU, C);
        exact_force(&e, (const double[]){0.01, 0, 0}, F);
        near(F[0]/0.01/C[KALKER_C11], 1, 0.03, "C11");
        exact_clear(&e);
        exact_force(&e, (const double[]){0, 0.01, 0}, F);
        near(F[1]/0.01/C[KALKER_C22], 1, 0.04, "C22");
        near(-F[2]/0.01/C[KALKER_C23], 1, 0.03, "C32 = -C23, of the moment");
        exact_clear(&e);
        exact_force(&e, (const double[]){0, 0, 0.01}, F);
        near(F[1]/0.01/C[KALKER_C23], 1, 0.03, "C23");
        exact_free(&e);
    }
}

static void test_properties(void)
{
    struct exact e;
    double F[3], M[3];

    ok(!exact_begin(&e, 12, 1.6, NU), "a contact");
    exact_force(&e, (const double[]){60, -80, 0}, F);
    ok(fabs(F[0] - 0.6) < 1e-3 && fabs(F[1] + 0.8) < 1e-3, "sliding, mu N along the creepage");
    exact_force(&e, (const double[]){0.1, 0.2, 0.3}, F);
    exact_clear(&e);
    exact_force(&e, (const double[]){0.1, 0.2, 0.3}, M);
    ok(hypot(F[0] - M[0], F[1] - M[1]) < 1e-3, "where it starts from does not matter");
    exact_force(&e, (const double[]){0.1, -0.2, -0.3}, M);
    ok(hypot(F[0] - M[0], F[1] + M[1]) < 1e-3 && fabs(F[2] + M[2]) < 1e-3, "mirrored");
    exact_free(&e);
}

int main(void)
{
    test_published(10, 0.0125);
    test_published(15, 0.0075);
    test_linear();
    test_properties();
    return done();
}
