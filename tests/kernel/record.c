/* What a passage leaves behind: every sample lies within the extremes, which are those of every step. */
#include "tools/integrate/record.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

static const struct case_dip dip = {.from = 0, .length = 1, .depth = 1e-3};
static const int all[RUN_GROUPS] = {1, 1, 1, 1, 1, 1};

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
    struct passage passage;
    struct record record;
};

/* A wheelset over a dip of 1 mm, which it leaves for a moment at 200 km/h. */
static void set_up(struct fixture *f, const int *groups, int64_t every)
{
    struct passage_options o = rig_options(-2, 3);
    double residual;
    const char *why;

    memset(f, 0, sizeof *f);
    o.speed = 200 / 3.6;
    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    rig_table(&f->table[0], 'l', 0.025);
    rig_table(&f->table[1], 'r', -0.025);
    if ((why = rig_track(&f->track, RIG_STRAIGHT, NULL, 0)) || (why = rig_vehicle(&f->vehicle, RIG_WHEELSET, NULL, 0)) ||
        (why = passage_new(&f->passage, &o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab)) ||
        (why = passage_start(&f->passage, &residual)) || (why = record_new(&f->record, &f->passage, groups, every))) {
        ok(0, "%s", why);
        exit(done());
    }
}

static void tear_down(struct fixture *f)
{
    record_free(&f->record);
    passage_free(&f->passage);
    trk_free(&f->track);
    veh_free(&f->vehicle);
}

/* Largest and smallest of channel c, element i, over the records held; float channels have the last place of theirs to give. */
static void range(const struct record *r, enum run_channel c, int64_t i, double *least, double *most)
{
    for (int64_t k = 0; k < r->held; k++) {
        int64_t at = k * r->size[c] + i;
        double x = run_channels[c].type == VXF_F32 ? (double)((const float *)r->buffer[c])[at] : ((const double *)r->buffer[c])[at];
        *least = fmin(*least, x);
        *most = fmax(*most, x);
    }
}

struct bound {
    enum run_channel channel;
    enum run_extreme extreme;
    int magnitude;
};

static const struct bound bounds[] = {
    {RUN_Q, RUN_MAX_Q, 0},
    {RUN_Y, RUN_MAX_Y, 1},
    {RUN_PAD, RUN_MAX_PAD, 0},
    {RUN_BALLAST_F, RUN_MAX_BALLAST, 0},
    {RUN_SLEEPER_A, RUN_MAX_SLEEPER_A, 1},
    {RUN_NODE_M, RUN_MAX_NODE_M, 1},
};
enum { BOUNDS = sizeof bounds / sizeof bounds[0] };

/* Largest of each bounded channel over all blocks, element by element. */
static void follow(struct fixture *f, double *most[BOUNDS], double *least_q, int64_t *samples)
{
    struct record *r = &f->record;
    int full = record_step(r, &f->passage);

    *samples = 0;
    for (;;) {
        if (full || f->passage.n == f->passage.steps) {
            for (int b = 0; b < BOUNDS; b++)
                for (int64_t i = 0; i < r->size[bounds[b].channel]; i++) {
                    double low = HUGE_VAL, high = -HUGE_VAL;
                    range(r, bounds[b].channel, i, &low, &high);
                    most[b][i] = fmax(most[b][i], bounds[b].magnitude ? fmax(high, -low) : high);
                    if (b == 0)
                        least_q[i] = fmin(least_q[i], low);
                }
            *samples += r->held;
            r->held = 0;
        }
        if (f->passage.n == f->passage.steps)
            return;
        if (passage_step(&f->passage)) {
            ok(0, "the passage goes on");
            return;
        }
        full = record_step(r, &f->passage);
    }
}

/* every = 1: extremes are those of the samples to the last bit of a float; every = 10: never below. */
static void extremes(int64_t every)
{
    struct fixture f;
    double *most[BOUNDS], least_q[2] = {HUGE_VAL, HUGE_VAL};
    int64_t samples;

    set_up(&f, all, every);
    for (int b = 0; b < BOUNDS; b++)
        most[b] = calloc((size_t)f.record.size[bounds[b].channel], sizeof *most[b]);
    follow(&f, most, least_q, &samples);
    ok(samples == f.passage.steps / every + 1, "%lld samples of %lld steps", (long long)samples, (long long)f.passage.steps);
    for (int b = 0; b < BOUNDS; b++) {
        double below = 0, above = 0, size = 0;
        for (int64_t i = 0; i < f.record.size[bounds[b].channel]; i++) {
            double e = f.record.extreme[bounds[b].extreme][i];
            below = fmax(below, most[b][i] - e);
            above = fmax(above, e - most[b][i]);
            size = fmax(size, e);
        }
        ok(below <= 1e-7 * size, "every %lld: %s is not below a sample", (long long)every, run_extremes[bounds[b].extreme].name);
        if (every == 1)
            ok(above <= 1e-7 * size, "and equals the largest");
        free(most[b]);
    }
    ok(f.record.extreme[RUN_MIN_Q][0] <= least_q[0], "min.Q is not above a sample");
    ok(least_q[0] >= 0, "no wheel pulls");
    tear_down(&f);
}

/* Extremes by wheel and by sleeper are the same ones, and stand where they say. */
static void places(void)
{
    struct fixture f;
    double most = 0, at = 0, sleeper = 0, Q = 0, low = 0, high = 0;
    int64_t where = 0;

    set_up(&f, all, 1);
    for (int full = record_step(&f.record, &f.passage); f.passage.n < f.passage.steps; full = record_step(&f.record, &f.passage)) {
        if (full)
            f.record.held = 0;
        if (passage_step(&f.passage))
            break;
        if (f.passage.wheel[0].Q > most) {
            most = f.passage.wheel[0].Q;
            at = f.passage.station;
        }
    }
    const double *by = f.record.extreme[RUN_SLEEPER_MAX_Q];
    for (int64_t i = 0; i < f.track.sleepers; i++)
        if (by[i] > Q) {
            Q = by[i];
            where = i;
        }
    sleeper = f.track.sleeper_x[where];
    near(f.record.extreme[RUN_MAX_Q][0], most, 0, "largest Q of the left wheel");
    near(f.record.extreme[RUN_AT_MAX_Q][0], at, 0, "at its station");
    near(Q, most, 0, "is the largest by sleeper");
    ok(fabs(sleeper - at) <= 0.3 + 1e-9, "at the sleeper nearest to it, %.2f m for %.2f m", sleeper, at);
    for (int64_t i = 0; i < f.track.sleepers; i++) {
        if (by[i] > 0) {
            low = low == 0 ? f.track.sleeper_x[i] : low;
            high = f.track.sleeper_x[i];
        }
    }
    near(low, -2.1, 1e-9, "no wheel before the first sleeper it passes");
    near(high, 3, 0.3 + 1e-9, "nor behind the last");
    ok(f.record.extreme[RUN_MIN_Q][0] == 0, "it left the rail");
    tear_down(&f);
}

/* Groups that are not asked for take no room; extremes stand all the same. */
static void groups(void)
{
    static const int wheels[RUN_GROUPS] = {[RUN_WHEELS] = 1};
    struct fixture f;
    int kept = 0, wrong = 0;

    set_up(&f, wheels, 10);
    for (int c = 0; c < RUN_CHANNELS; c++) {
        int want = (run_channels[c].group == RUN_GROUPS && c != RUN_FORCE && c != RUN_PROBE) || run_channels[c].group == RUN_WHEELS;
        kept += f.record.buffer[c] != NULL;
        wrong += (f.record.buffer[c] != NULL) != want;
    }
    ok(wrong == 0 && kept == 20, "%d series: time, station and those of wheels", kept);
    record_step(&f.record, &f.passage);
    double *Q = f.record.buffer[RUN_Q];
    near(Q[0], f.passage.wheel[0].Q, 0, "the first sample is the start");
    ok(f.record.extreme[RUN_MAX_PAD][20] != 0, "pads have extremes without samples");
    tear_down(&f);
}

int main(void)
{
    extremes(1);
    extremes(10);
    places();
    groups();
    return done();
}
