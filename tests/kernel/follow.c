/* A track that follows the train: rest in closed form, a dip against a Runge-Kutta integration of the same few masses, sides alike, sideways
 * motion against another. */
#include "tools/integrate/follow.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

#define ONE "data/tracks/moving-mass.yaml"
#define TWO "data/tracks/co-running.yaml"

static const double G = 9.81;

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
    struct passage p;
};

static int begin(struct fixture *f, const char *track, const char *vehicle, const struct passage_options *o)
{
    double residual;
    const char *why = rig_track(&f->track, track, NULL, 0), *also = rig_vehicle(&f->vehicle, vehicle, NULL, 0);

    rig_table(&f->table[0], 'l', 0);
    rig_table(&f->table[1], 'r', 0);
    if (!why && !also && !(why = passage_new(&f->p, o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab)))
        why = passage_start(&f->p, &residual);
    if (!ok(!why && !also && residual < 1e-6, "%s under %s%s%s", track, vehicle, why ? ": " : "", why ? why : ""))
        return 0;
    return 1;
}

static void end(struct fixture *f)
{
    passage_free(&f->p);
    trk_free(&f->track);
    veh_free(&f->vehicle);
}

static struct passage_options options(double length)
{
    struct passage_options o = rig_options(-4, -4 + length);

    o.scheme = WAY_AUTO;
    return o;
}

/* Pads carry wheels and running mass, ballast the sleeper too; the rail stands below by what both give. */
static void rests(const char *track, double running, double sleeper, double pad, double ballast)
{
    struct passage_options o = options(1);
    struct fixture f;

    if (begin(&f, track, RIG_COACH, &o)) {
        const double Q = 44482 * G / 8, F = Q + running * G, all = 2 * F + sleeper * G;
        int wrong = 0;
        for (int64_t i = 0; i < f.vehicle.wheelsets; i++)
            for (int s = 0; s < 2; s++) {
                wrong += !(fabs(f.p.rails.pad[s][i] - F) < 0.1 && fabs(f.p.rails.ballast[2 * s][i] - all / 2) < 0.1);
                wrong += !(fabs(f.p.rails.w[s][i] - F / pad - all / ballast) < 1e-9);
            }
        ok(wrong == 0 && f.p.track->sleepers == 4, "four copies at rest, pads with %.0f N", F);
        for (int k = 0; k < 100; k++)
            passage_step(&f.p);
        near(f.p.wheel[5].Q, Q, 0.5, "which stay there");
    }
    end(&f);
}

/* Half of a wheelset, its frame and its track: frame, wheel, rail, sleeper. */
struct half { double frame, wheel, rail, sleeper, k1, c1, pad_k, pad_c, k2, c2; };

enum { FRAME, WHEEL, RAIL, SLEEPER, PARTS, STATE = 2 * PARTS };

static double contact(const double *y, double dip)
{
    const double d = y[WHEEL] - y[RAIL] - dip;

    return d > 0 ? RIG_HERTZ_C * d * sqrt(d) : 0;
}

/* A rail without mass moves as pad and contact agree. */
static void derive(const struct half *h, const double *y, double dip, double *dy)
{
    const double *v = y + PARTS, N = contact(y, dip), spring = h->k1 * (y[FRAME] - y[WHEEL]) + h->c1 * (v[FRAME] - v[WHEEL]);
    const double squeeze = y[RAIL] - y[SLEEPER];
    const double rate = h->rail > 0 ? v[RAIL] - v[SLEEPER] : (N - h->pad_k * squeeze) / h->pad_c;
    const double pad = h->pad_k * squeeze + h->pad_c * rate;

    memcpy(dy, v, PARTS * sizeof *dy);
    dy[RAIL] = v[SLEEPER] + rate;
    dy[PARTS + FRAME] = G - spring / h->frame;
    dy[PARTS + WHEEL] = G + (spring - N) / h->wheel;
    dy[PARTS + RAIL] = h->rail > 0 ? G + (N - pad) / h->rail : 0;
    dy[PARTS + SLEEPER] = G + (pad - h->k2 * y[SLEEPER] - h->c2 * v[SLEEPER]) / h->sleeper;
}

static double dip_at(const struct case_dip *d, double s)
{
    return s > d->from && s < d->from + d->length ? 0.5 * d->depth * (1 - cos(2 * M_PI * (s - d->from) / d->length)) : 0;
}

static void runge_kutta(const struct half *h, const struct case_dip *d, double s, double v, double step, double *y)
{
    static const double at[4] = {0, 0.5, 0.5, 1}, weight[4] = {1 / 6.0, 1 / 3.0, 1 / 3.0, 1 / 6.0};
    double k[STATE] = {0}, sum[STATE] = {0}, x[STATE];

    for (int stage = 0; stage < 4; stage++) {
        for (int i = 0; i < STATE; i++)
            x[i] = y[i] + at[stage] * step * k[i];
        derive(h, x, dip_at(d, s + at[stage] * step * v), k);
        for (int i = 0; i < STATE; i++)
            sum[i] += weight[stage] * step * k[i];
    }
    for (int i = 0; i < STATE; i++)
        y[i] += sum[i];
}

/* Through a dip of 1 mm on 1 m: rms of the difference of Q over its rms change. */
static void dips(const char *track, const struct half *h, double least, double most)
{
    static const struct case_dip dip = {.from = -3, .length = 1, .depth = 1e-3};
    enum { FINE = 50 };
    struct passage_options o = options(5);
    struct fixture f;
    double y[STATE] = {0}, off = 0, change = 0, peak = 0;

    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    if (begin(&f, track, RIG_WHEELSET, &o)) {
        const double Q0 = f.p.wheel[0].Q;
        y[SLEEPER] = (Q0 + (h->rail + h->sleeper) * G) / h->k2;
        y[RAIL] = y[SLEEPER] + (Q0 + h->rail * G) / h->pad_k;
        y[WHEEL] = y[RAIL] + pow(Q0 / RIG_HERTZ_C, 2 / 3.0);
        y[FRAME] = y[WHEEL] + h->frame * G / h->k1;
        for (int64_t n = 0; n < f.p.steps; n++) {
            for (int k = 0; k < FINE; k++)
                runge_kutta(h, &dip, o.start + o.speed * o.step * ((double)n + (double)k / FINE), o.speed, o.step / FINE, y);
            passage_step(&f.p);
            const double Q = contact(y, dip_at(&dip, f.p.station));
            off += (f.p.wheel[0].Q - Q) * (f.p.wheel[0].Q - Q);
            change += (Q - Q0) * (Q - Q0);
            peak = fmax(peak, Q);
        }
        printf("# %s: largest Q %.0f N at rest %.0f N\n", track, peak, Q0);
        off = sqrt(off / change);
        ok(off < 0.005, "Q through the dip, off by %.2f %%", 100 * off);
        ok(peak > least && peak < most, "largest Q");
    }
    end(&f);
}

/* A dip of one rail, then of the other: the same, mirrored. */
static void mirrors(const char *track)
{
    struct case_dip dip = {.from = -3, .length = 1, .depth = 1e-3, .rail = CASE_LEFT};
    struct passage_options o = options(2);
    struct fixture f;
    double Q[2][2] = {{0}}, worst;

    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    for (int side = 0; side < 2; side++) {
        dip.rail = side ? CASE_RIGHT : CASE_LEFT;
        if (begin(&f, track, RIG_WHEELSET, &o)) {
            for (int k = 0; k < 600; k++)
                passage_step(&f.p);
            Q[side][0] = f.p.wheel[side].Q;
            Q[side][1] = f.p.wheel[!side].Q;
        }
        end(&f);
    }
    worst = fmax(fabs(Q[0][0] - Q[1][0]), fabs(Q[0][1] - Q[1][1]));
    ok(worst < 1e-4 && fabs(Q[0][0] - Q[0][1]) > 1e3, "a dip of one rail, mirrored for the other (%.0f and %.0f N, off by %.1e)", Q[0][0], Q[0][1], worst);
}

/* y'' of rails and sleeper under Y. */
static void pull(const struct trk *t, const double Y[2], const double *y, const double *v, double *a)
{
    double on_sleeper = -*t->sleeper_lateral_k * y[2] - *t->sleeper_lateral_c * v[2];

    for (int s = 0; s < 2; s++) {
        const double F = *t->lateral_k * (y[s] - y[2]) + *t->lateral_c * (v[s] - v[2]);
        a[s] = (Y[s] - F) / *t->lateral_m;
        on_sleeper += F;
    }
    a[2] = on_sleeper / *t->sleeper_mass;
}

/* One long step from rest: the change of momentum is what wheels and, at the end of the step, ground put in. */
static void pushes(void)
{
    static const struct wheel_output w[2] = {{.Y = -9e3}, {.Y = 4e3}};
    const double h = 1e-2;
    struct sideways s;
    struct trk t;

    ok(!rig_track(&t, TWO, NULL, 0) && !sideways_new(&s, 1), "a long step");
    sideways_accelerate(&s, &t, 1, h, w);
    const double force = -5e3 - (*t.sleeper_lateral_k * h * h + *t.sleeper_lateral_c * h) * s.a[2];
    near(*t.sleeper_mass * s.a[2] + *t.lateral_m * (s.a[0] + s.a[1]), force, 1e-9 * fabs(force), "momentum");
    sideways_free(&s);
    trk_free(&t);
}

/* Under forces that begin at once, 5 ms later, in steps of 1 microsecond, by midpoints for the reference. */
static void yields(void)
{
    static const double Y[2] = {-9e3, 4e3}, h = 1e-6;
    const struct wheel_output w[2] = {{.Y = Y[0]}, {.Y = Y[1] + 1e3, .check = 1e3}};
    struct sideways s;
    struct trk t;
    double y[3] = {0}, v[3] = {0}, a[3];

    ok(!rig_track(&t, TWO, NULL, 0) && !sideways_new(&s, 1), "sideways in two stages");
    for (int n = 0; n < 5000; n++) {
        double half_y[3], half_v[3];
        pull(&t, Y, y, v, a);
        for (int i = 0; i < 3; i++) {
            half_y[i] = y[i] + 0.5 * h * v[i];
            half_v[i] = v[i] + 0.5 * h * a[i];
        }
        pull(&t, Y, half_y, half_v, a);
        for (int i = 0; i < 3; i++) {
            y[i] += h * half_v[i];
            v[i] += h * a[i];
        }
        sideways_accelerate(&s, &t, 1, h, w);
        sideways_move(&s, h);
    }
    for (int i = 0; i < 3; i++)
        near(s.y[i], y[i], 1e-3 * fabs(y[i]), i == 2 ? "the sleeper" : i ? "the right rail" : "the left rail");
    for (int n = 0; n < 10000; n++) {
        sideways_accelerate(&s, &t, 1, 1e-4, w);
        sideways_move(&s, 1e-4);
    }
    near(s.y[2], -5e3 / 70e6, 1e-9, "at rest the sleeper stands aside by the sum of forces");
    near(s.y[0], -5e3 / 70e6 - 9e3 / 30e6, 1e-9, "and each rail by its own beyond it");
    sideways_free(&s);
    trk_free(&t);
    ok(!rig_track(&t, ONE, NULL, 0) && !sideways_new(&s, 1), "as one");
    for (int n = 0; n < 10000; n++) {
        sideways_accelerate(&s, &t, 1, 1e-4, w);
        sideways_move(&s, 1e-4);
    }
    ok(fabs(s.y[0] + 5e3 / 30e6) < 1e-9 && s.y[1] == s.y[0], "both rails stand aside by the sum of forces");
    sideways_free(&s);
    trk_free(&t);
}

int main(void)
{
    const struct half one = {9307.5 / 2, 906.5, 0, 190, 1220e3, 4e3, 300e6, 50e3, 140e6, 60e3};
    const struct half two = {9307.5 / 2, 906.5, 60, 700, 1220e3, 4e3, 150e6, 100e3, 140e6, 1400e3};

    rests(ONE, 0, 380, 300e6, 280e6);
    rests(TWO, 60, 1400, 150e6, 280e6);
    dips(ONE, &one, 60e3, 80e3);
    dips(TWO, &two, 60e3, 80e3);
    mirrors(ONE);
    mirrors(TWO);
    pushes();
    yields();
    return done();
}
