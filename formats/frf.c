/* Reading, checking and writing receptances. */
#include "formats/frf.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

const struct frf_quantity frf_quantity[] = {{"receptance", "m/N"}, {"mobility", "m/s/N"}, {"accelerance", "m/s2/N"}, {0}};

static const char *const direction[] = {"vertical", "lateral", NULL};

static int is_one_of(const char *word, const char *const *of)
{
    while (*of && strcmp(word, *of))
        of++;
    return *of != NULL;
}

static const char *check_place(const struct frf_place *p, const char *what)
{
    static const char *const on[] = {"left", "right", "both", "sleeper", NULL}, *const at[] = {"sleeper", "midspan", "station", NULL};

    if (!is_one_of(p->on, on))
        return reason("header key %s: \"%s\" is not left, right, both or sleeper", what, p->on);
    if (!is_one_of(p->at, at))
        return reason("header key %s_AT: \"%s\" is not sleeper, midspan or station", what, p->at);
    return NULL;
}

static const char *check(const struct frf *r)
{
    const char *why = check_place(&r->force, "FORCE");
    if (why || (why = check_place(&r->motion, "MOTION")))
        return why;
    if (r->quantity < 0 || r->quantity >= FRF_QUANTITIES)
        return reason("there is no quantity %d", r->quantity);
    if (strcmp(r->motion.on, "both") == 0)
        return reason("header key MOTION: both rails have no one motion");
    if (r->hermites != 0 && r->hermites != r->n)
        return reason("array hermite: %lld rows for %lld frequencies", (long long)r->hermites, (long long)r->n);
    if (r->coherences != 0 && r->coherences != r->n)
        return reason("array coherence: %lld rows for %lld frequencies", (long long)r->coherences, (long long)r->n);
    for (int64_t i = 0; i < r->coherences; i++)
        if (r->coherence[i] < 0 || r->coherence[i] > 1)
            return reason("array coherence: %g at %lld is not within 0 to 1", r->coherence[i], (long long)i);
    for (int64_t i = 0; i < r->n; i++)
        if (r->frequency[i] < 0 || (i && !(r->frequency[i] > r->frequency[i - 1])))
            return reason("array frequency: negative or not increasing at %lld", (long long)i);
    return NULL;
}

static const char *read_direction(const struct vxf *f, const char *key, int *lateral)
{
    char word[12];
    const char *why = vxf_key(f, key, word, sizeof word);

    if (!why && !is_one_of(word, direction))
        why = reason("header key %s: \"%s\" is not vertical or lateral", key, word);
    *lateral = !why && strcmp(word, direction[1]) == 0;
    return why;
}

static const char *read_keys(struct frf *r, const struct vxf *f)
{
    char quantity[16];
    const char *why = vxf_key(f, "QUANTITY", quantity, sizeof quantity);

    if (why || (why = vxf_key(f, "FORCE", r->force.on, sizeof r->force.on)) ||
        (why = vxf_key(f, "FORCE_AT", r->force.at, sizeof r->force.at)) ||
        (why = vxf_key(f, "MOTION", r->motion.on, sizeof r->motion.on)) ||
        (why = vxf_key(f, "MOTION_AT", r->motion.at, sizeof r->motion.at)) ||
        (why = read_direction(f, "FORCE_DIRECTION", &r->force.lateral)) ||
        (why = read_direction(f, "MOTION_DIRECTION", &r->motion.lateral)))
        return why;
    while (r->quantity < FRF_QUANTITIES && strcmp(quantity, frf_quantity[r->quantity].name))
        r->quantity++;
    return r->quantity < FRF_QUANTITIES ? NULL : reason("header key QUANTITY: \"%s\" is not receptance, mobility or accelerance", quantity);
}

const char *frf_read(struct frf *r, const struct vxf *f)
{
    int64_t n[1] = {-1}, rows[2] = {-1, 2}, more[2] = {-1, 2}, coherences[1] = {-1};
    const void *x[2], *frequency, *H, *hermite, *coherence;
    const char *why;

    memset(r, 0, sizeof *r);
    if ((why = vxf_is(f, "frf")) || (why = read_keys(r, f)) || (why = vxf_get(f, "force_x", VXF_F64, "m", 0, NULL, &x[0])) ||
        (why = vxf_get(f, "motion_x", VXF_F64, "m", 0, NULL, &x[1])) ||
        (why = vxf_get(f, "frequency", VXF_F64, "Hz", 1, n, &frequency)))
        return why;
    const struct frf_quantity *q = &frf_quantity[r->quantity];
    rows[0] = n[0];
    if ((why = vxf_get(f, q->name, VXF_F64, q->unit, 2, rows, &H)) || (why = vxf_get(f, "hermite", VXF_F64, q->unit, 2, more, &hermite)) ||
        (why = vxf_get(f, "coherence", VXF_F64, "1", 1, coherences, &coherence)))
        return why;
    r->force.x = *(const double *)x[0];
    r->motion.x = *(const double *)x[1];
    r->n = n[0];
    r->hermites = more[0];
    r->frequency = frequency;
    r->H = H;
    r->hermite = hermite;
    r->coherence = coherence;
    r->coherences = coherences[0];
    return check(r);
}

const char *frf_put(const struct frf *r, struct vxf_out *o)
{
    const char *why = check(r);
    if (why)
        return why;
    const struct frf_quantity *q = &frf_quantity[r->quantity];
    vxf_put_key(o, "QUANTITY", "%s", q->name);
    vxf_put_key(o, "FORCE", "%s", r->force.on);
    vxf_put_key(o, "FORCE_AT", "%s", r->force.at);
    vxf_put_key(o, "MOTION", "%s", r->motion.on);
    vxf_put_key(o, "MOTION_AT", "%s", r->motion.at);
    vxf_put_key(o, "FORCE_DIRECTION", "%s", direction[r->force.lateral != 0]);
    vxf_put_key(o, "MOTION_DIRECTION", "%s", direction[r->motion.lateral != 0]);
    vxf_put(o, "force_x", VXF_F64, "m", 0, NULL, &r->force.x);
    vxf_put(o, "motion_x", VXF_F64, "m", 0, NULL, &r->motion.x);
    vxf_put(o, "frequency", VXF_F64, "Hz", 1, &r->n, r->frequency);
    vxf_put(o, q->name, VXF_F64, q->unit, 2, (int64_t[]){r->n, 2}, r->H);
    vxf_put(o, "hermite", VXF_F64, q->unit, 2, (int64_t[]){r->hermites, 2}, r->hermite);
    vxf_put(o, "coherence", VXF_F64, "1", 1, &r->coherences, r->coherence);
    return NULL;
}

void frf_free(struct frf *r)
{
    free(r->store);
    memset(r, 0, sizeof *r);
}
