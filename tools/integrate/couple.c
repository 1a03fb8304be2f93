/* Rails that give within the step: with forces foreseen, by a straight line through the last two, the rails are solved for once.  What a
 * wheel's force beyond the foreseen moves at its own place and at the other wheel's of its set is known beforehand, so both wheels
 * find forces and rails together; the rails are solved for again with what the forces differ by.  What that moves under other
 * wheelsets, the vertical part of creep forces, and how the bodies move on by these forces, may want another round.
 *
 * Rails that do not: one round, no foreseeing. */
#include "tools/integrate/couple.h"
#include "formats/reason.h"
#include "tools/integrate/check_rail.h"
#include "tools/integrate/facing.h"
#include "tools/integrate/passage.h"

#include <math.h>

enum { ROUNDS_MOST = 20, PASSES_MOST = 30 };
#define PRESS_TOLERANCE 1e-6 /* N between the wheels of a set */
#define RAIL_TOLERANCE 1e-10 /* m of the rail under a wheel: 0.1 N */
#define SIDE_TOLERANCE 1e-2  /* N of a lateral force */

static int64_t wheels(const struct passage *p)
{
    return 2 * p->vehicle->wheelsets;
}

static const char *at_wheel(const struct passage *p, int64_t k, const char *why)
{
    return reason("wheelset %lld, %s wheel, station %.3f m: %s", (long long)(k / 2 + 1), facing_side(p, (int)(k % 2)),
                  facing_station(p, p->couple[k].in.s), why);
}

/* No force foreseen is below zero. */
static void foresee(struct passage *p)
{
    for (int64_t k = 0; k < wheels(p); k++) {
        struct couple *c = &p->couple[k];
        c->applied = fmax(2 * p->memory[k].Q - p->memory[k].Q_before, 0);
        way_load(&p->rails, (int)(k % 2), &c->place, c->applied);
        if (trk_is_spatial(p->track)) {
            lateral_foresee(&c->side, &p->memory[k]);
            c->side.applied = c->side.F;
            way_load_head(&p->rails, &c->place.head, &c->side.F);
        }
    }
}

/* Rate of d = (local + give) Q, give Q from where the rail would be without Q:  3/2 l/h - (4 l1 - l2)/(2 h) + quick give Q, with l = local Q
 * of this step and of those before, backward of second order. */
static void set_rate(struct couple *c, const struct wheel_memory *memory, double h)
{
    const struct way_rail *r = &c->rail;
    const double past = 2 * memory->local - 0.5 * memory->before;

    c->in.compliance = r->local + r->give;
    c->in.time = r->give > 0 ? h * c->in.compliance / (1.5 * r->local + h * r->quick * r->give) : h / 1.5;
    c->in.past = c->in.time * past / h;
}

/* The check rail as it is without the force of this wheel; what its element yields changes by a backward difference. */
static void look_check(const struct passage *p, int64_t k, struct couple *c)
{
    const double force = c->check_applied, b = c->check.b + c->check.height * c->check.height * c->check.t;
    struct head_motion m;
    double turn, yield[3] = {0};

    way_look_head(&p->rails, &c->check, &m, &turn, yield);
    c->in.check_y = m.y - yield[0] * force;
    c->in.check_vy = m.v + c->in.v * m.slope - c->rail.quick * yield[0] * force - b * p->memory[k].check / p->o.step;
    c->in.check_give = b + yield[0];
    c->in.check_quick = b / p->o.step + c->rail.quick * yield[0];
}

static void look(struct passage *p, int64_t k)
{
    struct couple *c = &p->couple[k];

    passage_wheel_input(p, k / 2, (int)(k % 2), &c->place, &c->rail, &c->in);
    set_rate(c, &p->memory[k], p->o.step);
    c->approach.d = c->rail.give > 0 ? c->in.compliance * c->applied : p->memory[k].local;
    c->Q = c->applied;
    lateral_begin(&c->side);
    if (c->checked)
        look_check(p, k, c);
}

static const char *meet(struct passage *p, int64_t k)
{
    struct couple *c = &p->couple[k];

    if (trk_is_spatial(p->track))
        lateral_stand(&c->side, &c->place, &c->rail, &p->memory[k], p->o.step, &c->in);
    const char *why = wheel_meet(&c->in, &c->approach);
    return why ? at_wheel(p, k, why) : NULL;
}

/* Both wheels of a set, each with what the other's force gives. */
static const char *press(struct passage *p, int64_t i)
{
    double change = HUGE_VAL;

    for (int pass = 0; pass < PASSES_MOST && change > PRESS_TOLERANCE; pass++) {
        change = 0;
        for (int side = 0; side < 2; side++) {
            struct couple *c = &p->couple[2 * i + side];
            const struct couple *other = &p->couple[2 * i + !side];
            const struct way_rail *r = &c->rail;
            const double more = c->Q - c->applied, other_more = other->Q - other->applied;
            const double shift = r->give_other * other_more - r->give * c->applied;
            c->in.rail_z = r->z + shift;
            c->in.rail_v = r->v + r->quick * shift;
            c->in.rail_slope = r->slope + r->turn * more + r->turn_other * other_more;
            const double Q = wheel_press(&p->o.law, &c->in, &p->memory[2 * i + side], &c->approach);
            change = fmax(change, fabs(Q - c->Q));
            c->Q = Q;
        }
        if (!way_yields(&p->rails))
            return NULL;
    }
    return change > PRESS_TOLERANCE ? at_wheel(p, 2 * i, reason("contact forces of the wheelset still change by %.3g N", change)) : NULL;
}

/* Wheel and rail approach more slowly by what the rail gives; the element's own part is not in creepages.  Returns by how much the lateral
 * force on a spatial rail is off, N. */
static double roll(struct passage *p, int64_t k)
{
    struct couple *c = &p->couple[k];
    struct wheel_output *w = &p->wheel[k];

    for (int j = 0; j < c->approach.n; j++)
        c->approach.rate[j] -= c->rail.quick * c->rail.give * c->Q;
    wheel_roll(&p->o.law, &c->in, &c->approach, &p->memory[k], w);
    c->made = lateral_force(p->track, (int)(k % 2), &c->in, w);
    check_rail_add(p->track, (int)(k % 2), &c->in, w);
    return trk_is_spatial(p->track) ? lateral_seek(&c->side, &c->place, &c->rail, &c->made, w->creep_damping, p->o.step) : 0;
}

/* The rails get what differs from what they have. */
static void load(struct passage *p, int64_t k)
{
    struct couple *c = &p->couple[k];
    const struct wheel_output *w = &p->wheel[k];

    way_load(&p->rails, (int)(k % 2), &c->place, w->Q - c->applied);
    c->applied = w->Q;
    if (trk_is_spatial(p->track)) {
        way_load_head(&p->rails, &c->place.head, &(struct head_force){c->made.Y - c->side.applied.Y, c->made.M - c->side.applied.M});
        c->side.F = c->side.applied = c->made;
    }
    if (c->checked) {
        way_load_head(&p->rails, &c->check, &(struct head_force){w->check - c->check_applied, 0});
        c->check_applied = w->check;
    }
}

/* Once, or where rails yield to the side until that agrees too. */
static const char *meet_wheelset(struct passage *p, int64_t i)
{
    const int again = trk_is_spatial(p->track) && way_yields(&p->rails);
    double off = HUGE_VAL;
    const char *why = NULL;

    for (int side = 0; side < 2; side++)
        look(p, 2 * i + side);
    for (int pass = 0; pass < (again ? PASSES_MOST : 1) && off > SIDE_TOLERANCE && !why; pass++) {
        for (int side = 0; side < 2 && !why; side++)
            why = meet(p, 2 * i + side);
        if (!why)
            why = press(p, i);
        off = 0;
        for (int side = 0; side < 2 && !why; side++)
            off = fmax(off, fabs(roll(p, 2 * i + side)));
    }
    for (int side = 0; side < 2 && !why; side++)
        load(p, 2 * i + side);
    return why;
}

static const char *round_of_forces(struct passage *p)
{
    const char *why = NULL;

    for (int64_t i = 0; i < p->vehicle->wheelsets && !why; i++)
        why = meet_wheelset(p, i);
    return why;
}

/* m, to the side: where the head is under the forces now on the rails, and where they were found. */
static double head_off(const struct passage *p, int64_t k, const struct way_rail *now)
{
    const struct couple *c = &p->couple[k];
    struct wheel_input in = c->in;

    lateral_stand(&c->side, &c->place, now, &p->memory[k], p->o.step, &in);
    return fabs(in.rail_y - c->in.rail_y);
}

/* m, the largest difference between where rails are and where the forces took them to be; *at is the wheel. */
static double disagreement(const struct passage *p, int64_t *at)
{
    double most = 0;

    for (int64_t k = 0; k < wheels(p); k++) {
        const struct couple *c = &p->couple[k];
        struct way_rail now;
        way_look(&p->rails, (int)(k % 2), &c->place, &now);
        double off = fabs(now.z - c->in.rail_z - c->rail.give * c->Q);
        if (trk_is_spatial(p->track))
            off = fmax(off, head_off(p, k, &now));
        if (!(off <= most)) {
            most = off;
            *at = k;
        }
    }
    return most;
}

static void account_heads(struct passage *p, int64_t k)
{
    const struct couple *c = &p->couple[k];
    const struct wheel_memory *memory = &p->memory[k];

    energy_work_head(&p->energy, &p->rails, &c->left.head, &(struct head_force){memory->Y, memory->M}, &c->place.head, &c->made);
    energy_work_head(&p->energy, &p->rails, &c->check_left, &(struct head_force){memory->check, 0}, &c->check,
                     &(struct head_force){c->checked ? p->wheel[k].check : 0, 0});
}

static void remember(struct passage *p)
{
    for (int64_t k = 0; k < wheels(p); k++) {
        struct couple *c = &p->couple[k];
        struct wheel_memory *memory = &p->memory[k];
        memory->before = memory->local;
        memory->local = c->rail.give > 0 ? c->rail.local * c->Q : c->approach.d;
        if (p->o.account && p->n > 0)
            energy_work(&p->energy, &p->rails, (int)(k % 2), &c->left, memory->Q, &c->place, p->wheel[k].Q);
        if (p->o.account && p->n > 0 && trk_is_spatial(p->track))
            account_heads(p, k);
        memory->Q_before = memory->Q;
        memory->Q = p->wheel[k].Q;
        memory->dip = c->in.dip;
        memory->line = c->in.line;
        memory->Y_before = memory->Y;
        memory->Y = c->made.Y;
        memory->M_before = memory->M;
        memory->M = c->made.M;
        memory->check = c->checked ? p->wheel[k].check : 0;
    }
}

const char *couple_wheels(struct passage *p)
{
    const int yields = way_yields(&p->rails);
    double off = HUGE_VAL;
    int64_t at = 0;

    for (int64_t k = 0; k < wheels(p); k++) {
        p->couple[k].left = p->couple[k].place;
        p->couple[k].place = passage_place(p, k / 2, (int)(k % 2));
        p->couple[k].applied = p->couple[k].check_applied = 0;
        p->couple[k].side = (struct lateral){.F = {p->memory[k].Y, p->memory[k].M}, .applied = {p->memory[k].Y, p->memory[k].M}};
        p->couple[k].check_left = p->couple[k].check;
        p->couple[k].checked = p->track->check_nodes > 0 && *p->track->check_rail == k % 2 &&
                               head_find_check(&p->couple[k].check, p->track, passage_wheel_station(p, k / 2));
    }
    if (yields)
        foresee(p);
    if (yields && p->o.exciter)
        exciter_load(p->o.exciter, &p->rails, p->n);
    way_move(&p->rails);
    if (!yields && p->o.exciter)
        exciter_load(p->o.exciter, &p->rails, p->n);
    for (int round = 0; round < ROUNDS_MOST && off > RAIL_TOLERANCE; round++) {
        const char *why = round_of_forces(p);
        if (why)
            return why;
        p->rounds++;
        off = 0;
        if (yields) {
            way_move(&p->rails);
            off = disagreement(p, &at);
        }
        if (passage_implies(p)) {
            train_force(&p->train, p->wheel);
            off = fmax(off, train_correct(&p->train));
        }
    }
    if (!(off <= RAIL_TOLERANCE))
        return at_wheel(p, at, reason("contact forces, rails and bodies still differ by %.3g m", off));
    if (way_unrest(&p->rails) > 0)
        return reason("station %.3f m: forces of ballast that only pushes still change by %.3g N", facing_station(p, p->station), way_unrest(&p->rails));
    remember(p);
    return NULL;
}
