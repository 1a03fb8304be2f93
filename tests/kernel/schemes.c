/* The explicit and the implicit scheme on the same lumped track, each the check of the other: smooth rail, dip, wheel off its rail; slow and
 * fast; soft and stiff pads and ballast.  Then what the implicit one promises alone: rest, second order, independence of the mesh. */
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

enum { MOST = 9000 };

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
};

static const char *set_up(struct fixture *f, const char *const *set, int sets, const char *vehicle)
{
    memset(f, 0, sizeof *f);
    rig_table(&f->table[0], 'l', 0.025);
    rig_table(&f->table[1], 'r', -0.025);
    const char *why = rig_track(&f->track, RIG_STRAIGHT, set, sets);
    return why ? why : rig_vehicle(&f->vehicle, vehicle, NULL, 0);
}

static void tear_down(struct fixture *f)
{
    trk_free(&f->track);
    veh_free(&f->vehicle);
}

struct history {
    int n, every;      /* every: steps between those kept, 0 for one */
    double Q[MOST];    /* N, front left wheel */
    double rounds;     /* a step */
};

static const char *run(struct fixture *f, struct passage_options o, enum way_scheme scheme, struct history *h)
{
    struct passage p;
    double residual;

    o.scheme = scheme;
    h->n = 0;
    const char *why = passage_new(&p, &o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab);
    if (why)
        return why;
    why = passage_start(&p, &residual);
    while (!why && p.n < p.steps && h->n < MOST) {
        why = passage_step(&p);
        if (h->every < 2 || p.n % h->every == 0)
            h->Q[h->n++] = p.wheel[0].Q;
    }
    h->rounds = (double)p.rounds / (double)(p.n + 1);
    passage_free(&p);
    return why;
}

struct difference {
    double rms, size, least;   /* N: rms and largest less smallest Q, smallest Q */
};

/* From `from`, a part of the run, on. */
static struct difference compare(const struct history *a, const struct history *b, double from)
{
    struct difference d = {.least = HUGE_VAL};
    double most = -HUGE_VAL;
    const int first = (int)(from * a->n);

    for (int i = first; i < a->n; i++) {
        d.rms += (a->Q[i] - b->Q[i]) * (a->Q[i] - b->Q[i]) / (a->n - first);
        d.least = fmin(d.least, a->Q[i]);
        most = fmax(most, a->Q[i]);
    }
    d.rms = sqrt(d.rms);
    d.size = most - d.least;
    return d;
}

static void agree(double speed, const char *pad, const char *ballast, enum wheel_normal law)
{
    static struct history a, b;
    const char *const set[] = {pad, ballast};
    struct case_dip dip = {1, 1, 1e-3, CASE_BOTH};
    struct fixture f;
    const char *why = set_up(&f, set, 2, RIG_WHEELSET);
    struct passage_options o = rig_options(-9.4, 9);

    o.speed = speed / 3.6;
    o.law.friction = 0.3;
    o.law.normal = law;
    o.law.stiffness = 137e6;
    o.law.damping = 28e3;
    if (!why && !(why = run(&f, o, WAY_EXPLICIT, &a)))
        why = run(&f, o, WAY_IMPLICIT, &b);
    const struct difference smooth = compare(&a, &b, 0.4);
    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    if (!why && !(why = run(&f, o, WAY_EXPLICIT, &a)))
        why = run(&f, o, WAY_IMPLICIT, &b);
    const struct difference over = compare(&a, &b, 0.4);
    ok(!why && smooth.rms < 50 && over.rms < 0.005 * over.size,
       "%g km/h, %s, %s, %s: smooth %.2f N rms of %.0f, dip %.1f N rms of %.0f (%.3f %%), least %.0f N, %.2f rounds%s%s", speed, pad, ballast,
       law == WHEEL_HERTZ ? "Hertz" : "linear", smooth.rms, smooth.size, over.rms, over.size, 100 * over.rms / over.size, over.least, b.rounds,
       why ? ": " : "", why ? why : "");
    tear_down(&f);
}

/* A dip that the wheel leaves, to strike the rail with five times its load: both err by the phase of what rings after the blow, the one
 * forward and the other back, by much the same. */
static void separation(void)
{
    static struct history a, b, fine = {.every = 16};
    struct case_dip dip = {1, 1, 1.5e-3, CASE_BOTH};
    struct fixture f;
    struct difference d[2], off[2] = {{0}};
    const char *why = set_up(&f, NULL, 0, RIG_WHEELSET);
    struct passage_options o = rig_options(-9.4, 9);

    o.speed = 200 / 3.6;
    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    o.step = o.law.step = 6.25e-6;
    if (!why)
        why = run(&f, o, WAY_IMPLICIT, &fine);
    for (int k = 0; k < 2; k++) {
        o.step = o.law.step = k ? 5e-5 : 1e-4;
        if (!why && !(why = run(&f, o, WAY_EXPLICIT, &a)))
            why = run(&f, o, WAY_IMPLICIT, &b);
        d[k] = compare(&a, &b, 0.4);
        if (k == 0) {
            off[0] = compare(&a, &fine, 0.4);
            off[1] = compare(&b, &fine, 0.4);
        }
        printf("# 200 km/h over 1.5 mm, step %g s: %.1f N rms of %.0f (%.3f %%)\n", o.step, d[k].rms, d[k].size, 100 * d[k].rms / d[k].size);
    }
    ok(!why && d[0].least <= 0 && d[0].rms < 0.01 * d[0].size, "off the rail and back: within 1 %% at 1e-4 s%s%s", why ? ": " : "", why ? why : "");
    ok(d[1].least <= 0 && d[1].rms < 0.005 * d[1].size && d[1].rms < 0.4 * d[0].rms, "and within 0.5 %% at half of that");
    ok(off[0].rms < 0.005 * off[0].size && off[1].rms < 0.005 * off[1].size, "at 1e-4 s the explicit one is off 6.25e-6 s by %.3f %%, the implicit one by %.3f",
       100 * off[0].rms / off[0].size, 100 * off[1].rms / off[1].size);
    tear_down(&f);
}

/* Voids under some sleepers, or ballast that does not pull anywhere: the sleepers strike and lift off. */
static void voids(const char *ballast, const char *what)
{
    static struct history a, b;
    const char *const set[] = {ballast};
    struct fixture f;
    const char *why = set_up(&f, set, 1, RIG_WHEELSET);
    struct passage_options o = rig_options(-9.4, 9);

    if (!why && !(why = run(&f, o, WAY_EXPLICIT, &a)))
        why = run(&f, o, WAY_IMPLICIT, &b);
    const struct difference d = compare(&a, &b, 0.4);
    ok(!why && d.rms < 0.005 * d.size, "%s: %.2f N rms of %.0f (%.3f %%)%s%s", what, d.rms, d.size, 100 * d.rms / d.size, why ? ": " : "", why ? why : "");
    tear_down(&f);
}

/* log2 of the ratio of changes of the wheelset's height as the step is halved twice. */
static const char *observed_order(struct fixture *f, struct passage_options o, double *order, double *change)
{
    enum { SAMPLES = 200 };
    double z[3][SAMPLES], sum[2] = {0}, residual;

    o.scheme = WAY_IMPLICIT;
    for (int k = 0; k < 3; k++) {
        struct passage p;
        o.step = o.law.step = 2e-4 / (1 << k);
        const char *why = passage_new(&p, &o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab);
        if (why)
            return why;
        why = passage_start(&p, &residual);
        for (int i = 0; i < SAMPLES && !why; i++) {
            while (!why && p.n < (i + 1) * p.steps / SAMPLES)
                why = passage_step(&p);
            z[k][i] = p.train.q[6 * f->vehicle.wheelset[0] + VEH_Z];
        }
        passage_free(&p);
        if (why)
            return why;
    }
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < SAMPLES; i++)
            sum[k] += (z[k + 1][i] - z[k][i]) * (z[k + 1][i] - z[k][i]);
    *change = sqrt(sum[0] / SAMPLES);
    *order = 0.5 * log2(sum[0] / sum[1]);
    return NULL;
}

/* With Hertz's law, and with the damper of the linear one, whose local part is a backward difference of second order here. */
static void order(const char *const *set, int sets, enum wheel_normal law)
{
    static const struct case_dip dip = {-2, 1.5, 0.3e-3, CASE_BOTH};
    struct fixture f;
    const char *why = set_up(&f, set, sets, RIG_WHEELSET);
    struct passage_options o = rig_options(-4.5, -4.5 + 0.4 * 80 / 3.6);
    double order = 0, change = 0;

    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    o.law.normal = law;
    o.law.stiffness = 137e6;
    o.law.damping = 28e3;
    if (!why)
        why = observed_order(&f, o, &order, &change);
    ok(!why && fabs(order - 2) < 0.1, "%s, %s: order %.3f in the step, halving 2e-4 s moves the wheelset by %.1e m rms%s%s", sets ? set[0] : "lumped",
       law == WHEEL_HERTZ ? "Hertz" : "linear", order, change, why ? ": " : "", why ? why : "");
    tear_down(&f);
}

/* What the wheels do on the track's material is stored or lost, of the loss in the dampers but `most`. */
static void energy(enum way_scheme scheme, const char *const *set, int sets, double depth, double most)
{
    struct case_dip dip = {-2, 1, depth, CASE_BOTH};
    struct fixture f;
    struct passage p;
    const char *why = set_up(&f, set, sets, RIG_WHEELSET);
    struct passage_options o = rig_options(-9.4, 9);
    double residual, work, stored, lost;

    o.scheme = scheme;
    o.account = 1;
    o.law.friction = 0.3;
    o.excitation.dips = depth > 0;
    o.excitation.dip = &dip;
    if (why || (why = passage_new(&p, &o, &f.track, &f.vehicle, &f.table[0].ctab, &f.table[1].ctab))) {
        ok(0, "energy: %s", why);
        tear_down(&f);
        return;
    }
    why = passage_start(&p, &residual);
    while (!why && p.n < p.steps)
        why = passage_step(&p);
    const double off = energy_end(&p.energy, &p.rails, &work, &stored, &lost);
    ok(!why && p.energy.counted && lost > 0 && off < most, "%s, dip of %g mm: work %.4f J, stored %.4f, lost %.4f, off by %.1e of that%s%s",
       scheme == WAY_EXPLICIT ? "explicit" : "implicit", 1e3 * depth, work, stored, lost, off, why ? ": " : "", why ? why : "");
    passage_free(&p);
    tear_down(&f);
}

/* At a crawl nothing moves. */
static void rest(const char *const *set, int sets)
{
    struct fixture f;
    struct passage p;
    const char *why = set_up(&f, set, sets, RIG_COACH);
    struct passage_options o = rig_options(6, 6.001);
    double residual = 0, worst = 0, moved = 0, first[64];

    o.speed = 1e-5;
    o.scheme = WAY_IMPLICIT;
    if (why || (why = passage_new(&p, &o, &f.track, &f.vehicle, &f.table[0].ctab, &f.table[1].ctab))) {
        ok(0, "rest: %s", why);
        tear_down(&f);
        return;
    }
    why = passage_start(&p, &residual);
    memcpy(first, p.train.q, (size_t)p.train.dofs * sizeof *first);
    for (int k = 0; k < 1000 && !why; k++) {
        why = passage_step(&p);
        for (int64_t w = 0; w < 2 * f.vehicle.wheelsets; w++)
            worst = fmax(worst, fabs(p.wheel[w].Q - f.vehicle.wheel_load[w]));
    }
    for (int64_t k = 0; k < p.train.dofs; k++)
        if (k % 6 != VEH_PITCH)
            moved = fmax(moved, fabs(p.train.q[k] - first[k]));
    ok(!why && worst < 0.1 && moved < 1e-7, "%s: at rest Q leaves its static value by %.1e N, bodies move by %.1e m or rad%s%s", set[sets - 1], worst,
       moved, why ? ": " : "", why ? why : "");
    passage_free(&p);
    tear_down(&f);
}

/* A run on mirrored sides is its own mirror: left and right wheels alike. */
static void mirror(void)
{
    static const char *const set[] = {"rail.mass_model=consistent", "rail.elements_per_bay=2"};
    struct fixture f;
    struct passage p;
    const char *why = set_up(&f, set, 2, RIG_WHEELSET);
    struct passage_options o = rig_options(-4.5, 4.5);
    double residual, worst = 0;

    o.scheme = WAY_IMPLICIT;
    o.law.friction = 0.3;
    if (why || (why = passage_new(&p, &o, &f.track, &f.vehicle, &f.table[0].ctab, &f.table[1].ctab))) {
        ok(0, "mirror: %s", why);
        tear_down(&f);
        return;
    }
    why = passage_start(&p, &residual);
    while (!why && p.n < 2000) {
        why = passage_step(&p);
        worst = fmax(worst, fmax(fabs(p.wheel[0].Q - p.wheel[1].Q), fabs(p.wheel[0].Y + p.wheel[1].Y)));
    }
    ok(!why && worst < 1e-3, "left and right differ by %.1e N", worst);
    passage_free(&p);
    tear_down(&f);
}

/* The lumped track with the compliance of its element against four consistent ones a bay. */
static void mesh(void)
{
    static struct history h[3];
    static const char *const set[][2] = {{"rail.mass_model=consistent", "rail.elements_per_bay=1"},
                                         {"rail.mass_model=consistent", "rail.elements_per_bay=2"},
                                         {"rail.mass_model=consistent", "rail.elements_per_bay=8"}};
    struct passage_options o = rig_options(-9.4, 9);
    struct case_dip dip = {1, 1, 1e-3, CASE_BOTH};
    const char *why = NULL;

    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    for (int k = 0; k < 3 && !why; k++) {
        struct fixture f;
        why = set_up(&f, set[k], 2, RIG_WHEELSET);
        if (!why)
            why = run(&f, o, WAY_IMPLICIT, &h[k]);
        tear_down(&f);
    }
    const struct difference one = compare(&h[0], &h[2], 0.4), two = compare(&h[1], &h[2], 0.4);
    ok(!why && one.rms < 0.005 * one.size && two.rms < one.rms,
       "consistent mass over a dip: one element a bay %.1f N rms off eight, two %.1f, of %.0f%s%s", one.rms, two.rms, one.size, why ? ": " : "",
       why ? why : "");
}

/* What a force moves within the step, as way_look tells it beforehand. */
static void give(const char *elements)
{
    const char *const set[] = {"rail.mass_model=consistent", elements};
    const double F = 1e4;
    struct trk t;
    struct way w;
    struct way_rail before[2], after[2];
    double worst = 0;
    const char *why = rig_track(&t, RIG_STRAIGHT, set, 2);

    if (why || (why = way_new(&w, &t, 9.81, 1e-4, WAY_IMPLICIT))) {
        ok(0, "%s", why);
        return;
    }
    for (int k = 0; k < 40; k++) {
        const int rail = k % 2;
        const struct wheel_place at = way_find(&w, rail, -3 + 0.111 * k);
        way_advance(&w);
        way_move(&w);
        for (int s = 0; s < 2; s++)
            way_look(&w, s, &at, &before[s]);
        way_load(&w, rail, &at, F);
        way_move(&w);
        for (int s = 0; s < 2; s++) {
            const struct way_rail *r = &before[s];
            const double give = s == rail ? r->give : r->give_other, turn = s == rail ? r->turn : r->turn_other;
            way_look(&w, s, &at, &after[s]);
            worst = fmax(worst, fabs(after[s].z - r->z - give * F) / (r->give * F));
            worst = fmax(worst, fabs(after[s].v - r->v - r->quick * give * F) / (r->quick * r->give * F));
            worst = fmax(worst, fabs(after[s].slope - r->slope - turn * F) / (r->give * F)); /* over a metre */
        }
        way_finish(&w);
    }
    ok(worst < 1e-8, "%s: what the rails give is known beforehand to %.1e", elements, worst);
    way_free(&w);
    trk_free(&t);
}

int main(void)
{
    static const char *const fine[] = {"rail.elements_per_bay=2", "rail.mass_model=consistent"};
    static const char *const longer[] = {"from=-30", "length=60", "rail.mass_model=lumped"};
    static const char *const shear[] = {"from=-30", "length=60", "rail.elements_per_bay=2", "rail.mass_model=consistent", "rail.beam=timoshenko"};

    for (int fast = 0; fast < 2; fast++)
        for (int k = 0; k < 4; k++)
            agree(fast ? 200 : 80, k % 2 ? "railpad.stiffness=300e6" : "railpad.stiffness=10e6",
                  k / 2 ? "ballast.stiffness=3000e6" : "ballast.stiffness=50e6", WHEEL_HERTZ);
    agree(80, "railpad.stiffness=300e6", "ballast.stiffness=280e6", WHEEL_LINEAR);
    give("rail.elements_per_bay=1");
    give("rail.elements_per_bay=4");
    separation();
    voids("ballast.gap={station: [-1, 0, 1, 2], value: [0, 2e-4, 4e-4, 0]}", "voids to 0.4 mm");
    voids("ballast.tension=false", "ballast that only pushes");
    order(NULL, 0, WHEEL_HERTZ);
    order(NULL, 0, WHEEL_LINEAR);
    order(fine, 2, WHEEL_HERTZ);
    for (int dip = 0; dip < 2; dip++) {
        energy(WAY_EXPLICIT, NULL, 0, dip * 1e-3, 1e-4);
        energy(WAY_IMPLICIT, NULL, 0, dip * 1e-3, 1e-8);
        energy(WAY_IMPLICIT, fine, 2, dip * 1e-3, 1e-8);
    }
    rest(longer, 3);
    rest(shear, 5);
    mirror();
    mesh();
    return done();
}
