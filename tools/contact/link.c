/* A contact goes on in that of the next node which lies nearest on the wheel and in height, on the same rail body and not further off on the
 * wheel than a patch is wide; at the next station only where the falls of both lead from one height to the other.  Pairs are made nearest
 * first, so no row goes on in two or is continued by two.
 *
 * Identity is a relation between neighbours, no number of its own: where two minima of the gap merge (the fold of the table over u and
 * yaw at which tread and flange contact become one) a walk around the fold leads from one to the other. */
#include "tools/contact/link.h"

#include <math.h>

#include "tools/contact/gap.h"

/* m, on the wheel.  As far as minima are kept apart; from station to station the edge of a wing rail moves 6 mm in 0.1 m. */
static const double reach[CTAB_LINKS] = {[CTAB_LINK_U] = GAP_APART, [CTAB_LINK_YAW] = GAP_APART, [CTAB_LINK_STATION] = 8e-3};

#define OFF_MOST 5e-4         /* m, between a contact's height at the next station and where its falls lead */

/* How far (m) the height of b is from that of a, or, at a station `length` (m) further on, from where the falls of both lead. */
static double height_off(const float *a, const float *b, enum ctab_link axis, double length)
{
    double rise = axis == CTAB_LINK_STATION ? 0.5 * (link_fall(a) + link_fall(b)) * length : 0;

    return fabs((double)b[CTAB_HEIGHT] - (double)a[CTAB_HEIGHT] - rise);
}

/* The n rows from `from` on of a node, their links link[n][CTAB_LINKS], the m rows from `to` on of the next one; stations are `length` (m)
 * apart. */
static void link_nodes(const struct ctab *t, int64_t from, uint8_t *link, int n, int64_t to, int m, enum ctab_link axis, double length)
{
    unsigned taken = 0;

    for (int pairs = n < m ? n : m; pairs > 0; pairs--) {
        double best = INFINITY;
        int i_best = -1, j_best = -1;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < m && !link[i * CTAB_LINKS + axis]; j++) {
                const float *a = t->row + (from + i) * CTAB_N, *b = t->row + (to + j) * CTAB_N;
                double aside = fabs((double)a[CTAB_WHEEL_Y] - (double)b[CTAB_WHEEL_Y]), off = height_off(a, b, axis, length);
                int may = t->body[from + i] == t->body[to + j] && !(taken >> j & 1) && (axis != CTAB_LINK_STATION || off < OFF_MOST);
                double far = aside + off;
                if (may && aside < reach[axis] && far < best) {
                    best = far;
                    i_best = i;
                    j_best = j;
                }
            }
        if (i_best < 0)
            return;
        link[i_best * CTAB_LINKS + axis] = (uint8_t)(j_best + 1);
        taken |= 1u << j_best;
    }
}

void link_rows(const struct ctab *t, uint8_t *link)
{
    for (int64_t is = 0; is < t->stations; is++)
        for (int64_t iy = 0; iy < t->yaws; iy++)
            for (int64_t iu = 0; iu < t->us; iu++) {
                double length = is + 1 < t->stations ? t->station[is + 1] - t->station[is] : 0;
                const int64_t next[CTAB_LINKS][3] = {{is, iy, iu + 1}, {is, iy + 1, iu}, {is + 1, iy, iu}};
                int64_t node = (is * t->yaws + iy) * t->us + iu, from = t->first[node];
                int n = t->first[node + 1] - t->first[node];
                for (enum ctab_link axis = 0; axis < CTAB_LINKS; axis++) {
                    const int64_t *at = next[axis];
                    if (at[0] == t->stations || at[1] == t->yaws || at[2] == t->us)
                        continue;
                    node = (at[0] * t->yaws + at[1]) * t->us + at[2];
                    link_nodes(t, from, link + from * CTAB_LINKS, n, t->first[node], t->first[node + 1] - t->first[node], axis, length);
                }
            }
}
