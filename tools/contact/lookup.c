/* Interpolation within contacts.
 *
 * The rows at the eight corners of the table's cell are joined to branches along the table's links.  A branch is the mean of its corners
 * by their trilinear weights, divided by their sum W; W itself is the branch's weight, so a branch that some corners lack fades in
 * and out continuously across the cell.  The height is exact to second order along each axis by its derivatives: a branch at both
 * ends of an edge gets half of each end's slope (the parabola through both), at one end its tangent.
 *
 * Roll carries the height to second order, d2(height)/d(roll)2 = -(1 + height_u^2) d(contact's y)/d(roll), and the place of the contact to
 * first. */
#include "tools/contact/lookup.h"

#include <math.h>

#include "tools/contact/clones.h"
#include "tools/contact/link.h"

#define LEAST_WEIGHT 1e-12    /* what rounding leaves of a corner on the query's own node */
#define TANGENT_MOST 0.05     /* m of station a contact that ends goes on along its tangent */

enum { CORNERS = 8, AXES = CTAB_LINKS };      /* bit 0 of a corner u, bit 1 yaw, bit 2 station */

struct cell {
    int64_t first[CORNERS];         /* row */
    int count[CORNERS];
    unsigned in;                    /* bits of the corners that count */
    double weight[CORNERS];
    double per_s[CORNERS];          /* 1/m, derivative of the weight by station */
    int inside;                     /* between the first and the last station */
    double beyond;                  /* rad, of the yaw asked for, beyond the end at which the table holds it */
    double off[AXES][2];            /* m, rad, m from the lower and the upper end of the cell to the query */
};

struct branch {
    unsigned held;                  /* bits of corners */
    int64_t row[CORNERS];
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
    const int inside = t->stations > 1 && s >= t->station[0] && s < t->station[t->stations - 1];
    double length = t->stations > 1 ? t->station[is + 1] - t->station[is] : 1, per_length = inside ? 1 / length : 0;
    double dy = t->yaws > 1 ? t->yaw[iy + 1] - t->yaw[iy] : 0, du = t->u[iu + 1] - t->u[iu];
    double across[4] = {(1 - tu) * (1 - ty), tu * (1 - ty), (1 - tu) * ty, tu * ty};

    for (int end = 0; end < 2; end++) {
        c->off[CTAB_LINK_U][end] = (tu - end) * du;
        c->off[CTAB_LINK_YAW][end] = (ty - end) * dy;
        c->off[CTAB_LINK_STATION][end] = (ts - end) * length;
    }
    c->inside = inside;
    c->in = 0;
    for (int k = 0; k < CORNERS; k++) {
        int at = k & 3, ahead = k >> 2;
        int64_t node = ((is + ahead) * t->yaws + iy + (k >> 1 & 1)) * t->us + iu + (k & 1);
        double ws = ahead ? ts : 1 - ts;
        int in = across[at] > 0 && (ws > 0 || (ahead && inside));     /* at a station the slope ahead still counts */
        c->weight[k] = across[at] * ws;
        c->per_s[k] = ahead ? across[at] * per_length : -across[at] * per_length;
        c->first[k] = in ? t->first[node] : 0;
        c->count[k] = in ? t->first[node + 1] - t->first[node] : 0;
        c->in |= (unsigned)in << k;
    }
}

/* Branches of a cell, and the branch of each row of its corners. */
struct joined {
    struct branch branch[CORNERS * CTAB_MOST];
    int n;
    uint8_t of[CORNERS][CTAB_MOST];
};

enum { NO_BRANCH = 255 };

static void join_row(struct joined *o, int k, int i, int64_t row, int branch)
{
    o->of[k][i] = (uint8_t)branch;
    o->branch[branch].held |= 1u << k;
    o->branch[branch].row[k] = row;
}

/* Two branches that a row belongs to both become one, the rows of `from` those of `to`. */
static void join_branches(struct joined *o, const struct cell *c, int to, int from)
{
    for (int k = 0; k < CORNERS; k++)
        if (o->branch[from].held >> k & 1)
            join_row(o, k, (int)(o->branch[from].row[k] - c->first[k]), o->branch[from].row[k], to);
    o->branch[from].held = 0;
}

/* Row i of corner k goes on with a branch that holds the corner before it. */
static void join_linked(struct joined *o, const struct cell *c, int k, int i, int branch)
{
    int own = o->of[k][i];

    if (own == NO_BRANCH && !(o->branch[branch].held >> k & 1))
        join_row(o, k, i, c->first[k] + i, branch);
    else if (own != NO_BRANCH && own != branch && !(o->branch[own].held & o->branch[branch].held))
        join_branches(o, c, own, branch);
}

/* Rows of corner k: each goes on with the branch whose row at a corner before links to it, or begins one. */
static void join_corner(const struct ctab *t, const struct cell *c, int k, struct joined *o)
{
    for (int i = 0; i < c->count[k]; i++)
        o->of[k][i] = NO_BRANCH;
    for (int axis = 0; axis < AXES; axis++) {
        int before = k ^ 1 << axis;
        if (before > k)
            continue;
        const uint8_t *link = t->link + c->first[before] * CTAB_LINKS + axis;
        for (int j = 0; j < c->count[before]; j++) {
            int i = link[j * CTAB_LINKS] - 1;
            if (i >= 0 && i < c->count[k])
                join_linked(o, c, k, i, o->of[before][j]);
        }
    }
    for (int i = 0; i < c->count[k]; i++)
        if (o->of[k][i] == NO_BRANCH) {
            o->branch[o->n].held = 0;
            join_row(o, k, i, c->first[k] + i, o->n++);
        }
}

/* The usual cell: all corners that count have as many rows, and each goes on with its like.  0 where it is not so. */
static int join_plain(const struct ctab *t, const struct cell *c, struct joined *o)
{
    int n = -1;

    for (int k = 0; k < CORNERS; k++) {
        const uint8_t *link = t->link + c->first[k] * CTAB_LINKS;
        if (!(c->in >> k & 1))
            continue;
        if (n >= 0 && c->count[k] != n)
            return 0;
        n = c->count[k];
        for (int axis = 0; axis < AXES; axis++)
            if (!(k >> axis & 1) && c->in >> (k | 1 << axis) & 1)
                for (int i = 0; i < n; i++)
                    if (link[i * CTAB_LINKS + axis] != i + 1)
                        return 0;
    }
    for (int i = 0; i < n; i++) {
        o->branch[i].held = c->in;
        for (int k = 0; k < CORNERS; k++)
            o->branch[i].row[k] = c->first[k] + i;
    }
    o->n = n;
    return 1;
}

static void join(const struct ctab *t, const struct cell *c, struct joined *o)
{
    if (join_plain(t, c, o))
        return;
    o->n = 0;
    for (int k = 0; k < CORNERS; k++)
        if (c->count[k])
            join_corner(t, c, k, o);
}

/* Height of a corner's row carried to the query, and its derivative by station. */
static double carried(const struct cell *c, const struct branch *b, int k, const float *row, double *by_station)
{
    static const double part[2] = {1, 0.5};
    double part_s = part[b->held >> (k ^ 4) & 1], ds = c->off[CTAB_LINK_STATION][k >> 2];
    double fall = link_fall(row);

    *by_station = c->inside ? part_s * fall : 0;
    if (part_s == 1 && fabs(ds) > TANGENT_MOST) {
        ds = copysign(TANGENT_MOST, ds);
        *by_station = 0;
    }
    return row[CTAB_HEIGHT] + part[b->held >> (k ^ 1) & 1] * row[CTAB_HEIGHT_U] * c->off[CTAB_LINK_U][k & 1] +
           part[b->held >> (k ^ 2) & 1] * row[CTAB_HEIGHT_YAW] * c->off[CTAB_LINK_YAW][k >> 1 & 1] + part_s * fall * ds;
}

/* sum[CTAB_N] of the rows of the corners held, weighed.  All eight are added, some with weight 0, so that the columns stay in lanes: the row
 * of corner `held` stands for those that are not. */
CLONES static void blend_rows(const struct ctab *t, const struct branch *b, int held, const double weight[CORNERS], double *restrict sum)
{
    const float *r[CORNERS];
    double w[CORNERS];

    for (int k = 0; k < CORNERS; k++) {
        int in = b->held >> k & 1;
        r[k] = t->row + b->row[in ? k : held] * CTAB_N;
        w[k] = in ? weight[k] : 0;
    }
    for (int i = 0; i < CTAB_N; i++)
        sum[i] = ((w[0] * r[0][i] + w[1] * r[1][i]) + (w[2] * r[2][i] + w[3] * r[3][i])) +
                 ((w[4] * r[4][i] + w[5] * r[5][i]) + (w[6] * r[6][i] + w[7] * r[7][i]));
}

/* How far the yaw asked for is from the mean of the corners held. */
static double mean_off(const struct cell *c, const struct branch *b, const double share[CORNERS])
{
    double off = c->beyond;

    for (int k = 0; k < CORNERS; k++)
        if (b->held >> k & 1)
            off += share[k] * c->off[CTAB_LINK_YAW][k >> 1 & 1];
    return off;
}

/* Mean of a branch over its corners, at roll 0. */
static void blend(const struct ctab *t, const struct cell *c, const struct branch *b, struct contact *o)
{
    double W = 0, W_s = 0, h = 0, h_s = 0, share[CORNERS];
    int held = 0;

    for (int k = 0; k < CORNERS; k++) {
        if (!(b->held >> k & 1))
            continue;
        const float *row = t->row + b->row[k] * CTAB_N;
        double w = c->weight[k], by_station, height = carried(c, b, k, row, &by_station);
        W += w;
        W_s += c->per_s[k];
        h += w * height;
        h_s += c->per_s[k] * height + w * by_station;
        held = k;
    }
    o->weight = W;
    if (!(W > 0))
        return;
    const double per_W = 1 / W;
    for (int k = 0; k < CORNERS; k++)
        share[k] = c->weight[k] * per_W;
    blend_rows(t, b, held, share, o->row);
    o->height = h * per_W;
    o->height_s = (h_s - o->height * W_s) * per_W;
    o->height_yaw = o->row[CTAB_HEIGHT_YAW] - o->height_s * t->wheel_position;
    if (b->held != c->in || c->beyond != 0)                         /* x holds -y tan(yaw), of the mean yaw of the corners held */
        o->row[CTAB_X] -= t->wheel_position * mean_off(c, b, share);
    o->row[CTAB_BODY] = t->row[b->row[held] * CTAB_N + CTAB_BODY];
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
    struct joined joined;
    int n = 0;

    if (!(u >= t->u[0] && u <= t->u[t->us - 1]))
        return -1;
    double held = yaw < t->yaw[0] ? t->yaw[0] : yaw > t->yaw[t->yaws - 1] ? t->yaw[t->yaws - 1] : yaw;
    cell_corners(t, s - t->wheel_position * yaw * (1 - yaw * yaw / 6), held, u, &cell);    /* sin: yaw is small */
    cell.beyond = yaw - held;
    join(t, &cell, &joined);
    for (int j = 0; j < joined.n; j++) {
        if (!joined.branch[j].held || n == CONTACT_MAX)
            continue;
        blend(t, &cell, &joined.branch[j], &c[n]);
        if (!(c[n].weight > LEAST_WEIGHT))
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
