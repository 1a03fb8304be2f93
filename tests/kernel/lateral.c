/* Wheels on a spatial track: the head of a rail under resting and moving lateral forces against statics, a symmetric run against the vertical
 * track, and that the forces found within a step hold at 1e-4 s, are of second order, and keep the account of energy. */
#include "tests/kernel/rig.h"
#include "tests/kernel/straight.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/lateral.h"
#include "tools/integrate/start.h"
#include "tools/track/equilibrium.h"
#include "tools/track/point.h"

static const struct head_force FORCE = {20e3, -400};
static const struct head_force STEADY = {0, 0};

/* ---- forces without wheels ---- */

/* m, displacement of a rail's running surface at x under FORCE there, at rest: by the direct solution and the statics of the element. */
static double rest_of(struct equilibrium *e, const struct trk *t, int rail, double x)
{
    double *f = calloc((size_t)t->dofs, sizeof *f), *u = calloc((size_t)t->dofs, sizeof *u), share[POINT_LATERAL], held, y = 0;
    const double h = *t->rail_head;
    int64_t dof[POINT_LATERAL];
    struct point p;

    point_at(&p, t, x);
    point_lateral(&p, t, rail, h, dof, share, &held);
    const double a = x - t->x[p.node], L = t->x[p.node + 1] - t->x[p.node];
    for (int k = 0; k < POINT_LATERAL; k++)
        f[dof[k]] += share[k] * FORCE.Y;
    f[dof[2]] += (1 - a / L) * FORCE.M;
    f[dof[5]] += a / L * FORCE.M;
    const char *why = equilibrium_add(e, f, u);
    for (int k = 0; k < POINT_LATERAL; k++)
        y += share[k] * u[dof[k]];
    free(f);
    free(u);
    return why ? NAN : y + held * FORCE.Y + h * a * (L - a) / (*t->rail_torsion * L) * FORCE.M;
}

static struct head_motion head_at(const struct way *w, int rail, double x, double speed)
{
    const struct wheel_place at = way_find(w, rail, x);
    struct head_motion m;
    double turn, yield[3];

    way_look_head(w, &at.head, &m, &turn, yield);
    head_bend(&at.head, &FORCE, &STEADY, speed, &m);
    return m;
}

static void push(struct way *w, int rail, double x)
{
    const struct wheel_place at = way_find(w, rail, x);

    way_advance(w);
    way_load_head(w, &at.head, &FORCE);
    way_move(w);
}

/* A force put on a rail at rest, until all is still. */
static void resting(double x, int rail)
{
    struct trk t;
    struct way w;
    struct equilibrium e;
    double y = 0;
    const char *why = straight(&t, NULL, 0);

    if (why || (why = way_new(&w, &t, 0, 1e-3, WAY_IMPLICIT)) || (why = equilibrium_new(&e, &t, 0))) {
        ok(0, "resting: %s", why);
        return;
    }
    for (int n = 0; n < 2000; n++) {
        push(&w, rail, x);
        y += n < 1000 ? 0 : head_at(&w, rail, x, 0).y / 1000;
        way_finish(&w);
    }
    const double rest = rest_of(&e, &t, rail, x);
    ok(fabs(y / rest - 1) < 1e-6, "a lateral force at %g m rests on the %s rail as statics has it: %.6f mm for %.6f", x, rail ? "right" : "left",
       1e3 * y, 1e3 * rest);
    equilibrium_free(&e);
    way_free(&w);
    trk_free(&t);
}

/* The force goes at 0.5 m/s from sleeper to sleeper and on: at each place nearly at rest; between nodes what the material does and the slope
 * make up what the head does under the force. */
static void moving(void)
{
    const double speed = 0.5, h = 1e-3;
    double worst = 0, most = 0, off = 0, rate = 0, before[3] = {0};
    struct trk t;
    struct way w;
    struct equilibrium e;
    const char *why = straight(&t, NULL, 0);

    if (why || (why = way_new(&w, &t, 0, h, WAY_IMPLICIT)) || (why = equilibrium_new(&e, &t, 0))) {
        ok(0, "moving: %s", why);
        return;
    }
    for (int n = 0; n < 4000; n++) {
        const double x = -1 + speed * h * n;
        push(&w, TRK_LEFT, x);
        const struct head_motion m = head_at(&w, TRK_LEFT, x, speed);
        const double passed = (m.y - before[0]) / h, own = 0.5 * (m.v + speed * m.slope + before[1]);
        if (n > 2000 && way_find(&w, TRK_LEFT, x).node == way_find(&w, TRK_LEFT, x - speed * h).node) {
            off = fmax(off, fabs(passed - own));
            rate = fmax(rate, fabs(passed));
        }
        if (n > 1000 && n % 50 == 0) {
            const double rest = rest_of(&e, &t, TRK_LEFT, x);
            worst = fmax(worst, fabs(m.y - rest));
            most = fmax(most, fabs(rest));
        }
        before[0] = m.y;
        before[1] = m.v + speed * m.slope;
        way_finish(&w);
    }
    ok(worst < 0.01 * most, "moving at 0.5 m/s it is within 1 %% of rest everywhere: off by %.4f mm of %.4f", 1e3 * worst, 1e3 * most);
    ok(off < 0.01 * rate, "the head's rate under it is the material's and the slope's: off by %.2e m/s of %.2e", off, rate);
    equilibrium_free(&e);
    way_free(&w);
    trk_free(&t);
}

/* ---- wheels ---- */

enum { SAMPLES = 60 };
#define START -4.5 /* m, between two sleepers */
#define ALL 8.0    /* m */

struct history {
    double Q[SAMPLES], Y[SAMPLES], rail_y[SAMPLES], y[SAMPLES]; /* of the left wheel, and of the wheelset */
    double unlike;      /* N, largest sum of Y of both wheels */
    double missing;     /* 1, of the account */
    double rounds;      /* a step */
    double most;        /* m, largest rail_y */
};

static const char *run(const char *const *set, int sets, const struct case_dip *dip, double length, double step, struct history *h)
{
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
    struct passage p;
    struct passage_options o = rig_options(START, START + length);
    double residual, work, stored, lost;
    const char *why;

    o.scheme = WAY_IMPLICIT;
    o.step = o.law.step = step;
    o.law.friction = 0.3;
    o.account = 1;
    o.excitation.dips = dip != NULL;
    o.excitation.dip = dip;
    *h = (struct history){0};
    rig_table(&table[0], 'l', 0.025);
    rig_table(&table[1], 'r', -0.025);
    if ((why = rig_track(&track, RIG_STRAIGHT, set, sets)) || (why = rig_vehicle(&vehicle, RIG_WHEELSET, NULL, 0)) ||
        (why = passage_new(&p, &o, &track, &vehicle, &table[0].ctab, &table[1].ctab)))
        return why;
    why = passage_start(&p, &residual);
    for (int i = 0; i < SAMPLES && !why; i++) {
        while (!why && p.n < (i + 1) * p.steps / SAMPLES) {
            why = passage_step(&p);
            h->unlike = fmax(h->unlike, fabs(p.wheel[0].Y + p.wheel[1].Y));
            h->most = fmax(h->most, fabs(p.couple[0].in.rail_y));
        }
        h->Q[i] = p.wheel[0].Q;
        h->Y[i] = p.wheel[0].Y;
        h->rail_y[i] = p.couple[0].in.rail_y;
        h->y[i] = p.train.q[6 * vehicle.wheelset[0] + VEH_Y];
    }
    h->missing = energy_end(&p.energy, &p.rails, &work, &stored, &lost);
    h->rounds = (double)p.rounds / (double)(p.n + 1);
    passage_free(&p);
    veh_free(&vehicle);
    trk_free(&track);
    return why;
}

static double rms(const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < SAMPLES; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]) / SAMPLES;
    return sqrt(sum);
}

static const char *const SPATIAL[] = {"dofs=spatial", "railpad.length=0"};

/* Railpads without length resist no pitch, as those of a vertical track. */
static void symmetric(void)
{
    static const struct case_dip both = {-2, 1.5, 0.3e-3, CASE_BOTH};
    static struct history vertical, spatial;
    const char *why = run(NULL, 0, &both, ALL, 1e-4, &vertical);
    double least = HUGE_VAL, most = 0;

    if (!why)
        why = run(SPATIAL, 2, &both, ALL, 1e-4, &spatial);
    for (int i = 0; i < SAMPLES; i++) {
        least = fmin(least, vertical.Q[i]);
        most = fmax(most, vertical.Q[i]);
    }
    const double off = rms(vertical.Q, spatial.Q);
    ok(!why && off < 1e-3 * (most - least), "over a dip of both rails Q is that of the vertical track: %.2f N rms off of %.0f%s%s", off, most - least,
       why ? ": " : "", why ? why : "");
    ok(spatial.unlike < 1e-3 * fabs(spatial.Y[0]), "and Y the mirror image on the other side: %.1e N of %.0f", spatial.unlike, spatial.Y[0]);
}

/* Only the left rail dips, ahead of a node, where an element of straight twist has a kink that no step meets: the wheelset rolls and is pushed
 * aside.  The rail, in which the step out of rest fades for some milliseconds, is of first order for so long. */
static void order(const char *const *set, int sets)
{
    static const struct case_dip left = {START + 0.02, 0.2, 0.05e-3, CASE_LEFT};
    static struct history h[3];
    const char *why = NULL;

    for (int k = 0; k < 3 && !why; k++)
        why = run(set, sets, &left, 0.26666, 2e-4 / (1 << k), &h[k]);
    const double y = log2(rms(h[0].y, h[1].y) / rms(h[1].y, h[2].y)), rail = log2(rms(h[0].rail_y, h[1].rail_y) / rms(h[1].rail_y, h[2].rail_y));
    ok(!why && fabs(y - 2) < 0.1 && rail > 1, "%s: order %.2f in the step of the wheelset's y, %.2f of the rail's%s%s", set[sets - 1], y, rail,
       why ? ": " : "", why ? why : "");
}

static void holds(const char *const *set, int sets, double step)
{
    static const struct case_dip left = {-2, 1.5, 0.3e-3, CASE_LEFT};
    static struct history h;
    const char *why = run(set, sets, &left, ALL, step, &h);

    ok(!why && h.most > 1e-5 && h.most < 1e-4 && h.rounds < 1.5 && h.missing < 1e-6,
       "%s at %g s over a dip of one rail: rails to the side by %.4f mm at most, %.2f rounds, account closes by %.1e of the loss%s%s", set[sets - 1], step,
       1e3 * h.most, h.rounds, h.missing, why ? ": " : "", why ? why : "");
}

int main(void)
{
    resting(-0.3, TRK_LEFT);
    resting(0.1, TRK_RIGHT);
    moving();
    symmetric();
    order(SPATIAL, 2);
    order((const char *const[]){"dofs=spatial", "rail.mass_model=consistent"}, 2);
    holds(SPATIAL, 2, 1e-4);
    holds(SPATIAL, 2, 4e-4);
    holds((const char *const[]){"dofs=spatial", "rail.beam=timoshenko", "rail.elements_per_bay=4", "rail.mass_model=consistent"}, 4, 1e-4);
    return done();
}
