/* Interpolation within branches of contact.
 *
 * The rows at the eight corners of the table's cell are joined to branches: rows of one body whose place on the wheel differs by
 * less than BRANCH at one station, by less than STATION_BRANCH from one station to the next.  A branch is the mean of its corners
 * by their trilinear weights, divided by their sum W; W itself is the branch's weight, so a branch that some corners lack fades in
 * and out continuously across the cell.  Along u the height is exact to second order: a branch at both ends of an edge gets half of
 * each end's slope (the parabola through both), at one end its tangent.
 *
 * Roll carries the height to second order, d2(height)/d(roll)2 = -(1 + height_u^2) d(contact's y)/d(roll), and the place of the contact to
 * first. */
#include "tools/contact/lookup.h"

#include <math.h>

#define BRANCH 4e-3           /* m, as search.h keeps minima apart */
#define STATION_BRANCH 8e-3   /* m; the edge of a wing rail moves 6 mm between sections 0.1 m apart */

#define LEAST_WEIGHT 1e-12    /* what rounding leaves of a corner on the query's own node */

enum { CORNERS = 8 };         /* bit 0 u, bit 1 yaw, bit 2 station */

struct cell {
    const double *row[CORNERS];     /* [count][CTAB_N] */
    int count[CORNERS];
    double weight[CORNERS];
    double u[CORNERS];              /* m, from the corner to the query */
    double per_s[CORNERS];          /* 1/m, derivative of the weight by station */
};

struct branch {
    int held;                       /* bits of corners */
    int rows, station;              /* of the corners joined last: how many, and at which station of the two */
    double wheel_y, body;           /* mean place of those rows */
    const double *row[CORNERS];
};

/* i and t of x between a[i] and a[i + 1]; t = 0 at or before the first, 1 at or beyond the last. */
static int64_t bracket(const double *a, int64_t n, double x, double *t)
{
    int64_t lo = 0, hi = n - 1;

    *t = 0;
    if (n == 1 || !(x > a[0]))
        return 0;
    if (x >= a[hi]) {
        *t = 1;
        return hi - 1;
    }
    while (hi - lo > 1) {
        int64_t mid = (lo + hi) / 2;
        *(a[mid] <= x ? &lo : &hi) = mid;
    }
    *t = (x - a[lo]) / (a[hi] - a[lo]);
    return lo;
}

/* The same on an even axis. */
static int64_t even_bracket(const double *a, int64_t n, double x, double *t)
{
    *t = 0;
    if (n == 1 || !(x > a[0]))
        return 0;
    double at = (x - a[0]) / (a[n - 1] - a[0]) * (double)(n - 1);
    int64_t i = at < (double)(n - 1) ? (int64_t)at : n - 2;
    *t = at - (double)i < 1 ? at - (double)i : 1;
    return i;
}

static void cell_corners(const struct ctab *t, double s, double yaw, double u, struct cell *c)
{
    double ts, ty, tu;
    int64_t is = bracket(t->station, t->stations, s, &ts);
    int64_t iy = even_bracket(t->yaw, t->yaws, yaw, &ty);
    int64_t iu = even_bracket(t->u, t->us, u, &tu);
    int inside = t->stations > 1 && s >= t->station[0] && s < t->station[t->stations - 1];
    double per_s = inside ? 1 / (t->station[is + 1] - t->station[is]) : 0;

    for (int k = 0; k < CORNERS; k++) {
        int bu = k & 1, by = k >> 1 & 1, bs = k >> 2;
        double wu = bu ? tu : 1 - tu, wy = by ? ty : 1 - ty, ws = bs ? ts : 1 - ts;
        c->weight[k] = wu * wy * ws;
        c->count[k] = 0;
        if (!(wu * wy > 0) || !(ws > 0 || (inside && bs)))        /* at a station the slope ahead still counts */
            continue;
        int64_t node = ((is + bs) * t->yaws + iy + by) * t->us + iu + bu;
        c->count[k] = t->count[node];
        c->row[k] = t->contact + node * t->slots * CTAB_N;
        c->u[k] = u - t->u[iu + bu];
        c->per_s[k] = (bs ? per_s : -per_s) * wu * wy;
    }
}

/* Joins the rows of corner k to the branches, nearest first; rows left over begin branches of their own. */
static int join_corner(const struct cell *c, int k, struct branch *b, int n)
{
    unsigned left = (1u << c->count[k]) - 1;
    int old = n, station = k >> 2;

    while (left) {
        double best = STATION_BRANCH;
        int at = -1, from = -1;
        for (int i = 0; i < c->count[k]; i++)
            for (int j = 0; j < old && left >> i & 1; j++) {
                const double *row = c->row[k] + i * CTAB_N;
                double far = fabs(row[CTAB_WHEEL_Y] - b[j].wheel_y);
                if (far < (b[j].station == station ? fmin(best, BRANCH) : best) && row[CTAB_BODY] == b[j].body &&
                    !(b[j].held >> k & 1)) {
                    best = far;
                    at = j;
                    from = i;
                }
            }
        if (at < 0)
            break;
        const double *row = c->row[k] + from * CTAB_N;
        if (b[at].station != station) {
            b[at].station = station;
            b[at].rows = 0;
        }
        b[at].wheel_y += (row[CTAB_WHEEL_Y] - b[at].wheel_y) / ++b[at].rows;
        b[at].held |= 1 << k;
        b[at].row[k] = row;
        left &= ~(1u << from);
    }
    for (int i = 0; i < c->count[k] && n < CONTACT_MAX; i++)
        if (left >> i & 1) {
            const double *row = c->row[k] + i * CTAB_N;
            b[n] = (struct branch){.held = 1 << k, .rows = 1, .station = station, .wheel_y = row[CTAB_WHEEL_Y], .body = row[CTAB_BODY]};
            b[n++].row[k] = row;
        }
    return n;
}

/* Mean of a branch over its corners, at roll 0. */
static void blend(const struct cell *c, const struct branch *b, struct contact *o)
{
    double W = 0, W_s = 0, h = 0, h_s = 0, sum[CTAB_N] = {0};

    for (int k = 0; k < CORNERS; k++) {
        if (!(b->held >> k & 1))
            continue;
        const double *row = b->row[k];
        double w = c->weight[k], part = b->held >> (k ^ 1) & 1 ? 0.5 : 1;
        double height = row[CTAB_HEIGHT] + part * row[CTAB_HEIGHT_U] * c->u[k];
        W += w;
        W_s += c->per_s[k];
        h += w * height;
        h_s += c->per_s[k] * height;
        for (int i = 0; i < CTAB_N; i++)
            sum[i] += w * row[i];
    }
    o->weight = W;
    if (!(W > 0))
        return;
    for (int i = 0; i < CTAB_N; i++)
        o->row[i] = sum[i] / W;
    o->height = h / W;
    o->height_s = (h_s - o->height * W_s) / W;
    o->row[CTAB_BODY] = b->body;
}

/* Carries a contact from roll 0 to roll.  The wheel's own slope, angle less roll, sets how far ahead it touches. */
static void turn(struct contact *o, double yaw, double roll)
{
    double *row = o->row, t = row[CTAB_HEIGHT_U], bend = (1 + t * t) * row[CTAB_ROLL_Y];
    double y = row[CTAB_ROLL_Y] * roll, on_wheel = y + (row[CTAB_RAIL_Z] - row[CTAB_HEIGHT]) * roll;
    double angle = row[CTAB_RAIL_K] * sqrt(1 + t * t) * y;

    o->height += (row[CTAB_HEIGHT_ROLL] - 0.5 * bend * roll) * roll;
    o->height_u = t;
    o->height_roll = row[CTAB_HEIGHT_ROLL] - bend * roll;
    row[CTAB_RAIL_Y] += y;
    row[CTAB_RAIL_Z] += t * y;
    row[CTAB_WHEEL_Y] += on_wheel;
    row[CTAB_RADIUS] += t * on_wheel;
    row[CTAB_ANGLE] += angle;
    row[CTAB_X] -= yaw * (on_wheel + row[CTAB_RADIUS] * (1 + t * t) * (angle - roll));
    row[CTAB_HEIGHT] = o->height;
    row[CTAB_HEIGHT_ROLL] = o->height_roll;
}

int contact_lookup(const struct ctab *t, double s, double yaw, double u, double roll, struct contact *c)
{
    struct cell cell;
    struct branch branch[CONTACT_MAX];
    int branches = 0, n = 0;

    if (!(u >= t->u[0] && u <= t->u[t->us - 1]))
        return -1;
    yaw = fmax(t->yaw[0], fmin(yaw, t->yaw[t->yaws - 1]));
    cell_corners(t, s, yaw, u, &cell);
    for (int k = 0; k < CORNERS; k++)
        if (cell.count[k])
            branches = join_corner(&cell, k, branch, branches);
    for (int j = 0; j < branches; j++) {
        struct contact one;
        blend(&cell, &branch[j], &one);
        if (!(one.weight > LEAST_WEIGHT))
            continue;
        turn(&one, yaw, roll);
        int i = n++;
        for (; i > 0 && c[i - 1].height > one.height; i--)
            c[i] = c[i - 1];
        c[i] = one;
    }
    return n;
}
