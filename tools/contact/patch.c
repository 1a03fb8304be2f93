/* With phi the slope angle of the plane of contact, a point of the rail dy, dz away lies at dy cos(phi) + dz sin(phi) along the plane, and
 * a wheel of slope s a vertical distance g above it lies
 *
 *     g/(cos(phi) + s sin(phi))
 *
 * away along the normal; a bend along the track in the plane y = const becomes A = bend/(2 (cos(phi) + s sin(phi))). */
#include "tools/contact/patch.h"

#include <math.h>

#define NEAR 1.5             /* semi-axes to either side that count as the patch */
#define FAR 0.015            /* m, within which another part of the patch is looked for */
#define FAR_NODES 5          /* from one look to the next */
#define NEAR_LOOKS 30        /* about as many looks at the patch */
#define ALL 0.02             /* m */
#define OWN_STRIPS 48
#define UPRIGHT 0.2          /* of cos(phi) + s sin(phi): a wheel that rises more steeply from the plane is no part of the patch */
#define DEEPER 3.0           /* times the depth, where the patch filled the strips */

struct frame {
    const struct gap_pair *p;
    const struct gap_minimum *m;
    int64_t off;             /* wheel's index of the rail's node 0 */
    double z0;               /* m, of the rail at the contact */
    double c, s;             /* cos, sin of the contact angle */
};

static int frame_make(const struct gap_pair *p, const struct gap_minimum *m, struct frame *f)
{
    struct gap_place here;

    if (m->end || !gap_at(p, m->y, &here))
        return 0;
    double c = 1 / sqrt(1 + m->slope * m->slope);
    *f = (struct frame){p, m, p->rail->first - p->wheel->first - p->shift, here.z, c, c * m->slope};
    return 1;
}

/* Nodes of the rail within `reach` (m) of the contact that both curves have. */
static void frame_nodes(const struct frame *f, double reach, int64_t *lo, int64_t *hi)
{
    const struct gap_curve *r = f->p->rail, *w = f->p->wheel;
    double at = f->m->y / f->p->step - (double)r->first, nodes = reach / f->p->step;
    int64_t last = r->n - 1 < w->n - 1 - f->off ? r->n - 1 : w->n - 1 - f->off;

    *lo = (int64_t)fmax(ceil(at - nodes), f->off < 0 ? (double)-f->off : 0);
    *hi = (int64_t)fmin(floor(at + nodes), (double)last);
}

/* Gap (m) and place (m) of the rail's node i; NaN where there is none. */
static double node_gap(const struct frame *f, int64_t i, double *y)
{
    const struct gap_curve *r = f->p->rail, *w = f->p->wheel;
    int64_t j = i + f->off;
    double g = gap_node(r, w, i, j) - f->m->gap;

    *y = ((double)(r->first + i) * f->p->step - f->m->y) * f->c + (r->z[i] - f->z0) * f->s;
    double turn = f->c + w->slope[j] * f->s;
    return turn > UPRIGHT ? g / turn : (double)NAN;
}

/* Sum of |depth - parabola's| over the nodes lo .. hi, every `stride`. */
static double near_looks(const struct frame *f, int64_t lo, int64_t hi, int64_t stride, double B, double depth)
{
    double sum = 0, y;

    for (int64_t i = lo; i <= hi; i += stride) {
        double g = node_gap(f, i, &y), d = depth - (g < 0 ? 0 : g), parabola = depth - B * y * y;
        double width = f->c + f->p->rail->slope[i] * f->s;        /* NaN where nothing covers the node */
        d = d > 0 ? d : 0;
        parabola = parabola > 0 ? parabola : 0;
        sum += width > 0 ? fabs(d - parabola) * width : 0;
    }
    return sum * (double)stride * f->p->step;
}

/* Sum of depth in other parts of the patch, beyond where the gap exceeds the approach, from node `from` outwards to `to`.  The surface is hardly bent
 * there: depth is 0 where the gap is the approach, and that of the contact where the gap is 0. */
static double far_looks(const struct frame *f, int64_t from, int64_t to, double depth, double approach)
{
    const struct gap_curve *r = f->p->rail, *w = f->p->wheel;
    int64_t way = to < from ? -1 : 1;
    double sum = 0;
    int beyond = 0;

    for (int64_t i = from; (to - i) * way >= 0; i += way * FAR_NODES) {
        double g = gap_node(r, w, i, i + f->off) - f->m->gap;
        double turn = f->c + w->slope[i + f->off] * f->s, width = f->c + r->slope[i] * f->s;
        beyond |= g >= approach * turn;
        if (beyond && width > 0 && turn > UPRIGHT && g < approach * turn)
            sum += depth * (1 - fmax(g / (turn * approach), 0)) * width;
    }
    return sum * FAR_NODES * f->p->step;
}

double patch_deviation(const struct gap_pair *p, const struct gap_minimum *m, double B, const struct hertz *h, double load)
{
    double b = h->b1 * cbrt(load), depth = fmax(B, HERTZ_FLATTEST) * b * b;
    struct frame f;
    int64_t lo, hi, first, last;

    if (!frame_make(p, m, &f))
        return 1;
    frame_nodes(&f, NEAR * b * f.c, &lo, &hi);
    frame_nodes(&f, fmax(FAR, NEAR * b * f.c), &first, &last);
    int64_t stride = (hi - lo) / NEAR_LOOKS + 1;
    double approach = cbrt(load / h->C * load / h->C);
    double sum = near_looks(&f, lo, hi, stride, depth / (b * b), depth);
    sum += far_looks(&f, lo - 1, first, depth, approach) + far_looks(&f, hi + 1, last, depth, approach);
    return sum / (4.0 / 3 * depth * b);
}

struct end {
    double y;                /* m, on the rail */
    int limited;             /* the gap exceeds the limit there */
};

/* How far the strips must go from the contact on its left (way -1) or right (1): to the first node of a gap above `limit`, or of another contact;
 * with PATCH_ALL to the last above it. */
static struct end extent_end(const struct frame *f, int way, double limit, enum patch_extent extent)
{
    int64_t lo, hi;
    double at = f->m->y / f->p->step - (double)f->p->rail->first, last = 0, y;

    frame_nodes(f, ALL, &lo, &hi);
    int64_t i = way > 0 ? (int64_t)floor(at) + 1 : (int64_t)ceil(at) - 1, end = i;
    int above = 0;
    for (; i >= lo && i <= hi; i += way) {
        double g = node_gap(f, i, &y);
        if (g <= limit || !above)
            end = i;
        above = g > limit;                                        /* not a NaN */
        if (extent == PATCH_OWN && (above || !(g >= 0) || (fabs(y) > GAP_APART && g < last)))
            break;
        last = g;
    }
    return (struct end){(double)(f->p->rail->first + end) * f->p->step, above};
}

/* n strips evenly over y of from .. to (m, on the rail); less where a curve has a hole. */
static int64_t strips_between(const struct frame *f, double from, double to, int64_t n, struct strip *strip)
{
    int64_t k = 0;

    for (int64_t i = 0; i < n; i++) {
        struct gap_place at;
        double y = from + (to - from) * (double)i / (double)(n - 1);
        if (!gap_at(f->p, y, &at))
            continue;
        double turn = f->c + (at.rail - at.slope) * f->s;
        if (turn < UPRIGHT)
            continue;
        strip[k++] = (struct strip){
            .y = (y - f->m->y) * f->c + (at.z - f->z0) * f->s, .gap = fmax(at.gap - f->m->gap, 0) / turn, .A = 0.5 * at.bend / turn,
        };
    }
    return k;
}

int64_t patch_strips(const struct gap_pair *p, const struct gap_minimum *m, double B, const struct hertz *h, double load,
                     const struct strip_law *law, enum patch_extent extent, struct strip strip[PATCH_STRIPS], struct strip_patch *patch)
{
    double b = h->b1 * cbrt(load), limit = 2 * fmax(B, HERTZ_FLATTEST) * b * b;
    struct frame f;
    int64_t n = 0;

    if (!frame_make(p, m, &f))
        return 0;
    for (int filled = 1; filled; limit *= DEEPER) {
        struct end left = extent_end(&f, -1, limit, extent), right = extent_end(&f, 1, limit, extent);
        n = strips_between(&f, left.y, right.y, extent == PATCH_OWN ? OWN_STRIPS : PATCH_STRIPS, strip);
        if (n < 3)
            return 0;
        strip_prepare(law, strip, n);
        strip_patch(strip, n, strip_approach(strip, n, load), patch);
        filled = (left.limited && strip[0].half > 0) || (right.limited && strip[n - 1].half > 0);
    }
    return n;
}

void patch_hertz(const struct gap_pair *p, const struct gap_minimum *m, double B, double load, const struct strip_law *law,
                 struct hertz *h)
{
    struct strip strip[PATCH_STRIPS];
    struct strip_patch patch;

    if (!patch_strips(p, m, B, h, load, law, PATCH_OWN, strip, &patch))
        return;
    h->C = load / (patch.approach * sqrt(patch.approach));
    h->a1 = patch.a / cbrt(load);
    h->b1 = patch.b / cbrt(load);
}
