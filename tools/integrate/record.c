#include "tools/integrate/record.h"
#include "formats/reason.h"
#include "tools/contact/clones.h"
#include "tools/integrate/facing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- setting up ---- */

/* x [n] into a room of its own, which *own is. */
static const double *copy(const double *x, int64_t n, double **own)
{
    if ((*own = calloc((size_t)n + 1, sizeof **own)))
        memcpy(*own, x, (size_t)n * sizeof **own);
    return *own;
}

/* What the run says of a trailing train, in the axes of the track. */
static const char *describe_trailing(struct record *r, const struct passage *p)
{
    const struct veh *v = p->vehicle;

    r->run.cg = copy(v->cg, 3 * v->bodies, &r->cg);
    r->run.static_q = copy(v->wheel_load, 2 * v->wheelsets, &r->static_q);
    if (p->follows)
        r->run.node_x = r->run.sleeper_x = copy(p->track->x, p->track->nodes, &r->node_x);
    if (!r->run.cg || !r->run.static_q || !r->run.node_x)
        return REASON_MEMORY;
    facing_turn(v->bodies, 3, r->cg);
    facing_turn(v->wheelsets, 1, r->wheelset_x);
    facing_turn(p->follows ? p->track->nodes : 0, 1, r->node_x);
    for (int64_t i = 0; i < v->wheelsets; i++) {
        r->static_q[2 * i] = v->wheel_load[2 * i + 1];
        r->static_q[2 * i + 1] = v->wheel_load[2 * i];
    }
    return NULL;
}

static const char *describe(struct record *r, const struct passage *p)
{
    const struct veh *v = p->vehicle;
    const struct trk *t = p->follows ? p->track : p->facing;

    r->wheelset_x = calloc((size_t)v->wheelsets, sizeof *r->wheelset_x);
    if (!r->wheelset_x)
        return REASON_MEMORY;
    for (int64_t i = 0; i < v->wheelsets; i++)
        r->wheelset_x[i] = v->cg[3 * v->wheelset[i]];
    r->run = (struct run){
        .speed = p->o.speed, .step = p->o.step, .friction = p->o.law.friction, .gravity = v->gravity,
        .rail_spacing = t->rail_spacing, .wheelsets = v->wheelsets, .bodies = v->bodies, .sleepers = t->sleepers,
        .nodes = t->nodes, .zones = t->zones, .curves = p->facing->curves, .wheelset_x = r->wheelset_x,
        .static_q = v->wheel_load, .radius = v->radius, .wheelset = v->wheelset, .mass = v->mass,
        .inertia = v->inertia, .cg = v->cg, .body_name = v->body_name, .sleeper_x = t->sleeper_x,
        .sleeper_number = t->sleeper_number, .node_x = t->x, .zone_name = t->zone_name, .pad_zone = t->pad_zone,
        .curve_x = p->facing->curve_x, .curvature = p->facing->curvature,
    };
    snprintf(r->run.direction, sizeof r->run.direction, "%s", p->o.trailing ? "trailing" : "facing");
    r->trailing = p->o.trailing;
    r->follows = p->follows;
    if (p->o.exciter) {
        const struct exciter *e = p->o.exciter;
        r->force_on = e->on;
        r->run.forces = 1;
        r->run.force_x = &e->x;
        r->run.force_on = &r->force_on;
        r->run.probes = e->probes;
        r->run.probe_x = e->probe_x;
        r->run.probe_on = e->probe_on;
        r->run.probe_held = e->held;
    }
    return p->o.trailing ? describe_trailing(r, p) : NULL;
}

static const char *allocate(struct record *r)
{
    int n = 0;

    for (int c = 0; c < RUN_CHANNELS; c++) {
        size_t element = vxf_type_size(run_channels[c].type);
        r->size[c] = run_count(&r->run, &run_channels[c]);
        if (r->recorded[c] && !(r->buffer[c] = calloc(RECORD_ROOM * (size_t)r->size[c] + 1, element)))
            return REASON_MEMORY;
        if (r->recorded[c])
            r->series[n++] = r->buffer[c];
    }
    for (int c = 0; c < RUN_EXTREMES; c++)
        if (!(r->extreme[c] = calloc((size_t)run_count(&r->run, &run_extremes[c]) + 1, sizeof(double))))
            return REASON_MEMORY;
    for (int64_t k = 0; k < 2 * r->run.wheelsets; k++)
        r->extreme[RUN_MIN_Q][k] = HUGE_VAL;
    r->moment = calloc((size_t)r->run.nodes, sizeof *r->moment);
    return r->moment ? NULL : REASON_MEMORY;
}

static const char *begin_lowpass(struct record *r)
{
    r->lowpass = calloc((size_t)(2 * LOWPASS_HALF * r->every + 1), sizeof *r->lowpass);
    r->weight = calloc(RECORD_ROOM, sizeof *r->weight);
    if (!r->lowpass || !r->weight)
        return REASON_MEMORY;
    lowpass_weights(r->every, r->lowpass);
    snprintf(r->run.filter, sizeof r->run.filter, "low-pass, sinc in a Hamming window of %lld steps, -6 dB at %.6g Hz, without delay",
             (long long)(2 * LOWPASS_HALF * r->every + 1), 0.5 / (r->run.step * (double)r->every));
    return NULL;
}

const char *record_new(struct record *r, const struct passage *p, const int *groups, int64_t every, int lowpass)
{
    const char *why;

    *r = (struct record){.every = every};
    why = describe(r, p);
    if (!why && lowpass && every > 1)
        why = begin_lowpass(r);
    for (int c = 0; c < RUN_CHANNELS && !why; c++)
        r->recorded[c] = (run_channels[c].group == RUN_GROUPS || groups[run_channels[c].group]) && run_count(&r->run, &run_channels[c]) > 0;
    if (!why)
        why = allocate(r);
    if (why)
        record_free(r);
    return why;
}

void record_free(struct record *r)
{
    for (int c = 0; c < RUN_CHANNELS; c++)
        free(r->buffer[c]);
    for (int c = 0; c < RUN_EXTREMES; c++)
        free(r->extreme[c]);
    free(r->moment);
    free(r->lowpass);
    free(r->weight);
    free(r->wheelset_x);
    free(r->cg);
    free(r->static_q);
    free(r->node_x);
    *r = (struct record){0};
}

double record_bytes(const struct record *r)
{
    double bytes = 0;

    for (int c = 0; c < RUN_CHANNELS; c++)
        if (r->recorded[c])
            bytes += (double)r->size[c] * (double)vxf_type_size(run_channels[c].type);
    return bytes;
}

/* ---- extremes ---- */

CLONES static void keep_largest(int64_t n, const double *restrict x, double *restrict largest)
{
    for (int64_t i = 0; i < n; i++)
        largest[i] = x[i] > largest[i] ? x[i] : largest[i];
}

CLONES static void keep_magnitude(int64_t n, const double *restrict x, double *restrict largest)
{
    for (int64_t i = 0; i < n; i++) {
        double magnitude = x[i] < 0 ? -x[i] : x[i];
        largest[i] = magnitude > largest[i] ? magnitude : largest[i];
    }
}

/* Compression of a pad: its own ends, not its force over its stiffness, which the damper shares. */
CLONES static void keep_compression(int64_t n, const double *restrict w, const double *restrict z, const double *restrict roll,
                                    const double *restrict arm, double *restrict largest)
{
    for (int64_t i = 0; i < n; i++) {
        double d = w[i] - z[i] - arm[i] * roll[i];
        largest[i] = d > largest[i] ? d : largest[i];
    }
}

static void wheel_extremes(struct record *r, const struct passage *p)
{
    for (int64_t k = 0; k < 2 * r->run.wheelsets; k++) {
        double Q = p->wheel[k].Q;
        if (Q > r->extreme[RUN_MAX_Q][k]) {
            r->extreme[RUN_MAX_Q][k] = Q;
            r->extreme[RUN_AT_MAX_Q][k] = passage_wheel_station(p, k / 2);
        }
        r->extreme[RUN_MIN_Q][k] = fmin(r->extreme[RUN_MIN_Q][k], Q);
        r->extreme[RUN_MAX_Y][k] = fmax(r->extreme[RUN_MAX_Y][k], fabs(p->wheel[k].Y));
    }
}

/* Sleepers stand evenly or nearly so: guess, then walk. */
static int64_t sleeper_near(const struct trk *t, double s)
{
    const double *x = t->sleeper_x;
    int64_t last = t->sleepers - 1, i = (int64_t)((s - x[0]) / (x[last] - x[0]) * (double)last);

    i = i < 0 ? 0 : i > last ? last : i;
    while (i > 0 && s < x[i])
        i--;
    while (i < last && s >= x[i + 1])
        i++;
    return i + (i < last && x[i + 1] - s < s - x[i]);
}

/* The same by where it happens: at the sleeper nearest to the wheel. */
static void wheel_extremes_by_sleeper(struct record *r, const struct passage *p)
{
    int64_t n = r->run.sleepers;

    for (int64_t k = 0; k < 2 * r->run.wheelsets; k++) {
        double s = passage_wheel_station(p, k / 2);
        int64_t i = p->follows ? k / 2 : sleeper_near(p->track, s);
        double *Q = &r->extreme[RUN_SLEEPER_MAX_Q][k % 2 * n + i], *Y = &r->extreme[RUN_SLEEPER_MAX_Y][k % 2 * n + i];
        *Q = fmax(*Q, p->wheel[k].Q);
        *Y = fmax(*Y, fabs(p->wheel[k].Y));
    }
}

/* The rails of a moving mass do not bend. */
static void find_moment(struct record *r, const struct passage *p, int rail)
{
    if (!p->follows)
        way_moment(&p->rails, rail, r->moment);
}

static void track_extremes(struct record *r, const struct passage *p)
{
    const struct way *w = &p->rails;
    int64_t n = r->run.sleepers, nodes = r->run.nodes;

    for (int s = 0; s < 2; s++) {
        keep_largest(n, w->pad[s], r->extreme[RUN_MAX_PAD] + s * n);
        keep_compression(n, w->seat[s], w->z, w->roll, w->arm[s], r->extreme[RUN_MAX_PAD_COMPRESSION] + s * n);
        find_moment(r, p, s);
        keep_magnitude(nodes, r->moment, r->extreme[RUN_MAX_NODE_M] + s * nodes);
    }
    for (int s = 0; s < 3; s++)
        keep_largest(n, w->ballast[s], r->extreme[RUN_MAX_BALLAST] + s * n);
    keep_magnitude(n, w->za, r->extreme[RUN_MAX_SLEEPER_A]);
}

/* ---- samples ---- */

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
        if (r->recorded[RUN_NODE_M]) {
            find_moment(r, p, s);
            put_floats(r, RUN_NODE_M, s * nodes, nodes, r->moment);
        }
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

/* ---- low-pass ---- */

/* What leaps from contact to contact stays as it is, and so do time and place. */
static int is_filtered(enum run_channel c)
{
    return c != RUN_TIME && c != RUN_STATION && (c < RUN_N || c > RUN_BODY) && c != RUN_BODY_OFFSET && c != RUN_BODY_HEADING;
}

/* Row `to` of channel c += w times row `from`, or a times itself where from is to. */
static void blend(struct record *r, enum run_channel c, int64_t to, int64_t from, double w)
{
    const int64_t n = r->size[c];
    double *x = r->buffer[c];
    float *f = r->buffer[c];

    if (run_channels[c].type == VXF_F64)
        for (int64_t i = 0; i < n; i++)
            x[to * n + i] += w * x[from * n + i];
    else
        for (int64_t i = 0; i < n; i++)
            f[to * n + i] += (float)w * f[from * n + i];
}

/* The present step, in the last row, goes into row `to`, whose own step is `away` steps before it. */
static void add_step(struct record *r, int64_t to, int64_t away)
{
    const int64_t now = RECORD_ROOM - 1;
    const double w = r->lowpass[away + LOWPASS_HALF * r->every];

    for (enum run_channel c = 0; c < RUN_CHANNELS; c++)
        if (r->buffer[c] && is_filtered(c))
            blend(r, c, to, now, w);
        else if (r->buffer[c] && away == 0)
            memcpy((char *)r->buffer[c] + (size_t)(to * r->size[c]) * vxf_type_size(run_channels[c].type),
                   (char *)r->buffer[c] + (size_t)(now * r->size[c]) * vxf_type_size(run_channels[c].type),
                   (size_t)r->size[c] * vxf_type_size(run_channels[c].type));
    r->weight[to] += w;
}

/* The first record under way has all its steps: at the ends of the run these are fewer. */
static void complete(struct record *r)
{
    const int64_t row = r->held++;

    for (enum run_channel c = 0; c < RUN_CHANNELS; c++)
        if (r->buffer[c] && is_filtered(c))
            blend(r, c, row, row, 1 / r->weight[row] - 1);
    r->begun--;
    r->first += r->every;
}

static void clear(struct record *r, int64_t row)
{
    for (enum run_channel c = 0; c < RUN_CHANNELS; c++)
        if (r->buffer[c]) {
            const size_t size = (size_t)r->size[c] * vxf_type_size(run_channels[c].type);
            memset((char *)r->buffer[c] + (size_t)row * size, 0, size);
        }
    r->weight[row] = 0;
}

/* Records whose window reaches this step begin, all take it in, and those it is the last of are complete. */
static void filter_step(struct record *r, int64_t n)
{
    const int64_t half = LOWPASS_HALF * r->every;

    if (r->held + r->begun == 0)
        r->first = (n + r->every - 1) / r->every * r->every;
    while (r->first + r->begun * r->every - half <= n)
        clear(r, r->held + r->begun++);
    for (int64_t k = 0; k < r->begun; k++)
        add_step(r, r->held + k, n - (r->first + k * r->every));
    while (r->begun && r->first + half <= n)
        complete(r);
}

int record_step(struct record *r, const struct passage *p)
{
    wheel_extremes(r, p);
    wheel_extremes_by_sleeper(r, p);
    track_extremes(r, p);
    if (!r->lowpass && p->n % r->every)
        return 0;
    r->row = r->lowpass ? RECORD_ROOM - 1 : r->held;
    sample(r, p);
    if (r->lowpass)
        filter_step(r, p->n);
    else
        r->held++;
    return r->held >= RECORD_BLOCK;
}

void record_empty(struct record *r)
{
    for (int c = 0; c < RUN_CHANNELS && r->begun; c++)
        if (r->buffer[c]) {
            const size_t size = (size_t)r->size[c] * vxf_type_size(run_channels[c].type);
            memmove(r->buffer[c], (char *)r->buffer[c] + (size_t)r->held * size, (size_t)r->begun * size);
        }
    if (r->begun)
        memmove(r->weight, r->weight + r->held, (size_t)r->begun * sizeof *r->weight);
    r->held = 0;
}

/* Samples beyond the last step are none. */
void record_end(struct record *r, int64_t n)
{
    while (r->begun && r->first <= n)
        complete(r);
    r->begun = 0;
    for (enum run_extreme c = 0; c < RUN_EXTREMES && r->trailing; c++)
        facing_extreme(&r->run, c, r->follows, r->extreme[c]);
    r->trailing = 0;
}
