/* Energy of contact and track together: what the wheels bring down, Q z', and what keeps the train at its speed, -Q v (dw/dx + dz/ds) of the
 * contact that moves and -Q^2/2 c' v of the compliance that changes under it, are stored by Hertz's springs, 2/5 C e^2.5, by the loaded
 * elements, c Q^2/2, and by the track, or lost there.  Without the moving contact's share the account would be off by all of the loss.
 * Plane contact without friction; then eight tracks and vehicles drawn at random, with both schemes. */
#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/integrate/start.h"

enum { MOST = 20000 };

struct fixture {
    struct trk track;
    struct veh vehicle;
    struct rig_table table[2];
};

static const char *set_up(struct fixture *f, const char *const *track, int tracks, const char *const *vehicle, int vehicles)
{
    memset(f, 0, sizeof *f);
    rig_table(&f->table[0], 'l', 0);
    rig_table(&f->table[1], 'r', 0);
    const char *why = rig_track(&f->track, RIG_STRAIGHT, track, tracks);
    return why ? why : rig_vehicle(&f->vehicle, RIG_WHEELSET, vehicle, vehicles);
}

static void tear_down(struct fixture *f)
{
    trk_free(&f->track);
    veh_free(&f->vehicle);
}

/* A wheel at one instant. */
struct instant {
    double Q, z;               /* N, m of the wheelset */
    double slope;              /* 1, dw/dx + dz/ds */
    double compliance;         /* m/N */
};

static struct instant look(const struct passage *p, int side)
{
    const struct couple *c = &p->couple[side];

    return (struct instant){p->wheel[side].Q, c->in.z, c->in.rail_slope + c->in.dip_slope, c->place.compliance};
}

static double in_contact(const struct passage *p, int side)
{
    const struct couple *c = &p->couple[side];
    const double Q = p->wheel[side].Q, e = fmax(pow(Q / RIG_HERTZ_C, 2.0 / 3), 0);

    return 0.4 * RIG_HERTZ_C * pow(e, 2.5) + 0.5 * c->place.compliance * Q * Q;
}

struct account {
    double work, drive, stored, lost, off;   /* J; drive is part of work; off over lost */
};

/* Q of the left wheel at every step into Q. */
static const char *account(struct fixture *f, const struct passage_options *o, struct account *a, double *Q)
{
    struct passage p;
    double residual;
    const char *why = passage_new(&p, o, &f->track, &f->vehicle, &f->table[0].ctab, &f->table[1].ctab);

    *a = (struct account){0};
    if (why)
        return why;
    why = passage_start(&p, &residual);
    const double begun = in_contact(&p, 0) + in_contact(&p, 1);
    while (!why && p.n < p.steps) {
        struct instant before[2] = {look(&p, 0), look(&p, 1)};
        why = passage_step(&p);
        Q[p.n < MOST ? p.n : 0] = p.wheel[0].Q;
        for (int side = 0; side < 2; side++) {
            const struct instant *b = &before[side], now = look(&p, side);
            const double drive = -0.5 * o->step * o->speed * (b->Q * b->slope + now.Q * now.slope) -
                                 0.25 * (b->Q * b->Q + now.Q * now.Q) * (now.compliance - b->compliance);
            a->drive += drive;
            a->work += 0.5 * (b->Q + now.Q) * (now.z - b->z) + drive;
        }
    }
    if (!why) {
        double work;
        energy_end(&p.energy, &p.rails, &work, &a->stored, &a->lost);
        a->stored += in_contact(&p, 0) + in_contact(&p, 1) - begun;
        a->off = fabs(a->work - a->stored - a->lost) / a->lost;
    }
    passage_free(&p);
    return why;
}

/* Within `most` at 1e-4 s, and of second order. */
static void closes(const char *const *set, int sets, enum way_scheme scheme, double speed, double depth, double most)
{
    const struct case_dip dip = {-2, 1, depth, CASE_BOTH};
    static double Q[MOST];
    struct fixture f;
    struct account a[2] = {{0}};
    const char *why = set_up(&f, set, sets, NULL, 0);
    struct passage_options o = rig_options(-9.4, 9);

    o.scheme = scheme;
    o.account = 1;
    o.speed = speed;
    o.excitation.dips = depth > 0;
    o.excitation.dip = &dip;
    for (int k = 0; k < 2 && !why; k++) {
        o.step = o.law.step = k ? 5e-5 : 1e-4;
        why = account(&f, &o, &a[k], Q);
    }
    ok(!why && a[0].off < most && a[1].off < 0.3 * a[0].off,
       "%s%s, %.1f m/s, dip of %g mm: work %.4f J (%.4f of it drives), stored %.4f, lost %.4f, off by %.1e, half the step %.1e%s%s",
       scheme == WAY_EXPLICIT ? "explicit" : "implicit", sets ? ", finer" : "", speed, 1e3 * depth, a[0].work, a[0].drive, a[0].stored,
       a[0].lost, a[0].off, a[1].off, why ? ": " : "", why ? why : "");
    tear_down(&f);
}

/* ---- at random ---- */

static double between(unsigned *seed, double least, double most)
{
    return least * pow(most / least, 0.5 + 0.5 * rig_draw(seed));
}

enum { TRACKS = 6, VEHICLES = 3 };

/* "key=value" drawn from all of each range. */
static void draw_set(unsigned *seed, char track[TRACKS][64], char vehicle[VEHICLES][64])
{
    snprintf(track[0], sizeof track[0], "railpad.stiffness=%.4g", between(seed, 10e6, 300e6));
    snprintf(track[1], sizeof track[1], "railpad.damping=%.4g", between(seed, 10e3, 80e3));
    snprintf(track[2], sizeof track[2], "ballast.stiffness=%.4g", between(seed, 50e6, 3000e6));
    snprintf(track[3], sizeof track[3], "ballast.damping=%.4g", between(seed, 50e3, 300e3));
    snprintf(track[4], sizeof track[4], "sleeper.mass=%.4g", between(seed, 150, 500));
    snprintf(track[5], sizeof track[5], "rail.bending_stiffness=%.4g", between(seed, 3e6, 7e6));
    snprintf(vehicle[0], sizeof vehicle[0], "body.1.mass=%.4g", between(seed, 4e3, 12e3));
    snprintf(vehicle[1], sizeof vehicle[1], "wheelset.1.mass=%.4g", between(seed, 1000, 2500));
    snprintf(vehicle[2], sizeof vehicle[2], "coupling.1.stiffness=[31391e3, 3884e3, %.4g]", between(seed, 300e3, 3e6));
}

static void random_set(unsigned *seed)
{
    static double Q[2][MOST];
    char track[TRACKS][64], vehicle[VEHICLES][64];
    const char *tracks[TRACKS], *vehicles[VEHICLES];
    struct fixture f;
    struct account a[2] = {{0}};
    struct passage_options o = rig_options(-9.4, 9);
    double e = 0, least = HUGE_VAL, most = -HUGE_VAL;

    draw_set(seed, track, vehicle);
    for (int k = 0; k < TRACKS; k++)
        tracks[k] = track[k];
    for (int k = 0; k < VEHICLES; k++)
        vehicles[k] = vehicle[k];
    o.account = 1;
    o.speed = between(seed, 50, 160) / 3.6;
    const struct case_dip dip = {-2, between(seed, 0.8, 2), between(seed, 0.2e-3, 1e-3), CASE_BOTH};
    o.excitation.dips = 1;
    o.excitation.dip = &dip;
    const char *why = set_up(&f, tracks, TRACKS, vehicles, VEHICLES);
    for (int k = 0; k < 2 && !why; k++) {
        o.scheme = k ? WAY_IMPLICIT : WAY_EXPLICIT;
        why = account(&f, &o, &a[k], Q[k]);
    }
    const int n = (int)passage_steps(&o);
    for (int i = n / 3; i < n && n <= MOST; i++) {
        e += pow(Q[0][i] - Q[1][i], 2) / (n - n / 3);
        least = fmin(least, Q[1][i]);
        most = fmax(most, Q[1][i]);
    }
    ok(!why && a[0].off < 1e-4 && a[1].off < 1e-4 && sqrt(e) < 0.005 * (most - least),
       "%s, %s, %s, %.0f km/h, dip of %.2f mm: energy off by %.1e and %.1e of %.2f J, schemes by %.1f N of %.0f (%.3f %%)%s%s", track[0], track[2], vehicle[1],
       3.6 * o.speed, 1e3 * dip.depth, a[0].off, a[1].off, a[1].lost, sqrt(e), most - least, 100 * sqrt(e) / (most - least), why ? ": " : "", why ? why : "");
    tear_down(&f);
}

int main(void)
{
    static const char *const fine[] = {"rail.elements_per_bay=2", "rail.mass_model=consistent"};

    unsigned seed = 1;

    for (int dip = 0; dip < 2; dip++) {
        closes(NULL, 0, WAY_EXPLICIT, 80 / 3.6, dip * 1e-3, 1e-4);
        closes(NULL, 0, WAY_IMPLICIT, 80 / 3.6, dip * 1e-3, 1e-4);
        closes(fine, 2, WAY_IMPLICIT, 80 / 3.6, dip * 1e-3, 1e-4);
        closes(NULL, 0, WAY_EXPLICIT, 200 / 3.6, dip * 1e-3, dip ? 3e-3 : 2e-4);
        closes(NULL, 0, WAY_IMPLICIT, 200 / 3.6, dip * 1e-3, dip ? 3e-3 : 1e-4);
        closes(fine, 2, WAY_IMPLICIT, 200 / 3.6, dip * 1e-3, dip ? 3e-3 : 1e-4);
    }
    for (int k = 0; k < 8; k++)
        random_set(&seed);
    return done();
}
