#include "tools/integrate/lateral.h"

#include <math.h>

enum { FORGET = 8 }; /* passes after which the bracket is sought anew: the vertical force has moved on */

void lateral_foresee(struct lateral *l, const struct wheel_memory *memory)
{
    *l = (struct lateral){.F = {2 * memory->Y - memory->Y_before, 2 * memory->M - memory->M_before}};
}

void lateral_begin(struct lateral *l)
{
    l->passes = 0;
    l->low = -HUGE_VAL;
    l->high = HUGE_VAL;
}

/* Rate by the backward difference of second order, as of what a loaded element gives downwards; none at rest. */
void lateral_stand(const struct lateral *l, const struct wheel_place *place, const struct way_rail *rail, const struct wheel_memory *memory, double h,
                   struct wheel_input *in)
{
    const struct head_force more = {l->F.Y - l->applied.Y, l->F.M - l->applied.M};
    const double n = rail->quick > 0 ? 1 / h : 0, speed = rail->quick > 0 ? in->v : 0;
    const struct head_force rate = {n * (1.5 * l->F.Y - 2 * memory->Y + 0.5 * memory->Y_before),
                                    n * (1.5 * l->F.M - 2 * memory->M + 0.5 * memory->M_before)};
    const double y = rail->yield[0] * more.Y + rail->yield[1] * more.M, roll = rail->yield[1] * more.Y + rail->yield[2] * more.M;
    struct head_motion head = rail->head;

    head.y += y;
    head.v += rail->quick * y;
    head.roll += roll;
    head.vroll += rail->quick * roll + speed * rail->head_turn;
    head_bend(&place->head, &l->F, &rate, speed, &head);
    in->rail_y = head.y;
    in->rail_vy = head.v;
    in->rail_turn = head.slope;
    in->rail_roll = head.roll;
    in->rail_vroll = head.vroll;
}

/* Mx is about the track's axis at rail level, whence the rail's stands aside and below by where it is. */
struct head_force lateral_force(const struct trk *t, int side, const struct wheel_input *in, const struct wheel_output *out)
{
    const double axis = (side == TRK_RIGHT ? 0.5 : -0.5) * t->rail_spacing + in->rail_y + in->line;

    return (struct head_force){out->Y - out->check, out->Mx - axis * out->Q + (out->rail_z + in->dip) * (out->Y - out->check)};
}

/* 1/s: the rate of the head to the side over the force Y, and over M. */
static void find_rates(const struct wheel_place *place, const struct way_rail *rail, double h, double rate[2])
{
    const struct head_place *p = &place->head;

    rate[0] = rail->quick * rail->yield[0] + 1.5 / h * (p->b + p->height * p->height * p->t);
    rate[1] = rail->quick * rail->yield[1] + 1.5 / h * p->height * p->t;
}

double lateral_seek(struct lateral *l, const struct wheel_place *place, const struct way_rail *rail, const struct head_force *made, double damping,
                    double h)
{
    double rate[2];

    find_rates(place, rail, h, rate);
    const double share = rate[1] / rate[0], X = l->F.Y + share * l->F.M, off = made->Y + share * made->M - X, moved = X - l->X_before;
    const double slope = l->passes == 0 ? -1 - damping * rate[0] : moved == 0 ? -1 : fmin((off - l->off_before) / moved, -1);
    double next = X - off / slope;

    if (l->passes % FORGET == FORGET - 1)
        lateral_begin(l);
    *(off > 0 ? &l->low : &l->high) = X;
    if (next <= l->low || next >= l->high)
        next = isfinite(l->low + l->high) ? 0.5 * (l->low + l->high) : next;
    l->X_before = X;
    l->off_before = off;
    l->F = (struct head_force){next - share * made->M, made->M};
    l->passes++;
    return off;
}
