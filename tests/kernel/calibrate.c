/* Railpads and ballast found again from receptances that were computed with known ones: exactly without noise, within their uncertainty
 * with it, whatever is excited and read; bounds hold; what the receptance does not tell is refused. */
#include "tools/receptance/calibrate.h"

#include <complex.h>
#include <string.h>

#include "tests/kernel/table1.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/sweep.h"

enum { FREQUENCIES = 60, DRAWS = 100 };

static const double truth[CALIBRATE_N] = {0.55, 1.6, 0.7, 1.3};
static const int all[CALIBRATE_N] = {1, 1, 1, 1};

/* Two numbers of a normal distribution by Box and Muller 1958. */
static double complex normal(uint64_t *state)
{
    double u[2];

    for (int k = 0; k < 2; k++) {
        *state = *state * 6364136223846793005u + 1442695040888963407u;
        u[k] = ((double)(*state >> 11) + 0.5) * 0x1p-53;
    }
    return sqrt(-2 * log(u[0])) * cexp(2 * M_PI * u[1] * I);
}

struct example {
    struct frf r;
    double re[FREQUENCIES], im[FREQUENCIES];
    struct measured m;
};

/* What would be measured on a track whose parameters are `truth` times those of t. */
static int example_new(struct example *e, const struct trk *t, int force, int motion, double from, int quantity)
{
    struct trk real;
    const char *why = calibrate_apply(&real, t, truth);

    memset(e, 0, sizeof *e);
    place_find(&e->m.force, t, force, AT_STATION, 0.1);
    place_find(&e->m.motion, t, motion, AT_STATION, from);
    if (!why)
        why = sweep_places(&e->r, &real, &e->m.force, &e->m.motion, quantity, &(struct sweep){30, 1210, 20});
    for (int64_t k = 0; k < e->r.n; k++) {
        e->re[k] = e->r.H[2 * k];
        e->im[k] = e->r.H[2 * k + 1];
    }
    e->m.quantity = quantity;
    e->m.n = e->r.n;
    e->m.frequency = e->r.frequency;
    e->m.re = e->re;
    e->m.im = e->im;
    trk_free(&real);
    return ok(why == NULL && e->r.n == FREQUENCIES, "%s, %s: what would be measured", place_on[force], place_on[motion]);
}

static void exactly(const struct trk *t)
{
    static const struct { int force, motion; double from; int quantity; } row[] = {
        {PLACE_BOTH, PLACE_LEFT, 0.1, FRF_RECEPTANCE}, {PLACE_LEFT, PLACE_RIGHT, 0.7, FRF_ACCELERANCE}, {PLACE_RIGHT, PLACE_SLEEPER, -0.3, FRF_MOBILITY}};
    struct calibration c;
    struct example e;

    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        if (example_new(&e, t, row[i].force, row[i].motion, row[i].from, row[i].quantity)) {
            const char *why = calibrate_track(&c, t, &e.m, all, 0.1, 10);
            ok(why == NULL && c.steps < 40, "fitted in %d steps%s%s", (int)c.steps, why ? ": " : "", why ? why : "");
            for (int p = 0; p < CALIBRATE_N; p++)
                near(c.factor[p] / truth[p], 1, 1e-7, calibrate_name[p]);
            ok(c.before > 0.1 && c.after < 1e-7, "the residual falls from %.2g to %.1g", c.before, c.after);
        }
        frf_free(&e.r);
    }
}

/* 5 % of noise on real and imaginary part, drawn a hundred times: over them the errors scatter as each fit says of itself. */
static void scatter(const struct trk *t)
{
    double mean[CALIBRATE_N] = {0}, square[CALIBRATE_N] = {0};
    uint64_t state = 20181;
    struct example e;
    int failed = 0;

    if (!example_new(&e, t, PLACE_LEFT, PLACE_LEFT, 0.1, FRF_RECEPTANCE))
        return;
    for (int draw = 0; draw < DRAWS; draw++) {
        struct calibration c;
        for (int k = 0; k < FREQUENCIES; k++) {
            const double complex H = (e.r.H[2 * k] + e.r.H[2 * k + 1] * I) * (1 + 0.05 * normal(&state));
            e.re[k] = creal(H);
            e.im[k] = cimag(H);
        }
        failed += calibrate_track(&c, t, &e.m, all, 0.1, 10) != NULL;
        for (int p = 0; p < CALIBRATE_N; p++) {
            const double error = log(c.factor[p] / truth[p]) / c.uncertainty[p];
            mean[p] += error / DRAWS;
            square[p] += error * error / DRAWS;
        }
    }
    near(failed, 0, 0, "a hundred fits");
    for (int p = 0; p < CALIBRATE_N; p++) {
        ok(fabs(mean[p]) < 0.3, "%s: the mean error is %.2f of its uncertainty", calibrate_name[p], mean[p]);
        ok(sqrt(square[p]) > 0.8 && sqrt(square[p]) < 1.2, "its root mean square %.2f", sqrt(square[p]));
    }
    frf_free(&e.r);
}

static void bounds(const struct trk *t)
{
    static const int pads[CALIBRATE_N] = {1, 0, 0, 0};
    struct calibration c;
    struct example e;

    if (!example_new(&e, t, PLACE_LEFT, PLACE_LEFT, 0.1, FRF_RECEPTANCE))
        return;
    ok(calibrate_track(&c, t, &e.m, all, 0.6, 10) == NULL && c.bound[CALIBRATE_PAD_K] == -1 && c.uncertainty[CALIBRATE_PAD_K] == 0,
       "pads that would be softer than allowed stay at their bound");
    near(c.factor[CALIBRATE_PAD_K], 0.6, 1e-12, "which is");
    ok(c.bound[CALIBRATE_BALLAST_K] == 0 && c.uncertainty[CALIBRATE_BALLAST_K] > 0, "the others are free");
    ok(calibrate_track(&c, t, &e.m, pads, 0.1, 10) == NULL && c.factor[CALIBRATE_PAD_C] == 1 && c.factor[CALIBRATE_BALLAST_K] == 1 &&
           c.factor[CALIBRATE_BALLAST_C] == 1 && c.uncertainty[CALIBRATE_BALLAST_C] == 0,
       "what is not fitted stays");
    e.m.n = 2;
    ok(calibrate_track(&c, t, &e.m, all, 0.1, 10) != NULL, "two frequencies are too few for four parameters");
    frf_free(&e.r);
}

int main(void)
{
    const char *set[] = {"from=-6", "length=12"};
    struct trk t;
    const char *why = table1(&t, set, 2);

    if (!ok(why == NULL, "twenty sleepers of Table 1%s%s", why ? ": " : "", why ? why : ""))
        return done();
    exactly(&t);
    scatter(&t);
    bounds(&t);
    trk_free(&t);
    return done();
}
