/* Ranges are those of rail vehicles from trams to locomotives, an order of magnitude beyond what is built, so that a thousand is caught. */
#include "tools/vehicle/doubt.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "formats/reason.h"

static const double mass_least = 50, mass_most = 200e3;                /* kg, of a body */
static const double wheelset_least = 300, wheelset_most = 5e3;         /* kg */
static const double radius_least = 0.15, radius_most = 0.75;           /* m, of a wheel */
static const double gyration_least = 0.05, gyration_most = 20;         /* m */
static const double below_rail = 1;                                    /* m, of the box of a body */
static const double bounce_least = 0.3, bounce_most = 200;             /* Hz */
static const double stiffness_least = 1e3, stiffness_most = 1e10;      /* N/m */
static const double turning_least = 10, turning_most = 1e11;           /* N m/rad */
static const double damping_least = 10, damping_most = 1e8;            /* N s/m, N m s/rad */
static const double relax_least = 1e-6, relax_most = 5;                /* s, damping over stiffness */
static const double off_body = 1.5;                                    /* m, of a coupling from the body's box */
static const double sides_apart = 0.01, wheels_apart = 0.1;            /* of the mean wheel load */
static const double bent_most = 0.5;                                   /* m, of a spring at rest */
static const double pulled_least = 10;                                 /* N, of a spring at rest in tension */
static const double load_least = 2e3, load_most = 200e3;               /* N, of a wheel */
static const char *const ALONG[VEH_DOFS] = {"along x", "along y", "along z", "about x", "about y", "about z"};

static void add(struct doubts *d, const char *format, ...) VX_PRINTF(2, 3);

static void add(struct doubts *d, const char *format, ...)
{
    va_list ap;

    va_start(ap, format);
    if (d->n < d->room)
        vsnprintf(d->words[d->n], DOUBT_WORDS, format, ap);
    va_end(ap);
    d->n++;
}

static int outside(double value, double least, double most)
{
    return value < least || value > most;
}

double doubt_bounce(const struct veh *v, int64_t i)
{
    const int64_t n = VEH_DOFS * v->bodies, z = VEH_DOFS * i + VEH_Z;

    return sqrt(fmax(v->K[n * z + z], 0) / v->mass[i]) / (2 * M_PI);
}

/* m, half of the box of uniform density with the inertias of body i along axis k */
static double half_box(const struct veh *v, int64_t i, int k)
{
    const double *J = &v->inertia[3 * i];

    return 0.5 * sqrt(fmax(6 * (J[(k + 1) % 3] + J[(k + 2) % 3] - J[k]) / v->mass[i], 0));
}

static void doubt_body(const struct veh *v, int64_t i, struct doubts *d)
{
    const double *J = &v->inertia[3 * i], m = v->mass[i], bounce = doubt_bounce(v, i);
    const char *name = v->body_name[i];
    const int wheelset = veh_is_wheelset(v, i);

    if (wheelset ? outside(m, wheelset_least, wheelset_most) : outside(m, mass_least, mass_most))
        add(d, "body %s: a mass of %g kg; kg are wanted, not t", name, m);
    for (int k = 0; k < 3; k++) {
        if (outside(sqrt(J[k] / m), gyration_least, gyration_most))
            add(d, "body %s: a radius of gyration of %.3g m %s", name, sqrt(J[k] / m), ALONG[VEH_ROLL + k]);
        if (J[k] > (J[(k + 1) % 3] + J[(k + 2) % 3]) * (1 + 1e-9))
            add(d, "body %s: no body has these inertias, that %s is more than the other two", name, ALONG[VEH_ROLL + k]);
    }
    if (!wheelset && v->cg[3 * i + 2] + half_box(v, i, 2) > below_rail)
        add(d, "body %s: a box of its inertias, %.2f m high, reaches %.2f m below the rails", name, 2 * half_box(v, i, 2),
            v->cg[3 * i + 2] + half_box(v, i, 2));
    if (!wheelset && bounce > 0 && outside(bounce, bounce_least, bounce_most))
        add(d, "body %s: %.3g Hz up and down by itself on its springs", name, bounce);
}

/* How far p lies outside that box. */
static double away(const struct veh *v, int64_t i, const double p[3])
{
    double sum = 0;

    for (int k = 0; k < 3; k++) {
        const double beyond = fmax(fabs(p[k] - v->cg[3 * i + k]) - half_box(v, i, k), 0);
        sum += beyond * beyond;
    }
    return sqrt(sum);
}

/* Of a vertical spring at rest: compressed where it pushes the lower of its bodies down. */
static void doubt_rest(const struct veh *v, int64_t c, struct doubts *d)
{
    const double force = v->preload[3 * c + VEH_Z], K = v->stiffness[VEH_DOFS * c + VEH_Z];
    const int first_below = v->cg[3 * v->ends[2 * c] + VEH_Z] > v->cg[3 * v->ends[2 * c + 1] + VEH_Z];
    const double pushes = first_below ? force : -force;
    const int64_t last = v->knot_first[c + 1] - 1;
    const int table = v->type[c] == VEH_SPRING && last > v->knot_first[c];
    const double bent = table ? v->rest[c] : K > 0 ? force / K : 0;

    if (pushes < -pulled_least)
        add(d, "coupling %s: pulls with %.4g N at rest", v->coupling_name[c], -pushes);
    if (fabs(bent) > bent_most)
        add(d, "coupling %s: bent by %.3g m at rest", v->coupling_name[c], fabs(bent));
    if (table && force != 0 && outside(v->rest[c], v->knot_at[v->knot_first[c]], v->knot_at[last]))
        add(d, "coupling %s: at rest at %.4g m, beyond its table of %.4g to %.4g m", v->coupling_name[c], v->rest[c], v->knot_at[v->knot_first[c]],
            v->knot_at[last]);
}

static void doubt_coupling(const struct veh *v, int64_t c, struct doubts *d)
{
    const double *stiffness = &v->stiffness[VEH_DOFS * c], *damping = &v->damping[VEH_DOFS * c];
    const char *name = v->coupling_name[c];

    for (int k = 0; k < VEH_DOFS; k++) {
        const double K = stiffness[k], C = damping[k];
        const int turns = k >= VEH_ROLL;
        if (K > 0 && (turns ? outside(K, turning_least, turning_most) : outside(K, stiffness_least, stiffness_most)))
            add(d, "coupling %s: %g %s %s", name, K, turns ? "N m/rad" : "N/m", ALONG[k]);
        if (C > 0 && outside(C, damping_least, damping_most))
            add(d, "coupling %s: %g %s %s", name, C, turns ? "N m s/rad" : "N s/m", ALONG[k]);
        else if (K > 0 && C > 0 && outside(C / K, relax_least, relax_most))
            add(d, "coupling %s: damping over stiffness %s is %.3g s", name, ALONG[k], C / K);
    }
    for (int end = 0; end < 2; end++) {
        const double far = away(v, v->ends[2 * c + end], end ? &v->end[3 * c] : &v->point[3 * c]);
        if (far > off_body)
            add(d, "coupling %s: %.2f m off body %s", name, far, v->body_name[v->ends[2 * c + end]]);
    }
}

/* A slope of a table of force: N/m, or N s/m of a damper. */
static void doubt_table(const struct veh *v, int64_t c, struct doubts *d)
{
    const int damper = v->type[c] == VEH_DAMPER;
    double steepest = 0;

    for (int64_t k = v->knot_first[c] + 1; k < v->knot_first[c + 1]; k++)
        steepest = fmax(steepest, (v->knot_force[k] - v->knot_force[k - 1]) / (v->knot_at[k] - v->knot_at[k - 1]));
    if (v->knot_first[c + 1] > v->knot_first[c] + 1 &&
        outside(steepest, damper ? damping_least : stiffness_least, damper ? damping_most : stiffness_most))
        add(d, "coupling %s: its table rises by %g %s at most", v->coupling_name[c], steepest, damper ? "N s/m" : "N/m");
}

static void doubt_wheels(const struct veh *v, struct doubts *d)
{
    double mean = 0;

    for (int64_t k = 0; k < 2 * v->wheelsets; k++)
        mean += v->wheel_load[k] / (double)(2 * v->wheelsets);
    for (int64_t w = 0; w < v->wheelsets && mean > 0; w++) {
        const char *name = v->body_name[v->wheelset[w]];
        const double left = v->wheel_load[2 * w], right = v->wheel_load[2 * w + 1];
        if (outside(v->radius[w], radius_least, radius_most))
            add(d, "wheelset %s: a radius of %g m", name, v->radius[w]);
        if (outside(0.5 * (left + right), load_least, load_most))
            add(d, "wheelset %s: a wheel load of %.4g N", name, 0.5 * (left + right));
        if (fabs(left - right) > sides_apart * mean)
            add(d, "wheelset %s: %.4g N more on its %s wheel", name, fabs(left - right), left > right ? "left" : "right");
        if (fabs(0.5 * (left + right) - mean) > wheels_apart * mean)
            add(d, "wheelset %s: a wheel load of %.4g N, the mean is %.4g N", name, 0.5 * (left + right), mean);
    }
}

void doubt_find(const struct veh *v, struct doubts *d)
{
    for (int64_t i = 0; i < v->bodies; i++)
        doubt_body(v, i, d);
    for (int64_t c = 0; c < v->couplings; c++) {
        doubt_coupling(v, c, d);
        doubt_table(v, c, d);
        doubt_rest(v, c, d);
    }
    doubt_wheels(v, d);
}
