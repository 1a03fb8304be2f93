/* Beams on closely spaced fixed springs against the beam on a Winkler foundation: a constant load that moves, and a wheelset over a sinusoidal
 * rail; consistent mass in the implicit scheme, lumped mass with its pitch inertia in both. */
#include <complex.h>

#include "tests/kernel/half_set.h"
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tests/kernel/winkler.h"
#include "tools/integrate/start.h"

#define LUMPED 1.6     /* kg m, J of the lumped rail */
#define FINE 1e-3      /* 1/m */

static const char *const lumped[] = {"sleeper.spacing=0.15", "railpad.stiffness=1.5e7", "railpad.damping=18600", "ballast.stiffness=1.5e11",
                                     "ballast.damping=0", "from=-30", "length=60", "rail.pitch_inertia=0.24"};

struct beam_run {
    const struct trk *track;
    enum way_scheme scheme;
    double J;                  /* kg m */
    double step;               /* s */
    const char *name;
};

/* Without damping w(0) = F beta/(2 k sqrt(1 - (v/v_c)^2)), beta^4 = k/(4 EI), v_c^4 = 4 EI k/m^2. */
static void closed_form(void)
{
    const double beta = pow(FOUNDATION / (4 * EI), 0.25), critical = pow(4 * EI * FOUNDATION / (MASS * MASS), 0.25);

    for (int k = 0; k < 4; k++) {
        const double part = 0.2 * k, want = beta / (2 * FOUNDATION * sqrt(1 - part * part));
        near(creal(winkler_receptance(0, part * critical, 0, 0, FINE)) / want, 1, 1e-5, "the integral is the closed form of a moving load without damping");
    }
}

/* The deflection under the load, its mean over the last 3 m. */
static void moving_load(const struct beam_run *b, double v)
{
    const struct trk *t = b->track;
    const double F = 1e5, h = b->step, from = -12, length = 24;
    struct way w;
    double sum = 0;
    int n = 0;
    const char *why = way_new(&w, t, 0, h, b->scheme);
    double *u = calloc((size_t)t->dofs, sizeof *u);

    if (why || !u) {
        ok(0, "%s", why ? why : REASON_MEMORY);
        return;
    }
    way_set(&w, u);
    for (int64_t k = 1; v * h * (double)k < length; k++) {
        const struct wheel_place at = way_find(&w, 0, from + v * h * (double)k);
        struct way_rail r;
        way_advance(&w);
        if (way_yields(&w))
            way_load(&w, 0, &at, F);
        way_move(&w);
        if (!way_yields(&w))
            way_load(&w, 0, &at, F);
        way_look(&w, 0, &at, &r);
        way_finish(&w);
        if (v * h * (double)k > length - 3) {
            sum += r.z + r.local * F;
            n++;
        }
    }
    const double got = sum / n, want = F * creal(winkler_receptance(0, v, DAMPING, b->J, FINE));
    ok(fabs(got / want - 1) < 0.01, "%s, a load at %g m/s: %.4f mm, Winkler %.4f (%.2f %%), at rest %.4f", b->name, v, 1e3 * got, 1e3 * want,
       100 * (got / want - 1), 1e3 * F * creal(winkler_receptance(0, 0, DAMPING, b->J, FINE)));
    free(u);
    way_free(&w);
}

enum { WAVES_MOST = 200 };

/* Amplitude of Q at the frequency of passing waves of length L and 0.1 mm, over the last `waves` of them. */
static void moving_oscillator(const struct beam_run *b, const struct veh *v, struct rig_table table[2], double speed, double L)
{
    static struct case_dip dip[WAVES_MOST];
    const double amplitude = 1e-4, omega = 2 * M_PI * speed / L;
    const int all = (int)(16 / L), last = (int)(6 / L);
    struct passage_options o = rig_options(-11, 9);
    struct passage p;
    double residual;
    double complex got = 0;

    o.scheme = b->scheme;
    o.speed = speed;
    o.step = o.law.step = fmin(5e-5, b->step);
    o.law.normal = WHEEL_LINEAR;
    o.law.stiffness = 137e6;
    o.law.damping = 28e3;
    for (int k = 0; k < all; k++)
        dip[k] = (struct case_dip){-9 + k * L, L, 2 * amplitude, CASE_BOTH};
    o.excitation.dips = all;
    o.excitation.dip = dip;
    o.end = -9 + all * L;
    const double from = o.end - last * L;
    const char *why = passage_new(&p, &o, b->track, v, &table[0].ctab, &table[1].ctab);
    if (!why)
        why = passage_start(&p, &residual);
    while (!why && p.station + speed * o.step < o.end) {
        why = passage_step(&p);
        if (p.station > from)
            got += (p.wheel[0].Q - v->wheel_load[0]) * cexp(-I * omega * (p.station + 9) / speed) * 2 * o.step * speed / (last * L);
    }
    const double complex contact = o.law.stiffness + I * omega * o.law.damping;
    const double complex want = amplitude / (1 / contact + half_set(v, omega) + winkler_receptance(omega, speed, DAMPING, b->J, FINE));
    ok(!why && cabs(got / want - 1) < 0.01, "%s, waves of %g m at %g m/s, %.0f Hz: Q %.1f N, %.1f deg, Winkler %.1f N, %.1f deg (%.2f %%)%s%s", b->name,
       L, speed,
       omega / (2 * M_PI), cabs(got), carg(got) * 180 / M_PI, cabs(want), carg(want) * 180 / M_PI, 100 * cabs(got / want - 1), why ? ": " : "",
       why ? why : "");
    passage_free(&p);
}

int main(void)
{
    struct trk consistent, light;
    struct veh vehicle;
    struct rig_table table[2];
    const char *why = rig_track(&consistent, RIG_STRAIGHT, winkler_beam, sizeof winkler_beam / sizeof *winkler_beam);
    const char *also = rig_track(&light, RIG_STRAIGHT, lumped, sizeof lumped / sizeof *lumped), *last = rig_vehicle(&vehicle, RIG_WHEELSET, NULL, 0);
    const struct beam_run run[] = {{&consistent, WAY_IMPLICIT, 0, 2e-5, "consistent mass, implicit"},
                                   {&light, WAY_IMPLICIT, LUMPED, 2e-5, "lumped mass, implicit"},
                                   {&light, WAY_EXPLICIT, LUMPED, 1.6e-5, "lumped mass, explicit"}};

    if (why || also || last) {
        ok(0, "%s", why ? why : also ? also : last);
        return done();
    }
    rig_table(&table[0], 'l', 0);
    rig_table(&table[1], 'r', 0);
    closed_form();
    for (int i = 0; i < 3; i++) {
        moving_load(&run[i], 80 / 3.6);
        for (int k = 1; k < 4; k++)
            moving_load(&run[i], 180 * k);
        if (i == 1)
            continue;
        moving_oscillator(&run[i], &vehicle, table, 80 / 3.6, 1);
        moving_oscillator(&run[i], &vehicle, table, 200 / 3.6, 1);
        moving_oscillator(&run[i], &vehicle, table, 200 / 3.6, 0.4);
        moving_oscillator(&run[i], &vehicle, table, 100, 0.5);
    }
    trk_free(&consistent);
    trk_free(&light);
    veh_free(&vehicle);
    return done();
}
