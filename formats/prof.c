/* The .prof file: header keys NAME SIDE PART POSITION RADIUS, then the arrays in the order of struct prof. */
#include "formats/prof.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

static const char *keys_read(struct prof *p, const struct vxf *f)
{
    char side[16], part[16];
    const char *why;

    if ((why = vxf_key(f, "NAME", p->name, sizeof p->name)) || (why = vxf_key(f, "SIDE", side, sizeof side)) ||
        (why = vxf_key(f, "PART", part, sizeof part)) || (why = vxf_number(f, "POSITION", &p->position)) ||
        (why = vxf_number(f, "RADIUS", &p->radius)))
        return why;
    if (strcmp(side, "l") != 0 && strcmp(side, "r") != 0)
        return reason("SIDE must be l or r, is '%s'", side);
    if (strcmp(part, "wheel") != 0 && strcmp(part, "rail") != 0)
        return reason("PART must be wheel or rail, is '%s'", part);
    p->side = side[0];
    p->part = part[0];
    if (p->part == 'w' ? p->radius <= 0 : p->radius != 0)
        return reason("RADIUS must be positive for a wheel and 0 for a rail, is %g", p->radius);
    if (p->side == 'l' ? p->position >= 0 : p->position <= 0)
        return reason("POSITION must be negative on the left and positive on the right, is %g", p->position);
    return NULL;
}

static const char *arrays_read(struct prof *p, const struct vxf *f)
{
    int64_t name = PROF_NAME, bodies[2] = {-1, name}, firsts = -1;
    const char *why;

    p->sections = p->polys = p->points = -1;
    if ((why = vxf_get(f, "station", VXF_F64, "m", 1, &p->sections, (const void **)&p->station)) ||
        (why = vxf_get(f, "body", VXF_U8, "text", 2, bodies, (const void **)&p->body)) ||
        (why = vxf_get(f, "poly_section", VXF_I64, "1", 1, &p->polys, (const void **)&p->poly_section)) ||
        (why = vxf_get(f, "poly_body", VXF_I64, "1", 1, &p->polys, (const void **)&p->poly_body)) ||
        (why = vxf_get(f, "poly_first", VXF_I64, "1", 1, &firsts, (const void **)&p->poly_first)) ||
        (why = vxf_get(f, "y", VXF_F64, "m", 1, &p->points, (const void **)&p->y)) ||
        (why = vxf_get(f, "z", VXF_F64, "m", 1, &p->points, (const void **)&p->z)) ||
        (why = vxf_get(f, "slope", VXF_F64, "1", 1, &p->points, (const void **)&p->slope)) ||
        (why = vxf_get(f, "curvature", VXF_F64, "1/m", 1, &p->points, (const void **)&p->curvature)) ||
        (why = vxf_get(f, "fall", VXF_F64, "1", 1, &p->points, (const void **)&p->fall)))
        return why;
    p->bodies = bodies[0];
    if (firsts != p->polys + 1)
        return reason("array poly_first: %lld entries for %lld polylines", (long long)firsts, (long long)p->polys);
    return NULL;
}

/* Every section is there, in order, with each of its bodies once. */
static const char *polys_check(const struct prof *p)
{
    for (int64_t i = 0; i < p->polys; i++) {
        int64_t s = p->poly_section[i], before = i ? p->poly_section[i - 1] : -1;
        if (s < before || s > before + 1 || s >= p->sections)
            return reason("array poly_section: %lld at %lld leaves out or repeats a section", (long long)s, (long long)i);
        if (p->poly_body[i] < 0 || p->poly_body[i] >= p->bodies)
            return reason("array poly_body: no body %lld at %lld", (long long)p->poly_body[i], (long long)i);
        if (s == before && p->poly_body[i] <= p->poly_body[i - 1])
            return reason("array poly_body: bodies of section %lld not increasing", (long long)s);
        if (p->poly_first[i] < 0 || p->poly_first[i] > p->points - 2 || p->poly_first[i + 1] < p->poly_first[i] + 2)
            return reason("array poly_first: polyline %lld has fewer than two points", (long long)i);
    }
    if (p->polys == 0 || p->poly_section[p->polys - 1] != p->sections - 1)
        return "array poly_section: sections without a polyline";
    if (p->poly_first[0] != 0 || p->poly_first[p->polys] != p->points)
        return "array poly_first: does not cover all points";
    return NULL;
}

static const char *values_check(const struct prof *p)
{
    for (int64_t i = 0; i < p->bodies; i++)
        if (!memchr(p->body[i], '\0', PROF_NAME))
            return reason("array body: name %lld does not end", (long long)i);
    for (int64_t i = 1; i < p->sections; i++)
        if (p->station[i] <= p->station[i - 1])
            return reason("array station: not increasing at %lld", (long long)i);
    for (int64_t i = 0; i < p->polys; i++)
        for (int64_t k = p->poly_first[i] + 1; k < p->poly_first[i + 1]; k++)
            if (p->y[k] <= p->y[k - 1])
                return reason("array y: not increasing at %lld", (long long)k);
    return NULL;
}

const char *prof_read(struct prof *p, const struct vxf *f)
{
    const char *why;

    *p = (struct prof){0};
    if ((why = vxf_is(f, "prof")) || (why = keys_read(p, f)) || (why = arrays_read(p, f)) || (why = polys_check(p)))
        return why;
    return values_check(p);
}

int64_t prof_nearest(const struct prof *p, double s)
{
    int64_t best = 0;

    for (int64_t i = 1; i < p->sections; i++)
        best = fabs(p->station[i] - s) < fabs(p->station[best] - s) ? i : best;
    return best;
}

const char *prof_put(const struct prof *p, struct vxf_out *o)
{
    int64_t bodies[2] = {p->bodies, PROF_NAME}, firsts = p->polys + 1;
    const char *why;

    if ((why = polys_check(p)) || (why = values_check(p)))
        return why;
    vxf_put_key(o, "NAME", "%s", p->name);
    vxf_put_key(o, "SIDE", "%c", p->side);
    vxf_put_key(o, "PART", "%s", p->part == 'w' ? "wheel" : "rail");
    vxf_put_key(o, "POSITION", "%.17g", p->position);
    vxf_put_key(o, "RADIUS", "%.17g", p->radius);
    vxf_put(o, "station", VXF_F64, "m", 1, &p->sections, p->station);
    vxf_put(o, "body", VXF_U8, "text", 2, bodies, p->body);
    vxf_put(o, "poly_section", VXF_I64, "1", 1, &p->polys, p->poly_section);
    vxf_put(o, "poly_body", VXF_I64, "1", 1, &p->polys, p->poly_body);
    vxf_put(o, "poly_first", VXF_I64, "1", 1, &firsts, p->poly_first);
    vxf_put(o, "y", VXF_F64, "m", 1, &p->points, p->y);
    vxf_put(o, "z", VXF_F64, "m", 1, &p->points, p->z);
    vxf_put(o, "slope", VXF_F64, "1", 1, &p->points, p->slope);
    vxf_put(o, "curvature", VXF_F64, "1/m", 1, &p->points, p->curvature);
    vxf_put(o, "fall", VXF_F64, "1", 1, &p->points, p->fall);
    return NULL;
}

void prof_free(struct prof *p)
{
    free(p->store);
    *p = (struct prof){0};
}
