/* Interpolation within contacts.
 *
 * The rows at the eight corners of the table's cell are joined to branches, branch.h.  A branch is the mean of its corners
 * by their trilinear weights, divided by their sum W; W itself is the branch's weight, so a branch that some corners lack fades in
 * and out continuously across the cell.  The height is exact to second order along each axis by its derivatives: a branch at both
 * ends of an edge gets half of each end's slope (the parabola through both), at one end its tangent.
 *
 * Roll carries the height to second order, d2(height)/d(roll)2 = -(1 + height_u^2) d(contact's y)/d(roll), and the place of the contact to
 * first.
 *
 * A call waits for memory twice: for five lines of it, the cell's and the nodes' first rows, and for a line for each corner of each branch, all
 * asked for at once. */
#include "tools/contact/lookup.h"

#include <math.h>
#include <string.h>

#include "tools/contact/clones.h"
#include "tools/contact/link.h"
#include "tools/contact/prefetch.h"

#define LEAST_WEIGHT 1e-12    /* what rounding leaves of a corner on the query's own node */
#define TANGENT_MOST 0.05     /* m of station a contact that ends goes on along its tangent */

enum { CORNERS = CTAB_CORNERS, ALL = (1 << CORNERS) - 1, AXES = CTAB_LINKS };

struct cell {
    const uint8_t *branch;          /* of the table, those of the cell */
    const float *before[CORNERS];   /* the row before the corner's first */
    unsigned in;                    /* bits of the corners that count */
    double weight[CORNERS];
    double per_s[CORNERS];          /* 1/m, derivative of the weight by station */
    int inside;                     /* between the first and the last station */
    double beyond;                  /* rad, of the yaw asked for, beyond the end at which the table holds it */
    double off[AXES][2];            /* m, rad, m from the lower and the upper end of the cell to the query */
};

/* The rows of a branch. */
struct branch {
    unsigned held;                  /* bits of the corners that it holds and that count */
    const float *row[CORNERS];      /* [CTAB_N] in the table; where not held, the same as one that is */
    double weight[CORNERS], per_s[CORNERS];      /* 0 where not held */
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

static void cell_find(const struct ctab *t, double s, double yaw, double u, struct cell *c)
{
    double ts, ty, tu;
    int64_t is = bracket(t->station, t->stations, s, &ts);
    int64_t iy = even_bracket(t->yaw, t->yaws, yaw, &ty);
    int64_t iu = even_bracket(t->u, t->us, u, &tu), node = (is * t->yaws + iy) * t->us + iu;
    const int inside = t->stations > 1 && s >= t->station[0] && s < t->station[t->stations - 1];
    double length = t->stations > 1 ? t->station[is + 1] - t->station[is] : 1, per_length = inside ? 1 / length : 0;
    double dy = t->yaws > 1 ? t->yaw[iy + 1] - t->yaw[iy] : 0, du = t->u[iu + 1] - t->u[iu];
    double across[4] = {(1 - tu) * (1 - ty), tu * (1 - ty), (1 - tu) * ty, tu * ty};

    for (int end = 0; end < 2; end++) {
        c->off[CTAB_LINK_U][end] = (tu - end) * du;
        c->off[CTAB_LINK_YAW][end] = (ty - end) * dy;
        c->off[CTAB_LINK_STATION][end] = (ts - end) * length;
    }
    c->branch = t->branch + (int64_t)t->cell[node] * CORNERS;
    c->inside = inside;
    c->in = 0;
    for (int k = 0; k < CORNERS; k++) {
        int at = k & 3, ahead = k >> 2;
        double ws = ahead ? ts : 1 - ts;
        int in = across[at] > 0 && (ws > 0 || (ahead && inside));     /* at a station the slope ahead still counts */
        int64_t further = (ahead ? t->yaws * t->us : 0) + (k >> 1 & 1 ? t->us : 0) + (k & 1);
        c->weight[k] = across[at] * ws;
        c->per_s[k] = ahead ? across[at] * per_length : -across[at] * per_length;
        c->before[k] = t->row + ((int64_t)t->first[in ? node + further : node] - 1) * CTAB_N;
        c->in |= (unsigned)in << k;
        PREFETCH(c->before[k] + CTAB_N);
    }
}

/* Is this the row of zeros after the branches of a cell? */
static int branch_end(const uint8_t of[CORNERS])
{
    uint64_t all;

    memcpy(&all, of, sizeof all);
    return all == 0;
}

/* 0 where none of the corners that count are held. */
static int branch_find(const struct cell *c, const uint8_t of[CORNERS], struct branch *b)
{
    int any = 0;

    b->held = 0;
    for (int k = 0; k < CORNERS; k++) {
        b->held |= (unsigned)(of[k] > 0) << k & c->in;
        b->row[k] = c->before[k] + of[k] * CTAB_N;
    }
    memcpy(b->weight, c->weight, sizeof b->weight);
    memcpy(b->per_s, c->per_s, sizeof b->per_s);
    if (b->held == ALL)
        return 1;
    while (any < CORNERS && !(b->held >> any & 1))
        any++;
    for (int k = 0; k < CORNERS; k++)
        if (!(b->held >> k & 1)) {
            b->row[k] = b->row[any % CORNERS];
            b->weight[k] = b->per_s[k] = 0;
        }
    return b->held != 0;
}

/* Sum of the columns of eight rows, some with weight 0, so that columns stay in lanes. */
CLONES static void rows_sum(const float *const r[CORNERS], const double w[CORNERS], double sum[restrict CTAB_N])
{
    for (int i = 0; i < CTAB_N; i++)
        sum[i] = ((w[0] * r[0][i] + w[1] * r[1][i]) + (w[2] * r[2][i] + w[3] * r[3][i])) +
                 ((w[4] * r[4][i] + w[5] * r[5][i]) + (w[6] * r[6][i] + w[7] * r[7][i]));
}

struct height { double z, by_station; };      /* m, 1 */

/* Sum of the heights of a branch's corners, carried to the query.  `held` says which corners have a neighbour along an axis. */
static inline struct height heights_sum(const struct cell *c, const struct branch *b, unsigned held)
{
    static const double part[2] = {1, 0.5};
    struct height o = {0, 0};

    for (int k = 0; k < CORNERS; k++) {
        const float *row = b->row[k];
        double part_s = part[held >> (k ^ 4) & 1], ds = c->off[CTAB_LINK_STATION][k >> 2], fall = link_fall(row), by_station = part_s * fall;
        if (part_s == 1 && fabs(ds) > TANGENT_MOST) {
            ds = copysign(TANGENT_MOST, ds);
            by_station = 0;
        }
        double z = row[CTAB_HEIGHT] + part[held >> (k ^ 1) & 1] * row[CTAB_HEIGHT_U] * c->off[CTAB_LINK_U][k & 1] +
                   part[held >> (k ^ 2) & 1] * row[CTAB_HEIGHT_YAW] * c->off[CTAB_LINK_YAW][k >> 1 & 1] + part_s * fall * ds;
        o.z += b->weight[k] * z;
        o.by_station += b->per_s[k] * z + (c->inside ? b->weight[k] * by_station : 0);
    }
    return o;
}

/* How far the yaw asked for is from the mean of the corners held. */
static double mean_off(const struct cell *c, const double share[CORNERS])
{
    double off = c->beyond;

    for (int k = 0; k < CORNERS; k++)
        off += share[k] * c->off[CTAB_LINK_YAW][k >> 1 & 1];
    return off;
}

/* Mean of a branch over its corners, at roll 0; 0 where it has no weight. */
static int blend(const struct ctab *t, const struct cell *c, const uint8_t of[CORNERS], struct contact *o)
{
    struct branch b;
    double W = 1, W_s = 0;

    if (!branch_find(c, of, &b))
        return 0;
    const int whole = b.held == c->in;
    struct height h = whole ? heights_sum(c, &b, ALL) : heights_sum(c, &b, b.held);
    if (!whole) {
        W = 0;
        for (int k = 0; k < CORNERS; k++) {
            W += b.weight[k];
            W_s += b.per_s[k];
        }
        if (!(W > LEAST_WEIGHT))
            return 0;
    }
    const double per_W = 1 / W;
    o->weight = W;
    for (int k = 0; k < CORNERS; k++) {
        o->at[k] = (b.row[k] - t->row) / CTAB_N;
        o->share[k] = b.weight[k] * per_W;
    }
    rows_sum(b.row, o->share, o->row);
    o->height = h.z * per_W;
    o->height_s = (h.by_station - o->height * W_s) * per_W;
    o->height_yaw = o->row[CTAB_HEIGHT_YAW] - o->height_s * t->wheel_position;
    if (!whole || c->beyond != 0)                                   /* x holds -y tan(yaw), of the mean yaw of the corners held */
        o->row[CTAB_X] -= t->wheel_position * mean_off(c, o->share);
    o->row[CTAB_BODY] = t->body[o->at[0]];
    return 1;
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

struct ctab contact_turn(const struct ctab *t)
{
    struct ctab o = *t;

    o.side = t->side == 'l' ? 'r' : 'l';
    o.rail_position = -t->rail_position;
    o.wheel_position = -t->wheel_position;
    o.turned = t;
    o.store = NULL;
    o.row_store = o.rest_store = NULL;
    o.body_store = NULL;
    return o;
}

/* Lateral and longitudinal places and slopes change their sign; what yaw does along them does not. */
static void turn_back(struct contact *c)
{
    static const enum ctab_column sign[] = {CTAB_HEIGHT_U, CTAB_HEIGHT_S, CTAB_HEIGHT_ROLL, CTAB_RAIL_Y, CTAB_WHEEL_Y, CTAB_X, CTAB_ANGLE};

    for (size_t i = 0; i < sizeof sign / sizeof *sign; i++)
        c->row[sign[i]] = -c->row[sign[i]];
    c->height_u = -c->height_u;
    c->height_s = -c->height_s;
    c->height_roll = -c->height_roll;
}

static int lookup_turned(const struct ctab *t, double s, double yaw, double u, double roll, struct contact *c)
{
    const int n = contact_lookup(t, -s, yaw, -u, -roll, c);

    for (int i = 0; i < n; i++)
        turn_back(&c[i]);
    return n;
}

int contact_lookup(const struct ctab *t, double s, double yaw, double u, double roll, struct contact *c)
{
    struct cell cell;
    int n = 0;

    if (t->turned)
        return lookup_turned(t->turned, s, yaw, u, roll, c);
    if (!(u >= t->u[0] && u <= t->u[t->us - 1]))
        return -1;
    double held = yaw < t->yaw[0] ? t->yaw[0] : yaw > t->yaw[t->yaws - 1] ? t->yaw[t->yaws - 1] : yaw;
    cell_find(t, s - t->wheel_position * yaw * (1 - yaw * yaw / 6), held, u, &cell);      /* sin: yaw is small */
    cell.beyond = yaw - held;
    for (const uint8_t *of = cell.branch; n < CONTACT_MAX && !branch_end(of); of += CORNERS) {
        if (!blend(t, &cell, of, &c[n]))
            continue;
        turn(&c[n], yaw, roll);
        for (int i = n++; i > 0 && c[i - 1].height > c[i].height; i--) {
            struct contact lower = c[i];
            c[i] = c[i - 1];
            c[i - 1] = lower;
        }
    }
    return n;
}

void contact_complete(const struct ctab *t, struct contact *c)
{
    for (int i = 0; i < CTAB_REST; i++) {
        c->row[CTAB_N + i] = 0;
        for (int k = 0; k < CORNERS; k++)
            c->row[CTAB_N + i] += c->share[k] * t->rest[c->at[k] * CTAB_REST + i];
    }
}
