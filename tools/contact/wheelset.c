/* A side's running circle hangs at z + roll b (b its position, negative on the left), its displacement is u = y - roll r0.  Each side
 * alone has the height h(u, roll) at which it touches, or carries its load; the roll follows from
 *
 *     f(roll) = (h_r - r_r) - (h_l - r_l) - roll (b_r - b_l) = 0
 *
 * with r the nominal radii, both wheels being on one axle.  It falls with roll unless a flange is steeper than b/r0, 73 degrees:
 * Newton, kept inside a shrinking bracket. */
#include "tools/contact/wheelset.h"

#include <math.h>
#include <stddef.h>

#include "formats/reason.h"

#define EXACT 1e-15           /* m, rad: a step below this ends the iteration */
#define LOOSE 1e-9            /* m, rad: a roll at the end of its bracket must balance to this */
#define ROLL_MOST 0.02        /* rad */

/* N at a side's height z: vertical force of its contacts, its derivative by z (N/m), the normal forces. */
static double side_load(struct wheelset_side *d, double z, double *stiffness)
{
    double sum = 0;

    *stiffness = 0;
    for (int i = 0; i < d->n; i++) {
        const struct contact *c = &d->contact[i];
        double cosine = cos(c->row[CTAB_ANGLE]), depth = (z - c->height) * cosine;
        double rate = depth > 0 ? c->weight * c->row[CTAB_HERTZ_C] * sqrt(depth) : 0;
        d->force[i] = rate * fmax(depth, 0);
        sum += d->force[i] * cosine;
        *stiffness += 1.5 * rate * cosine * cosine;
    }
    return sum;
}

static void side_rigid(struct wheelset_side *d, double *h_u, double *h_roll)
{
    const struct contact *c = &d->contact[0];

    d->z = c->height;
    d->radius = c->row[CTAB_RADIUS];
    *h_u = c->height_u;
    *h_roll = c->height_roll;
    for (int i = 0; i < d->n; i++)
        d->force[i] = 0;
}

/* Height at which the contacts carry `load`: Newton from where the first alone carries it.  The others only add, and the force is
 * convex in z, so each step is down and none goes too far. */
static void side_elastic(struct wheelset_side *d, double load, double *h_u, double *h_roll)
{
    const struct contact *c = d->contact;
    double stiffness, first = cos(c->row[CTAB_ANGLE]);
    double z = c->height + pow(load / (first * c->weight * c->row[CTAB_HERTZ_C]), 2.0 / 3) / first;

    for (int i = 0; i < 60; i++) {
        double step = (side_load(d, z, &stiffness) - load) / stiffness;
        z -= step;
        if (fabs(step) < EXACT)
            break;
    }
    side_load(d, z, &stiffness);
    d->z = z;
    d->radius = *h_u = *h_roll = 0;
    double sum = 0, held = 0;
    for (int i = 0; i < d->n; i++) {
        double cosine = cos(c[i].row[CTAB_ANGLE]), part = d->force[i] > 0 ? d->force[i] * cosine / (z - c[i].height) : 0;
        *h_u += part * c[i].height_u;
        *h_roll += part * c[i].height_roll;
        sum += part;
        d->radius += d->force[i] * c[i].row[CTAB_RADIUS];
        held += d->force[i];
    }
    *h_u /= sum;
    *h_roll /= sum;
    d->radius /= held;
}

/* One side at roll; its height in d->z, the height's total derivative by roll in *rate. */
static const char *side_rest(const struct ctab *t, double s, double yaw, double y, double roll, double load,
                             struct wheelset_side *d, double *rate)
{
    double h_u, h_roll;

    d->u = y - roll * t->radius;
    d->n = contact_lookup(t, s, yaw, d->u, roll, d->contact);
    if (d->n < 0)
        return reason("displacement %g m is beyond the table, %g to %g m", d->u, t->u[0], t->u[t->us - 1]);
    if (d->n == 0)
        return reason("no contact at station %g m, displacement %g m, yaw %g rad", s, d->u, yaw);
    if (load > 0)
        side_elastic(d, load, &h_u, &h_roll);
    else
        side_rigid(d, &h_u, &h_roll);
    *rate = h_roll - t->radius * h_u;
    return NULL;
}

/* f of the text above, and its derivative. */
static const char *imbalance(const struct ctab *const *t, double s, double yaw, double y, double roll, double load,
                             struct wheelset *w, double *f, double *slope)
{
    double rate[2], span = t[WHEELSET_RIGHT]->wheel_position - t[WHEELSET_LEFT]->wheel_position;
    const char *why = NULL;

    for (int i = 0; i < 2 && !why; i++)
        why = side_rest(t[i], s, yaw, y, roll, load, &w->side[i], &rate[i]);
    if (why)
        return why;
    *f = w->side[WHEELSET_RIGHT].z - w->side[WHEELSET_LEFT].z - roll * span;
    *f -= t[WHEELSET_RIGHT]->radius - t[WHEELSET_LEFT]->radius;
    *slope = rate[WHEELSET_RIGHT] - rate[WHEELSET_LEFT] - span;
    return NULL;
}

/* Roll of +-ROLL_MOST, less where a table ends before. */
static void roll_bracket(const struct ctab *const *t, double y, double *lo, double *hi)
{
    *lo = -ROLL_MOST;
    *hi = ROLL_MOST;
    for (int i = 0; i < 2; i++) {
        double most = (y - t[i]->u[0]) / t[i]->radius, least = (y - t[i]->u[t[i]->us - 1]) / t[i]->radius;
        *lo = least > *lo ? least : *lo;
        *hi = most < *hi ? most : *hi;
    }
}

const char *wheelset_rest(const struct ctab *left, const struct ctab *right, double s, double yaw, double y, double load,
                          int roll_free, struct wheelset *w)
{
    const struct ctab *const t[2] = {left, right};
    double lo, hi, f, slope, roll = 0;
    const char *why = imbalance(t, s, yaw, y, 0, load, w, &f, &slope);

    roll_bracket(t, y, &lo, &hi);
    const double first = lo, last = hi;
    for (int i = 0; i < 100 && !why && roll_free; i++) {
        *(f > 0 ? &lo : &hi) = roll;
        double next = roll - f / slope;
        if (!(next > lo && next < hi))
            next = 0.5 * (lo + hi);
        double step = next - roll;
        roll = next;
        why = imbalance(t, s, yaw, y, roll, load, w, &f, &slope);
        if (fabs(step) < EXACT || f == 0)
            break;
    }
    if (why)
        return why;
    if (roll_free && fabs(f) > LOOSE && fmin(roll - first, last - roll) < LOOSE)
        return reason("displacement %g m: no rest within the tables, which end at a roll of %g or %g rad", y, first, last);
    const struct wheelset_side *l = &w->side[WHEELSET_LEFT], *r = &w->side[WHEELSET_RIGHT];
    double b_l = left->wheel_position, b_r = right->wheel_position;
    w->roll = roll;
    w->z = (l->z * b_r - r->z * b_l) / (b_r - b_l);               /* the straight line between both sides at y = 0 */
    w->radius_difference = r->radius - l->radius;
    return NULL;
}

static void point_set(const struct wheelset *w, double y, struct wheelset_point *p)
{
    *p = (struct wheelset_point){.y = y, .z = w->z, .roll = w->roll, .radius_difference = w->radius_difference};
    for (int i = 0; i < 2; i++) {
        const double *row = w->side[i].contact[0].row;
        p->rail_y[i] = row[CTAB_RAIL_Y];
        p->wheel_y[i] = row[CTAB_WHEEL_Y];
        p->angle[i] = row[CTAB_ANGLE];
    }
}

const char *wheelset_sweep(const struct ctab *left, const struct ctab *right, double s, double yaw, double step, int roll_free,
                           struct wheelset_point *p, int64_t most, int64_t *n)
{
    int64_t reach = (most - 1) / 2, lo = 0, hi = 0;
    struct wheelset w;
    const char *why = wheelset_rest(left, right, s, yaw, 0, 0, roll_free, &w);

    if (why)
        return why;
    while (lo > -reach && !wheelset_rest(left, right, s, yaw, (double)(lo - 1) * step, 0, roll_free, &w))
        lo--;
    while (hi < reach && !wheelset_rest(left, right, s, yaw, (double)(hi + 1) * step, 0, roll_free, &w))
        hi++;
    *n = hi - lo + 1;
    for (int64_t k = lo; k <= hi; k++) {
        wheelset_rest(left, right, s, yaw, (double)k * step, 0, roll_free, &w);
        point_set(&w, (double)k * step, &p[k - lo]);
    }
    return NULL;
}
