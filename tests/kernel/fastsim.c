/* FASTSIM: linear theory, exact solutions, saturation, symmetry, dissipation, grids. */
#include "tools/creep/fastsim.h"

#include "tests/kernel/tap.h"
#include "tools/creep/kalker.h"

static const double G = 82e9, NU = 0.28, MU = 0.3, N = 82e3;

/* Contacts of the published table: a, and curvature rho and mean semi-axis c that scale its creepages, m. */
static const struct { double ratio, a, rho, c; } CONTACTS[] = {
    {0.2, 4e-3, 1.772, 8.944e-3}, {0.5, 6e-3, 2.075, 8.485e-3}, {1, 9e-3, 2.7, 9e-3}, {2, 12e-3, 2.075, 8.485e-3},
    {5, 20e-3, 1.772, 8.944e-3}};

enum { KINDS = sizeof CONTACTS/sizeof *CONTACTS };

/* Vollebregt, CONTACT (25 x 25 elements): full theory, and its own FASTSIM with the same flexibilities and bound.  xi = m mu cos(angle)
 * c/rho, eta = m mu sin(angle) c/rho, phi = spin mu/rho; forces of the wheel on the rail over mu N. */
static const struct { double ratio, spin, angle, m, full[2], fastsim[2]; } PUBLISHED[] = {
    {0.5, 0, 0, 0.5, {0.47695, 0}, {0.4744, 0.0000}}, {0.5, 0, 0, 1.1, {0.83063, 0}, {0.8041, 0.0000}},
    {0.5, 0, 30, 0.5, {0.41546, 0.19602}, {0.4124, 0.1975}}, {0.5, 0, 30, 1.1, {0.72879, 0.35152}, {0.7036, 0.3465}},
    {0.5, 0, 90, 0.5, {0, 0.39880}, {0.0000, 0.4000}}, {0.5, 0, 90, 1.1, {0, 0.72905}, {0.0000, 0.7148}},
    {0.5, 0.5, 0, 0, {0, 0.13683}, {0.0000, 0.1412}}, {0.5, 0.5, 30, 0.5, {0.36823, 0.32245}, {0.3571, 0.3222}},
    {0.5, 0.5, 30, 1.1, {0.68593, 0.45954}, {0.6571, 0.4503}}, {0.5, 1, 0, 0, {0, 0.25443}, {0.0000, 0.2584}},
    {0.5, 1, 30, 0.5, {0.29352, 0.41895}, {0.2793, 0.4131}}, {0.5, 1, 30, 1.1, {0.58517, 0.54722}, {0.5560, 0.5309}},
    {0.5, 2, 0, 0, {0, 0.41006}, {0.0000, 0.4032}}, {0.5, 2, 30, 0.5, {0.18850, 0.52970}, {0.1773, 0.5130}},
    {0.5, 2, 30, 1.1, {0.39228, 0.62039}, {0.3762, 0.6007}}, {1, 0, 0, 0.5, {0.48922, 0}, {0.4886, 0.0000}},
    {1, 0, 0, 1.1, {0.84091, 0}, {0.8194, 0.0000}}, {1, 0, 30, 0.5, {0.42549, 0.21675}, {0.4242, 0.2182}},
    {1, 0, 30, 1.1, {0.73518, 0.37879}, {0.7144, 0.3746}}, {1, 0, 90, 0.5, {0, 0.43921}, {0.0000, 0.4401}},
    {1, 0, 90, 1.1, {0, 0.77910}, {0.0000, 0.7645}}, {1, 0.5, 0, 0, {0, 0.20101}, {0.0000, 0.2062}},
    {1, 0.5, 30, 0.5, {0.39407, 0.40289}, {0.3881, 0.4027}}, {1, 0.5, 30, 1.1, {0.69937, 0.52771}, {0.6770, 0.5161}},
    {1, 1, 0, 0, {0, 0.37931}, {0.0000, 0.3821}}, {1, 1, 30, 0.5, {0.33375, 0.55639}, {0.3234, 0.5502}},
    {1, 1, 30, 1.1, {0.62757, 0.64677}, {0.6043, 0.6307}}, {1, 2, 0, 0, {0, 0.60221}, {0.0000, 0.6048}},
    {1, 2, 30, 0.5, {0.22598, 0.69398}, {0.2159, 0.7064}}, {1, 2, 30, 1.1, {0.45435, 0.71354}, {0.4394, 0.7269}},
    {2, 0, 0, 0.5, {0.61271, 0}, {0.6080, 0.0000}}, {2, 0, 0, 1.1, {0.94770, 0}, {0.9250, 0.0000}},
    {2, 0, 30, 0.5, {0.53195, 0.29397}, {0.5273, 0.2932}}, {2, 0, 30, 1.1, {0.82558, 0.45758}, {0.8039, 0.4513}},
    {2, 0, 90, 0.5, {0, 0.59277}, {0.0000, 0.5889}}, {2, 0, 90, 1.1, {0, 0.93116}, {0.0000, 0.9116}},
    {2, 0.5, 0, 0, {0, 0.38854}, {0.0000, 0.3890}}, {2, 0.5, 30, 0.5, {0.48780, 0.62437}, {0.4790, 0.6121}},
    {2, 0.5, 30, 1.1, {0.74489, 0.63939}, {0.7335, 0.6328}}, {2, 1, 0, 0, {0, 0.69228}, {0.0000, 0.6872}},
    {2, 1, 30, 0.5, {0.40284, 0.80247}, {0.3887, 0.8116}}, {2, 1, 30, 1.1, {0.64874, 0.69690}, {0.6427, 0.7121}},
    {2, 2, 0, 0, {0, 0.64040}, {0.0000, 0.7079}}, {2, 2, 30, 0.5, {0.25814, 0.69483}, {0.2487, 0.7486}},
    {2, 2, 30, 1.1, {0.50324, 0.69005}, {0.4928, 0.7262}},
};

static void force_published(const struct fastsim *f, size_t i, double force[3])
{
    int k = 0;
    while (CONTACTS[k].ratio != PUBLISHED[i].ratio)
        k++;
    double size = PUBLISHED[i].m*MU*CONTACTS[k].c/CONTACTS[k].rho, angle = PUBLISHED[i].angle*M_PI/180;
    fastsim(f, CONTACTS[k].a, CONTACTS[k].a/CONTACTS[k].ratio, N, MU, G, NU, size*cos(angle), size*sin(angle),
            PUBLISHED[i].spin*MU/CONTACTS[k].rho, force);
    force[0] /= MU*N;
    force[1] /= MU*N;
}

/* The simplified theory itself differs from the full one by up to 0.1 mu N, most with much spin; the other FASTSIM is of first order
 * in its grid, 0.02 to 0.04 mu N here. */
static void test_published(int n)
{
    static struct fastsim f;
    double sum = 0, most = 0, other = 0, force[3];
    size_t rows = sizeof PUBLISHED/sizeof *PUBLISHED;

    fastsim_begin(&f, n);
    for (size_t i = 0; i < rows; i++) {
        force_published(&f, i, force);
        double e = hypot(force[0] - PUBLISHED[i].full[0], force[1] - PUBLISHED[i].full[1]);
        sum += e*e;
        most = fmax(most, e);
        other = fmax(other, hypot(force[0] - PUBLISHED[i].fastsim[0], force[1] - PUBLISHED[i].fastsim[1]));
    }
    ok(sqrt(sum/(double)rows) < 0.045 && most < 0.11, "%d x %d against the full theory: %.3f mu N rms, %.3f at most", n, n,
       sqrt(sum/(double)rows), most);
    ok(other < 0.045, "%d x %d against another FASTSIM at 25 x 25: %.3f mu N at most", n, n, other);
}

/* User guide of CONTACT: a 8, b 4 mm, eta = -6.25e-4, phi = 0.625 1/m; parabolic FASTSIM gives -0.6118 on 44 x 44 and -0.6359 on 220 x 220
 * elements, of first order: -0.6419 in the limit. */
static void test_guide(void)
{
    static struct fastsim f;
    double force[3], at[2];

    for (int k = 0; k < 2; k++) {
        fastsim_begin(&f, 100 << k);
        fastsim(&f, 8e-3, 4e-3, N, MU, G, NU, 0, -6.25e-4, 0.625, force);
        at[k] = force[1]/(MU*N);
        ok(fabs(force[0]) < 1e-9*MU*N, "lateral creepage and spin give no longitudinal force");
    }
    near(2*at[1] - at[0], 0.6419, 0.001, "the published example where its spin outdoes its creepage, fine grid");
    fastsim_begin(&f, 10);
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

    for (size_t i = 0; i < sizeof PUBLISHED/sizeof *PUBLISHED; i++) {
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
