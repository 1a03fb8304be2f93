/* The track of the explicit scheme: the equations of the .trk without its matrices, statics, highest frequency, energy, wheels on it. */
#include "tools/integrate/lumped.h"

#include "tests/kernel/rig.h"
#include "tests/kernel/tap.h"
#include "tools/track/cholesky.h"
#include "tools/track/rails.h"

/* Degree of freedom d of the .trk in the state vector. */
static int64_t place_of(const struct lumped *l, int64_t node, int part)
{
    return part * l->stride + node;
}

/* y += A x on the pattern of the track. */
static void multiply(const struct trk *t, const double *A, const double *x, double *y)
{
    for (int64_t j = 0; j < t->dofs; j++)
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++)
            y[t->Ai[p]] += A[p] * x[j];
}

/* Between the order of the .trk and that of lumped. */
static void exchange(const struct lumped *l, double *dof, double *state, int into_state)
{
    const struct trk *t = l->track;

    for (int64_t i = 0; i < l->n; i++)
        for (int part = 0; part < LUMPED_PARTS; part++) {
            double *d = dof + (part < LUMPED_Z ? t->node_dof[i] + part : t->sleeper_dof[i] + part - LUMPED_Z);
            double *s = state + place_of(l, i, part);
            *(into_state ? s : d) = *(into_state ? d : s);
        }
}

static struct wheel_place find(const struct lumped *l, int rail, double x)
{
    return wheel_place_find(l->track, l->beam[rail], x);
}

/* Rails whose stiffness rises and falls within bays. */
static const char *const VARYING[] = {"rail.left.bending_stiffness={station: [2.1, 9.4, 9.7, 40], value: [6.11e6, 4e6, 9e6, 6.11e6]}",
                                      "rail.right.bending_stiffness={station: [-3, 3], value: [6.11e6, 7e6]}"};

/* M a = f - K u - C v with the matrices of the track, at random states, the turnout's off-centre bearers included. */
static void same_equations(const char *const *set, int sets)
{
    struct trk t;
    struct lumped l;
    unsigned seed = 7;
    double worst = 0, most = 0;

    ok(!rig_track(&t, RIG_TURNOUT, set, sets) && !lumped_new(&l, &t, 0), "the turnout's track%s", sets ? ", its rails of varying stiffness" : "");
    size_t n = (size_t)t.dofs;
    double *u = calloc(3 * n, sizeof *u), *v = u + n, *a = v + n, *f = calloc(n, sizeof *f);
    for (size_t i = 0; i < n; i++) {
        u[i] = 1e-3 * rig_draw(&seed);
        v[i] = rig_draw(&seed);
    }
    exchange(&l, u, l.u, 1);
    exchange(&l, v, l.v, 1);
    lumped_accelerate(&l);
    exchange(&l, a, l.a, 0);
    multiply(&t, t.Kx, u, f);
    multiply(&t, t.Cx, v, f);
    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(f[i]));
    multiply(&t, t.Mx, a, f);
    for (size_t i = 0; i < n; i++)
        worst = fmax(worst, fabs(f[i]));
    printf("# largest residual %.1e of the largest force\n", worst / most);
    ok(worst < 1e-13 * most, "M a + C v + K u = 0 with the sparse matrices");
    free(u);
    free(f);
    lumped_free(&l);
    trk_free(&t);
}

static void refusals(void)
{
    static const char *const set[] = {"rail.mass_model=consistent", "rail.beam=timoshenko", "rail.elements_per_bay=2"};

    for (int k = 0; k < 3; k++) {
        struct trk t;
        struct lumped l;
        ok(!rig_track(&t, RIG_STRAIGHT, &set[k], 1) && lumped_new(&l, &t, 0) != NULL, "%s is refused", set[k]);
        lumped_free(&l);
        trk_free(&t);
    }
}

/* Deflections of the factored K under weight and one wheel, put into the state: nothing accelerates. */
static void statics(void)
{
    struct trk t;
    struct lumped l;
    struct cholesky s;
    double worst = 0, pads = 0, ballast = 0, weight = 0, F = 50e3, g = 9.81;

    ok(!rig_track(&t, RIG_TURNOUT, NULL, 0) && !lumped_new(&l, &t, g) && !cholesky_new(&s, &t), "the turnout's track, factored");
    double *u = calloc((size_t)t.dofs, sizeof *u);
    struct wheel_place at = find(&l, 1, 20.13);
    for (int64_t i = 0; i < t.nodes; i++)
        for (int k = 0; k < 2; k++)
            u[t.node_dof[i] + 2 * k] = t.rail_mass[k * t.nodes + i] * g;
    for (int64_t i = 0; i < t.sleepers; i++)
        u[t.sleeper_dof[i]] = t.sleeper_mass[i] * g;
    for (int64_t i = 0; i < t.sleepers; i++)
        weight += (t.rail_mass[i] + t.rail_mass[t.nodes + i] + t.sleeper_mass[i]) * g;
    for (int j = 0; j < 4; j++)
        u[t.node_dof[at.node + j / 2] + 2 + j % 2] += F * at.shape[j];
    ok(!cholesky_solve(&s, u, u), "solved by CHOLMOD");
    exchange(&l, u, l.u, 1);
    lumped_accelerate(&l);
    lumped_load(&l, 1, &at, F);
    for (int64_t i = 0; i < LUMPED_PARTS * l.stride; i++)
        if (l.inverse[i] > 0)
            worst = fmax(worst, fabs(l.a[i] / l.inverse[i]));
    for (int64_t i = 0; i < l.n; i++) {
        pads += l.pad[0][i] + l.pad[1][i];
        ballast += l.ballast[0][i] + l.ballast[1][i] + l.ballast[2][i];
    }
    printf("# largest force left over %.1e N of %.0f N\n", worst, F);
    ok(worst < 1e-9 * F, "equilibrium: no mass is pushed");
    near(ballast, weight + F, 1e-6, "the ballast carries weight and wheel");
    double sleepers = 0;
    for (int64_t i = 0; i < t.sleepers; i++)
        sleepers += t.sleeper_mass[i] * g;
    near(pads, weight + F - sleepers, 1e-6, "the pads all but the sleepers");
    free(u);
    cholesky_free(&s);
    lumped_free(&l);
    trk_free(&t);
}

/* 30 m of Table 1, free ends: 1572 Hz by a dense eigensolver of another program. */
static void highest_frequency(void)
{
    struct trk t;
    struct lumped l;

    ok(!rig_track(&t, RIG_STRAIGHT, NULL, 0) && !lumped_new(&l, &t, 9.81), "the track of Table 1");
    double omega = lumped_highest(&l), still = 0;
    printf("# %.3f Hz, limit of a step %.4g s\n", omega / (2 * M_PI), 2 / omega);
    near(omega / (2 * M_PI), 1572, 1, "highest frequency 1572 Hz");
    near(2 / omega, 2.02e-4, 0.01e-4, "limit of an undamped step 2.02e-4 s");
    for (int64_t i = 0; i < LUMPED_PARTS * l.stride; i++)
        still = fmax(still, fabs(l.u[i]) + fabs(l.v[i]));
    ok(still == 0 && l.gravity == 9.81, "it leaves the track at rest");
    lumped_free(&l);
    trk_free(&t);
}

/* Kinetic energy of the mean velocity over a step and the mixed strain energy u(n) K u(n + 1)/2: the scheme's own invariant. */
static double energy(const struct trk *t, const struct lumped *l, double *last, double h, double *dof, double *force)
{
    double sum = 0;

    exchange(l, dof, l->u, 0);
    memset(force, 0, (size_t)t->dofs * sizeof *force);
    multiply(t, t->Kx, dof, force);
    exchange(l, dof, last, 0);
    for (int64_t i = 0; i < t->dofs; i++)
        sum += 0.5 * dof[i] * force[i];
    for (int64_t i = 0; i < LUMPED_PARTS * l->stride; i++)
        if (l->inverse[i] > 0)
            sum += 0.5 * (l->u[i] - last[i]) * (l->u[i] - last[i]) / (h * h) / l->inverse[i];
    return sum;
}

/* Energy after `steps` over that after the first, of a track without dampers let go from random deflections: Zhai's step as passage.h says. */
static double let_go(const struct trk *t, double h, int steps)
{
    struct lumped l;
    unsigned seed = 3;
    double first = 0, now = 0;

    if (lumped_new(&l, t, 0))
        return NAN;
    size_t n = (size_t)(LUMPED_PARTS * l.stride);
    double *last = calloc(n, sizeof *last), *dof = calloc((size_t)t->dofs, sizeof *dof), *force = calloc((size_t)t->dofs, sizeof *force);
    for (size_t i = 0; i < n; i++)
        l.u[i] = l.inverse[i] > 0 ? 1e-3 * rig_draw(&seed) : 0;
    lumped_accelerate(&l);
    memcpy(l.before, l.a, n * sizeof *l.a);
    for (int k = 0; k < steps; k++) {
        memcpy(last, l.u, n * sizeof *last);
        for (size_t i = 0; i < n; i++) {
            l.u[i] += l.v[i] * h + (l.a[i] - 0.5 * l.before[i]) * h * h;
            l.v[i] += (1.5 * l.a[i] - 0.5 * l.before[i]) * h;
            l.before[i] = l.a[i];
        }
        lumped_accelerate(&l);
        if (k == 0)
            first = energy(t, &l, last, h, dof, force);
    }
    now = energy(t, &l, last, h, dof, force);
    free(last);
    free(dof);
    free(force);
    lumped_free(&l);
    return now / first;
}

static void free_vibration(void)
{
    static const char *const bare[] = {"railpad.damping=0", "ballast.damping=0"};
    struct trk t;
    struct lumped l;

    ok(!rig_track(&t, RIG_STRAIGHT, bare, 2) && !lumped_new(&l, &t, 0), "a track without dampers");
    double limit = 2 / lumped_highest(&l);
    near(let_go(&t, 1e-4, 20000), 1, 1e-9, "energy is the same after 20 000 steps of 1e-4 s");
    near(let_go(&t, 0.99 * limit, 20000), 1, 1e-9, "and of 0.99 of the limit");
    ok(!(let_go(&t, 1.01 * limit, 4000) < 1e6), "but not at 1.01 of the limit");
    lumped_free(&l);
    trk_free(&t);
}

/* The deflection at p under a force at q is that at q under the same force at p, and the power of a wheel load is that of its nodes. */
static void wheel_loads(const char *const *set, int sets)
{
    struct trk t;
    struct lumped l;
    struct cholesky s;
    double value[2];

    ok(!rig_track(&t, RIG_TURNOUT, set, sets) && !lumped_new(&l, &t, 0) && !cholesky_new(&s, &t), "the turnout's track, factored");
    double *u = calloc((size_t)t.dofs, sizeof *u);
    struct wheel_place p[2] = {find(&l, 0, 20.13), find(&l, 1, 21.47)};
    for (int k = 0; k < 2; k++) {
        memset(l.a, 0, (size_t)(LUMPED_PARTS * l.stride) * sizeof *l.a);
        lumped_load(&l, k, &p[k], 1);
        for (int64_t i = 0; i < LUMPED_PARTS * l.stride; i++)
            l.a[i] = l.inverse[i] > 0 ? l.a[i] / l.inverse[i] : 0; /* force again */
        exchange(&l, u, l.a, 0);
        cholesky_solve(&s, u, u);
        exchange(&l, u, l.u, 1);
        value[k] = lumped_sample(&l, !k, &p[!k], p[!k].shape, l.u);
    }
    printf("# %.6e and %.6e m/N\n", value[0], value[1]);
    near(value[0], value[1], 1e-12 * fabs(value[0]) + 1e-22, "reciprocity of the wheel load, left rail and right");

    double h = 1e-6, worst = 0;
    for (double x = 20.05; x < 21.2; x += 0.1) {
        struct wheel_place a = find(&l, 0, x - h), b = find(&l, 0, x), c = find(&l, 0, x + h);
        double difference = lumped_sample(&l, 0, &c, c.shape, l.u) - lumped_sample(&l, 0, &a, a.shape, l.u);
        worst = fmax(worst, fabs(difference / (2 * h) - lumped_sample(&l, 0, &b, b.slope, l.u)));
    }
    double size = fabs(lumped_sample(&l, 0, &p[0], p[0].slope, l.u));
    ok(worst < 1e-6 * size, "slope is the derivative of the deflection (%.1e)", worst / size);
    near(find(&l, 0, t.x[9]).compliance, 0, 1e-30, "no compliance over a sleeper");
    if (!sets)
        near(find(&l, 0, t.x[9] + 0.3).compliance * 192 * 6.11e6 / (0.6 * 0.6 * 0.6), 1, 1e-9, "L^3/(192 EI) halfway");
    free(u);
    cholesky_free(&s);
    lumped_free(&l);
    trk_free(&t);
}

/* Bending moment at the nodes under a force anywhere in a bay, in equilibrium.  The reference has twenty elements a bay, so that elements
 * without load meet every sleeper: M = -EI w'' is the moment at their ends. */
static void moments(double along, const char *bending)
{
    const char *fine[] = {bending, "rail.elements_per_bay=20"};
    struct trk t, r;
    struct lumped l;
    struct cholesky s, f;
    double F = 93.2e3, x = 0.3 + 0.6 * along, m[50], worst = 0, most = 0;

    ok(!rig_track(&t, RIG_STRAIGHT, fine, 1) && !lumped_new(&l, &t, 0) && !cholesky_new(&s, &t) &&
       !rig_track(&r, RIG_STRAIGHT, fine, 2) && !cholesky_new(&f, &r), "force at %.2f of a bay", along);
    double *u = calloc((size_t)r.dofs, sizeof *u);
    struct wheel_place at = find(&l, 0, x);
    for (int j = 0; j < 4; j++)
        u[t.node_dof[at.node + j / 2] + j % 2] += F * at.shape[j];
    cholesky_solve(&s, u, u);
    exchange(&l, u, l.u, 1);
    lumped_accelerate(&l);
    lumped_load(&l, 0, &at, F);
    lumped_moment(&l, 0, m);

    memset(u, 0, (size_t)r.dofs * sizeof *u);
    for (int64_t i = 0; i < r.nodes; i++)
        if (fabs(r.x[i] - x) < 1e-9)
            u[r.node_dof[i]] = F;
    cholesky_solve(&f, u, u);
    for (int64_t i = 1; i + 1 < t.nodes; i++) {
        int64_t k = r.sleeper_node[i];
        k -= along > 0 && i == at.node + 1; /* the element behind or ahead that carries no load at its end */
        const struct beam b = rails_beam(&r, 0, k);
        double K[4][4], near_end = 0, far_end = 0;
        beam_stiffness(&b, K);
        for (int j = 0; j < 4; j++) {
            near_end += K[1][j] * u[r.node_dof[k + j / 2] + j % 2];
            far_end += K[3][j] * u[r.node_dof[k + j / 2] + j % 2];
        }
        double want = k == r.sleeper_node[i] ? -near_end : far_end;
        worst = fmax(worst, fabs(m[i] - want));
        most = fmax(most, want);
    }
    printf("# largest moment at a sleeper %.1f N m, off by %.1e N m\n", most, worst);
    ok(worst < 1e-6 * most, "moments at all sleepers are those of twenty elements a bay");
    free(u);
    cholesky_free(&s);
    cholesky_free(&f);
    lumped_free(&l);
    trk_free(&t);
    trk_free(&r);
}

/* Over a sleeper the moment under the force is somewhat below that of a beam on a continuous support of the same stiffness,
 * F/(4 b) with b^4 = k/(4 EI L), pad and half a sleeper's ballast in series; that changes sign at b x = pi/4, 0.49 m. */
static void continuous_support(void)
{
    struct trk t;
    struct lumped l;
    struct cholesky s;
    double F = 93.2e3, m[50], k = 1 / (1 / 300e6 + 2 / 280e6), b = pow(k / (4 * 6.11e6 * 0.6), 0.25);

    ok(!rig_track(&t, RIG_STRAIGHT, NULL, 0) && !lumped_new(&l, &t, 0) && !cholesky_new(&s, &t), "the track of Table 1");
    double *u = calloc((size_t)t.dofs, sizeof *u);
    u[t.node_dof[25]] = u[t.node_dof[25] + 2] = F;
    cholesky_solve(&s, u, u);
    exchange(&l, u, l.u, 1);
    lumped_accelerate(&l);
    lumped_moment(&l, 0, m);
    printf("# %.0f N m over the sleeper, continuous support %.0f N m\n", m[25], F / (4 * b));
    near(m[25] / (F / (4 * b)), 1, 0.2, "positive under the wheel, about that of a continuous support");
    ok(m[27] < 0 && fabs(m[27]) < 0.25 * m[25], "and negative two sleepers on");
    near(m[0], 0, 1e-6, "none at a free end");
    free(u);
    cholesky_free(&s);
    lumped_free(&l);
    trk_free(&t);
}

int main(void)
{
    same_equations(NULL, 0);
    same_equations(VARYING, 2);
    refusals();
    statics();
    highest_frequency();
    free_vibration();
    wheel_loads(NULL, 0);
    wheel_loads(VARYING, 2);
    for (int along = 0; along < 3; along++) {
        moments(0.25 * along, "rail.bending_stiffness=6.11e6");
        moments(0.25 * along, "rail.bending_stiffness={station: [-2.9, 0.4, 0.75, 3], value: [6.11e6, 5e6, 9e6, 6.11e6]}");
    }
    continuous_support();
    return done();
}
