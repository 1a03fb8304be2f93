#include "tools/profile/turnout.h"

#include <math.h>
#include <string.h>

#include "formats/reason.h"

static const char *const bodies[] = {"stock rail", "switch and wing rail", "nose"};

struct plan turnout_plan(const struct turnout_text *t, double gauge)
{
    return (struct plan){t->radius, atan(1 / t->ratio), gauge, t->route == TURNOUT_DIVERGING};
}

char turnout_switch_side(const struct turnout_text *t)
{
    return (t->hand == TURNOUT_RIGHT) == (t->route == TURNOUT_DIVERGING) ? 'l' : 'r';
}

/* Straight between the pairs, constant beyond them. */
static double table_at(const struct yaml_nums *pairs, double x)
{
    const double *t = pairs->x;
    int64_t last = pairs->n - 2, i = 0;

    if (x <= t[0])
        return t[1];
    if (x >= t[last])
        return t[last + 1];
    while (x >= t[i + 2])
        i += 2;
    return t[i + 1] + (t[i + 3] - t[i + 1]) * (x - t[i]) / (t[i + 2] - t[i]);
}

/* The plain rail, moved outwards and up. */
static const char *rail_moved(const struct section *rail, double out, double up, struct outline *o)
{
    const struct outline *plain = &rail->outline;
    const char *why = outline_new(o, plain->n);

    if (why)
        return why;
    memcpy(o->y, plain->y, (size_t)plain->n * 5 * sizeof *o->y);
    outline_shift(o, out, -up);
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

const char *turnout_body(const struct turnout_text *t, const struct plan *plan, const struct section *rail, double smoothing,
                         double spacing, int body, double s, struct outline *o)
{
    double stock = plan_stock(plan, s), width = plan_separation(plan, s), wing = width + t->wing.flangeway;
    double head = rail->outline.y[rail->outline.n - 1] - rail->outline.y[0], lowering;

    *o = (struct outline){0};
    if (body == TURNOUT_STOCK)
        return stock <= t->reach ? rail_moved(rail, stock, 0, o) : NULL;
    if (body == TURNOUT_SWITCH) {
        lowering = table_at(&t->blade.lowering, stock);
        if (s < t->blade.tip || wing > t->reach)
            return NULL;
        if (wing > 0)
            return rail_wing(t, rail, smoothing, spacing, wing, o);
        if (stock > head && lowering == 0)
            return rail_moved(rail, 0, 0, o);
        return head_blade(rail, stock, lowering, &(struct head_options){t->blade.edge_radius, smoothing, spacing}, o);
    }
    lowering = table_at(&t->nose.lowering, width);
    if (width < t->nose.lowering.x[0])
        return NULL;
    if (width >= -2 * rail->gauge_face && lowering == 0)
        return rail_moved(rail, 0, 0, o);
    return head_nose(rail, width, lowering, &(struct head_options){t->nose.edge_radius, smoothing, spacing}, o);
}

static const char *section_add(const struct turnout_text *t, const struct plan *plan, const struct section *rail,
                               double smoothing, double spacing, double s, struct set *set)
{
    const char *why = set_section(set, s);

    for (int body = 0; !why && body < TURNOUT_BODIES; body++) {
        struct outline o;
        why = turnout_body(t, plan, rail, smoothing, spacing, body, s, &o);
        if (!why && o.n)
            why = set_body(set, body, &o);
        else
            outline_free(&o);
    }
    return why ? reason("section at %g m: %s", s, why) : NULL;
}

const char *turnout_sections(const struct turnout_text *t, double gauge, double smoothing, double spacing, char side,
                             const struct section *rail, struct set *set)
{
    struct plan plan = turnout_plan(t, gauge);
    const struct turnout_stations *range = t->stations.item;
    const char *why = NULL;

    *set = (struct set){.bodies = TURNOUT_BODIES, .body = bodies};
    if (side != turnout_switch_side(t)) {
        struct outline o;
        set->bodies = 1;
        if ((why = set_section(set, 0)) || (why = rail_moved(rail, 0, 0, &o)))
            return why;
        return set_body(set, TURNOUT_STOCK, &o);
    }
    for (int64_t i = 0; !why && i < t->stations.n; i++) {
        int64_t steps = (int64_t)ceil((range[i].to - range[i].from) / range[i].step - 1e-9);
        steps = steps > 1 ? steps : 1;
        int64_t first = i && range[i].from == range[i - 1].to;      /* the last of the range before */
        for (int64_t k = first; !why && k <= steps; k++)
            why = section_add(t, &plan, rail, smoothing, spacing,
                              range[i].from + (range[i].to - range[i].from) * (double)k / (double)steps, set);
    }
    return why;
}
