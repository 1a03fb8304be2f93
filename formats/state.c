#include "formats/state.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

static const char PREFIX[] = "track.";

static const char *get_hash(const struct vxf *f, const char *key, uint64_t *hash)
{
    char text[32], *end;
    const char *why = vxf_key(f, key, text, sizeof text);

    if (why)
        return why;
    *hash = strtoull(text, &end, 16);
    return *end || end == text ? reason("header key %s: \"%s\" is no hash", key, text) : NULL;
}

static const char *get_keys(struct state *s, const struct vxf *f)
{
    const struct { const char *key; double *x; } number[] = {
        {"SPEED", &s->speed}, {"STEP", &s->step}, {"START", &s->start}, {"STATION", &s->station}, {"STEPS", &s->steps},
        {"REACH_FROM", &s->reach[0]}, {"REACH_TO", &s->reach[1]},
    };
    const char *why = vxf_key(f, "SCHEME", s->scheme, sizeof s->scheme);

    if (!why)
        why = vxf_key(f, "DIRECTION", s->direction, sizeof s->direction);
    if (!why)
        why = vxf_key(f, "FAILED", s->failed, sizeof s->failed);
    for (size_t k = 0; k < sizeof number / sizeof *number && !why; k++)
        why = vxf_number(f, number[k].key, number[k].x);
    if (why || (why = get_hash(f, "VEHICLE", &s->vehicle)) || (why = get_hash(f, "CONTACT_LEFT", &s->contact[0])) ||
        (why = get_hash(f, "CONTACT_RIGHT", &s->contact[1])) || (why = get_hash(f, "CASE", &s->text)))
        return why;
    if (!(s->speed > 0) || !(s->step > 0) || !(s->steps >= 1) || s->steps != floor(s->steps))
        return "header keys SPEED, STEP, STEPS: not those of a run";
    return NULL;
}

const char *state_read(struct state *s, const struct vxf *f)
{
    int64_t n[1] = {-1};
    const void *rest;
    const char *why;

    *s = (struct state){.track = f, .file = f};
    if ((why = vxf_is(f, "state")) || (why = get_keys(s, f)) || (why = vxf_get(f, "rest", VXF_F64, "SI", 1, n, &rest)))
        return why;
    s->dofs = n[0];
    s->rest = rest;
    return NULL;
}

/* Its matrices follow from the rest of a track, numbers of other types are names and places. */
static int is_compared(const struct vxf_array *a)
{
    return a->type == VXF_F64 && strcmp(a->name, "K.x") && strcmp(a->name, "C.x") && strcmp(a->name, "M.x");
}

static void put_track(const struct vxf *track, struct vxf_out *o)
{
    for (int k = 0; k < track->array.n; k++) {
        const struct vxf_array *a = &track->array.item[k];
        char name[VXF_NAME + sizeof PREFIX];
        snprintf(name, sizeof name, "%s%s", PREFIX, a->name);
        if (is_compared(a))
            vxf_put(o, name, a->type, a->unit, a->ndim, a->dim, a->data);
    }
}

void state_put(const struct state *s, int n, const struct state_part *part, struct vxf_out *o)
{
    vxf_put_key(o, "SCHEME", "%s", s->scheme);
    vxf_put_key(o, "DIRECTION", "%s", s->direction);
    vxf_put_key(o, "FAILED", "%s", s->failed);
    vxf_put_key(o, "SPEED", "%.17g", s->speed);
    vxf_put_key(o, "STEP", "%.17g", s->step);
    vxf_put_key(o, "START", "%.17g", s->start);
    vxf_put_key(o, "STATION", "%.17g", s->station);
    vxf_put_key(o, "STEPS", "%.17g", s->steps);
    vxf_put_key(o, "REACH_FROM", "%.17g", s->reach[0]);
    vxf_put_key(o, "REACH_TO", "%.17g", s->reach[1]);
    vxf_put_key(o, "VEHICLE", "%016" PRIx64, s->vehicle);
    vxf_put_key(o, "CONTACT_LEFT", "%016" PRIx64, s->contact[0]);
    vxf_put_key(o, "CONTACT_RIGHT", "%016" PRIx64, s->contact[1]);
    vxf_put_key(o, "CASE", "%016" PRIx64, s->text);
    vxf_put(o, "rest", VXF_F64, "SI", 1, &s->dofs, s->rest);
    for (int k = 0; k < n; k++)
        vxf_put(o, part[k].name, VXF_F64, "SI", 1, &part[k].n, part[k].x);
    put_track(s->track, o);
}

const char *state_get(const struct state *s, int n, const struct state_part *part)
{
    for (int k = 0; k < n; k++) {
        int64_t count = part[k].n;
        const void *x;
        const char *why = vxf_get(s->file, part[k].name, VXF_F64, "SI", 1, &count, &x);
        if (why)
            return why;
        memcpy(part[k].x, x, (size_t)count * sizeof *part[k].x);
    }
    return NULL;
}

/* ---- what differs ---- */

static const double *stations(const struct vxf *f, const char *name, int64_t *n)
{
    const struct vxf_array *a = vxf_find(&f->array, name);

    *n = a && a->type == VXF_F64 && a->ndim == 1 ? a->dim[0] : 0;
    return *n ? a->data : NULL;
}

/* The stations of the last dim: sleepers, rail nodes, or elements by the node behind.  *wide is 1 where an item reaches to the next. */
static const double *along(const struct vxf *track, const struct vxf_array *a, int *wide)
{
    const int64_t count = a->ndim ? a->dim[a->ndim - 1] : 0;
    int64_t sleepers, nodes;
    const double *sleeper_x = stations(track, "sleeper.x", &sleepers), *x = stations(track, "x", &nodes);

    *wide = count == nodes - 1 && count != sleepers;
    return count == sleepers ? sleeper_x : count == nodes || *wide ? x : NULL;
}

/* Where a and b, of one shape, differ; 0 where nowhere. */
static int find_range(const struct vxf *track, const struct vxf_array *a, const struct vxf_array *b, struct state_difference *d)
{
    const double *p = a->data, *q = b->data;
    const int64_t count = vxf_count(a), row = a->ndim ? a->dim[a->ndim - 1] : 1;
    int wide, found = 0;
    const double *x = along(track, a, &wide);

    *d = (struct state_difference){.from = HUGE_VAL, .to = -HUGE_VAL};
    snprintf(d->name, sizeof d->name, "%s", a->name);
    for (int64_t i = 0; i < count; i++) {
        if (p[i] == q[i])
            continue;
        found = 1;
        d->from = fmin(d->from, x ? x[i % row] : -HUGE_VAL);
        d->to = fmax(d->to, x ? x[i % row + wide] : HUGE_VAL);
    }
    return found;
}

static int of_one_shape(const struct vxf_array *a, const struct vxf_array *b)
{
    if (!b || a->type != b->type || a->ndim != b->ndim)
        return 0;
    for (int k = 0; k < a->ndim; k++)
        if (a->dim[k] != b->dim[k])
            return 0;
    return 1;
}

const char *state_compare(const struct state *s, const struct vxf *track, struct state_difference *d, int *n)
{
    *n = 0;
    for (int k = 0; k < track->array.n; k++) {
        const struct vxf_array *a = &track->array.item[k], *b;
        char name[VXF_NAME + sizeof PREFIX];
        if (!is_compared(a))
            continue;
        snprintf(name, sizeof name, "%s%s", PREFIX, a->name);
        b = vxf_find(&s->track->array, name);
        if (!of_one_shape(a, b))
            return reason("the track's %s has another shape than in the state", a->name);
        if (*n < STATE_DIFFERENCES && find_range(track, a, b, &d[*n]))
            ++*n;
    }
    return NULL;
}
