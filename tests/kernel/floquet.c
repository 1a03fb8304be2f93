/* A wheel over sleepers and over a sinusoidal rail against a solution in the frequency domain that is exact for the meshed track.
 *
 * The track repeats every bay L.  A force exp(i w t) at x = vt loads node k with g(vt - kL) exp(i w t), g the shape functions, so by Floquet
 * and Fourier the deflection under it is exp(i w t) times harmonics m of the bay,
 *   H(m, w) = 1/(2 pi L) integral dq  g(2 pi m/L - q)' B(q, w + qv) g(q),
 * g(q) the transforms of the shape functions and B(q, w) the inverse of the cell's dynamic stiffness with its neighbours turned by
 * exp(-+ i q L).  Wheel, contact and the element's own compliance c(x) then give for the harmonics of Q
 *   (1/K + W) Q(m) + sum (H(m - n, w + n Omega) + c(m - n)) Q(n) = -r(m) - static part,   Omega = 2 pi v/L. */
#include <complex.h>

#include "tests/kernel/half_set.h"
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

#define BAY 0.6            /* m */
#define WINDOW 6.0         /* m, ten bays and whole waves */
#define AMPLITUDE 5e-5     /* m of the rail */
#define SLEEPER 0.3        /* m, a sleeper, */
#define START -22.5        /* where the wheel starts, */
#define WAVES -21.0        /* where waves begin, */
#define END 21.9           /* and the end: the window before that is whole bays from a sleeper on */
#define CONTACT_K 137e6    /* N/m */
#define CONTACT_C 28e3     /* N s/m */
enum { W, T, Z, PARTS, HARMONICS = 12, ALL = 2 * HARMONICS + 1, MOST = 30000 };

/* ---- the track ---- */

/* A cell and what its neighbours give it, behind, itself, ahead; both rails alike, no roll. */
struct cell {
    double K[3][PARTS][PARTS], C[3][PARTS][PARTS], M[3][PARTS][PARTS];
};

/* Which part of cell k a degree of freedom is; -1 for none that moves. */
static int part_of(const struct trk *t, int64_t k, int64_t dof)
{
    const int64_t at = dof - t->node_dof[t->sleeper_node[k]];

    return at >= 0 && at < 4 ? (int)(at % 2) : dof == t->sleeper_dof[k] ? Z : -1;
}

/* Rows of the left rail and the sleeper amid the track. */
static void cell_take(struct cell *c, const struct trk *t)
{
    const int64_t k = t->sleepers / 2, w = t->node_dof[t->sleeper_node[k]], row[PARTS] = {w, w + 1, t->sleeper_dof[k]};

    memset(c, 0, sizeof *c);
    for (int j = 0; j < 3; j++)
        for (int64_t dof = 0; dof < t->dofs; dof++) {
            const int b = part_of(t, k + j - 1, dof);
            for (int64_t p = t->Ap[dof]; b >= 0 && p < t->Ap[dof + 1]; p++)
                for (int a = 0; a < PARTS; a++)
                    if (t->Ai[p] == row[a]) {
                        c->K[j][a][b] += t->Kx[p];
                        c->C[j][a][b] += t->Cx[p];
                        c->M[j][a][b] += t->Mx[p];
                    }
        }
}

/* x = D^-1 b by elimination; D is destroyed. */
static void solve(double complex D[PARTS][PARTS], double complex x[PARTS])
{
    for (int i = 0; i < PARTS; i++)
        for (int r = i + 1; r < PARTS; r++) {
            const double complex f = D[r][i] / D[i][i];
            for (int c = i; c < PARTS; c++)
                D[r][c] -= f * D[i][c];
            x[r] -= f * x[i];
        }
    for (int i = PARTS - 1; i >= 0; i--) {
        for (int c = i + 1; c < PARTS; c++)
            x[i] -= D[i][c] * x[c];
        x[i] /= D[i][i];
    }
}

static void respond(const struct cell *c, double q, double omega, double complex x[PARTS])
{
    double complex D[PARTS][PARTS] = {0};

    for (int j = 0; j < 3; j++) {
        const double complex turn = cexp(-I * q * BAY * (j - 1));
        for (int a = 0; a < PARTS; a++)
            for (int b = 0; b < PARTS; b++)
                D[a][b] += turn * (c->K[j][a][b] + I * omega * c->C[j][a][b] - omega * omega * c->M[j][a][b]);
    }
    solve(D, x);
}

/* Transforms over -L..L of the shape functions of a node: of w even, of the pitch t = -dw/dx odd. */
static void shapes(double q, double complex g[2])
{
    enum { POINTS = 400 };
    double even = 0, odd = 0;

    for (int i = 0; i < POINTS; i++) { /* midpoints: all but the second derivatives vanish at the ends */
        const double s = (i + 0.5) / POINTS;
        even += (1 - s) * (1 - s) * (1 + 2 * s) * cos(q * BAY * s);
        odd += -BAY * s * (1 - s) * (1 - s) * sin(q * BAY * s);
    }
    g[0] = 2 * even * BAY / POINTS;
    g[1] = -2 * I * odd * BAY / POINTS;
}

#define Q_STEP (2 * M_PI / BAY / 320)   /* 1/m: waves come round after 192 m */
enum { Q_BAY = 320, Q_MOST = 40 * Q_BAY };  /* up to 40 times 2 pi/L, 419/m */

static double complex g[2 * (Q_MOST + ALL * Q_BAY) + 1][2];

static const double complex *shape_at(int k)
{
    return g[k + Q_MOST + ALL * Q_BAY];
}

static void tabulate_shapes(void)
{
    for (int k = -(Q_MOST + ALL * Q_BAY); k <= Q_MOST + ALL * Q_BAY; k++)
        shapes(k * Q_STEP, g[k + Q_MOST + ALL * Q_BAY]);
}

/* H(m, omega) for m = -2 HARMONICS..2 HARMONICS into H + 2 HARMONICS. */
static void moving(const struct cell *c, double v, double omega, double complex *H)
{
    memset(H, 0, (2 * ALL - 1) * sizeof *H);
    for (int k = -Q_MOST; k <= Q_MOST; k++) {
        double complex x[PARTS] = {shape_at(k)[0], shape_at(k)[1], 0};
        respond(c, k * Q_STEP, omega + k * Q_STEP * v, x);
        for (int m = -2 * HARMONICS; m <= 2 * HARMONICS; m++) {
            const double complex *to = shape_at(m * Q_BAY - k);
            H[m + 2 * HARMONICS] += (to[0] * x[0] + to[1] * x[1]) * Q_STEP / (2 * M_PI * BAY);
        }
    }
}

/* Harmonic m of x^3 (L - x)^3/(3 EI L^3), x from the node. */
static double own(double EI, int m)
{
    enum { POINTS = 2000 };
    double sum = 0;

    for (int i = 0; i < POINTS; i++) {
        const double s = (i + 0.5) / POINTS;
        sum += pow(s * (1 - s), 3) * cos(2 * M_PI * m * s);
    }
    return sum / POINTS * pow(BAY, 3) / (3 * EI);
}

/* ---- wheel and track ---- */

/* Q(m) exp(i (omega + m Omega) t), N, into Q, of waves exp(i omega t) of the rail (static load P = 0) or of P itself (omega = 0). */
static void wheel_on_track(const struct cell *c, const struct veh *vehicle, double EI, double v, double omega, double wave, double P,
                           double complex Q[ALL])
{
    double complex A[ALL][ALL], H[2 * ALL - 1];

    for (int n = -HARMONICS; n <= HARMONICS; n++) {
        moving(c, v, omega + n * 2 * M_PI * v / BAY, H);
        for (int m = -HARMONICS; m <= HARMONICS; m++)
            A[m + HARMONICS][n + HARMONICS] = H[m - n + 2 * HARMONICS] + own(EI, m - n);
    }
    for (int m = 0; m < ALL; m++)
        Q[m] = (m == HARMONICS ? -wave : 0) - (P > 0 ? A[m][HARMONICS] * P : 0);
    for (int m = 0; m < ALL; m++) {
        const double w = omega + (m - HARMONICS) * 2 * M_PI * v / BAY;
        if (P > 0 && m == HARMONICS) {      /* the mean is P and nothing else */
            memset(A[m], 0, sizeof A[m]);
            A[m][m] = 1;
            Q[m] = 0;
        } else {
            A[m][m] += 1 / (CONTACT_K + I * w * CONTACT_C) + half_set(vehicle, w);
        }
    }
    for (int i = 0; i < ALL; i++)
        for (int r = i + 1; r < ALL; r++) {
            const double complex f = A[r][i] / A[i][i];
            for (int k = i; k < ALL; k++)
                A[r][k] -= f * A[i][k];
            Q[r] -= f * Q[i];
        }
    for (int i = ALL - 1; i >= 0; i--) {
        for (int k = i + 1; k < ALL; k++)
            Q[i] -= A[i][k] * Q[k];
        Q[i] /= A[i][i];
    }
}

/* ---- the run ---- */

struct ride {
    double speed, wave;        /* m/s, m; wave 0: smooth */
    enum way_scheme scheme;
    double step;               /* s */
};

/* Q less the static load over the last window, which ends above a sleeper; *n steps. */
static const char *pass(const struct trk *t, const struct veh *v, struct rig_table table[2], const struct ride *r, double *Q, int *n)
{
    static struct case_dip dip[100];
    struct passage_options o = rig_options(START, END);
    struct passage p;
    double residual;

    o.scheme = r->scheme;
    o.speed = r->speed;
    o.step = o.law.step = r->step;
    o.law.normal = WHEEL_LINEAR;
    o.law.stiffness = CONTACT_K;
    o.law.damping = CONTACT_C;
    for (int k = 0; r->wave > 0 && WAVES + k * r->wave < END; k++) {
        dip[k] = (struct case_dip){WAVES + k * r->wave, r->wave, 2 * AMPLITUDE, CASE_BOTH};
        o.excitation.dips = k + 1;
    }
    o.excitation.dip = dip;
    const char *why = passage_new(&p, &o, t, v, &table[0].ctab, &table[1].ctab);
    if (!why)
        why = passage_start(&p, &residual);
    *n = (int)rint(WINDOW / (r->speed * r->step));
    while (!why && p.n < p.steps) {
        why = passage_step(&p);
        if (p.n > p.steps - *n)
            Q[p.n - p.steps + *n - 1] = p.wheel[0].Q - v->wheel_load[0];
    }
    passage_free(&p);
    return why;
}

/* N at x, by harmonics. */
static double harmonics(const double complex sleepers[ALL], const double complex waves[ALL], double wave, double x)
{
    double Q = 0;

    for (int m = -HARMONICS; m <= HARMONICS; m++) {
        const double turn = 2 * M_PI * m * (x - SLEEPER) / BAY;
        Q += creal(sleepers[m + HARMONICS] * cexp(I * turn));
        if (wave > 0) /* a dip is 1 - cos: -AMPLITUDE cos of x from its beginning */
            Q -= creal(waves[m + HARMONICS] * cexp(I * (2 * M_PI / wave * (x - WAVES) + turn)));
    }
    return Q;
}

struct result {
    double rms, off;       /* N; rms of Q from the run less that of the frequency domain, over rms of the latter */
    double order;          /* log2 of the ratio of changes of Q's wave, or passing of sleepers, as the step is halved twice */
};

/* Its part of wave number k: what rings at 908 Hz since the start, undamped between sleepers, has no phase at such steps. */
static double complex part(const double *Q, int n, double k)
{
    double complex sum = 0;

    for (int i = 0; i < n; i++)
        sum += 2 * Q[i] / n * cexp(-I * k * (i + 1) * WINDOW / n);
    return sum;
}

static const char *ride(const struct trk *t, const struct veh *v, struct rig_table table[2], struct ride r, const double complex *sleepers,
                        const double complex *waves, struct result *out)
{
    static double Q[MOST];
    const double k = 2 * M_PI / (r.wave > 0 ? r.wave : BAY);
    double complex is[3] = {0};
    double e = 0, all = 0;
    int n;
    const char *why = NULL;

    for (int halved = 0; halved < 3 && !why; halved++, r.step /= 2) {
        why = pass(t, v, table, &r, Q, &n);
        is[halved] = part(Q, n, k);
        for (int i = 0; i < n && !halved; i++) {
            const double want = harmonics(sleepers, waves, r.wave, END - WINDOW + (i + 1) * WINDOW / n);
            e += (Q[i] - want) * (Q[i] - want) / n;
            all += want * want / n;
        }
    }
    *out = (struct result){sqrt(all), sqrt(e / all), log2(cabs(is[0] - is[1]) / cabs(is[1] - is[2]))};
    return why;
}

static void wheel(const struct trk *t, const struct veh *v, struct rig_table table[2], double speed, double wave)
{
    double complex sleepers[ALL], waves[ALL] = {0};
    struct cell c;

    cell_take(&c, t);
    wheel_on_track(&c, v, t->bending[0], speed, 0, 0, v->wheel_load[0], sleepers);
    if (wave > 0)
        wheel_on_track(&c, v, t->bending[0], speed, 2 * M_PI * speed / wave, AMPLITUDE, 0, waves);
    for (int s = WAY_EXPLICIT; s <= WAY_IMPLICIT; s++) {
        struct result r = {0};
        const char *why = ride(t, v, table, (struct ride){speed, wave, (enum way_scheme)s, 1e-4}, sleepers, waves, &r);
        ok(!why && r.off < 0.01 && fabs(r.order - 2) < 0.1, "%.1f m/s, %s, waves of %.3f m: Q %.1f N rms, off by %.3f %%, order %.2f%s%s", speed,
           s == WAY_EXPLICIT ? "explicit" : "implicit", wave, r.rms, 100 * r.off, r.order, why ? ": " : "", why ? why : "");
    }
}

int main(void)
{
    static const char *const longer[] = {"from=-30", "length=60"}, *const damped[] = {"coupling.1.damping=[15e3, 2e3, 150e3]"};
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
    const char *why = rig_track(&track, RIG_STRAIGHT, longer, 2), *also = rig_vehicle(&vehicle, RIG_WHEELSET, damped, 1);

    if (why || also) {
        ok(0, "%s", why ? why : also);
        return done();
    }
    rig_table(&table[0], 'l', 0);
    rig_table(&table[1], 'r', 0);
    tabulate_shapes();
    wheel(&track, &vehicle, table, 80 / 3.6, 0);
    wheel(&track, &vehicle, table, 80 / 3.6, 6.0 / 7);
    wheel(&track, &vehicle, table, 200 / 3.6, 0);
    wheel(&track, &vehicle, table, 200 / 3.6, 6.0 / 7);
    trk_free(&track);
    veh_free(&vehicle);
    return done();
}
