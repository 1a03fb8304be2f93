/* Reading, checking and writing receptances. */
#include "formats/frf.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

static const char *check(const struct frf *r)
{
    if (strcmp(r->excite, "left") && strcmp(r->excite, "right") && strcmp(r->excite, "both"))
        return reason("header key EXCITE: \"%s\" is not left, right or both", r->excite);
    if (strcmp(r->at, "sleeper") && strcmp(r->at, "midspan"))
        return reason("header key AT: \"%s\" is not sleeper or midspan", r->at);
    if (r->hermites != 0 && r->hermites != r->n)
        return reason("array hermite: %lld rows for %lld frequencies", (long long)r->hermites, (long long)r->n);
    for (int64_t i = 0; i < r->n; i++)
        if (r->frequency[i] < 0 || (i && !(r->frequency[i] > r->frequency[i - 1])))
            return reason("array frequency: negative or not increasing at %lld", (long long)i);
    return NULL;
}

const char *frf_read(struct frf *r, const struct vxf *f)
{
    int64_t n[1] = {-1}, rows[2] = {-1, 2}, more[2] = {-1, 2};
    const void *x, *frequency, *receptance, *hermite;
    const char *why;

    memset(r, 0, sizeof *r);
    if ((why = vxf_is(f, "frf")) || (why = vxf_key(f, "EXCITE", r->excite, sizeof r->excite)) ||
        (why = vxf_key(f, "AT", r->at, sizeof r->at)) || (why = vxf_get(f, "x", VXF_F64, "m", 0, NULL, &x)) ||
        (why = vxf_get(f, "frequency", VXF_F64, "Hz", 1, n, &frequency)))
        return why;
    rows[0] = n[0];
    if ((why = vxf_get(f, "receptance", VXF_F64, "m/N", 2, rows, &receptance)) ||
        (why = vxf_get(f, "hermite", VXF_F64, "m/N", 2, more, &hermite)))
        return why;
    r->x = *(const double *)x;
    r->n = n[0];
    r->hermites = more[0];
    r->frequency = frequency;
    r->receptance = receptance;
    r->hermite = hermite;
    return check(r);
}

const char *frf_put(const struct frf *r, struct vxf_out *o)
{
    const char *why = check(r);
    if (why)
        return why;
    vxf_put_key(o, "EXCITE", "%s", r->excite);
    vxf_put_key(o, "AT", "%s", r->at);
    vxf_put(o, "x", VXF_F64, "m", 0, NULL, &r->x);
    vxf_put(o, "frequency", VXF_F64, "Hz", 1, &r->n, r->frequency);
    vxf_put(o, "receptance", VXF_F64, "m/N", 2, (int64_t[]){r->n, 2}, r->receptance);
    vxf_put(o, "hermite", VXF_F64, "m/N", 2, (int64_t[]){r->hermites, 2}, r->hermite);
    return NULL;
}

void frf_free(struct frf *r)
{
    free(r->store);
    memset(r, 0, sizeof *r);
}
