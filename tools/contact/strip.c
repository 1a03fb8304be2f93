/* ANALYN (Sichani, Enblom, Berg, Vehicle System Dynamics 52 (2014)).  Each strip takes from Hertz, for its own A and B = g''/2, what its
 * semi-axes and pressure would be: with d the approach and E* = G/(1 - nu), an ellipse a, b has A a^2 (1 + alpha) = B b^2 (1 + beta) = d, and
 *
 *     depth(y) = d - (1 + beta) g(y)     half length^2 = depth/((1 + alpha) A)     pressure = Hertz's under an approach of depth
 *
 * along x as an ellipse's.  By Hertz's similarity 1 + alpha and 1 + beta depend on B/A alone, pressure and half length go with the root of
 * depth, and the force of a strip per width is proportional to depth:
 *
 *     (pi/2) half length pressure = 3/4 C^(2/3)/b1 depth                     N = C d^1.5, b = b1 N^(1/3) as in hertz.h
 *
 * so that an elliptic gap gives Hertz's force, patch and pressure.  Between two strips depth is taken as straight. */
#include "tools/contact/strip.h"

#include <math.h>

#include "tools/contact/hertz.h"

#define LOWEST (-8.0)        /* log(B/A) of the law's first entry */
#define RATIO_STEP 0.03125
#define EXACT 1e-13          /* of the load */

enum { SHARE, REACH, STIFF };

void strip_law(double G, double nu, struct strip_law *law)
{
    const double A = 1e3;                                         /* 1/m; any, far from hertz_contact's flattest */

    law->modulus = G / (1 - nu);
    for (int i = 0; i < STRIP_RATIOS; i++) {
        struct hertz h;
        double B = A * exp(LOWEST + RATIO_STEP * i);
        hertz_contact(A, B, G, nu, &h);
        double c = cbrt(h.C * h.C);
        law->value[i][SHARE] = 1 / (B * h.b1 * h.b1 * c);         /* 1 + beta */
        law->value[i][REACH] = A * h.a1 * h.a1 * c;               /* 1/(1 + alpha) */
        law->value[i][STIFF] = 0.75 * c / (h.b1 * law->modulus);
    }
}

/* Cubic through four entries. */
static void law_at(const struct strip_law *law, double A, double B, double v[3])
{
    double at = (log(B / A) - LOWEST) / RATIO_STEP;
    int i = at < 1 ? 1 : at > STRIP_RATIOS - 3 ? STRIP_RATIOS - 3 : (int)at;
    double t = at - i, p = t + 1, q = t - 1, r = t - 2;
    double w0 = -t * q * r / 6, w1 = p * q * r / 2, w2 = -p * t * r / 2, w3 = p * t * q / 6;

    for (int k = 0; k < 3; k++)
        v[k] = w0 * law->value[i - 1][k] + w1 * law->value[i][k] + w2 * law->value[i + 1][k] + w3 * law->value[i + 2][k];
}

void strip_prepare(const struct strip_law *law, struct strip *strip, int64_t n)
{
    for (int64_t i = 0; i < n; i++) {
        struct strip *r = &strip[i];
        const struct strip *m = &strip[i == 0 ? 1 : i == n - 1 ? n - 2 : i];
        double B = ((m[1].gap - m->gap) / (m[1].y - m->y) - (m->gap - m[-1].gap) / (m->y - m[-1].y)) / (m[1].y - m[-1].y);
        double A = r->A > HERTZ_FLATTEST ? r->A : HERTZ_FLATTEST, v[3];
        law_at(law, A, B > HERTZ_FLATTEST ? B : HERTZ_FLATTEST, v);
        r->share = v[SHARE];
        r->reach = v[REACH] / A;
        r->stiff = v[STIFF] * law->modulus;
        r->peak = 2 / M_PI * r->stiff / sqrt(r->reach);
    }
}

/* Where between strips i and i + 1 depth d0, d1 is positive: its length, and depths at its ends in place of d0, d1. */
static double overlap(const struct strip *r, double approach, double *d0, double *d1)
{
    double length = r[1].y - r[0].y;

    *d0 = approach - r[0].share * r[0].gap;
    *d1 = approach - r[1].share * r[1].gap;
    if (*d0 <= 0 && *d1 <= 0)
        return 0;
    if (*d0 > 0 && *d1 > 0)
        return length;
    length *= fmax(*d0, *d1) / fabs(*d0 - *d1);
    *d0 = fmax(*d0, 0);
    *d1 = fmax(*d1, 0);
    return length;
}

/* Force, and its derivative by the approach but for moving edges, which carry nothing. */
static double force_rate(const struct strip *strip, int64_t n, double approach, double *rate)
{
    double force = 0, d0, d1;

    *rate = 0;
    for (int64_t i = 0; i + 1 < n; i++) {
        double length = overlap(&strip[i], approach, &d0, &d1), s0 = strip[i].stiff, s1 = strip[i + 1].stiff;
        force += 0.5 * length * (s0 * d0 + s1 * d1) * (length > 0);
        *rate += 0.5 * length * (s0 + s1);
    }
    return force;
}

double strip_force(const struct strip *strip, int64_t n, double approach)
{
    double rate;

    return force_rate(strip, n, approach, &rate);
}

double strip_approach(const struct strip *strip, int64_t n, double load)
{
    double lo = 0, hi = 1e-6, rate, d;

    while (strip_force(strip, n, hi) < load)
        lo = hi, hi *= 4;
    d = hi;
    for (int i = 0; i < 100; i++) {
        double off = force_rate(strip, n, d, &rate) - load;
        if (fabs(off) < EXACT * load)
            break;
        *(off > 0 ? &hi : &lo) = d;
        d -= off / rate;
        if (!(d > lo && d < hi))
            d = 0.5 * (lo + hi);
    }
    return d;
}

/* Area of the strips of a length across whose squares of half length run straight from q0 to q1. */
static double straight_area(double length, double q0, double q1)
{
    return 4.0 / 3 * length * (q0 + sqrt(q0 * q1) + q1) / (sqrt(q0) + sqrt(q1));
}

void strip_patch(struct strip *strip, int64_t n, double approach, struct strip_patch *p)
{
    double width = 0, moment = 0, longest = 0, d0, d1;

    *p = (struct strip_patch){.approach = approach};
    for (int64_t i = 0; i < n; i++) {
        double depth = fmax(approach - strip[i].share * strip[i].gap, 0);
        strip[i].half = sqrt(strip[i].reach * depth);
        strip[i].pressure = strip[i].peak * sqrt(depth);
        p->pressure = fmax(p->pressure, strip[i].pressure);
        longest = fmax(longest, strip[i].half);
        p->parts += depth > 0 && (i == 0 || strip[i - 1].half <= 0);
    }
    for (int64_t i = 0; i + 1 < n; i++) {
        const struct strip *r = &strip[i];
        double length = overlap(r, approach, &d0, &d1);
        if (length <= 0)
            continue;
        double f0 = 0.5 * length * r[0].stiff * d0, f1 = 0.5 * length * r[1].stiff * d1;
        width += length;
        p->force += f0 + f1;
        moment += f0 * r[0].y + f1 * r[1].y;
        p->area += straight_area(length, r[0].reach * d0, r[1].reach * d1);
    }
    if (p->force <= 0)
        return;
    p->y = moment / p->force;
    p->a = sqrt(p->area / M_PI * 2 * longest / width);
    p->b = p->area / (M_PI * p->a);
}
