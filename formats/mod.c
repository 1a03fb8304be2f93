/* Reading, checking and writing natural modes. */
#include "formats/mod.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

static const char *check(const struct mod *m)
{
    if (strcmp(m->of, "trk") && strcmp(m->of, "veh"))
        return reason("header key OF: \"%s\" is not trk or veh", m->of);
    if (m->imaginaries != 0 && m->imaginaries != m->n)
        return reason("array imaginary: %lld rows for %lld modes", (long long)m->imaginaries, (long long)m->n);
    for (int64_t i = 0; i < m->n; i++) {
        if (m->frequency[i] < 0 || (i && m->frequency[i] < m->frequency[i - 1]))
            return reason("array frequency: negative or decreasing at %lld", (long long)i);
        if (!memchr(m->name[i], 0, sizeof m->name[i]))
            return reason("array name: no end at %lld", (long long)i);
    }
    return NULL;
}

const char *mod_read(struct mod *m, const struct vxf *f)
{
    int64_t n[1] = {-1}, letters[2], shape[2], more[2] = {-1, -1};
    const void *frequency, *damping, *name, *values, *imaginary;
    const char *why;

    memset(m, 0, sizeof *m);
    if ((why = vxf_is(f, "mod")) || (why = vxf_key(f, "OF", m->of, sizeof m->of)) ||
        (why = vxf_get(f, "frequency", VXF_F64, "Hz", 1, n, &frequency)) ||
        (why = vxf_get(f, "damping", VXF_F64, "1", 1, n, &damping)))
        return why;
    letters[0] = shape[0] = n[0];
    letters[1] = sizeof m->name[0];
    shape[1] = -1;
    if ((why = vxf_get(f, "name", VXF_U8, "text", 2, letters, &name)) || (why = vxf_get(f, "shape", VXF_F64, "1", 2, shape, &values)))
        return why;
    more[1] = shape[1];
    if ((why = vxf_get(f, "imaginary", VXF_F64, "1", 2, more, &imaginary)))
        return why;
    m->n = n[0];
    m->dofs = shape[1];
    m->frequency = frequency;
    m->damping = damping;
    m->name = (const char (*)[32])name;
    m->shape = values;
    m->imaginary = imaginary;
    m->imaginaries = more[0];
    return check(m);
}

const char *mod_put(const struct mod *m, struct vxf_out *o)
{
    const char *why = check(m);
    if (why)
        return why;
    vxf_put_key(o, "OF", "%s", m->of);
    vxf_put(o, "frequency", VXF_F64, "Hz", 1, &m->n, m->frequency);
    vxf_put(o, "damping", VXF_F64, "1", 1, &m->n, m->damping);
    vxf_put(o, "name", VXF_U8, "text", 2, (int64_t[]){m->n, sizeof m->name[0]}, m->name);
    vxf_put(o, "shape", VXF_F64, "1", 2, (int64_t[]){m->n, m->dofs}, m->shape);
    vxf_put(o, "imaginary", VXF_F64, "1", 2, (int64_t[]){m->imaginaries, m->dofs}, m->imaginary);
    return NULL;
}

void mod_free(struct mod *m)
{
    free(m->store);
    memset(m, 0, sizeof *m);
}
