/* Receptances of any two places of the track of Table 1: the direct solution equals the sum over all modes, undamped over the real modes
 * of vxfreq and damped over the complex ones of LAPACK; it is reciprocal, passive where force and motion share a place, and its derivatives
 * are mobility and accelerance. */
#include "tools/receptance/sweep.h"

#include <string.h>

#include <lapacke.h>

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/direct.h"
#include "tools/receptance/modes.h"

enum { PLACES = 6, SMALL = 36 };

static const struct { int on, at; double x; const char *what; } where[PLACES] = {
    {PLACE_LEFT, AT_SLEEPER, 0.2, "left rail above a sleeper"}, {PLACE_LEFT, AT_STATION, 0.47, "left rail at 0.47 m"},
    {PLACE_LEFT, AT_STATION, 0.61, "left rail at 0.61 m"},      {PLACE_RIGHT, AT_MIDSPAN, -0.5, "right rail between sleepers"},
    {PLACE_SLEEPER, AT_SLEEPER, 0, "sleeper"},                  {PLACE_BOTH, AT_SLEEPER, -0.9, "both rails"}};

/* H by the direct solution over a few frequencies, without what elements give with held ends. */
static int direct(const struct trk *t, const struct place *force, const struct place *motion, const struct sweep *s, struct frf *r)
{
    return sweep_places(r, t, force, motion, FRF_RECEPTANCE, s) == NULL;
}

static double share(const struct place *p, const double *x)
{
    double sum = 0;

    for (int k = 0; k < p->dofs; k++)
        sum += p->share[k] * x[p->dof[k]];
    return sum;
}

/* The lowest half of the modes and the highest, which together are all. */
static int all_modes(const struct trk *t, struct mod half[2])
{
    const int64_t n = t->dofs / 2;
    const char *why = modes_track(&half[0], t, n, 0), *other = modes_track(&half[1], t, n, 1e4);

    return ok(!why && !other && half[0].frequency[n - 1] < half[1].frequency[0], "all %d modes, in two halves%s%s", (int)t->dofs,
              why ? ": " : other ? ": " : "", why ? why : other ? other : "");
}

/* H = sum x_f x_m / (omega_k^2 - omega^2) */
static double modal(const struct mod half[2], const struct place *force, const struct place *motion, double frequency)
{
    double H = 0;

    for (int h = 0; h < 2; h++)
        for (int64_t k = 0; k < half[h].n; k++) {
            const double *x = half[h].shape + k * half[h].dofs;
            H += share(force, x) * share(motion, x) / (pow(2 * M_PI * half[h].frequency[k], 2) - pow(2 * M_PI * frequency, 2));
        }
    return H;
}

/* The response of the undamped track to a unit force: direct_* without its damping. */
static double undamped(const struct trk *t, const struct place *force, const struct place *motion, double frequency)
{
    static double u[800];
    struct direct d;
    double H = NAN;

    memset(u, 0, sizeof u);
    for (int k = 0; k < force->dofs; k++)
        u[2 * force->dof[k]] = force->share[k];
    if (direct_new(&d, t) == NULL) {
        d.part = 0;
        if (direct_factor(&d, 2 * M_PI * frequency * I) == NULL && direct_solve(&d, u) == NULL) {
            H = 0;
            for (int k = 0; k < motion->dofs; k++)
                H += motion->share[k] * u[2 * motion->dof[k]];
        }
        direct_free(&d);
    }
    return H;
}

static void modal_sum(const struct trk *t)
{
    static const double f[] = {0, 37, 100, 240, 321.5, 700, 1000, 1700};
    struct mod half[2];
    double worst = 0;

    if (!all_modes(t, half))
        return;
    for (int a = 0; a < PLACES; a++)
        for (int b = 0; b < PLACES; b++) {
            struct place force, motion;
            place_find(&force, t, where[a].on, where[a].at, where[a].x);
            place_find(&motion, t, where[b].on, where[b].at, where[b].x);
            for (size_t k = 0; k < sizeof f / sizeof f[0]; k++) {
                const double scale = fabs(undamped(t, &force, &force, f[k])), H = undamped(t, &force, &motion, f[k]);
                worst = fmax(worst, fabs(H - modal(half, &force, &motion, f[k])) / fmax(scale, fabs(H)));
            }
        }
    near(worst, 0, 1e-8, "direct equals the sum over all modes, undamped, 36 pairs of places");
    mod_free(&half[0]);
    mod_free(&half[1]);
}

/* Row-major dense copy. */
static void dense(const struct trk *t, const double *X, double *A)
{
    memset(A, 0, SMALL * SMALL * sizeof *A);
    for (int64_t j = 0; j < SMALL; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            A[t->Ai[p] * SMALL + j] = X[p];
}

/* Eigenvalues s [2 SMALL] and vectors x [SMALL][2 SMALL] of K + s C + s^2 M by [0 I; -K/M -C/M], in columns. */
static int complex_modes(const struct trk *t, double complex *s, double complex *x, double *C, double *M)
{
    enum { N = 2 * SMALL };
    static double K[SMALL * SMALL], A[N * N], re[N], im[N], V[N * N];

    dense(t, t->Kx, K);
    dense(t, t->Cx, C);
    dense(t, t->Mx, M);
    static double Mc[SMALL * SMALL], KC[SMALL * N];
    static lapack_int pivot[SMALL];
    memcpy(Mc, M, sizeof Mc);
    for (int i = 0; i < SMALL; i++)
        for (int j = 0; j < SMALL; j++) {
            KC[i * N + j] = -K[i * SMALL + j];
            KC[i * N + SMALL + j] = -C[i * SMALL + j];
        }
    if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, SMALL, N, Mc, SMALL, pivot, KC, N) != 0)
        return 0;
    for (int i = 0; i < SMALL; i++) {
        A[i * N + SMALL + i] = 1;
        memcpy(&A[(SMALL + i) * N], &KC[i * N], N * sizeof *A);
    }
    if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', N, A, N, re, im, NULL, 1, V, N) != 0)
        return 0;
    for (int k = 0; k < N; k++) {
        s[k] = re[k] + im[k] * I;
        const int first = im[k] < 0 ? k - 1 : k;         /* of a conjugate pair */
        for (int i = 0; i < SMALL; i++)
            x[i * N + k] = im[k] == 0 ? V[i * N + k] : V[i * N + first] + (im[k] < 0 ? -1 : 1) * V[i * N + first + 1] * I;
    }
    return 1;
}

/* x'(C + 2 s M)x without conjugation; x [SMALL] apart by 2 SMALL */
static double complex norm(const double complex *x, double complex s, const double *C, const double *M)
{
    double complex sum = 0;

    for (int i = 0; i < SMALL; i++)
        for (int j = 0; j < SMALL; j++)
            sum += x[i * 2 * SMALL] * x[j * 2 * SMALL] * (C[i * SMALL + j] + 2 * s * M[i * SMALL + j]);
    return sum;
}

/* H = sum x_f x_m / (x'(C + 2 s M)x (i omega - s)) over all eigenvalues (Tisseur and Meerbergen 2001, SIAM Review 43, 235). */
static void damped_sum(void)
{
    static double complex s[2 * SMALL], x[2 * SMALL * SMALL];
    static double C[SMALL * SMALL], M[SMALL * SMALL];
    const char *set[] = {"from=-1.8", "length=3.6"};
    struct trk t;
    double worst = 0;

    if (!ok(table1(&t, set, 2) == NULL && t.dofs == SMALL && complex_modes(&t, s, x, C, M), "all complex modes of six sleepers by LAPACK"))
        return;
    for (int a = 0; a < PLACES; a++)
        for (int b = 0; b < PLACES; b++) {
            struct place force, motion;
            struct frf r;
            place_find(&force, &t, where[a].on, where[a].at, where[a].x);
            place_find(&motion, &t, where[b].on == PLACE_BOTH ? PLACE_LEFT : where[b].on, where[b].at, where[b].x);
            if (!direct(&t, &force, &motion, &(struct sweep){0, 1500, 150}, &r)) {
                ok(0, "%s and %s", where[a].what, where[b].what);
                continue;
            }
            for (int64_t k = 0; k < r.n; k++) {
                double complex H = 0, got = (r.hermites ? r.hermite : r.H)[2 * k] + r.H[2 * k + 1] * I;
                for (int m = 0; m < 2 * SMALL; m++) {
                    double complex f = 0, w = 0;
                    for (int i = 0; i < force.dofs; i++)
                        f += force.share[i] * x[force.dof[i] * 2 * SMALL + m];
                    for (int i = 0; i < motion.dofs; i++)
                        w += motion.share[i] * x[motion.dof[i] * 2 * SMALL + m];
                    H += f * w / (norm(&x[m], s[m], C, M) * (2 * M_PI * r.frequency[k] * I - s[m]));
                }
                worst = fmax(worst, cabs(got - H) / fmax(cabs(H), 1e-12));
            }
            frf_free(&r);
        }
    near(worst, 0, 1e-8, "direct equals the sum over all complex modes, 36 pairs of places, 0 to 1500 Hz");
    trk_free(&t);
}

static void reciprocity(const struct trk *t)
{
    double worst = 0;
    int gains = 0;

    for (int a = 0; a < PLACES - 1; a++)
        for (int b = 0; b <= a; b++) {
            struct place one, other;
            struct frf there, back;
            place_find(&one, t, where[a].on, where[a].at, where[a].x);
            place_find(&other, t, where[b].on, where[b].at, where[b].x);
            const struct sweep s = {0, 1600, 40};
            if (!direct(t, &one, &other, &s, &there) || !direct(t, &other, &one, &s, &back)) {
                ok(0, "%s and %s", where[a].what, where[b].what);
                continue;
            }
            for (int64_t k = 0; k < there.n; k++) {
                const double scale = hypot(there.H[2 * k], there.H[2 * k + 1]);
                worst = fmax(worst, hypot(there.H[2 * k] - back.H[2 * k], there.H[2 * k + 1] - back.H[2 * k + 1]) / fmax(scale, 1e-12));
                gains += a == b && there.H[2 * k + 1] > 0;
            }
            frf_free(&there);
            frf_free(&back);
        }
    near(worst, 0, 1e-9, "reciprocity of every two places, 0 to 1600 Hz");
    near(gains, 0, 0, "where force and motion share a place, the track takes energy up");
}

static void derivatives(const struct trk *t)
{
    struct place p;
    struct frf r[FRF_QUANTITIES];
    double worst = 0;

    place_find(&p, t, PLACE_LEFT, AT_MIDSPAN, 0);
    for (int q = 0; q < FRF_QUANTITIES; q++)
        ok(sweep_places(&r[q], t, &p, &p, q, &(struct sweep){10, 1500, 10}) == NULL, "%s in %s", frf_quantity[q].name, frf_quantity[q].unit);
    for (int64_t k = 0; k < r[0].n; k++) {
        const double complex iw = 2 * M_PI * r[0].frequency[k] * I, H = r[0].H[2 * k] + r[0].H[2 * k + 1] * I;
        for (int q = 1; q < FRF_QUANTITIES; q++)
            worst = fmax(worst, cabs(r[q].H[2 * k] + r[q].H[2 * k + 1] * I - (q == 1 ? iw : iw * iw) * H) / cabs(cpow(iw, q) * H));
    }
    near(worst, 0, 1e-14, "mobility is i omega, accelerance -omega^2 times the receptance");
    for (int q = 0; q < FRF_QUANTITIES; q++)
        frf_free(&r[q]);
}

/* Two places in one bay, exactly: a track with nodes at both has them as nodes. */
static void held_ends(const struct trk *t)
{
    struct place force, motion;
    double H[2] = {NAN, NAN};
    struct frf r;

    place_find(&force, t, PLACE_LEFT, AT_STATION, 0.45);
    place_find(&motion, t, PLACE_LEFT, AT_STATION, 0.75);
    ok(force.point.node == motion.point.node, "0.45 and 0.75 m lie in one bay");
    if (direct(t, &force, &motion, &(struct sweep){0, 0, 1}, &r))
        H[0] = r.H[0];
    frf_free(&r);
    const char *set[] = {"rail.elements_per_bay=4"};
    struct trk fine;
    if (table1(&fine, set, 1) == NULL) {
        place_find(&force, &fine, PLACE_LEFT, AT_STATION, 0.45);
        place_find(&motion, &fine, PLACE_LEFT, AT_STATION, 0.75);
        ok(force.point.node != motion.point.node, "and in two elements of four a bay");
        if (direct(&fine, &force, &motion, &(struct sweep){0, 0, 1}, &r))
            H[1] = r.H[0];
        frf_free(&r);
    }
    trk_free(&fine);
    near(H[0] / H[1], 1, 1e-9, "static influence within a bay is that of finer elements");
}

int main(void)
{
    struct trk t;
    const char *why = table1(&t, NULL, 0);

    if (!ok(why == NULL, "the track of Table 1 builds%s%s", why ? ": " : "", why ? why : ""))
        return done();
    modal_sum(&t);
    damped_sum();
    reciprocity(&t);
    derivatives(&t);
    held_ends(&t);
    trk_free(&t);
    return done();
}
