#include "tools/integrate/passage.h"
#include "formats/reason.h"
#include "tools/contact/lookup.h"
#include "tools/creep/kalker.h"
#include "tools/integrate/facing.h"
#include "tools/track/turn.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SPIN_MARGIN 0.8    /* of 1/rate, below */
#define REAR_MARGIN 1.0    /* m, behind the last body, where headings and offsets begin to count */
#define END_MARGIN 5.0     /* m that every wheel keeps from a free rail end */

/* ---- checks ---- */

static const char *check_ends(const struct passage *p)
{
    const struct passage_options *o = &p->o;
    const struct trk *t = p->track;
    const struct veh *v = p->vehicle;
    double rear = 0, first = t->x[0] + END_MARGIN, last = t->x[t->nodes - 1] - END_MARGIN;

    if (!v->wheelsets || p->follows)
        return NULL;
    for (int64_t i = 0; i < v->wheelsets; i++)
        rear = fmin(rear, v->cg[3 * v->wheelset[i]]);
    if (o->start + rear < first)
        return reason("the last wheelset would start at %.2f m, but the track carries wheels %s %.2f m", facing_station(p, o->start + rear),
                      o->trailing ? "to" : "from", facing_station(p, first));
    if (o->end > last)
        return reason("the front wheelset would end at %.2f m, but the track carries wheels %s %.2f m", facing_station(p, o->end),
                      o->trailing ? "from" : "to", facing_station(p, last));
    return NULL;
}

static const char *check_tables(const struct veh *v, const struct ctab *left, const struct ctab *right)
{
    if (!v->wheelsets)
        return NULL;
    if (left->side != 'l' || right->side != 'r')
        return "the contact tables are not one of a left and one of a right side";
    for (int64_t i = 0; i < v->wheelsets; i++)
        if (fabs(v->radius[i] - left->radius) > 1e-6 || fabs(v->radius[i] - right->radius) > 1e-6)
            return reason("wheelset %lld has radius %g m, the contact tables %g and %g m", (long long)i + 1, v->radius[i],
                          left->radius, right->radius);
    return NULL;
}

static const char *check_flats(const struct excitation_options *o, const struct veh *v)
{
    for (int64_t i = 0; i < o->flats; i++)
        if (o->flat[i].wheelset > v->wheelsets)
            return reason("wheel_flat.%lld.wheelset is %lld, but the vehicle has %lld", (long long)i + 1, (long long)o->flat[i].wheelset,
                          (long long)v->wheelsets);
    return NULL;
}

/* 1/s, at which creep forces bring the spin of wheelset i to free rolling: Jy w' = -(r0^2/v) sum G a b C11 w.  The scheme takes
 * velocities one step on by their past: a decay is stable to a step of 1/rate. */
static double spin_rate(const struct passage *p, int64_t i)
{
    const struct veh *v = p->vehicle;
    double sum = 0;

    for (int side = 0; side < 2; side++) {
        const struct ctab *t = p->table[side];
        struct contact c[CONTACT_MAX];
        double N = cbrt(v->wheel_load[2 * i + side]), a, b, C[KALKER_COEFFICIENTS];
        if (contact_lookup(t, p->o.start + v->cg[3 * v->wheelset[i]], 0, 0, 0, c) <= 0)
            continue;
        a = c[0].row[CTAB_HERTZ_A] * N;
        b = c[0].row[CTAB_HERTZ_B] * N;
        kalker(a / b, t->poisson, C);
        sum += t->shear_modulus * a * b * C[KALKER_C11];
    }
    return v->radius[i] * v->radius[i] * sum / (p->o.speed * v->inertia[3 * v->wheelset[i] + 1]);
}

static const char *check_step(struct passage *p)
{
    double spin = 0;

    for (int64_t i = 0; i < p->vehicle->wheelsets && p->o.law.friction > 0; i++)
        spin = fmax(spin, spin_rate(p, i));
    p->limit = p->rails.limit;
    if (p->o.step * spin > SPIN_MARGIN)
        return reason("step %g s is beyond the limit of the wheelsets' spin at %.3g m/s, %.3g s", p->o.step, p->o.speed, SPIN_MARGIN / spin);
    if (spin > 0)
        p->limit = fmin(p->limit, SPIN_MARGIN / spin);
    return NULL;
}

/* m, a little behind the last body where the train starts. */
static double rear_station(const struct passage *p)
{
    double rear = 0;

    for (int64_t i = 0; i < p->vehicle->bodies; i++)
        rear = fmin(rear, p->vehicle->cg[3 * i]);
    return p->o.start + rear - REAR_MARGIN;
}

/* A moving mass is laid under every wheelset. */
static const char *lay_track(struct passage *p, const struct trk *track)
{
    p->follows = follow_is(track);
    p->track = p->follows ? &p->own : track;
    return p->follows ? follow_train(&p->own, track, p->vehicle) : NULL;
}

/* Track and tables as the train runs on them; the alignment is that of the one track or of the masses that follow. */
static const char *turn(struct passage *p, const struct ctab *left, const struct ctab *right)
{
    const char *why = NULL;

    if (p->o.trailing && !(why = turn_track(&p->turned, p->facing))) {
        p->view[0] = contact_turn(right);
        p->view[1] = contact_turn(left);
        p->table[0] = &p->view[0];
        p->table[1] = &p->view[1];
    }
    return why ? why : lay_track(p, p->o.trailing ? &p->turned : p->facing);
}

static const char *lay_alignment(struct passage *p)
{
    const struct trk *t = p->track;
    const char *why = alignment_new(&p->alignment, t->curves, t->curve_x, t->curvature);

    if (why)
        return why;
    alignment_raise(&p->alignment, t->cants, t->cant_x, t->cant, t->rail_spacing);
    return alignment_begin(&p->alignment, rear_station(p));
}

int64_t passage_steps(const struct passage_options *o)
{
    return (int64_t)ceil((o->end - o->start) / (o->speed * o->step) - 1e-9);
}

const char *passage_new(struct passage *p, const struct passage_options *o, const struct trk *track, const struct veh *vehicle,
                        const struct ctab *left, const struct ctab *right)
{
    size_t wheels = (size_t)(2 * vehicle->wheelsets);
    const char *why;

    *p = (struct passage){.o = *o, .facing = track, .vehicle = vehicle, .table = {left, right}, .station = o->start};
    p->steps = o->exciter ? o->exciter->steps : passage_steps(o);
    p->memory = calloc(wheels, sizeof *p->memory);
    p->couple = calloc(wheels, sizeof *p->couple);
    p->wheel = calloc(wheels, sizeof *p->wheel);
    if (!p->memory || !p->couple || !p->wheel || sideways_new(&p->sideways, vehicle->wheelsets))
        why = REASON_MEMORY;
    else if (!(why = check_tables(vehicle, left, right)) && !(why = turn(p, left, right)) && !(why = check_ends(p)) && !(why = lay_alignment(p)) &&
             !(why = check_flats(&o->excitation, vehicle)) && !(why = excitation_new(&p->excitation, &o->excitation)) &&
             !(why = way_new(&p->rails, p->track, vehicle->gravity, o->step, o->scheme)) &&
             (!o->account || !(why = energy_new(&p->energy, &p->rails))) && !(why = train_new(&p->train, vehicle, o->speed, o->step)))
        why = check_step(p);
    if (!why && o->implicit_train)
        why = p->rails.scheme == WAY_IMPLICIT ? train_imply(&p->train) : "train_scheme: implicit wants scheme: implicit";
    if (why)
        passage_free(p);
    return why;
}

void passage_free(struct passage *p)
{
    alignment_free(&p->alignment);
    excitation_free(&p->excitation);
    way_free(&p->rails);
    energy_free(&p->energy);
    train_free(&p->train);
    free(p->memory);
    free(p->couple);
    free(p->wheel);
    sideways_free(&p->sideways);
    trk_free(&p->own);
    trk_free(&p->turned);
    memset(p, 0, sizeof *p);
}

/* ---- forces ---- */

double passage_wheel_station(const struct passage *p, int64_t i)
{
    return p->station + p->vehicle->cg[3 * p->vehicle->wheelset[i]];
}

struct wheel_place passage_place(const struct passage *p, int64_t i, int side)
{
    return p->follows ? follow_find(p->track->nodes, i) : way_find(&p->rails, side, passage_wheel_station(p, i));
}

void passage_wheel_input(const struct passage *p, int64_t i, int side, const struct wheel_place *place, struct way_rail *rail,
                         struct wheel_input *in)
{
    struct excitation_at at;

    in->table = p->table[side];
    in->s = passage_wheel_station(p, i);
    train_wheelset(&p->train, i, in);
    way_look(&p->rails, side, place, rail);
    in->rail_z = rail->z;
    in->rail_v = rail->v;
    in->rail_slope = rail->slope;
    in->compliance = rail->local;
    in->rail_y = p->sideways.y[2 * i + side];
    in->rail_vy = p->sideways.v[2 * i + side];
    in->rail_turn = in->rail_roll = in->rail_vroll = 0;
    in->check_y = in->check_vy = in->check_give = in->check_quick = 0;
    if (trk_is_spatial(p->track)) {
        const struct wheel_memory *m = &p->memory[2 * i + side];
        lateral_stand(&(struct lateral){.F = {m->Y, m->M}, .applied = {m->Y, m->M}}, place, rail, m, p->o.step, in);
    }
    excitation_find(&p->excitation, in->s, i, side, p->vehicle->radius[i], &at);
    in->dip = at.z;
    in->dip_slope = at.z_slope;
    in->line = at.y;
    in->line_slope = at.y_slope;
}

/* A track that follows the train has no bays: any length will do. */
void passage_account(struct passage *p)
{
    const struct trk *t = p->track;
    const double bay = p->follows || t->sleepers < 2 ? 0.6 : t->sleeper_x[1] - t->sleeper_x[0];

    energy_begin(&p->energy, &p->rails);
    if (p->vehicle->wheelsets)
        run_in_begin(&p->run_in, t->sleeper_x[0], bay, *p->vehicle->wheel_load, p->station);
}

const char *passage_forces(struct passage *p)
{
    const char *why;

    train_locate(&p->train, &p->alignment, p->station);
    if ((why = couple_wheels(p)))
        return why;
    if (!trk_is_spatial(p->track))
        sideways_accelerate(&p->sideways, p->track, p->follows, p->o.step, p->wheel);
    way_finish(&p->rails);
    if (p->o.account && p->n > 0)
        energy_lose(&p->energy, &p->rails);
    if (!passage_implies(p)) /* where it does, the rounds have them */
        train_accelerate(&p->train, p->wheel);
    return NULL;
}

/* ---- the step ---- */

/* A motion that grows without bound shows in the train, which stands on everything else, or without one in the rails. */
static const char *check_motion(const struct passage *p)
{
    double sum = 0;

    for (int64_t k = 0; k < p->train.dofs; k++)
        sum += p->train.a[k];
    for (int64_t k = 0; k < p->track->nodes && !p->train.dofs; k++)
        sum += p->rails.wa[TRK_LEFT][k] + p->rails.wa[TRK_RIGHT][k];
    return isfinite(sum) ? NULL : reason("the motion is not finite at station %.3f m", facing_station(p, p->station));
}

const char *passage_step(struct passage *p)
{
    const char *why;

    train_advance(&p->train);
    way_advance(&p->rails);
    sideways_move(&p->sideways, p->o.step);
    p->n++;
    p->time = (double)p->n * p->o.step;
    p->station = p->o.start + p->o.speed * p->time;
    if ((why = passage_forces(p)))
        return why;
    if (p->o.account && p->vehicle->wheelsets)
        run_in_step(&p->run_in, p->station, p->wheel->Q);
    return check_motion(p);
}
