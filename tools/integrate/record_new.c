/* What a run says of its passage, and the room for its samples. */
#include "tools/integrate/record.h"
#include "formats/reason.h"
#include "tools/integrate/facing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    return extremes_new(&r->extremes, &r->run);
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
    extremes_free(&r->extremes);
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
