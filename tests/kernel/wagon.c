/* Whole vehicles with all their couplings: rigid motion, mirror images, the bounce of the wagon and how friction ends it, energy of a
 * coach without dampers in the explicit scheme. */
#include "tests/kernel/rig.h"

#include <lapacke.h>

#include "tests/kernel/tap.h"
#include "tools/vehicle/couplings.h"

#define LADEN "data/vehicles/freight-y25-22t5.yaml"
#define TARE "data/vehicles/freight-y25-tare.yaml"
#define STUCK (0.3*0.364*103741/8e6)    /* m, mu N/k of an axlebox's friction, laden */

static int loaded(struct veh *v, const char *path, const char *const *set, int sets)
{
    const char *why = rig_vehicle(v, path, set, sets);
    if (why)
        ok(0, "%s: %s", path, why);
    return !why;
}

static double largest(const double *f, int64_t n)
{
    double most = 0;
    for (int64_t i = 0; i < n; i++)
        most = fmax(most, fabs(f[i]));
    return most;
}

/* ---- properties ---- */

/* Shifted and turned as one in 200 steps, memory and all; preloads taken off, which turn with the vehicle. */
static void test_rigid(const char *path)
{
    struct veh v;
    struct couplings_memory m;
    double q[120], qd[120], f[120], none[400] = {0}, most = 0;

    if (!loaded(&v, path, NULL, 0) || couplings_memory_new(&m, &v))
        return;
    v.preload = none;
    v.rest = none;
    for (int i = 0; i <= 200; i++) {
        double t = 0.01*i, shift[3] = {0.02*t, -0.03*t*t, 0.01*t}, turn[3] = {0.01*t, 0, -0.02*t*t};
        double ds[3] = {0.02, -0.06*t, 0.01}, dt[3] = {0.01, 0, -0.04*t};
        for (int64_t b = 0; b < v.bodies; b++)
            for (int k = 0; k < 3; k++) {
                int k1 = (k + 1)%3, k2 = (k + 2)%3;
                const double *c = &v.cg[3*b];
                q[6*b + k] = shift[k] + turn[k1]*c[k2] - turn[k2]*c[k1];
                qd[6*b + k] = ds[k] + dt[k1]*c[k2] - dt[k2]*c[k1];
                q[6*b + 3 + k] = turn[k];
                qd[6*b + 3 + k] = dt[k];
            }
        couplings_keep(&m, 0.01);
        memset(f, 0, sizeof f);
        couplings_force(&v, &m, q, qd, f);
        most = fmax(most, largest(f, 6*v.bodies));
    }
    ok(most < 1e-6, "%s: moved and turned as one it feels nothing (%.1e N)", v.name, most);
    couplings_memory_free(&m);
    veh_free(&v);
}

/* Number of the body or coupling mirrored: bodies lie in the middle; x, z and pitch keep their sign. */
static void mirror(int64_t bodies, const double *q, double *to)
{
    static const double sign[6] = {1, -1, 1, -1, 1, -1};
    for (int64_t i = 0; i < 6*bodies; i++)
        to[i] = sign[i%6]*q[i];
}

static void test_mirror(const char *path)
{
    struct veh v;
    struct couplings_memory m[2];
    double q[2][120] = {{0}}, qd[2][120] = {{0}}, f[2][120], turned[120], most = 0, size = 0;
    unsigned seed = 3;

    if (!loaded(&v, path, NULL, 0) || couplings_memory_new(&m[0], &v) || couplings_memory_new(&m[1], &v))
        return;
    for (int i = 0; i < 500; i++) {
        for (int64_t k = 0; k < 6*v.bodies; k++) {
            qd[0][k] = (k%6 < 3 ? 1 : 0.5)*rig_draw(&seed);
            q[0][k] += 1e-3*qd[0][k];
        }
        mirror(v.bodies, q[0], q[1]);
        mirror(v.bodies, qd[0], qd[1]);
        for (int k = 0; k < 2; k++) {
            couplings_keep(&m[k], 1e-3);
            memset(f[k], 0, sizeof f[k]);
            couplings_force(&v, &m[k], q[k], qd[k], f[k]);
        }
        mirror(v.bodies, f[0], turned);
        size = fmax(size, largest(turned, 6*v.bodies));
        for (int64_t k = 0; k < 6*v.bodies; k++)
            most = fmax(most, fabs(turned[k] - f[1][k]));
    }
    ok(most < 1e-9*size, "%s: the mirror image of a random motion has mirrored forces (%.1e of %.3g N)", v.name, most, size);
    couplings_memory_free(&m[0]);
    couplings_memory_free(&m[1]);
    veh_free(&v);
}

/* ---- motions of the bodies, wheelsets held, by the explicit scheme of a passage ---- */

struct motion {
    const struct veh *v;
    struct couplings_memory m;
    int64_t n;                  /* degrees of freedom that move: bodies come before wheelsets */
    double q[120], qd[120], a[120], before[120], f[120];
};

static void forces(struct motion *s)
{
    const struct veh *v = s->v;

    memset(s->f, 0, sizeof s->f);
    couplings_force(v, &s->m, s->q, s->qd, s->f);
    for (int64_t i = 0; i < s->n; i++)
        s->a[i] = s->f[i]/(i%6 < 3 ? v->mass[i/6] : v->inertia[3*(i/6) + i%6 - 3]) + (i%6 == VEH_Z ? v->gravity : 0);
}

/* All bodies but the wheelsets `by` m below rest. */
static int begin(struct motion *s, const struct veh *v, double by)
{
    *s = (struct motion){.v = v, .n = 6*(v->bodies - v->wheelsets)};
    if (couplings_memory_new(&s->m, v))
        return 0;
    for (int64_t i = VEH_Z; i < s->n; i += 6)
        s->q[i] = by;
    forces(s);
    memcpy(s->before, s->a, sizeof s->a);
    return 1;
}

static void step(struct motion *s, double h)
{
    couplings_keep(&s->m, h);
    for (int64_t i = 0; i < s->n; i++) {
        s->q[i] += s->qd[i]*h + (s->a[i] - 0.5*s->before[i])*h*h;
        s->qd[i] += (1.5*s->a[i] - 0.5*s->before[i])*h;
        s->before[i] = s->a[i];
    }
    forces(s);
}

/* Hz of the vertical motion of the first body let go `by` m off rest: one period, from its first turning point to its third. */
static double bounce(const char *path, double by, double *left, double *last)
{
    struct veh v;
    struct motion s;
    const double h = 1e-4;
    double turn[3] = {0}, low = 0, high = 0;
    int turns = 0;

    if (!loaded(&v, path, NULL, 0) || !begin(&s, &v, by))
        return 0;
    for (int i = 1; i <= 200000; i++) {
        double was = s.qd[VEH_Z];
        step(&s, h);
        if (was*s.qd[VEH_Z] < 0 && turns < 3)
            turn[turns++] = i*h;
        low = i == 190000 ? s.q[VEH_Z] : fmin(low, s.q[VEH_Z]);
        high = i == 190000 ? s.q[VEH_Z] : fmax(high, s.q[VEH_Z]);
    }
    *left = high - low;
    *last = s.q[VEH_Z];
    couplings_memory_free(&s.m);
    veh_free(&v);
    return 1/(turn[2] - turn[0]);
}

static void test_bounce(void)
{
    double left, last, laden = bounce(LADEN, 0.03, &left, &last);

    ok(laden > 2 && laden < 3, "the laden wagon let go 30 mm below rest bounces at %.2f Hz, between 2 and 3", laden);
    ok(left < 2*STUCK, "friction ends it: in the second after 19 s it swings by %.1e m, within the %.1e m to which friction gives", left, 2*STUCK);
    ok(fabs(last) < 5e-3, "and leaves it %.2g mm off, within what friction holds", 1e3*last);
    double tare = bounce(TARE, -0.01, &left, &last);
    ok(tare > laden, "tare, from 10 mm, at %.2f Hz", tare);
}

/* Frequency of the bounce on the springs alone, the friction of the axleboxes taken out, by the stiffness at rest. */
static double springs_hz(const char *path)
{
    static const char *const set[] = {"bogie.1.friction.1.coefficient=0", "bogie.1.friction.2.coefficient=0"};
    struct veh v;
    double hz[18], A[18*18], best = 0, at = 0;

    if (!loaded(&v, path, set, 2))
        return 0;
    int64_t n = 6*v.bodies;
    for (int i = 0; i < 18; i++)
        for (int j = 0; j < 18; j++)
            A[18*i + j] = v.K[n*i + j]/sqrt(v.M[n*i + i]*v.M[n*j + j]);
    LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'V', 'U', 18, A, 18, hz);
    for (int k = 0; k < 18; k++)
        if (fabs(A[18*VEH_Z + k]) > best) {
            best = fabs(A[18*VEH_Z + k]);
            at = sqrt(hz[k])/(2*M_PI);
        }
    veh_free(&v);
    return at;
}

static void test_springs(void)
{
    double laden = springs_hz(LADEN), tare = springs_hz(TARE);

    ok(laden > 2 && laden < 3, "bounce on the springs alone, laden: %.3f Hz, between 2 and 3", laden);
    ok(tare > laden, "tare higher: %.3f Hz", tare);
}

/* Energy of the coach without dampers, let go 1 mm below rest: off by a share of (omega h)^2, no more after 100 s than after 10. */
static void test_coach_energy(void)
{
    double early[2], late[2];

    for (int fine = 0; fine < 2; fine++) {
        struct veh v;
        struct motion s;
        double h = fine ? 5e-4 : 1e-3, none[400] = {0}, start = 0;
        if (!loaded(&v, RIG_COACH, NULL, 0))
            return;
        v.damping = none;
        if (!begin(&s, &v, 1e-3))
            return;
        early[fine] = late[fine] = 0;
        int64_t n = 6*v.bodies, steps = (int64_t)(100/h + 0.5);
        for (int64_t i = 0; i <= steps; i++) {
            double E = 0;
            if (i)
                step(&s, h);
            for (int64_t k = 0; k < s.n; k++) {
                E += 0.5*v.M[n*k + k]*s.qd[k]*s.qd[k];
                for (int64_t l = 0; l < s.n; l++)
                    E += 0.5*s.q[k]*v.K[n*k + l]*s.q[l];
            }
            start = i ? start : E;
            double *most = i < steps/10 ? &early[fine] : &late[fine];
            *most = fmax(*most, fabs(E/start - 1));
        }
        couplings_memory_free(&s.m);
        veh_free(&v);
    }
    printf("# energy off by %.3e and %.3e at steps of 1 and 0.5 ms in the first 10 s, later by %.3e and %.3e\n", early[0], early[1], late[0],
           late[1]);
    near(late[0]/late[1], 4, 0.1, "energy of the coach without dampers over 100 s: an error of second order");
    ok(late[0] < 1.05*early[0] && late[1] < 1.05*early[1], "that does not grow with time");
}

int main(void)
{
    test_rigid(RIG_COACH);
    test_rigid(LADEN);
    test_mirror(RIG_COACH);
    test_mirror(LADEN);
    test_springs();
    test_bounce();
    test_coach_energy();
    return done();
}
