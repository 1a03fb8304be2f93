/* Each rail body is searched by itself; minima of all bodies are sorted by height.  The end of a body counts as a contact (an edge) only
 * where no other body of the section lies beside it, as a switch rail does beside its stock rail. */
#include "tools/contact/search.h"

#include <math.h>

#include "formats/reason.h"
#include "formats/room.h"

#define WITHIN 8e-3           /* m: a contact further above the first is left out; no approach is that large */
#define CROWN_LEAST 1.0       /* 1/m: flatter, z_yy says nothing of how a surface runs along the track */
#define ALONG_MOST 0.03       /* m from a section the wheel is looked for on those before and behind, which are */
#define NEXT_MOST 0.012       /* m from one to the next at most */
#define SHARE 0.6             /* of the distance to the next section, that a section's fall speaks for */
#define BEND_MOST 100.0       /* 1/m: an edge of 1 mm radius that runs aslant by 1:3 */
#define RISE_MOST 1e-3        /* m, of a fall: the flank of a wing rail that runs aslant falls by 1 or more, as far as it is high */
#define ALONE 0.02            /* m along the track that it speaks for where none is that near */
#define BESIDE 1e-3           /* m beyond its end another body must reach for the end not to count */

/* A rail's surface is taken as developable, swept along straight lines as a wing rail that runs aslant is: z_xx z_yy = z_xy^2 gives its bend
 * along the track from what the fall varies by across it. */
static void line_bend(struct gap_line *o)
{
    for (int64_t i = 0; i < o->n; i++) {
        int64_t a = i > 0 ? i - 1 : 0, b = i < o->n - 1 ? i + 1 : i;
        double across = (o->along[b] - o->along[a]) / (o->y[b] - o->y[a]);
        double t2 = 1 + o->slope[i] * o->slope[i], second = o->k[i] * t2 * sqrt(t2);
        o->bend[i] = fmin(across * across / fmax(second, CROWN_LEAST), BEND_MOST);
    }
}

static void poly_copy(const struct prof *p, int64_t poly, int mirror, struct gap_line *o)
{
    int64_t from = p->poly_first[poly], to = p->poly_first[poly + 1];

    o->n = to - from;
    for (int64_t i = 0; i < o->n; i++) {
        int64_t j = mirror ? to - 1 - i : from + i;
        o->y[i] = mirror ? -p->y[j] : p->y[j];
        o->z[i] = p->z[j];
        o->slope[i] = mirror ? -p->slope[j] : p->slope[j];
        o->k[i] = p->curvature[j];
        o->along[i] = p->fall[j];
    }
    line_bend(o);
}

static int64_t longest(const struct prof *p)
{
    int64_t n = 0;

    for (int64_t i = 0; i < p->polys; i++)
        n = p->poly_first[i + 1] - p->poly_first[i] > n ? p->poly_first[i + 1] - p->poly_first[i] : n;
    return n;
}

/* Nodes on the grid of the widest polyline, with one to spare. */
static int64_t widest(const struct prof *p, double step)
{
    int64_t n = 0;

    for (int64_t i = 0; i < p->polys; i++) {
        int64_t from = p->poly_first[i], m = gap_nodes(p->y + from, p->poly_first[i + 1] - from, step) + 1;
        n = m > n ? m : n;
    }
    return n;
}

/* Arrays of a curve one after another from `at` on. */
static struct gap_curve curve_at(double *at, int64_t n)
{
    return (struct gap_curve){.z = at, .slope = at + n, .k = at + 2 * n, .along = at + 3 * n, .along_y = at + 4 * n,
                              .bend = at + 5 * n, .bend_y = at + 6 * n, .at = at + 7 * n, .reach = at + 8 * n};
}

static struct gap_line line_at(double *at, int64_t n)
{
    return (struct gap_line){.y = at, .z = at + n, .slope = at + 2 * n, .k = at + 3 * n, .along = at + 4 * n, .bend = at + 5 * n};
}

static const char *search_room(struct search *s, int64_t points, int64_t rail_nodes, int64_t wheel_nodes, int64_t yaws)
{
    double *line = room_take(&s->store, 2 * GAP_LINE_ARRAYS * points, sizeof *line);
    double *rail = room_take(&s->store, (SEARCH_BODIES + SEARCH_KEPT) * GAP_ARRAYS * rail_nodes, sizeof *rail);
    double *wheel = room_take(&s->store, yaws * GAP_ARRAYS * wheel_nodes, sizeof *wheel);

    s->wheel = room_take(&s->store, yaws, sizeof *s->wheel);
    s->cut = room_take(&s->store, yaws, sizeof *s->cut);
    s->gap.work = room_take(&s->store, rail_nodes, sizeof *s->gap.work);
    if (!line || !rail || !wheel || !s->wheel || !s->cut || !s->gap.work)
        return REASON_MEMORY;
    s->line = line_at(line, points);
    s->silhouette = line_at(line + GAP_LINE_ARRAYS * points, points);
    for (int64_t i = 0; i < SEARCH_BODIES; i++)
        s->rail[i] = curve_at(rail + i * GAP_ARRAYS * rail_nodes, rail_nodes);
    for (int64_t i = 0; i < SEARCH_KEPT; i++)
        s->kept[i].curve = curve_at(rail + (SEARCH_BODIES + i) * GAP_ARRAYS * rail_nodes, rail_nodes);
    for (int64_t i = 0; i < yaws; i++)
        s->wheel[i] = curve_at(wheel + i * GAP_ARRAYS * wheel_nodes, wheel_nodes);
    return NULL;
}

/* The wheel's polyline, in s->line, as it is seen along the track. */
static const char *silhouette_make(struct search *s, double radius, double yaw, struct thesis_cut *cut)
{
    struct gap_line *o = &s->silhouette;
    const struct locus_wheel w = {s->line.n, s->line.y, s->line.z, s->line.slope, s->line.k, s->wheel_position, radius};

    const struct locus l = {o->y, o->z, o->slope, o->along, o->bend};
    const char *why = NULL;

    o->n = w.n;
    if (s->method != SEARCH_THESIS)
        locus_silhouette(&w, yaw, &l);
    else if (!(why = thesis_section(&w, yaw, cut)))
        thesis_profile(&w, yaw, cut, &l);
    for (int64_t i = 0; i < o->n; i++) {
        o->y[i] -= s->rail_position;
        o->k[i] = w.k[i];
    }
    return why;
}

const char *search_begin(struct search *s, const struct prof *wheel, const struct prof *rail, const double *yaw, int64_t yaws,
                         enum search_method method, double step)
{
    /* Yaw narrows a silhouette, but moves points of slope up to 1/tan(yaw) by r0 tan(yaw) at most. */
    int64_t spare = (int64_t)ceil(2 * wheel->radius * yaw[yaws - 1] / step);
    int64_t points = longest(wheel) > longest(rail) ? longest(wheel) : longest(rail);
    int64_t wheel_nodes = widest(wheel, step) + 2 * spare;
    const char *why;

    *s = (struct search){.mirror = wheel->side == 'l', .method = method, .radius = wheel->radius, .gap = {.step = step, .apart = GAP_APART}};
    s->wheel_position = s->mirror ? -wheel->position : wheel->position;
    s->rail_position = s->mirror ? -rail->position : rail->position;
    if ((why = search_room(s, points, widest(rail, step), wheel_nodes, yaws)))
        return why;
    poly_copy(wheel, 0, s->mirror, &s->line);
    for (int64_t i = 0; i < yaws; i++) {
        if ((why = silhouette_make(s, wheel->radius, yaw[i], &s->cut[i])))
            return why;
        if (gap_nodes(s->silhouette.y, s->silhouette.n, step) > wheel_nodes)
            return reason("wheel profile too steep for a yaw of %g rad", yaw[i]);
        gap_tabulate(&s->silhouette, step, &s->wheel[i]);
    }
    return NULL;
}

void search_free(struct search *s)
{
    room_release(&s->store);
}

/* Does a body of this section other than `poly` reach over y (m, of the file)? */
static int covered(const struct prof *p, int64_t section, int64_t poly, double y)
{
    for (int64_t i = 0; i < p->polys; i++)
        if (i != poly && p->poly_section[i] == section && p->y[p->poly_first[i]] <= y && p->y[p->poly_first[i + 1] - 1] >= y)
            return 1;
    return 0;
}

/* The polyline of poly's body in the next section that way, or -1. */
static int64_t poly_next(const struct prof *p, int64_t poly, int way)
{
    int64_t section = p->poly_section[poly] + way;

    for (int64_t i = poly + way; i >= 0 && i < p->polys && (p->poly_section[i] - section) * way <= 0; i += way)
        if (p->poly_section[i] == section && p->poly_body[i] == p->poly_body[poly])
            return i;
    return -1;
}

/* A polyline on the grid, from the cache or into it. */
static const struct gap_curve *poly_curve(struct search *s, const struct prof *p, int64_t poly)
{
    struct search_kept *k = &s->kept[poly % SEARCH_KEPT];

    if (k->poly != poly + 1) {
        poly_copy(p, poly, s->mirror, &s->line);
        gap_tabulate(&s->line, s->gap.step, &k->curve);
        k->poly = poly + 1;
    }
    return &k->curve;
}

/* Joins to c the sections of its body that lie near, one way along the track; *reach (m) falls to what they leave to each. */
static void body_join(struct search *s, const struct prof *p, int64_t poly, int way, struct gap_curve *c, double *reach)
{
    double here = p->station[p->poly_section[poly]], last = here;

    for (int64_t i = poly_next(p, poly, way); i >= 0; i = poly_next(p, i, way)) {
        double there = p->station[p->poly_section[i]], next = fabs(there - last);
        if (next > NEXT_MOST || fabs(there - here) > ALONG_MOST)
            return;
        *reach = fmin(*reach, SHARE * next);
        gap_join(c, poly_curve(s, p, i), there - here, 1 / s->radius);
        last = there;
    }
}

/* A body of a section on the grid: as it is there, or as far as the wheel can feel it before and behind. */
static void body_tabulate(struct search *s, const struct prof *p, int64_t poly, struct gap_curve *c)
{
    double reach = ALONE;

    poly_copy(p, poly, s->mirror, &s->line);
    gap_tabulate(&s->line, s->gap.step, c);
    c->level |= s->method != SEARCH_EXACT;
    if (s->method == SEARCH_EXACT) {
        body_join(s, p, poly, -1, c, &reach);
        body_join(s, p, poly, 1, c, &reach);
    }
    for (int64_t i = 0; i < c->n; i++)
        c->reach[i] = fmin(reach, RISE_MOST / fabs(c->along[i]));
}

const char *search_section(struct search *s, const struct prof *p, int64_t section)
{
    s->bodies = 0;
    for (int64_t i = 0; i < p->polys; i++) {
        if (p->poly_section[i] != section)
            continue;
        if (s->bodies == SEARCH_BODIES)
            return reason("section %lld has more than %d bodies", (long long)section, SEARCH_BODIES);
        int low = covered(p, section, i, p->y[p->poly_first[i]] - BESIDE) ? 0 : s->mirror ? GAP_RIGHT_END : GAP_LEFT_END;
        int high = covered(p, section, i, p->y[p->poly_first[i + 1] - 1] + BESIDE) ? 0 : s->mirror ? GAP_LEFT_END : GAP_RIGHT_END;
        s->body[s->bodies] = (int)p->poly_body[i];
        s->ends[s->bodies] = low | high;
        body_tabulate(s, p, i, &s->rail[s->bodies++]);
    }
    return NULL;
}

int search_contacts(const struct search *s, int64_t iy, int64_t shift, struct search_contact c[SEARCH_MOST])
{
    struct gap_minimum found[SEARCH_BODY_MOST];
    int n = 0;

    for (int b = 0; b < s->bodies; b++) {
        int minima = gap_minima(&s->gap, &s->rail[b], &s->wheel[iy], shift, s->ends[b], found, SEARCH_BODY_MOST);
        for (int k = 0; k < minima; k++) {
            if (n == SEARCH_MOST && found[k].gap >= c[n - 1].at.gap)
                continue;
            int i = n < SEARCH_MOST ? n++ : n - 1;
            for (; i > 0 && c[i - 1].at.gap > found[k].gap; i--)
                c[i] = c[i - 1];
            c[i] = (struct search_contact){.at = found[k], .body = s->body[b], .pair = {&s->rail[b], &s->wheel[iy], shift, s->gap.step},
                                           .cut = s->method == SEARCH_THESIS ? &s->cut[iy] : NULL};
        }
    }
    while (n > 0 && c[n - 1].at.gap > c[0].at.gap + WITHIN)
        n--;
    return n;
}
