#include "tools/profile/turnout.h"

#include <math.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/profile/fall.h"

#define FALL_STEP 1e-3       /* m along the track, behind and ahead */
#define ROUNDING 1e-9        /* m, of a station */
#define CHECK_DEPTH 0.014    /* m below the rail's top, where its flangeway is measured as the gauge is */

/* By the enumeration of bodies; on the side without a crossing the check rail follows the stock rail. */
static const char *const switch_bodies[] = {"stock rail", "switch and wing rail", "nose"};
static const char *const check_bodies[] = {"stock rail", "check rail"};

struct plan turnout_plan(const struct turnout_text *t, double gauge)
{
    return (struct plan){t->radius, atan(1 / t->ratio), gauge, t->route == TURNOUT_DIVERGING};
}

char turnout_switch_side(const struct turnout_text *t)
{
    return (t->hand == TURNOUT_RIGHT) == (t->route == TURNOUT_DIVERGING) ? 'l' : 'r';
}

/* Slope at pair i of m: 0 at the ends and where the pairs turn, else the mean of the slopes to either side that Fritsch and Butland weigh
 * (SIAM J. Sci. Stat. Comput. 5 (1984) 300), with which a cubic does not overshoot. */
static double table_slope(const double *t, int64_t m, int64_t i)
{
    if (i == 0 || i == m - 1)
        return 0;
    double a = t[2 * i] - t[2 * i - 2], b = t[2 * i + 2] - t[2 * i];
    double before = (t[2 * i + 1] - t[2 * i - 1]) / a, after = (t[2 * i + 3] - t[2 * i + 1]) / b;

    return before * after > 0 ? 3 * (a + b) / ((2 * b + a) / before + (b + 2 * a) / after) : 0;
}

/* Monotone cubics between the pairs, constant beyond them: a machined top has no kinks. */
static double table_at(const struct yaml_nums *pairs, double x)
{
    const double *t = pairs->x;
    int64_t m = pairs->n / 2, i = 0;

    if (x <= t[0])
        return t[1];
    if (x >= t[2 * m - 2])
        return t[2 * m - 1];
    while (x >= t[2 * i + 2])
        i++;
    double h = t[2 * i + 2] - t[2 * i], u = (x - t[2 * i]) / h, v = 1 - u;
    return t[2 * i + 1] + u * u * (1 + 2 * v) * (t[2 * i + 3] - t[2 * i + 1]) +
           h * u * v * (v * table_slope(t, m, i) - u * table_slope(t, m, i + 1));
}

double turnout_wing(const struct turnout_text *t, const struct plan *plan, double s)
{
    double opening = 0, knee = t->wing.knee, straight;

    if (t->wing.flare > 0) {
        double left = plan_separation_station(plan, 0) + t->wing.end - s;
        opening = (t->wing.opening - t->wing.flangeway) * fmin(fmax(1 - left / t->wing.flare, 0), 1);
    }
    straight = plan_separation(plan, s) + t->wing.flangeway + opening;
    return fabs(straight) < knee ? (straight + knee) * (straight + knee) / (4 * knee) : straight;
}

/* How the head of a body is made at a station. */
enum head { HEAD_NONE, HEAD_PLAIN, HEAD_BLADE, HEAD_WING, HEAD_NOSE, HEAD_CHECK };

static enum head switch_head(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double s)
{
    double wing = turnout_wing(t, plan, s), stock = plan_stock(plan, s);
    double width = rail->outline.y[rail->outline.n - 1] - rail->outline.y[0];
    int ended = t->wing.end > 0 && s > plan_separation_station(plan, 0) + t->wing.end;

    if (s < t->blade.tip || ended || wing > t->reach)
        return HEAD_NONE;
    if (wing > 0)
        return HEAD_WING;
    return stock > width && table_at(&t->blade.lowering, stock) == 0 ? HEAD_PLAIN : HEAD_BLADE;
}

static enum head nose_head(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double s)
{
    double width = plan_separation(plan, s);

    if (width < t->nose.lowering.x[0])
        return HEAD_NONE;
    return width >= -2 * rail->gauge_face && table_at(&t->nose.lowering, width) == 0 ? HEAD_PLAIN : HEAD_NOSE;
}

static enum head check_head(const struct turnout_text *t, const struct plan *plan, double s)
{
    const struct yaml_nums *f = &t->check.flangeway;
    double x = s - plan_separation_station(plan, 0);

    return f->n && x >= f->x[0] - ROUNDING && x <= f->x[f->n - 2] + ROUNDING ? HEAD_CHECK : HEAD_NONE;
}

static enum head body_head(const struct turnout_text *t, const struct plan *plan, const struct section *rail, int body, double s)
{
    switch (body) {
    case TURNOUT_PLAIN:
        return HEAD_PLAIN;
    case TURNOUT_STOCK:
        return plan_stock(plan, s) <= t->reach ? HEAD_PLAIN : HEAD_NONE;
    case TURNOUT_SWITCH:
        return switch_head(t, plan, rail, s);
    case TURNOUT_NOSE:
        return nose_head(t, plan, rail, s);
    default:
        return check_head(t, plan, s);
    }
}

/* The plain rail, moved outwards. */
static const char *rail_moved(const struct section *rail, double out, struct outline *o)
{
    const struct outline *plain = &rail->outline;
    const char *why = outline_new(o, plain->n);

    if (why)
        return why;
    memcpy(o->y, plain->y, (size_t)plain->n * 5 * sizeof *o->y);
    outline_shift(o, out, 0);
    return NULL;
}

/* The machined top grows out of the plain rail's with the distance from the running edge, smoothly at both ends. */
static const char *rail_wing(const struct turnout_text *t, const struct section *rail, double smoothing, double spacing, double distance,
                             struct outline *o)
{
    struct head_top top = {t->wing.level, t->wing.crown_radius};
    double part = fmin(distance / t->wing.blend, 1);
    const char *why = head_wing(rail, part * part * (3 - 2 * part), &top,
                                &(struct head_options){t->wing.edge_radius, smoothing, spacing}, o);

    if (!why)
        outline_shift(o, distance, -table_at(&t->wing.raise, distance));
    return why;
}

static const char *rail_check(const struct turnout_text *t, const struct section *rail, double spacing, double flangeway, struct outline *o)
{
    const char *why = head_check(&(struct head_face){t->check.height, t->check.width, t->check.edge_radius, t->check.inclination, CHECK_DEPTH},
                                 rail->outline.z[0], spacing, o);

    if (!why)
        outline_shift(o, rail->gauge_face - flangeway, 0);
    return why;
}

const char *turnout_body(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double smoothing,
                         double spacing, int body, double s, struct outline *o)
{
    double stock = plan_stock(plan, s), width = plan_separation(plan, s);

    *o = (struct outline){0};
    switch (body_head(t, plan, rail, body, s)) {
    case HEAD_NONE:
        return NULL;
    case HEAD_PLAIN:
        return rail_moved(rail, body == TURNOUT_STOCK ? stock : 0, o);
    case HEAD_BLADE:
        return head_blade(rail, stock, table_at(&t->blade.lowering, stock),
                          &(struct head_options){t->blade.edge_radius, smoothing, spacing}, o);
    case HEAD_WING:
        return rail_wing(t, rail, smoothing, spacing, turnout_wing(t, plan, s), o);
    case HEAD_NOSE:
        return head_nose(rail, width, table_at(&t->nose.lowering, width),
                         &(struct head_options){t->nose.edge_radius, smoothing, spacing}, o);
    case HEAD_CHECK:
        return rail_check(t, rail, spacing, table_at(&t->check.flangeway, s - plan_separation_station(plan, 0)), o);
    }
    return NULL;
}

/* Where a head is made another way behind or ahead, the small step between them is no fall: the difference is one-sided there. */
const char *turnout_fall(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double smoothing,
                         double spacing, int body, double s, double h, struct outline *o)
{
    struct outline near[2] = {0};
    const char *why = NULL;

    for (int k = 0; !why && k < 2; k++) {
        double beside = k ? s + h : s - h;
        if (body_head(t, plan, rail, body, beside) == body_head(t, plan, rail, body, s))
            why = turnout_body(t, plan, rail, smoothing, spacing, body, beside, &near[k]);
    }
    if (!why)
        fall_between(&near[0], &near[1], h, o);
    outline_free(&near[0]);
    outline_free(&near[1]);
    return why;
}

static const char *body_add(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double smoothing,
                            double spacing, int body, int64_t number, double s, struct set *set)
{
    struct outline o;
    const char *why = turnout_body(t, plan, rail, smoothing, spacing, body, s, &o);

    if (!why && o.n && !(why = turnout_fall(t, plan, rail, smoothing, spacing, body, s, FALL_STEP, &o)))
        return set_body(set, number, &o);
    outline_free(&o);
    return why;
}

/* A range of stations begins with its first, unless that is the last of the range before. */
static const char *switch_sections(const struct turnout_text *t, const struct plan *plan, double smoothing, double spacing,
                                   const struct section *rail, struct set *set)
{
    const struct turnout_stations *range = t->stations.item;

    for (int64_t i = 0; i < t->stations.n; i++) {
        int64_t steps = (int64_t)ceil((range[i].to - range[i].from) / range[i].step - 1e-9);
        steps = steps > 1 ? steps : 1;
        for (int64_t k = i && range[i].from == range[i - 1].to; k <= steps; k++) {
            double s = range[i].from + (range[i].to - range[i].from) * (double)k / (double)steps;
            const char *why = set_section(set, s);
            for (int body = 0; !why && body < TURNOUT_BODIES; body++)
                why = body_add(t, plan, rail, smoothing, spacing, body, body, s, set);
            if (why)
                return reason("section at %g m: %s", s, why);
        }
    }
    return NULL;
}

/* A section at each pair of its flangeway and between them, one without it before and behind. */
static const char *check_sections(const struct turnout_text *t, const struct plan *plan, double spacing, const struct section *rail,
                                  struct set *set)
{
    const struct yaml_nums *f = &t->check.flangeway;
    double point = plan_separation_station(plan, 0), first = point + f->x[0], last = point + f->x[f->n - 2];
    const char *why;

    if (first <= 0 || last >= t->length)
        return reason("check_rail.flangeway: reaches from station %g to %g m, the turnout from 0 to %g m", first, last, t->length);
    if ((why = set_section(set, 0)) || (why = body_add(t, plan, rail, 0, spacing, TURNOUT_PLAIN, 0, 0, set)))
        return why;
    for (int64_t i = 2; i < f->n; i += 2) {
        double length = f->x[i] - f->x[i - 2];
        int64_t steps = (int64_t)ceil(length / t->check.step - 1e-9);
        for (int64_t k = i > 2; k <= steps; k++) {
            double s = point + f->x[i - 2] + length * (double)k / (double)steps;
            if ((why = set_section(set, s)) || (why = body_add(t, plan, rail, 0, spacing, TURNOUT_PLAIN, 0, s, set)) ||
                (why = body_add(t, plan, rail, 0, spacing, TURNOUT_CHECK, 1, s, set)))
                return reason("section at %g m: %s", s, why);
        }
    }
    why = set_section(set, t->length);
    return why ? why : body_add(t, plan, rail, 0, spacing, TURNOUT_PLAIN, 0, t->length, set);
}

const char *turnout_sections(const struct turnout_text *t, double gauge, double smoothing, double spacing, char side,
                             const struct section *rail, struct set *set)
{
    struct plan plan = turnout_plan(t, gauge);
    const char *why;

    if (side == turnout_switch_side(t)) {
        *set = (struct set){.bodies = TURNOUT_BODIES, .body = switch_bodies};
        return switch_sections(t, &plan, smoothing, spacing, rail, set);
    }
    *set = (struct set){.bodies = t->check.body ? 2 : 1, .body = check_bodies};
    if (t->check.body)
        return check_sections(t, &plan, spacing, rail, set);
    why = set_section(set, 0);
    return why ? why : body_add(t, &plan, rail, smoothing, spacing, TURNOUT_PLAIN, 0, 0, set);
}
