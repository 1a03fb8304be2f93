/* The track that moves with a wheelset: receptance against that of its masses in closed form, and its natural frequencies.
 *
 * Rails alike, so the motion in phase and the antiphase one go apart: each is a rail mass on a pad on half a sleeper, which antiphase
 * has the mass J/2a^2 and stands on k (r/a)^2, rails at +-a and ballast springs at +-r; held in roll it stands still. */
#include <complex.h>

#include "formats/trk_text.h"
#include "tests/kernel/tap.h"
#include "tools/receptance/modes.h"
#include "tools/receptance/sweep.h"
#include "tools/track/assemble.h"
#include "tools/track/layout.h"

static const double SAME = 1e-10;

/* A rail m1 on a pad, and the half sleeper m2 on its ballast. */
struct chain { double m1, k1, c1, m2, k2, c2; };

static const char *track(struct trk *t, const char *const *set, int sets)
{
    struct trk_text in;

    *t = (struct trk){0};
    const char *why = trk_text_read(&in, "data/tracks/moving-mass.yaml", (char *const *)set, sets, NULL);
    if (why)
        return why;
    why = layout_track(t, &in);
    trk_text_free(&in);
    return why ? why : assemble_track(t);
}

/* m/N of the rail, under a force on it */
static double complex receptance(const struct chain *c, double w)
{
    const double complex pad = c->k1 + w * c->c1 * I, below = c->k2 + w * c->c2 * I - w * w * c->m2;

    return 1 / (pad * below / (pad + below) - w * w * c->m1);
}

/* The largest difference from the closed form over its size, 1 to 1500 Hz; of the right rail under a force on `on`. */
static double worst(const struct trk *t, int on, const struct chain *in_phase, const struct chain *antiphase)
{
    struct place force, motion;
    struct frf r;
    double most = 0;

    place_find(&force, t, on, AT_SLEEPER, 0);
    place_find(&motion, t, PLACE_RIGHT, AT_SLEEPER, 0);
    if (sweep_places(&r, t, &force, &motion, FRF_RECEPTANCE, &(struct sweep){1, 1500, 1}))
        return NAN;
    for (int64_t i = 0; i < r.n; i++) {
        const double w = 2 * M_PI * r.frequency[i];
        const double complex both = receptance(in_phase, w), apart = receptance(antiphase, w);
        const double complex H = on == PLACE_BOTH ? both : on == PLACE_RIGHT ? (both + apart) / 2 : (both - apart) / 2;
        most = fmax(most, cabs(r.H[2 * i] + r.H[2 * i + 1] * I - H) / cabs(H));
    }
    frf_free(&r);
    return most;
}

static void compare(const struct trk *t, const struct chain *in_phase, const struct chain *antiphase, const char *of)
{
    static const char *const on[] = {"left", "right", "both"};

    for (int k = PLACE_LEFT; k <= PLACE_BOTH; k++) {
        const double most = worst(t, k, in_phase, antiphase);
        ok(most < SAME, "%s, force on %s: the right rail moves as the closed form tells (%.1e)", of, on[k], most);
    }
}

static void natural(const struct trk *t)
{
    struct mod m;
    const char *why = modes_track(&m, t, 3, 0);

    if (ok(why == NULL, "three modes%s%s", why ? ": " : "", why ? why : "")) {
        near(m.frequency[0], 124.5, 0.05, "rails and sleeper on the ballast");
        near(m.frequency[1], sqrt(300e6 / 36) / (2 * M_PI), 1e-4, "rails against each other, the sleeper at rest");
        near(m.frequency[2], 504.2, 0.05, "rails against the sleeper");
    }
    mod_free(&m);
}

int main(void)
{
    static const char *const benchmark[] = {
        "rail.mass=100", "sleeper.mass=1400", "sleeper.roll=free", "sleeper.roll_inertia=450", "sleeper.length=2.2", "rail_spacing=1.507",
        "railpad={stiffness: 150e6, damping: 100e3}", "ballast={stiffness: 280e6, damping: 2800e3, edge: 0.35}"};
    const double a = 1.507 / 2, r = 0.75, lever = (r / a) * (r / a);
    const struct chain table_1 = {36, 300e6, 50e3, 190, 140e6, 60e3}, still = {36, 300e6, 50e3, 1e30, 0, 0};
    const struct chain bounce = {60, 150e6, 100e3, 700, 140e6, 1400e3};
    const struct chain roll = {60, 150e6, 100e3, 450 / (2 * a * a), lever * 140e6, lever * 1400e3};
    struct trk t;
    const char *why = track(&t, NULL, 0);

    if (ok(why == NULL, "the track of Table 1%s%s", why ? ": " : "", why ? why : "")) {
        compare(&t, &table_1, &still, "Table 1");
        natural(&t);
    }
    trk_free(&t);
    why = track(&t, benchmark, sizeof benchmark / sizeof *benchmark);
    if (ok(why == NULL, "the co-running track of the S&C benchmark%s%s", why ? ": " : "", why ? why : ""))
        compare(&t, &bounce, &roll, "benchmark");
    trk_free(&t);
    return done();
}
