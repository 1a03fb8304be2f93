/* Whole passages: order of the scheme, rest, equilibrium at the start, stability, refusals. */
#include "tools/integrate/passage.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/creep/kalker.h"
#include "tools/integrate/start.h"

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
};

static void set_up(struct fixture *f, const char *track, const char *const *set, int sets, const char *vehicle)
{
    memset(f, 0, sizeof *f);
    const char *why = rig_track(&f->track, track, set, sets), *also = rig_vehicle(&f->vehicle, vehicle, NULL, 0);
    if (why || also) {
        ok(0, "%s", why ? why : also);
        exit(done());
    }
    rig_table(&f->table[0], 'l', 0.025);
    rig_table(&f->table[1], 'r', -0.025);
}

static void tear_down(struct fixture *f)
{
    trk_free(&f->track);
    veh_free(&f->vehicle);
}

/* Ready to step, or the reason why not. */
static const char *begin(struct fixture *f, struct passage *p, const struct passage_options *o, double *residual)
{
    const char *why = passage_new(p, o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab);

    if (why)
        return why;
    if ((why = passage_start(p, residual)))
        passage_free(p);
    return why;
}

/* Height of the front wheelset at `samples` even times into z, the step h an even part of the time between. */
static const char *history(struct fixture *f, struct passage_options o, double h, int samples, double *z)
{
    struct passage p;
    double residual;
    const char *why;

    o.step = o.law.step = h;
    if ((why = begin(f, &p, &o, &residual)))
        return why;
    for (int i = 0; i < samples && !why; i++) {
        while (!why && p.n < (i + 1) * p.steps / samples)
            why = passage_step(&p);
        z[i] = p.train.q[6 * f->vehicle.wheelset[0] + VEH_Z];
    }
    passage_free(&p);
    return why;
}

enum { SAMPLES = 200 };

/* log2 of the ratio of changes as the step is halved twice: 2 for a scheme of second order.  Heights, because forces ring at 1.5 kHz, which
 * no such step resolves in phase: the wheel comes upon the resting rail at full speed. */
static double observed_order(struct fixture *f, const struct passage_options *o, double *change)
{
    double z[3][SAMPLES], sum[2] = {0};

    for (int k = 0; k < 3; k++) {
        const char *why = history(f, *o, 1e-4 / (1 << k), SAMPLES, z[k]);
        if (why) {
            ok(0, "%s", why);
            return NAN;
        }
    }
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < SAMPLES; i++)
            sum[k] += (z[k + 1][i] - z[k][i]) * (z[k + 1][i] - z[k][i]);
    *change = sqrt(sum[0] / SAMPLES);
    return 0.5 * log2(sum[0] / sum[1]);
}

/* A wheelset under its frame through a dip of 0.3 mm on 1.5 m, at 80 km/h for 0.4 s: 4000 steps of 1e-4 s. */
static void order(void)
{
    static const struct case_dip dip = {.from = -2, .length = 1.5, .depth = 0.3e-3};
    struct fixture f;
    struct passage_options o = rig_options(-4.5, -4.5 + 0.4 * 80 / 3.6);
    double change, order;

    set_up(&f, RIG_STRAIGHT, NULL, 0, RIG_WHEELSET);
    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    order = observed_order(&f, &o, &change);
    printf("# Hertz without friction: order %.3f, halving 1e-4 s moves the wheelset by %.2e m rms\n", order, change);
    near(order, 2, 0.1, "second order in the step");
    o.law.friction = 0.3;
    order = observed_order(&f, &o, &change);
    printf("# with friction 0.3: order %.3f, %.2e m rms\n", order, change);
    o.law = (struct wheel_law){.normal = WHEEL_LINEAR, .stiffness = 137e6, .damping = 28e3};
    fastsim_begin(&o.law.grid, 10);
    order = observed_order(&f, &o, &change);
    printf("# linear law with damping: order %.3f, %.2e m rms\n", order, change);
    near(order, 2, 0.1, "second with contact damping too");
    tear_down(&f);
}

/* At a crawl nothing moves: rest is kept for 2000 steps. */
static void rest(const char *vehicle)
{
    struct fixture f;
    struct passage_options o = rig_options(6, 6.001);
    struct passage p;
    static const char *const longer[] = {"from=-30", "length=60"};
    double residual, worst = 0, moved = 0, first[64];

    set_up(&f, RIG_STRAIGHT, longer, 2, vehicle);
    o.speed = 1e-5;
    const char *why = begin(&f, &p, &o, &residual);
    if (why) {
        ok(0, "%s", why);
        tear_down(&f);
        return;
    }
    memcpy(first, p.train.q, (size_t)p.train.dofs * sizeof *first);
    for (int k = 0; k < 2000 && !why; k++) {
        why = passage_step(&p);
        for (int64_t w = 0; w < 2 * f.vehicle.wheelsets; w++)
            worst = fmax(worst, fabs(p.wheel[w].Q - f.vehicle.wheel_load[w]));
    }
    for (int64_t k = 0; k < p.train.dofs; k++)
        if (k % 6 != VEH_PITCH)
            moved = fmax(moved, fabs(p.train.q[k] - first[k]));
    printf("# %s: Q leaves its static value by %.2e N, bodies move by %.1e m or rad\n", f.vehicle.name, worst, moved);
    ok(!why, "%s: a crawl", f.vehicle.name);
    near(worst, 0, 0.1, "wheel forces stay static within 0.1 N");
    near(moved, 0, 1e-7, "nothing moves");
    passage_free(&p);
    tear_down(&f);
}

/* On straight level track the start is the static equilibrium of train and track together, to `still` m/s2: in height, roll and pitch, for
 * without friction and contact angle nothing holds a wheelset sideways. */
static void start(struct fixture *f, double still)
{
    struct passage_options o = rig_options(12.37, 13);
    struct passage p;
    double residual, load = 0, body = 0, rail = 0, lateral = 0;
    const char *why = begin(f, &p, &o, &residual);

    if (why) {
        ok(0, "%s", why);
        return;
    }
    for (int64_t w = 0; w < 2 * f->vehicle.wheelsets; w++) {
        load = fmax(load, fabs(p.wheel[w].Q / f->vehicle.wheel_load[w] - 1));
        lateral = fmax(lateral, fabs(p.wheel[w].T));
    }
    for (int64_t i = 0; i < f->vehicle.bodies; i++)
        for (int k = VEH_Z; k <= VEH_PITCH; k++)
            body = fmax(body, fabs(p.train.a[6 * i + k]));
    for (int64_t k = 0; k < LUMPED_PARTS * p.rails.lumped.stride; k++)
        rail = fmax(rail, p.rails.lumped.inverse[k] > 0 ? fabs(p.rails.lumped.a[k]) : 0);
    printf("# %s: Q off its static value by %.1e, bodies accelerate by %.1e m/s2, rails and sleepers by %.1e m/s2\n", f->vehicle.name, load,
           body, rail);
    near(load, 0, 1e-4, "wheel forces are the static loads");
    ok(body < still && rail < 1e-3, "nothing accelerates by %g m/s2", still);
    near(lateral, 0, 1e-3, "wheels roll without pulling");
    passage_free(&p);
}

static void starts(void)
{
    static const char *const longer[] = {"from=-30", "length=60"}, *const aside[] = {"body.1.y=0.06"};
    struct fixture f;

    set_up(&f, RIG_STRAIGHT, longer, 2, RIG_WHEELSET);
    start(&f, 1e-5);
    tear_down(&f);
    set_up(&f, RIG_STRAIGHT, longer, 2, RIG_COACH);
    start(&f, 1e-5);
    tear_down(&f);

    /* A load off centre rolls the wheelset and turns the frame on its springs; level rails, or it would slide.  The roll shifts the
     * contacts by roll r0, which the start does not see: 1.4 N m about x. */
    set_up(&f, RIG_STRAIGHT, longer, 2, RIG_WHEELSET);
    veh_free(&f.vehicle);
    const char *why = rig_vehicle(&f.vehicle, RIG_WHEELSET, aside, 1);
    ok(!why && f.vehicle.wheel_load[1] > 1.1 * f.vehicle.wheel_load[0], "a load off centre%s%s", why ? ": " : "", why ? why : "");
    rig_table(&f.table[0], 'l', 0);
    rig_table(&f.table[1], 'r', 0);
    start(&f, 2e-3);
    tear_down(&f);
}

/* Steps inside the limit keep the force near its static value, damping and contact included; the same step outside is refused. */
static void stability(void)
{
    struct fixture f;
    struct passage_options o = rig_options(-4.5, 4.5);
    struct passage p;
    double residual, most = 0;

    set_up(&f, RIG_STRAIGHT, NULL, 0, RIG_WHEELSET);
    o.step = o.law.step = 1.69e-4;
    o.law.friction = 0.3;
    const char *why = begin(&f, &p, &o, &residual);
    for (int k = 0; !why && p.n < p.steps; k++) {
        why = passage_step(&p);
        most = fmax(most, fabs(p.wheel[0].Q / f.vehicle.wheel_load[0] - 1));
    }
    ok(!why && most < 0.03, "a step of 1.69e-4 s of at most %.3g s keeps Q within 3 %% (%.4f)", p.limit, most);
    passage_free(&p);
    o.step = o.law.step = 1.72e-4;
    why = begin(&f, &p, &o, &residual);
    ok(why && strstr(why, "beyond the limit"), "a longer one is refused: %s", why ? why : "it is not");
    tear_down(&f);
}

/* Spin against creep decays at (r0^2/v Jy) sum G a b C11.  Of a step of 0.75 of its time a disturbance dies away; 0.85 is refused. */
static void spin(void)
{
    struct fixture f;
    struct passage_options o = rig_options(-4.5, 4.5);
    struct passage p;
    double residual, C[KALKER_COEFFICIENTS], sum = 0;

    set_up(&f, RIG_STRAIGHT, NULL, 0, RIG_WHEELSET);
    kalker(RIG_HERTZ_A / RIG_HERTZ_B, 0.28, C);
    for (int w = 0; w < 2; w++)
        sum += 82e9 * RIG_HERTZ_A * RIG_HERTZ_B * pow(f.vehicle.wheel_load[w], 2.0 / 3) * C[KALKER_C11];
    double rate = 0.46 * 0.46 * sum / f.vehicle.inertia[3 * f.vehicle.wheelset[0] + 1]; /* times v */
    o.law.friction = 0.3;
    o.speed = rate * o.step / 0.75;
    const char *why = begin(&f, &p, &o, &residual);
    if (!why) {
        double *w = &p.train.v[6 * f.vehicle.wheelset[0] + VEH_PITCH], still = *w;
        *w += 1e-6 * o.speed / 0.46;
        for (int k = 0; k < 200 && !why; k++)
            why = passage_step(&p);
        double left = fabs(*w - still) / (1e-6 * o.speed / 0.46);
        ok(!why && left < 0.1, "at %.3g m/s a disturbed spin dies away (%.1e)", o.speed, left);
        passage_free(&p);
    } else {
        ok(0, "%s", why);
    }
    o.speed = rate * o.step / 0.85;
    why = begin(&f, &p, &o, &residual);
    ok(why && strstr(why, "wheelsets' spin"), "slower it would not, and is refused: %s", why ? why : "it is not");
    o.law.friction = 0;
    why = begin(&f, &p, &o, &residual);
    ok(!why, "but for wheels without friction");
    if (!why)
        passage_free(&p);
    tear_down(&f);
}

static void refused(const char *what, struct fixture *f, struct passage_options o, const char *word)
{
    struct passage p;
    double residual;
    const char *why = begin(f, &p, &o, &residual);

    ok(why && strstr(why, word), "%s: %s", what, why ? why : "is taken");
    if (!why)
        passage_free(&p);
}

static void refusals(void)
{
    struct fixture f;
    static const char *const longer[] = {"from=-51", "length=102"};
    static const char *const curved[] = {"from=-51", "length=102", "curve=[{from: 0, curvature: 0.002}]"};

    set_up(&f, RIG_STRAIGHT, longer, 2, RIG_COACH);
    refused("a start before the track", &f, rig_options(-30, 0), "last wheelset would start at");
    refused("an end beyond it", &f, rig_options(0, 46), "front wheelset would end at");
    f.table[0].ctab.side = 'r';
    refused("tables of one side", &f, rig_options(0, 10), "one of a left and one of a right");
    f.table[0].ctab.side = 'l';
    f.table[1].ctab.radius = 0.45;
    refused("another wheel's table", &f, rig_options(0, 10), "radius");
    f.table[1].ctab.radius = 0.46;
    rig_table(&f.table[1], 'r', -0.05);
    refused("sides that push it away where it starts", &f, rig_options(0, 10), "no quasi-static equilibrium found");
    tear_down(&f);

    set_up(&f, RIG_STRAIGHT, curved, 3, RIG_COACH);
    refused("a start in a curve without friction or flanges", &f, rig_options(0.5, 10), "no quasi-static equilibrium found");
    refused("even with the front wheelset alone", &f, rig_options(0.001, 10), "is still pushed sideways by");
    struct passage p;
    struct passage_options o = rig_options(-0.001, 10);
    double residual;
    const char *why = begin(&f, &p, &o, &residual);
    ok(!why, "but not before it%s%s", why ? ": " : "", why ? why : "");
    if (!why)
        passage_free(&p);
    tear_down(&f);
}

/* A wheelset on a slope that drives it off its rail says where. */
static void failure(void)
{
    struct fixture f;
    struct passage_options o = rig_options(-4.5, 9);
    struct passage p;
    double residual;

    set_up(&f, RIG_STRAIGHT, NULL, 0, RIG_WHEELSET);
    const char *why = begin(&f, &p, &o, &residual);
    if (!why) {
        p.train.v[6 * f.vehicle.wheelset[0] + VEH_Y] = 20;
        while (!why && p.n < p.steps)
            why = passage_step(&p);
        ok(why && strstr(why, "wheelset 1, left wheel, station -4.4"), "a wheel off its table stops the passage: %s", why ? why : "it does not");
        passage_free(&p);
    }
    tear_down(&f);
}

int main(void)
{
    order();
    rest(RIG_WHEELSET);
    rest(RIG_COACH);
    starts();
    stability();
    spin();
    refusals();
    failure();
    return done();
}
