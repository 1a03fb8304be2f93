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
static void set_up(struct fixture *f, const int *groups, int64_t every, int lowpass)
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
        (why = passage_start(&f->passage, &residual)) || (why = record_new(&f->record, &f->passage, groups, every, lowpass))) {
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
            record_empty(r);
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

    set_up(&f, all, every, 0);
    for (int b = 0; b < BOUNDS; b++)
        most[b] = calloc((size_t)f.record.size[bounds[b].channel], sizeof *most[b]);
    follow(&f, most, least_q, &samples);
    ok(samples == f.passage.steps / every + 1, "%lld samples of %lld steps", (long long)samples, (long long)f.passage.steps);
    for (int b = 0; b < BOUNDS; b++) {
        double below = 0, above = 0, size = 0;
        for (int64_t i = 0; i < f.record.size[bounds[b].channel]; i++) {
            double e = f.record.extremes.of[bounds[b].extreme][i];
            below = fmax(below, most[b][i] - e);
            above = fmax(above, e - most[b][i]);
            size = fmax(size, e);
        }
        ok(below <= 1e-7 * size, "every %lld: %s is not below a sample", (long long)every, run_extremes[bounds[b].extreme].name);
        if (every == 1)
            ok(above <= 1e-7 * size, "and equals the largest");
        free(most[b]);
    }
    ok(f.record.extremes.of[RUN_MIN_Q][0] <= least_q[0], "min.Q is not above a sample");
    ok(least_q[0] >= 0, "no wheel pulls");
    tear_down(&f);
}

/* Extremes by wheel and by sleeper are the same ones, and stand where they say. */
static void places(void)
{
    struct fixture f;
    double most = 0, at = 0, sleeper = 0, Q = 0, low = 0, high = 0;
    int64_t where = 0;

    set_up(&f, all, 1, 0);
    for (int full = record_step(&f.record, &f.passage); f.passage.n < f.passage.steps; full = record_step(&f.record, &f.passage)) {
        if (full)
            record_empty(&f.record);
        if (passage_step(&f.passage))
            break;
        if (f.passage.wheel[0].Q > most) {
            most = f.passage.wheel[0].Q;
            at = f.passage.station;
        }
    }
    const double *by = f.record.extremes.of[RUN_SLEEPER_MAX_Q];
    for (int64_t i = 0; i < f.track.sleepers; i++)
        if (by[i] > Q) {
            Q = by[i];
            where = i;
        }
    sleeper = f.track.sleeper_x[where];
    near(f.record.extremes.of[RUN_MAX_Q][0], most, 0, "largest Q of the left wheel");
    near(f.record.extremes.of[RUN_AT_MAX_Q][0], at, 0, "at its station");
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
    ok(f.record.extremes.of[RUN_MIN_Q][0] == 0, "it left the rail");
    tear_down(&f);
}

/* Groups that are not asked for take no room; extremes stand all the same. */
static void groups(void)
{
    static const int wheels[RUN_GROUPS] = {[RUN_WHEELS] = 1};
    struct fixture f;
    int kept = 0, wrong = 0;

    set_up(&f, wheels, 10, 0);
    for (int c = 0; c < RUN_CHANNELS; c++) {
        int want = (run_channels[c].group == RUN_GROUPS && c != RUN_FORCE && c != RUN_PROBE) || run_channels[c].group == RUN_WHEELS;
        kept += f.record.buffer[c] != NULL;
        wrong += (f.record.buffer[c] != NULL) != want;
    }
    ok(wrong == 0 && kept == 20, "%d series: time, station and those of wheels", kept);
    record_step(&f.record, &f.passage);
    double *Q = f.record.buffer[RUN_Q];
    near(Q[0], f.passage.wheel[0].Q, 0, "the first sample is the start");
    ok(f.record.extremes.of[RUN_MAX_PAD][20] != 0, "pads have extremes without samples");
    tear_down(&f);
}

enum { STEPS_MOST = 4000 };

/* Records of a channel of one number a record, or of a float's element i, over a whole run into x [STEPS_MOST]; returns how many. */
static int64_t history(enum run_channel c, int64_t i, int64_t every, int lowpass, double *x)
{
    struct fixture f;
    int64_t n = 0;
    int full, last = 0;

    set_up(&f, all, every, lowpass);
    full = record_step(&f.record, &f.passage);
    for (;;) {
        if (last)
            record_end(&f.record, f.passage.n);
        if (full || last) {
            for (int64_t k = 0; k < f.record.held; k++, n++)
                x[n] = run_channels[c].type == VXF_F64 ? ((double *)f.record.buffer[c])[k * f.record.size[c] + i]
                                                       : (double)((float *)f.record.buffer[c])[k * f.record.size[c] + i];
            record_empty(&f.record);
        }
        if (last)
            break;
        if (passage_step(&f.passage))
            break;
        last = f.passage.n == f.passage.steps;
        full = record_step(&f.record, &f.passage);
    }
    tear_down(&f);
    return n;
}

/* Each record is the weighted mean of the steps around it, as far as there are any. */
static void filtered(enum run_channel c, int64_t i, double tolerance)
{
    static double all_steps[STEPS_MOST], plain[STEPS_MOST], smooth[STEPS_MOST], w[2 * LOWPASS_HALF * 10 + 1];
    const int64_t half = LOWPASS_HALF * 10, steps = history(c, i, 1, 0, all_steps), n = history(c, i, 10, 0, plain);
    double worst = 0, size = 0;

    lowpass_weights(10, w);
    ok(history(c, i, 10, 1, smooth) == n && n == (steps - 1) / 10 + 1, "%s: as many records with the low-pass", run_channels[c].name);
    for (int64_t k = 0; k < n; k++) {
        double sum = 0, weight = 0;
        for (int64_t j = 10 * k - half; j <= 10 * k + half; j++)
            if (j >= 0 && j < steps) {
                sum += w[j - 10 * k + half] * all_steps[j];
                weight += w[j - 10 * k + half];
            }
        worst = fmax(worst, fabs(smooth[k] - sum / weight));
        size = fmax(size, fabs(all_steps[10 * k]));
    }
    near(worst / size, 0, tolerance, "and each the weighted mean of the steps around it");
}

/* Gain at frequency f over that of the samples. */
static double gain(const double *w, int64_t every, double f)
{
    const int64_t half = LOWPASS_HALF * every;
    double sum = 0;

    for (int64_t k = -half; k <= half; k++)
        sum += w[k + half] * cos(2 * acos(-1) * f * (double)k / (double)every);
    return fabs(sum);
}

static void lowpass(void)
{
    for (int64_t every = 2; every <= 50; every *= 5) {
        static double w[2 * LOWPASS_HALF * 50 + 1];
        double pass = 0, stop = 0;
        lowpass_weights(every, w);
        for (double f = 0; f <= 0.25; f += 0.01)
            pass = fmax(pass, fabs(gain(w, every, f) - 1));
        for (double f = 0.75; f <= 0.5 * (double)every; f += 0.01)
            stop = fmax(stop, gain(w, every, f));
        near(pass, 0, 0.01, "every few steps: nothing lost up to a quarter of the sampling frequency");
        near(gain(w, every, 0.5), 0.5, 0.01, "half at a half");
        near(stop, 0, 0.00316, "50 dB down from three quarters on");
    }
}

int main(void)
{
    lowpass();
    filtered(RUN_Q, 0, 1e-12);
    filtered(RUN_SLEEPER_A, 20, 81 * 6e-8); /* sums of floats */
    extremes(1);
    extremes(10);
    places();
    groups();
    return done();
}
