#include "tools/vehicle/join.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "formats/reason.h"
#include "tools/vehicle/linear.h"

enum { WORD = 8 };      /* bytes of a number, whole or not */

#define AT(member) offsetof(struct veh, member)

/* Arrays that stand one behind the other, by what they count. */
static const struct row { size_t member, count; int64_t width; } rows[] = {
    {AT(mass), AT(bodies), 1}, {AT(inertia), AT(bodies), 3}, {AT(cg), AT(bodies), 3},
    {AT(type), AT(couplings), 1}, {AT(ends), AT(couplings), 2}, {AT(bearing), AT(couplings), 1}, {AT(point), AT(couplings), 3},
    {AT(end), AT(couplings), 3}, {AT(stiffness), AT(couplings), 6}, {AT(damping), AT(couplings), 6}, {AT(preload), AT(couplings), 3},
    {AT(axis), AT(couplings), 1}, {AT(series), AT(couplings), 1}, {AT(rest), AT(couplings), 1}, {AT(coefficient), AT(couplings), 1},
    {AT(load), AT(couplings), 1}, {AT(spring), AT(couplings), 1}, {AT(share), AT(couplings), 1}, {AT(lever), AT(couplings), 1},
    {AT(knot_first), AT(couplings), 1}, {AT(knot_at), AT(knots), 1}, {AT(knot_force), AT(knots), 1},
    {AT(wheelset), AT(wheelsets), 1}, {AT(radius), AT(wheelsets), 1}, {AT(wheel_load), AT(wheelsets), 2},
};
enum { ROWS = sizeof rows / sizeof *rows };

static int64_t count_of(const struct veh *v, const struct row *r)
{
    return *(const int64_t *)(const void *)((const char *)v + r->count);
}

static const void *array_of(const struct veh *v, const struct row *r)
{
    const void *x;

    memcpy(&x, (const char *)v + r->member, sizeof x);
    return x;
}

/* Room for one more of each, that knot_first ends in. */
static const char *chain(struct veh *v, const struct veh *part, int64_t n)
{
    for (int k = 0; k < ROWS; k++) {
        char *x = veh_room(v, rows[k].width * (count_of(v, &rows[k]) + 1), WORD), *to = x;
        if (!x)
            return REASON_MEMORY;
        for (int64_t i = 0; i < n; i++) {
            const size_t size = (size_t)(rows[k].width * count_of(&part[i], &rows[k])) * WORD;
            memcpy(to, array_of(&part[i], &rows[k]), size);
            to += size;
        }
        memcpy((char *)v + rows[k].member, &x, sizeof x);
    }
    return NULL;
}

/* name.number into to; fails where that is too long. */
static const char *name_part(char to[32], const char *name, int64_t number)
{
    return snprintf(to, 32, "%s.%lld", name, (long long)number) < 32 ? NULL : reason("%s: too long for a name in a train", name);
}

static const char *name_parts(struct veh *v, const struct veh *part, int64_t n)
{
    char (*body)[32] = veh_room(v, v->bodies, sizeof *body), (*coupling)[32] = veh_room(v, v->couplings + 1, sizeof *coupling);
    int64_t b = 0, c = 0;
    const char *why = NULL;

    if (!body || !coupling)
        return REASON_MEMORY;
    for (int64_t i = 0; i < n; i++) {
        for (int64_t k = 0; k < part[i].bodies && !why; k++)
            why = name_part(body[b++], part[i].body_name[k], i + 1);
        for (int64_t k = 0; k < part[i].couplings && !why; k++)
            why = name_part(coupling[c++], part[i].coupling_name[k], i + 1);
    }
    for (int64_t i = 1; c < v->couplings && !why; i++)
        why = name_part(coupling[c++], "coupler", i);
    v->body_name = (const char (*)[32])body;
    v->coupling_name = (const char (*)[32])coupling;
    return why;
}

static double last_x(const struct veh *v)
{
    return v->cg[3*v->wheelset[v->wheelsets - 1]];
}

static int64_t heaviest(const struct veh *v)
{
    int64_t most = -1;

    for (int64_t i = 0; i < v->bodies; i++)
        if (!veh_is_wheelset(v, i) && (most < 0 || v->mass[i] > v->mass[most]))
            most = i;
    return most;
}

/* The arrays of v, which join_vehicles made, to write. */
#define OWN(type, member) ((type *)(uintptr_t)v->member)

/* Places and numbers of one part, whose items come after `before`; its first wheelset at x. */
static void move_part(struct veh *v, const struct veh *part, const struct veh *before, double x)
{
    for (int64_t b = before->bodies; b < before->bodies + part->bodies; b++)
        OWN(double, cg)[3*b] += x;
    for (int64_t c = before->couplings; c < before->couplings + part->couplings; c++) {
        OWN(double, point)[3*c] += x;
        OWN(double, end)[3*c] += x;
        OWN(int64_t, ends)[2*c] += before->bodies;
        OWN(int64_t, ends)[2*c + 1] += before->bodies;
        OWN(int64_t, spring)[c] += v->spring[c] < 0 ? 0 : before->couplings;
        OWN(int64_t, knot_first)[c] += before->knots;
    }
    for (int64_t w = before->wheelsets; w < before->wheelsets + part->wheelsets; w++)
        OWN(int64_t, wheelset)[w] += before->bodies;
}

/* Coupling c, a rod about x from body a to body b behind it. */
static void couple(struct veh *v, int64_t c, int64_t a, int64_t b, double x, const struct join *j)
{
    OWN(int64_t, type)[c] = VEH_ROD;
    OWN(int64_t, ends)[2*c] = a;
    OWN(int64_t, ends)[2*c + 1] = b;
    OWN(int64_t, bearing)[c] = OWN(int64_t, spring)[c] = -1;
    OWN(double, point)[3*c] = x + 0.5*j->length;
    OWN(double, end)[3*c] = x - 0.5*j->length;
    OWN(double, point)[3*c + 2] = OWN(double, end)[3*c + 2] = -j->height;
    OWN(double, stiffness)[6*c] = j->stiffness;
    OWN(double, damping)[6*c] = j->damping;
    OWN(int64_t, knot_first)[c] = v->knots;
}

static const char *place_parts(struct veh *v, const struct veh *part, int64_t n, const struct join *j)
{
    struct veh before = {0};
    int64_t coupler = v->couplings - (j->stiffness > 0 ? n - 1 : 0), last = -1;
    double x = 0;

    for (int64_t i = 0; i < n; i++) {
        const int64_t body = heaviest(&part[i]);
        move_part(v, &part[i], &before, x);
        if (j->stiffness > 0 && body < 0)
            return reason("%s: has no body on springs for a coupler", part[i].name);
        if (i && j->stiffness > 0)
            couple(v, coupler++, last, before.bodies + body, x + 0.5*j->gap, j);
        last = before.bodies + body;
        before.bodies += part[i].bodies;
        before.couplings += part[i].couplings;
        before.wheelsets += part[i].wheelsets;
        before.knots += part[i].knots;
        x += last_x(&part[i]) - j->gap;
    }
    OWN(int64_t, knot_first)[v->couplings] = v->knots;
    return NULL;
}

const char *join_vehicles(struct veh *v, const struct veh *part, int64_t n, const struct join *j)
{
    const char *why;

    *v = (struct veh){.gravity = part->gravity, .couplings = j->stiffness > 0 ? n - 1 : 0};
    snprintf(v->name, sizeof v->name, "train of %.54s", part->name);
    for (int64_t i = 0; i < n; i++) {
        if (part[i].gravity != part->gravity)
            return reason("%s: gravity %g m/s2, but %g of the first", part[i].name, part[i].gravity, part->gravity);
        v->bodies += part[i].bodies;
        v->couplings += part[i].couplings;
        v->wheelsets += part[i].wheelsets;
        v->knots += part[i].knots;
    }
    const int64_t size = VEH_DOFS*v->bodies*VEH_DOFS*v->bodies;
    double *K = veh_room(v, size, sizeof *K), *C = veh_room(v, size, sizeof *C), *M = veh_room(v, size, sizeof *M);
    if (!K || !C || !M)
        return REASON_MEMORY;
    v->K = K;
    v->C = C;
    v->M = M;
    if ((why = chain(v, part, n)) || (why = name_parts(v, part, n)) || (why = place_parts(v, part, n, j)) || (why = veh_check(v)))
        return why;
    linear_matrices(v, M, C, K);
    return NULL;
}
