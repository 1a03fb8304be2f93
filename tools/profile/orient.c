#include "tools/profile/orient.h"

#include <math.h>

#include "formats/reason.h"

#define EXTREMUM 0.2         /* of the height of a wheel: an extremum between the ends that is the flange */
#define CLEAR 3.0            /* times the opposite one */
#define CROWN 0.5e-3         /* m, of a rail's top above both ends */
#define HOLLOW 1e-3          /* m, of a rail below both ends: no crown */
#define GROOVE 5e-3          /* m, of a rail below both ends */
#define FLANGE 15e-3         /* m, height of a wheel that has a flange */
#define THIRD (1.0 / 3)
#define ALIKE 0.1e-3         /* m, between both sides of a rail */
#define LOWER 0.5e-3         /* m, of one corner below the other */
#define INSIDE 10e-3         /* m, from the side face to where the corner's height is taken */

/* mirror */
enum { UNKNOWN = PROF_MIRROR_UNSTATED, NO = PROF_MIRROR_NO, YES = PROF_MIRROR_YES };

struct extent {
    double first, last;      /* m, z of the ends */
    double least, most;      /* m, z */
    int64_t least_at, most_at;
    double left, right;      /* m, y */
};

static struct extent extent_of(const struct points *p)
{
    struct extent e = {p->z[0], p->z[p->n - 1], p->z[0], p->z[0], 0, 0, p->y[0], p->y[0]};

    for (int64_t i = 1; i < p->n; i++) {
        if (p->z[i] < e.least)
            e.least = p->z[e.least_at = i];
        if (p->z[i] > e.most)
            e.most = p->z[e.most_at = i];
        e.left = fmin(e.left, p->y[i]);
        e.right = fmax(e.right, p->y[i]);
    }
    return e;
}

/* Does z point up?  `down` and `up` are how far the shape passes both ends to either side. */
static int z_shown(const struct extent *e, int wheel)
{
    double down = e->most - fmax(e->first, e->last), up = fmin(e->first, e->last) - e->least, whole = EXTREMUM * (e->most - e->least);

    if (wheel)
        return down >= whole && down > CLEAR * up && down > 0 ? NO : up >= whole && up > CLEAR * down && up > 0 ? YES : UNKNOWN;
    if (up >= CROWN && down < HOLLOW && up > CLEAR * down)
        return NO;
    return down >= CROWN && up < HOLLOW && down > CLEAR * up ? YES : UNKNOWN;
}

static const char *z_settle(const struct points *p, const struct shape_kind *k, int stated, int wheel, struct orient *o)
{
    struct extent e = extent_of(p);
    int shown = z_shown(&e, wheel), usual = k->z_up ? YES : NO, mirror = stated;

    o->by_z = "stated";
    if (stated == UNKNOWN && shown != UNKNOWN) {
        mirror = shown;
        o->by_z = wheel ? "detected: the surface is deepest between its ends" : "detected: the crown rises above both ends";
        if (k->fixed && shown != usual)
            return wheel ? "the flange points up: state mirror_z" : "the surface is hollow where a rail has its top: no rail, else state mirror_z";
    }
    if (mirror == UNKNOWN && k->fixed) {
        mirror = usual;
        o->by_z = "the axes of its kind";
    }
    if (mirror == UNKNOWN)
        return wheel ? "whether z points up or down cannot be seen without a flange: state mirror_z"
                     : "whether z points up or down cannot be seen, no crown rises above both ends or there is a groove: state mirror_z";
    o->mirror_z = mirror == YES;
    double dip = o->mirror_z ? fmin(e.first, e.last) - e.least : e.most - fmax(e.first, e.last);
    return wheel || dip < GROOVE ? NULL : reason("the surface dips %.1f mm below both its ends: a groove, or two rails in one outline", 1e3 * dip);
}

/* ---- y of a wheel; z points down ---- */

/* Does y point towards the track's centre?  Unknown without a flange. */
static int wheel_y_shown(const struct points *p, const struct extent *e)
{
    double whole = e->most - e->least, part = (p->y[e->most_at] - e->left) / (e->right - e->left);

    if (whole < FLANGE || e->most - fmax(e->first, e->last) < EXTREMUM * whole)
        return UNKNOWN;
    return part < THIRD ? NO : part > 1 - THIRD ? YES : UNKNOWN;
}

/* ---- y of a rail; z points down ---- */

/* Height of the surface at y, from the top towards `step` (-1 or 1 by index); the height of the end beyond it. */
static double side_height(const struct points *p, int64_t top, int64_t step, double y)
{
    for (int64_t i = top; i + step >= 0 && i + step < p->n; i += step) {
        double a = p->y[i], b = p->y[i + step];
        if ((a <= y && y <= b) || (b <= y && y <= a))
            return a == b ? p->z[i] : p->z[i] + (y - a) / (b - a) * (p->z[i + step] - p->z[i]);
    }
    return p->z[step < 0 ? 0 : p->n - 1];
}

/* y of the side face at `depth` below the top; 0 where the side does not reach it. */
static int side_face(const struct points *p, int64_t top, int64_t step, double depth, double *y)
{
    double limit = p->z[top] + depth;

    for (int64_t i = top; i + step >= 0 && i + step < p->n; i += step)
        if (p->z[i + step] >= limit) {
            *y = p->y[i] + (limit - p->z[i]) / (p->z[i + step] - p->z[i]) * (p->y[i + step] - p->y[i]);
            return 1;
        }
    return 0;
}

struct sides { int low, high; double lower; double apart; };

/* Which sides reach the gauge depth, by y; how much lower the corner at low y is (m); the greatest difference of both sides (m). */
static struct sides sides_of(const struct points *p, int64_t top, double depth)
{
    int64_t up = p->y[p->n - 1] >= p->y[0] ? 1 : -1;
    double low, high;
    struct sides s = {side_face(p, top, -up, depth, &low), side_face(p, top, up, depth, &high), 0, 0};

    if (!s.low || !s.high)
        return s;
    double half = (high - low) / 2, middle = (high + low) / 2;
    int64_t start = top;
    while (start + up >= 0 && start + up < p->n && (p->y[start] - middle) < 0)
        start += up;
    while (start - up >= 0 && start - up < p->n && (p->y[start] - middle) > 0)
        start -= up;
    for (int i = 1; i < 20; i++) {
        double y = half * i / 20;
        s.apart = fmax(s.apart, fabs(side_height(p, start, -up, middle - y) - side_height(p, start, up, middle + y)));
    }
    s.lower = side_height(p, start, -up, low + INSIDE) - side_height(p, start, up, high - INSIDE);
    return s;
}

static const char *rail_y_settle(const struct points *p, const struct extent *e, const struct shape_kind *k, double depth,
                                 struct orient *o)
{
    struct sides s = sides_of(p, e->least_at, depth);
    double lower = k->y_to_centre ? -s.lower : s.lower;    /* the corner on the kind's gauge side */

    o->mirror_y = k->y_to_centre;
    o->by_y = "the axes of its kind";
    if (s.low != s.high) {
        if (k->fixed && s.high != k->y_to_centre)
            return reason("only the field side reaches the gauge depth of %.1f mm: state mirror_y", 1e3 * depth);
        o->mirror_y = s.high;
        o->by_y = "detected: only this side reaches the gauge depth";
    } else if (s.low && s.apart < ALIKE) {
        o->by_y = "detected: both sides are alike";
    } else if (!k->fixed && s.low && lower < LOWER) {
        return "which side of this rail is the gauge side cannot be seen: state mirror_y";
    } else if (!k->fixed && s.low) {
        o->by_y = "the axes of its kind, and the corner there is the lower one";
    }
    return NULL;
}

static const char *wheel_y_settle(const struct points *p, const struct extent *e, const struct shape_kind *k, struct orient *o)
{
    int shown = wheel_y_shown(p, e), usual = k->y_to_centre ? YES : NO;

    if (shown == UNKNOWN && !k->fixed)
        return "no flange shows which side faces the track's centre: state mirror_y";
    o->by_y = shown == UNKNOWN ? "the axes of its kind" : "detected: the flange lies towards the track's centre";
    o->mirror_y = (shown == UNKNOWN ? usual : shown) == YES;
    if (k->fixed && shown != UNKNOWN && shown != usual)
        return reason("the flange lies on the field side by the axes of %s: state mirror_y", k->name);
    return NULL;
}

static const char *y_settle(const struct points *p, const struct shape_kind *k, const struct prof_text *t, struct orient *o)
{
    struct extent e = extent_of(p);

    if (t->mirror_y != PROF_MIRROR_UNSTATED) {
        o->mirror_y = t->mirror_y == PROF_MIRROR_YES;
        o->by_y = "stated";
        return NULL;
    }
    return t->part == PROF_WHEEL ? wheel_y_settle(p, &e, k, o) : rail_y_settle(p, &e, k, t->gauge_depth, o);
}

/* ---- origin of a wheel; y points towards the field ---- */

/* Where the tip of a flange is from the running circle, and from its back. */
static const double tip_circle[2] = {-68e-3, -38e-3}, tip_back[2] = {5e-3, 30e-3}, back_at[2] = {-2e-3, 6e-3};

static int within(const double range[2], double x)
{
    return range[0] <= x && x <= range[1];
}

static const char *origin_settle(const struct points *p, const struct shape_kind *k, const struct prof_text *t, struct orient *o)
{
    struct extent e = extent_of(p);
    double tip = p->y[e.most_at];

    o->shift_y = t->shift_y;
    o->by_shift = t->shift_y != 0 ? "stated" : "none: its origin is taken as it is";
    if (t->part != PROF_WHEEL || t->shift_y != 0 || wheel_y_shown(p, &e) == UNKNOWN)
        return NULL;
    o->by_shift = "none: the flange tip lies as from the running circle";
    if (within(tip_circle, tip))
        return NULL;
    if (!k->from_back || !within(tip_back, tip) || !within(back_at, e.left))
        return reason("the flange tip lies at y = %.1f mm, from a running circle it would be -68 to -38: state shift_y", 1e3 * tip);
    o->shift_y = -t->flange_back;
    o->by_shift = "its kind counts y from the flange back";
    return NULL;
}

const char *orient_shape(struct shape *s, const struct prof_text *t, struct orient *o)
{
    struct points *p = &s->points;
    const char *why;

    *o = (struct orient){0};
    if ((why = z_settle(p, s->kind, t->mirror_z, t->part == PROF_WHEEL, o)))
        return why;
    for (int64_t i = 0; o->mirror_z && i < p->n; i++)
        p->z[i] = -p->z[i];
    if ((why = y_settle(p, s->kind, t, o)))
        return why;
    for (int64_t i = 0; o->mirror_y && i < p->n; i++)
        p->y[i] = -p->y[i];
    if ((why = origin_settle(p, s->kind, t, o)))
        return why;
    for (int64_t i = 0; i < p->n; i++)
        p->y[i] += o->shift_y;
    return NULL;
}
