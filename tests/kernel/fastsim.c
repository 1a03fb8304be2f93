/* FASTSIM: linear theory, exact solutions, saturation, symmetry, dissipation, grids. */
#include "tools/creep/fastsim.h"

#include "tests/kernel/creep_points.h"
#include "tests/kernel/tap.h"
#include "tools/creep/kalker.h"

static void force_published(const struct fastsim *f, size_t i, double force[3])
{
    double a, b, creep[3];

    point(i, &a, &b, creep);
    fastsim(f, a, b, N, MU, G, NU, creep[0], creep[1], creep[2], force);
    force[0] /= MU*N;
    force[1] /= MU*N;
}

/* The simplified theory itself differs from the full one by up to 0.06 mu N.  Published for 10 x 10 cells and a parabolic bound: 0.029 mu N
 * rms, 0.25 at most over 3220 points.  The other FASTSIM is of first order in its grid, 0.02 to 0.04 mu N here. */
static void test_published(int n)
{
    static struct fastsim f;
    double sum = 0, most = 0, other = 0, force[3];

    fastsim_begin(&f, n);
    for (size_t i = 0; i < POINTS; i++) {
        force_published(&f, i, force);
        double e = hypot(force[0] - PUBLISHED[i].full[0], force[1] - PUBLISHED[i].full[1]);
        sum += e*e;
        most = fmax(most, e);
    }
    fastsim_begin_bound(&f, n, 1);
    for (size_t i = 0; i < POINTS; i++) {
        force_published(&f, i, force);
        other = fmax(other, hypot(force[0] - PUBLISHED[i].fastsim[0], force[1] - PUBLISHED[i].fastsim[1]));
    }
    ok(sqrt(sum/POINTS) < 0.029 && most < 0.07, "%d x %d against the full theory, %d points: %.4f mu N rms, %.4f at most", n, n, POINTS,
       sqrt(sum/POINTS), most);
    ok(other < 0.045, "%d x %d, parabolic, against another FASTSIM at 25 x 25: %.3f mu N at most", n, n, other);
}

/* User guide of CONTACT: a 8, b 4 mm, eta = -6.25e-4, phi = 0.625 1/m; parabolic FASTSIM gives -0.6118 on 44 x 44 and -0.6359 on 220 x 220
 * elements, of first order: -0.6419 in the limit. */
static void test_guide(void)
{
    static struct fastsim f;
    double force[3], at[2];

    for (int k = 0; k < 2; k++) {
        fastsim_begin_bound(&f, 100 << k, 1);
        fastsim(&f, 8e-3, 4e-3, N, MU, G, NU, 0, -6.25e-4, 0.625, force);
        at[k] = force[1]/(MU*N);
        ok(fabs(force[0]) < 1e-9*MU*N, "lateral creepage and spin give no longitudinal force");
    }
    near(2*at[1] - at[0], 0.6419, 0.001, "the published example where its spin outdoes its creepage, fine grid");
    fastsim_begin_bound(&f, 10, 1);
    fastsim(&f, 8e-3, 4e-3, N, MU, G, NU, 0, -6.25e-4, 0.625, force);
    near(force[1]/(MU*N), 0.6419, 0.01, "and at 10 x 10 within 0.01 mu N of that");
}

static void test_linear(void)
{
    static struct fastsim f;
    double C[4], force[3];

    fastsim_begin(&f, 10);
    for (int k = 0; k < KINDS; k++) {
        double a = CONTACTS[k].a, b = a/CONTACTS[k].ratio, tiny = 1e-9;
        kalker(a/b, NU, C);
        fastsim(&f, a, b, N, MU, G, NU, tiny, 0, 0, force);
        near(force[0]/(G*a*b*C[KALKER_C11]*tiny), 1, 0.015, "small xi: Fx = G a b C11 xi");
        fastsim(&f, a, b, N, MU, G, NU, 0, tiny, 0, force);
        near(force[1]/(G*a*b*C[KALKER_C22]*tiny), 1, 0.015, "small eta: Fy = G a b C22 eta");
        fastsim(&f, a, b, N, MU, G, NU, 0, 0, tiny, force);
        near(force[1]/(G*pow(a*b, 1.5)*C[KALKER_C23]*tiny), 1, 0.015, "small phi: Fy = G (a b)^1.5 C23 phi");
        ok(force[2] > 0, "and a spin moment against it");
    }
}

static void test_saturation(void)
{
    static struct fastsim f;
    double force[3];

    for (int n = 1; n <= 40; n += 13) {
        fastsim_begin(&f, n);
        fastsim(&f, 5e-3, 3e-3, N, MU, G, NU, 0.6, -0.8, 0, force);
        ok(fabs(force[0] - 0.6*MU*N) < 1e-9*N && fabs(force[1] + 0.8*MU*N) < 1e-9*N,
           "a sliding contact on %d x %d carries mu N along its creepage", n, n);
    }
    fastsim(&f, 5e-3, 3e-3, N, MU, G, NU, 0, 0, 0, force);
    ok(force[0] == 0 && force[1] == 0 && force[2] == 0, "no creepage, no force");
    fastsim(&f, 0, 0, 0, MU, G, NU, 1e-3, 0, 0, force);
    ok(force[0] == 0 && force[1] == 0 && force[2] == 0, "no contact, no force");
}

static double draw(unsigned *state)
{
    *state = *state*1664525u + 1013904223u;
    return (double)(*state >> 8)/8388608.0 - 1;
}

static void test_properties(void)
{
    static struct fastsim f;
    int bounded = 1, dissipates = 1, mirrored = 1, odd = 1;
    unsigned state = 1;

    fastsim_begin(&f, 10);
    for (int i = 0; i < 2000; i++) {
        double a = 5e-3*exp(draw(&state)), b = 5e-3*exp(draw(&state)), size = 1e-5*exp(5 + 5*draw(&state));
        double xi = size*draw(&state), eta = size*draw(&state), phi = size*draw(&state)/a, F[3], M[3], R[3];
        fastsim(&f, a, b, N, MU, G, NU, xi, eta, phi, F);
        fastsim(&f, a, b, N, MU, G, NU, xi, -eta, -phi, M);
        fastsim(&f, a, b, N, MU, G, NU, -xi, -eta, -phi, R);
        bounded &= hypot(F[0], F[1]) <= MU*N*(1 + 1e-12);
        dissipates &= F[0]*xi + F[1]*eta + F[2]*phi > 0;
        mirrored &= hypot(M[0] - F[0], M[1] + F[1]) < 1e-12*N && fabs(M[2] + F[2]) < 1e-12*N*b;
        odd &= hypot(R[0] + F[0], R[1] + F[1]) < 1e-12*N && fabs(R[2] + F[2]) < 1e-12*N*b;
    }
    ok(bounded, "the force never exceeds mu N");
    ok(dissipates, "force and moment oppose the motion: power is lost for any creepage");
    ok(mirrored, "seen in a mirror along the track, Fx stays, Fy and Mz change sign");
    ok(odd, "all creepages reversed, all forces reversed");
}

static void test_grids(void)
{
    static struct fastsim f;
    double fine[3], force[3], wrong[3] = {0};

    for (size_t i = 0; i < POINTS; i++) {
        fastsim_begin(&f, FASTSIM_MOST);
        force_published(&f, i, fine);
        for (int k = 0; k < 3; k++) {
            fastsim_begin(&f, 10 << k);
            force_published(&f, i, force);
            wrong[k] = fmax(wrong[k], hypot(force[0] - fine[0], force[1] - fine[1]));
        }
    }
    ok(wrong[0] < 0.03, "10 x 10 is within %.3f mu N of 256 x 256", wrong[0]);
    ok(wrong[1] < 0.7*wrong[0] && wrong[2] < 0.7*wrong[1], "20 x 20 within %.4f, 40 x 40 within %.4f", wrong[1], wrong[2]);
}

int main(void)
{
    test_linear();
    test_published(10);
    test_published(25);
    test_guide();
    test_saturation();
    test_properties();
    test_grids();
    return done();
}
