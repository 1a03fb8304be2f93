/* Joints, flats and random irregularity on a beam on a Winkler foundation, against Fourier transforms: a rail whose height r passes under the
 * wheel gives  Q = -r/(1/K + W + H)  at every frequency, W and H the receptances of wheel and moving load.  Then the forces at a dipped
 * joint against the formulas of Jenkins et al. 1974. */
#include "tests/kernel/half_set.h"
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tests/kernel/winkler.h"
#include "tools/integrate/start.h"

#define CONTACT_K 137e6    /* N/m */
#define CONTACT_C 28e3     /* N s/m */
#define STEP 2e-5          /* s */
#define COARSE 0.02        /* 1/m, for the receptance */
#define HIGHEST 4000.0     /* Hz */
#define START -20.0        /* m */
enum { MOST = 60000 };

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
};

struct history {
    int n;
    double r[MOST], Q[MOST], want[MOST];   /* m height of the rails, N of a wheel less its static load, N by transforms: means of both sides */
};

static const char *pass(struct fixture *f, double speed, double end, const struct excitation_options *e, struct history *h)
{
    struct passage_options o = rig_options(START, end);
    struct passage p;
    double residual;

    o.speed = speed;
    o.scheme = WAY_IMPLICIT;
    o.step = o.law.step = STEP;
    o.law.normal = WHEEL_LINEAR;
    o.law.stiffness = CONTACT_K;
    o.law.damping = CONTACT_C;
    o.excitation = *e;
    h->n = 0;
    const char *why = passage_new(&p, &o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab);
    if (why)
        return why;
    why = passage_start(&p, &residual);
    while (!why && p.n < p.steps && h->n < MOST) {
        struct excitation_at at[2];
        why = passage_step(&p);
        for (int side = 0; side < 2; side++)
            excitation_find(&p.excitation, p.station, 0, side, f->vehicle.radius[0], &at[side]);
        h->r[h->n] = 0.5 * (at[0].z + at[1].z);
        h->Q[h->n++] = 0.5 * (p.wheel[0].Q + p.wheel[1].Q) - f->vehicle.wheel_load[0];
    }
    passage_free(&p);
    return why;
}

/* By a transform over twice the run, whose second half lets r and Q fall to nothing. */
static void transform(const struct veh *v, double speed, struct history *h)
{
    const double T = 2 * h->n * STEP, end = h->r[h->n - 1];

    memset(h->want, 0, sizeof h->want);
    for (int k = 0; k < HIGHEST * T; k++) {
        const double omega = 2 * M_PI * k / T;
        const double complex turn = cexp(-I * omega * STEP);
        double complex sum = 0, at = turn;
        for (int i = 0; i < 2 * h->n; i++, at *= turn)
            sum += at * (i < h->n ? h->r[i] : end * 0.5 * (1 + cos(M_PI * fmin(2.0 * (i - h->n) / h->n, 1))));
        sum *= -(k ? 2 : 1) * STEP / T / (1 / (CONTACT_K + I * omega * CONTACT_C) + half_set(v, omega) + winkler_receptance(omega, speed, DAMPING, 0, COARSE));
        at = conj(turn);
        for (int i = 0; i < h->n; i++, at *= conj(turn))
            h->want[i] += creal(sum * at);
    }
}

static double rms(const double *x, int n)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += x[i] * x[i] / n;
    return sqrt(sum);
}

static double largest(const double *x, int from, int to)
{
    double most = -HUGE_VAL;

    for (int i = from; i < to; i++)
        most = fmax(most, x[i]);
    return most;
}

static void transformed(struct fixture *f, double speed, double end, const struct excitation_options *e, const char *what, struct history *h)
{
    static double off[MOST];
    const char *why = pass(f, speed, end, e, h);

    transform(&f->vehicle, speed, h);
    for (int i = 0; i < h->n; i++)
        off[i] = h->Q[i] - h->want[i];
    const double Q = rms(h->Q, h->n), want = rms(h->want, h->n), most = largest(h->want, 0, h->n);
    ok(!why && fabs(Q / want - 1) < 0.01 && rms(off, h->n) < 0.02 * want && fabs(largest(h->Q, 0, h->n) / most - 1) < 0.02,
       "%s at %.1f m/s: %.1f N rms, by transform %.1f, difference %.2f %%; largest %.0f, %.0f%s%s", what, speed, Q, want, 100 * rms(off, h->n) / want,
       largest(h->Q, 0, h->n), most, why ? ": " : "", why ? why : "");
}

/* P2 = P0 + 2a v sqrt(Mu/(Mu + Mt)) (1 - pi Ct/(4 sqrt(Kt (Mu + Mt)))) sqrt(Kt Mu), 2a the angle of the rail ends, Mu the unsprung mass of a
 * wheel, and of a beam on a foundation Kt = 2 k/b, Mt = 3 m/2b, Ct = 3 c/2b, b^4 = k/4EI. */
static double jenkins(double angle, double speed, double Mu)
{
    const double b = pow(FOUNDATION / (4 * EI), 0.25), Kt = 2 * FOUNDATION / b, Mt = 1.5 * MASS / b, Ct = 1.5 * DAMPING / b;

    return angle * speed * sqrt(Mu / (Mu + Mt)) * (1 - M_PI * Ct / (4 * sqrt(Kt * (Mu + Mt)))) * sqrt(Kt * Mu);
}

/* Rail ends so long that they hardly bend while the wheel bounces once. */
static void joint(struct fixture *f, double speed, double angle)
{
    static struct history h;
    const struct case_joint at = {-17.5, 5, angle * 2.5 / 4, CASE_BOTH};
    const double Mu = 0.5 * f->vehicle.mass[f->vehicle.wheelset[0]], want = jenkins(angle, speed, Mu);

    transformed(f, speed, -15, &(struct excitation_options){.joints = 1, .joint = &at}, "a joint", &h);
    const int gap = (int)((at.at - START) / (speed * STEP)), later = gap + (int)(2.5e-3 / STEP);
    const double P1 = largest(h.Q, gap, later), P2 = largest(h.Q, later, gap + (int)(20e-3 / STEP));
    ok(fabs(P2 / want - 1) < 0.2, "P1 %.1f kN and P2 %.1f kN beyond the static load, P2 of Jenkins %.1f (%+.0f %%)", 1e-3 * P1, 1e-3 * P2, 1e-3 * want,
       100 * (P2 / want - 1));
}

int main(void)
{
    static struct history h;
    static const char *const damped[] = {"coupling.1.damping=[15e3, 2e3, 150e3]"};
    const struct case_flat flat = {1, CASE_BOTH, CASE_WORN, 0.04, -18};
    const struct excitation_options random = {.waves = {SPECTRUM_HIGH, 1, 12, 36, 7}, .scale = 0.3, .from = START, .to = 16, .fade = 4};
    struct fixture f;

    memset(&f, 0, sizeof f);
    const char *why = rig_track(&f.track, RIG_STRAIGHT, winkler_beam, sizeof winkler_beam / sizeof *winkler_beam);
    const char *also = rig_vehicle(&f.vehicle, RIG_WHEELSET, damped, 1);
    if (why || also) {
        ok(0, "%s", why ? why : also);
        return done();
    }
    rig_table(&f.table[0], 'l', 0);
    rig_table(&f.table[1], 'r', 0);
    joint(&f, 80 / 3.6, 2e-3);
    joint(&f, 200 / 3.6, 1.2e-3);
    transformed(&f, 80 / 3.6, -16, &(struct excitation_options){.flats = 1, .flat = &flat}, "a worn flat", &h);
    transformed(&f, 200 / 3.6, 16, &random, "irregularity of the spectrum", &h);
    trk_free(&f.track);
    veh_free(&f.vehicle);
    return done();
}
