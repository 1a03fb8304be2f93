/* Levenberg's and Marquardt's method in the logarithms of the factors, p of them, those that push against a bound left out of a step (Nocedal
 * and Wright 2006, Numerical Optimization, 10.3 and 16.7).  With A = K + i omega C - omega^2 M symmetric, A x = f and A y = r, the
 * derivative of H = r'x is -y'(dA)x.  The uncertainties are those of linear least squares, s^2 (J'J)^-1, s^2 = sum / (2n - p). */
#include "tools/receptance/calibrate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/receptance/direct.h"
#include "tools/track/assemble.h"

static const double DAMPED_FIRST = 1e-3, DAMPED_MOST = 1e12;   /* of Marquardt's diagonal */
static const double SETTLED = 1e-9;        /* step of a logarithm */
static const double LONGEST = 1;           /* step of a logarithm */
static const double SINGULAR = 1e-10;      /* pivot of J'J with unit diagonal */
enum { STEPS = 200 };

const char *const calibrate_name[] = {"railpad_stiffness", "railpad_damping", "ballast_stiffness", "ballast_damping", NULL};

/* K = K0 + a Kp + b Kb and C = c Cp + d Cb, by entries. */
struct model {
    struct trk track;                      /* its Kx and Cx are K and C here */
    const struct measured *m;
    double *store, *part[CALIBRATE_N];     /* [entries] Kp, Cp, Kb, Cb */
    double *K0, *C0, *K, *C;               /* [entries] */
    double *x, *y;                         /* [dofs][2] */
    double held;
    struct direct direct;
};

struct sums { double sum, g[CALIBRATE_N], N[CALIBRATE_N][CALIBRATE_N]; };   /* |r|^2, J'r, J'J */

/* values [n] times the factor, in room of t */
static const double *scaled(struct trk *t, int64_t n, const double *values, double factor)
{
    double *of = trk_room(t, n, sizeof *of);

    for (int64_t i = 0; of && i < n; i++)
        of[i] = factor * values[i];
    return of;
}

const char *calibrate_apply(struct trk *out, const struct trk *t, const double *factor)
{
    const int64_t pads = TRK_RAILS * t->sleepers, springs = TRK_BALLAST * t->sleepers;

    *out = *t;
    out->store = NULL;
    out->pad_k = scaled(out, pads, t->pad_k, factor[CALIBRATE_PAD_K]);
    out->pad_c = scaled(out, pads, t->pad_c, factor[CALIBRATE_PAD_C]);
    out->ballast_k = scaled(out, springs, t->ballast_k, factor[CALIBRATE_BALLAST_K]);
    out->ballast_c = scaled(out, springs, t->ballast_c, factor[CALIBRATE_BALLAST_C]);
    if (!out->pad_k || !out->pad_c || !out->ballast_k || !out->ballast_c)
        return REASON_MEMORY;
    return assemble_track(out);
}

void calibrate_values(const struct trk *t, double *value)
{
    const double *of[CALIBRATE_N] = {t->pad_k, t->pad_c, t->ballast_k, t->ballast_c};

    for (int p = 0; p < CALIBRATE_N; p++) {
        const int ballast = p >= CALIBRATE_BALLAST_K;
        const int64_t n = (ballast ? TRK_BALLAST : TRK_RAILS) * t->sleepers;
        value[p] = 0;
        for (int64_t i = 0; i < n; i++)
            value[p] += of[p][i] / (double)(ballast ? t->sleepers : n);
    }
}

/* The parts as differences of the track without springs, with its pads alone, and whole. */
static const char *split(struct model *s, const struct trk *t)
{
    static const double nothing[CALIBRATE_N], pads[CALIBRATE_N] = {1, 1, 0, 0};
    struct trk bare = {0}, padded = {0};
    const char *why = calibrate_apply(&bare, t, nothing);

    if (!why)
        why = calibrate_apply(&padded, t, pads);
    for (int64_t i = 0; i < t->Ap[t->dofs] && !why; i++) {
        s->K0[i] = bare.Kx[i];
        s->C0[i] = bare.Cx[i];
        s->part[CALIBRATE_PAD_K][i] = padded.Kx[i] - bare.Kx[i];
        s->part[CALIBRATE_PAD_C][i] = padded.Cx[i] - bare.Cx[i];
        s->part[CALIBRATE_BALLAST_K][i] = t->Kx[i] - padded.Kx[i];
        s->part[CALIBRATE_BALLAST_C][i] = t->Cx[i] - padded.Cx[i];
    }
    trk_free(&bare);
    trk_free(&padded);
    return why;
}

static void model_free(struct model *s)
{
    direct_free(&s->direct);
    free(s->store);
}

static const char *model_new(struct model *s, const struct trk *t, const struct measured *m)
{
    const size_t entries = (size_t)t->Ap[t->dofs], dofs = (size_t)t->dofs;

    memset(s, 0, sizeof *s);
    s->m = m;
    s->held = place_held(&m->force, &m->motion, t);
    s->store = calloc((CALIBRATE_N + 4) * entries + 4 * dofs, sizeof *s->store);
    if (!s->store)
        return REASON_MEMORY;
    for (int p = 0; p < CALIBRATE_N; p++)
        s->part[p] = s->store + (size_t)p * entries;
    s->K0 = s->store + CALIBRATE_N * entries;
    s->C0 = s->K0 + entries;
    s->K = s->C0 + entries;
    s->C = s->K + entries;
    s->x = s->C + entries;
    s->y = s->x + 2 * dofs;
    s->track = *t;
    s->track.Kx = s->K;
    s->track.Cx = s->C;
    const char *why = split(s, t);
    return why ? why : direct_new(&s->direct, &s->track);
}

/* u [dofs][2] = A^-1 of a unit force at p */
static const char *respond(struct model *s, const struct place *p, double *u)
{
    memset(u, 0, 2 * (size_t)s->track.dofs * sizeof *u);
    for (int k = 0; k < p->dofs; k++)
        u[2 * p->dof[k]] += p->share[k];
    return direct_solve(&s->direct, u);
}

/* y'A x without conjugation, A real; x, y [dofs][2] */
static double complex product(const struct trk *t, const double *A, const double *y, const double *x)
{
    double complex sum = 0;

    for (int64_t j = 0; j < t->dofs; j++) {
        double re = 0, im = 0;
        for (int64_t p = t->Ap[j]; p < t->Ap[j + 1]; p++) {
            re += A[p] * y[2 * t->Ai[p]];
            im += A[p] * y[2 * t->Ai[p] + 1];
        }
        sum += (re + im * I) * (x[2 * j] + x[2 * j + 1] * I);
    }
    return sum;
}

/* The k-th frequency: residual r, and dr [CALIBRATE_N] over the logarithms of the factors. */
static const char *residual(struct model *s, int64_t k, const double *factor, double complex *r, double complex *dr)
{
    const struct measured *m = s->m;
    const double complex iw = 2 * M_PI * m->frequency[k] * I;
    double complex measured = m->re[k] + m->im[k] * I, H = s->held;
    const char *why = direct_factor(&s->direct, iw);

    if (why || (why = respond(s, &m->force, s->x)) || (why = respond(s, &m->motion, s->y)))
        return reason("at %g Hz: %s", m->frequency[k], why);
    for (int q = 0; q < m->quantity; q++)
        measured /= iw;
    for (int i = 0; i < m->motion.dofs; i++)
        H += m->motion.share[i] * (s->x[2 * m->motion.dof[i]] + s->x[2 * m->motion.dof[i] + 1] * I);
    *r = clog(H / measured);
    for (int p = 0; p < CALIBRATE_N; p++) {
        const double complex d = p == CALIBRATE_PAD_C || p == CALIBRATE_BALLAST_C ? iw : 1;
        dr[p] = -factor[p] * d * product(&s->track, s->part[p], s->y, s->x) / H;
    }
    return NULL;
}

/* The sums over all frequencies at the logarithms theta [CALIBRATE_N]. */
static const char *evaluate(struct model *s, const double *theta, struct sums *of)
{
    double factor[CALIBRATE_N];
    const char *why = NULL;

    memset(of, 0, sizeof *of);
    for (int p = 0; p < CALIBRATE_N; p++)
        factor[p] = exp(theta[p]);
    for (int64_t i = 0; i < s->track.Ap[s->track.dofs]; i++) {
        s->K[i] = s->K0[i] + factor[CALIBRATE_PAD_K] * s->part[CALIBRATE_PAD_K][i] + factor[CALIBRATE_BALLAST_K] * s->part[CALIBRATE_BALLAST_K][i];
        s->C[i] = s->C0[i] + factor[CALIBRATE_PAD_C] * s->part[CALIBRATE_PAD_C][i] + factor[CALIBRATE_BALLAST_C] * s->part[CALIBRATE_BALLAST_C][i];
    }
    for (int64_t k = 0; k < s->m->n && !why; k++) {
        double complex r = 0, dr[CALIBRATE_N];
        if ((why = residual(s, k, factor, &r, dr)))
            break;
        of->sum += creal(r * conj(r));
        for (int p = 0; p < CALIBRATE_N; p++) {
            of->g[p] += creal(conj(dr[p]) * r);
            for (int q = 0; q < CALIBRATE_N; q++)
                of->N[p][q] += creal(conj(dr[p]) * dr[q]);
        }
    }
    return why;
}

/* X [CALIBRATE_N][CALIBRATE_N] = (N + damped diag N)^-1 on the rows where on is true, by Gauss and Jordan with unit diagonal, zero
 * elsewhere; the row that has no pivot, or -1. */
static int invert(const struct sums *of, const int *on, double damped, double X[CALIBRATE_N][CALIBRATE_N])
{
    double A[CALIBRATE_N][CALIBRATE_N] = {{0}}, scale[CALIBRATE_N];

    for (int p = 0; p < CALIBRATE_N; p++) {
        scale[p] = on[p] ? sqrt(of->N[p][p]) : 1;
        if (!(scale[p] > 0))
            return p;
    }
    for (int p = 0; p < CALIBRATE_N; p++)
        for (int q = 0; q < CALIBRATE_N; q++) {
            A[p][q] = p == q ? 1 + (on[p] ? damped : 0) : on[p] && on[q] ? of->N[p][q] / (scale[p] * scale[q]) : 0;
            X[p][q] = p == q;
        }
    for (int k = 0; k < CALIBRATE_N; k++) {
        const double pivot = A[k][k];
        if (!(pivot > SINGULAR))
            return k;
        for (int q = 0; q < CALIBRATE_N; q++) {
            A[k][q] /= pivot;
            X[k][q] /= pivot;
        }
        for (int p = 0; p < CALIBRATE_N; p++) {
            const double by = p == k ? 0 : A[p][k];
            for (int q = 0; q < CALIBRATE_N; q++) {
                A[p][q] -= by * A[k][q];
                X[p][q] -= by * X[k][q];
            }
        }
    }
    for (int p = 0; p < CALIBRATE_N; p++)
        for (int q = 0; q < CALIBRATE_N; q++)
            X[p][q] = on[p] && on[q] ? X[p][q] / (scale[p] * scale[q]) : 0;
    return -1;
}

/* The parameters that may move: fitted, and not pushing against a bound. */
static void choose(const int *fit, const double *theta, const double *g, double lo, double hi, int *on)
{
    for (int p = 0; p < CALIBRATE_N; p++)
        on[p] = fit[p] && !(theta[p] <= lo && g[p] >= 0) && !(theta[p] >= hi && g[p] <= 0);
}

/* theta + step within the bounds, the longest part of the step LONGEST; returns its longest part. */
static double move(const double *theta, double X[CALIBRATE_N][CALIBRATE_N], const double *g, double lo, double hi, double *to)
{
    double step[CALIBRATE_N] = {0}, longest = 0, moved = 0;

    for (int p = 0; p < CALIBRATE_N; p++) {
        for (int q = 0; q < CALIBRATE_N; q++)
            step[p] -= X[p][q] * g[q];
        longest = fmax(longest, fabs(step[p]));
    }
    for (int p = 0; p < CALIBRATE_N; p++) {
        to[p] = theta[p] + step[p] * fmin(1, LONGEST / longest);
        if (step[p] != 0)
            to[p] = fmin(fmax(to[p], lo), hi);
        moved = fmax(moved, fabs(to[p] - theta[p]));
    }
    return moved;
}

static const char *descend(struct calibration *c, struct model *s, const int *fit, double lo, double hi, double *theta, struct sums *of)
{
    double damped = DAMPED_FIRST, X[CALIBRATE_N][CALIBRATE_N], to[CALIBRATE_N];
    int on[CALIBRATE_N];

    for (c->steps = 1; c->steps <= STEPS; c->steps++) {
        struct sums next;
        choose(fit, theta, of->g, lo, hi, on);
        const int lost = invert(of, on, damped, X);
        if (lost >= 0)
            return reason("%s does not change this receptance", calibrate_name[lost]);
        const double moved = move(theta, X, of->g, lo, hi, to);
        if (moved <= SETTLED)
            return NULL;
        const char *why = evaluate(s, to, &next);
        if (why)
            return why;
        if (next.sum < of->sum) {
            memcpy(theta, to, sizeof to);
            *of = next;
            damped /= 10;
        } else if ((damped *= 10) > DAMPED_MOST)
            return NULL;                   /* no step goes down: rounding */
    }
    return reason("the fit does not settle in %d steps", STEPS);
}

/* What stands at the end: factors, bounds, uncertainties. */
static const char *conclude(struct calibration *c, const struct sums *of, int64_t n, const int *fit, const double *theta, double lo, double hi)
{
    double X[CALIBRATE_N][CALIBRATE_N];
    int on[CALIBRATE_N], free_ones = 0;

    choose(fit, theta, of->g, lo, hi, on);
    const int lost = invert(of, on, 0, X);
    if (lost >= 0)
        return reason("%s cannot be told from the others by these frequencies", calibrate_name[lost]);
    for (int p = 0; p < CALIBRATE_N; p++)
        free_ones += on[p];
    for (int p = 0; p < CALIBRATE_N; p++) {
        c->factor[p] = exp(theta[p]);
        c->bound[p] = !fit[p] || on[p] ? 0 : theta[p] <= lo ? -1 : 1;
        c->uncertainty[p] = sqrt(of->sum / (double)(2 * n - free_ones) * X[p][p]);
    }
    c->after = sqrt(of->sum / (double)n);
    return NULL;
}

const char *calibrate_track(struct calibration *c, const struct trk *t, const struct measured *m, const int *fit, double lo, double hi)
{
    struct model s;
    struct sums of;
    double theta[CALIBRATE_N] = {0};
    int fitted = 0;

    *c = (struct calibration){0};
    for (int p = 0; p < CALIBRATE_N; p++)
        fitted += fit[p];
    if (2 * m->n <= fitted)
        return reason("%d parameters want %d frequencies or more within the range, there are %lld", fitted, fitted / 2 + 1, (long long)m->n);
    const char *why = model_new(&s, t, m);
    if (!why)
        why = evaluate(&s, theta, &of);
    if (!why) {
        c->before = sqrt(of.sum / (double)m->n);
        why = descend(c, &s, fit, log(lo), log(hi), theta, &of);
    }
    if (!why)
        why = conclude(c, &of, m->n, fit, theta, log(lo), log(hi));
    model_free(&s);
    return why;
}
