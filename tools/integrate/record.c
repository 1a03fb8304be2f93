#include "tools/integrate/record.h"
#include "tools/integrate/facing.h"

/* Where the present record of channel c begins; NULL where the channel is not kept. */
static void *slot(const struct record *r, enum run_channel c)
{
    size_t at = (size_t)(r->row * r->size[c]) * vxf_type_size(run_channels[c].type);

    return r->buffer[c] ? (char *)r->buffer[c] + at : NULL;
}

static void put(const struct record *r, enum run_channel c, int64_t i, double value)
{
    double *x = slot(r, c);

    if (x)
        x[i] = value;
}

/* n numbers as floats, from element `first` of the record on. */
static void put_floats(const struct record *r, enum run_channel c, int64_t first, int64_t n, const double *value)
{
    float *x = slot(r, c);

    for (int64_t i = 0; x && i < n; i++)
        x[first + i] = (float)value[i];
}

static void sample_wheels(const struct record *r, const struct passage *p)
{
    static const struct wheel_patch none;

    for (int64_t k = 0; k < 2 * r->run.wheelsets; k++) {
        const struct wheel_output *w = &p->wheel[k];
        put(r, RUN_Q, k, w->Q);
        put(r, RUN_Y, k, w->Y);
        put(r, RUN_T, k, w->T);
        put(r, RUN_CHECK, k, w->check);
        put(r, RUN_MX, k, w->Mx);
        put(r, RUN_RAIL_Y, k, p->couple[k].in.rail_y);
        put(r, RUN_RAIL_Z, k, w->rail_z);
        for (int j = 0; j < RUN_CONTACTS; j++) {
            const struct wheel_patch *c = j < w->patches ? &w->patch[j] : &none;
            int64_t i = k * RUN_CONTACTS + j;
            put(r, RUN_N, i, c->N);
            put(r, RUN_CONTACT_Y, i, c->rail_y);
            put(r, RUN_CONTACT_WHEEL_Y, i, c->wheel_y);
            put(r, RUN_CONTACT_X, i, c->x);
            put(r, RUN_ANGLE, i, c->angle);
            put(r, RUN_XI, i, c->xi);
            put(r, RUN_ETA, i, c->eta);
            put(r, RUN_PHI, i, c->phi);
            put(r, RUN_TX, i, c->tx);
            put(r, RUN_TY, i, c->ty);
            put(r, RUN_BODY, i, c->body);
        }
    }
}

static void sample_bodies(const struct record *r, const struct passage *p)
{
    for (int64_t i = 0; i < r->run.bodies; i++) {
        double q[6], v[6], a[6];
        train_in_frame(&p->train, i, q, v);
        train_felt(&p->train, i, a);
        for (int k = 0; k < 6; k++) {
            put(r, RUN_BODY_Q, 6 * i + k, q[k]);
            put(r, RUN_BODY_V, 6 * i + k, v[k]);
            put(r, RUN_BODY_A, 6 * i + k, a[k]);
        }
        put(r, RUN_BODY_OFFSET, i, p->train.line[i].offset);
        put(r, RUN_BODY_HEADING, i, p->train.line[i].heading);
    }
}

static void sample_track(struct record *r, const struct passage *p)
{
    const struct way *w = &p->rails;
    int64_t n = r->run.sleepers, nodes = r->run.nodes;

    for (int s = 0; s < 2; s++) {
        put_floats(r, RUN_PAD, s * n, n, w->pad[s]);
        put_floats(r, RUN_NODE_Z, s * nodes, nodes, w->w[s]);
        put_floats(r, RUN_NODE_A, s * nodes, nodes, w->wa[s]);
        if (r->recorded[RUN_NODE_M])
            put_floats(r, RUN_NODE_M, s * nodes, nodes, extremes_moment(&r->extremes, p, s));
    }
    for (int s = 0; s < 3; s++)
        put_floats(r, RUN_BALLAST_F, s * n, n, w->ballast[s]);
    put_floats(r, RUN_SLEEPER_Z, 0, n, w->z);
    put_floats(r, RUN_SLEEPER_ROLL, 0, n, w->roll);
    put_floats(r, RUN_SLEEPER_A, 0, n, w->za);
}

static void sample_exciter(const struct record *r, const struct passage *p)
{
    const struct exciter *e = p->o.exciter;

    put(r, RUN_FORCE, 0, e->F[p->n]);
    for (int64_t k = 0; k < e->probes; k++)
        put(r, RUN_PROBE, k, exciter_deflection(e, &p->rails, p->n, k));
}

static void sample(struct record *r, const struct passage *p)
{
    put(r, RUN_TIME, 0, p->time);
    put(r, RUN_STATION, 0, p->station);
    sample_wheels(r, p);
    sample_bodies(r, p);
    sample_track(r, p);
    if (p->o.exciter)
        sample_exciter(r, p);
    for (enum run_channel c = 0; c < RUN_CHANNELS && r->trailing; c++)
        if (r->buffer[c])
            facing_channel(&r->run, c, r->follows, slot(r, c));
}

int record_step(struct record *r, const struct passage *p)
{
    extremes_step(&r->extremes, p);
    if (!r->lowpass && p->n % r->every)
        return 0;
    r->row = r->lowpass ? RECORD_ROOM - 1 : r->held;
    sample(r, p);
    if (r->lowpass)
        record_filter(r, p->n);
    else
        r->held++;
    return r->held >= RECORD_BLOCK;
}

void record_end(struct record *r, int64_t n)
{
    record_filter_end(r, n);
    for (enum run_extreme c = 0; c < RUN_EXTREMES && r->trailing; c++)
        facing_extreme(&r->run, c, r->follows, r->extremes.of[c]);
    r->trailing = 0;
}
