#include "tools/post/balance.h"
#include "formats/reason.h"

#include <math.h>
#include <string.h>

enum { X, Y, Z, ROLL, PITCH, YAW, DOFS };

/* One sample, and the body whose frame is the reference. */
struct sample {
    const struct run *r;
    int64_t record, reference;
};

static double channel(const struct sample *s, enum run_channel c, int64_t i)
{
    const double *x = s->r->channel[c];

    return x[s->record * run_count(s->r, &run_channels[c]) + i];
}

/* How far the frame of body i lies right of the tangent at the reference. */
static double offset(const struct sample *s, int64_t i)
{
    int64_t k = s->reference;
    double ahead = s->r->cg[3 * i] - s->r->cg[3 * k];

    return channel(s, RUN_BODY_OFFSET, i) - channel(s, RUN_BODY_OFFSET, k) - channel(s, RUN_BODY_HEADING, k) * ahead;
}

static double curvature_at(const struct run *r, double station)
{
    double k = 0;

    for (int64_t i = 0; i < r->curves && r->curve_x[i] <= station; i++)
        k = r->curvature[i];
    return k;
}

struct sums {
    double Q, Y, moment;        /* N, N m of the wheels */
    double side[2];             /* N Q of a side */
    double lever[2];            /* N m moment of a side */
    double force, push, torque; /* N, N m what they should be */
};

static void sum_wheels(const struct sample *s, struct sums *u)
{
    for (int64_t k = 0; k < 2 * s->r->wheelsets; k++) {
        double Q = channel(s, RUN_Q, k), shift = offset(s, s->r->wheelset[k / 2]);
        u->Q += Q;
        u->Y += channel(s, RUN_Y, k);
        u->moment += channel(s, RUN_MX, k) + shift * Q;
        u->side[k % 2] += Q;
        u->lever[k % 2] += channel(s, RUN_MX, k) + shift * Q;
    }
}

static void sum_bodies(const struct sample *s, struct sums *u)
{
    for (int64_t i = 0; i < s->r->bodies; i++) {
        const double m = s->r->mass[i], g = s->r->gravity;
        double y = offset(s, i) + s->r->cg[3 * i + 1] + channel(s, RUN_BODY_Q, DOFS * i + Y);
        double z = s->r->cg[3 * i + 2] + channel(s, RUN_BODY_Q, DOFS * i + Z);
        double ay = channel(s, RUN_BODY_A, DOFS * i + Y), az = channel(s, RUN_BODY_A, DOFS * i + Z);
        u->force += m * (g - az);
        u->push -= m * ay;
        u->torque += y * m * (g - az) + z * m * ay - s->r->inertia[3 * i] * channel(s, RUN_BODY_A, DOFS * i + ROLL);
    }
}

static void sum_spins(const struct sample *s, struct sums *u)
{
    const double *station = s->r->channel[RUN_STATION];

    for (int64_t k = 0; k < s->r->wheelsets; k++) {
        int64_t i = s->r->wheelset[k];
        double v = s->r->speed, at = station[s->record] + s->r->wheelset_x[k];
        double spin = channel(s, RUN_BODY_V, DOFS * i + PITCH) - v / s->r->radius[k];
        double rate = channel(s, RUN_BODY_V, DOFS * i + YAW) + curvature_at(s->r, at) * v;
        u->torque += s->r->inertia[3 * i + 1] * spin * rate;
    }
}

static int64_t heaviest(const struct run *r)
{
    int64_t k = 0;

    for (int64_t i = 1; i < r->bodies; i++)
        if (r->mass[i] > r->mass[k])
            k = i;
    return k;
}

static void add_sample(struct balance *b, const struct sums *u)
{
    /* With Ql, Qr at the levers yl, yr: yl Ql + yr Qr = torque and Ql + Qr = force give Ql - Qr. */
    double lever = u->lever[1] / u->side[1] - u->lever[0] / u->side[0];
    double middle = 0.5 * (u->lever[1] / u->side[1] + u->lever[0] / u->side[0]);

    b->vertical = fmax(b->vertical, fabs(u->Q - u->force));
    b->lateral = fmax(b->lateral, fabs(u->Y - u->push));
    b->roll = fmax(b->roll, fabs(u->moment - u->torque));
    b->mean_q[0] += u->side[0];
    b->mean_q[1] += u->side[1];
    b->mean_y += u->Y;
    b->expected -= (u->torque - middle * u->force) / lever;
    b->samples++;
}

const char *balance_find(const struct run *r, double from, double to, struct balance *b)
{
    const double *station = r->channel[RUN_STATION];
    struct sample s = {.r = r, .reference = heaviest(r)};

    memset(b, 0, sizeof *b);
    if (!r->channel[RUN_Q] || !r->channel[RUN_BODY_Q])
        return "the groups wheels and bodies are not recorded";
    for (int64_t i = 0; i < r->bodies; i++)
        b->weight += r->mass[i] * r->gravity;
    for (s.record = 0; s.record < r->records; s.record++) {
        struct sums u = {0};
        if (station[s.record] < from || station[s.record] > to)
            continue;
        sum_wheels(&s, &u);
        sum_bodies(&s, &u);
        sum_spins(&s, &u);
        add_sample(b, &u);
    }
    if (b->samples == 0)
        return reason("no sample with the front wheelset from %g to %g m", from, to);
    b->mean_q[0] /= (double)b->samples;
    b->mean_q[1] /= (double)b->samples;
    b->mean_y /= (double)b->samples;
    b->expected /= (double)b->samples;
    b->transfer = 0.5 * (b->mean_q[0] - b->mean_q[1]);
    return NULL;
}
