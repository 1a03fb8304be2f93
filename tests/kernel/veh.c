/* A vehicle in a file: what was put is read, and what no user of a vehicle could bear is refused at both doors. */
#include "formats/veh.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "formats/veh_text.h"
#include "tests/kernel/tap.h"
#include "tools/vehicle/vehicle.h"

static const char *build(struct veh *v)
{
    struct veh_text in;
    uint64_t hash;

    memset(v, 0, sizeof *v);
    const char *why = veh_text_read(&in, "data/vehicles/manchester-passenger.yaml", NULL, 0, &hash);
    if (why)
        return why;
    why = vehicle_build(v, &in);
    veh_text_free(&in);
    return why;
}

static const char *write_file(const struct veh *v, const char *path)
{
    struct vxf_out o;
    FILE *file = fopen(path, "wb");

    if (!file)
        return "no file";
    vxf_out_begin(&o, "veh");
    const char *why = veh_put(v, &o);
    if (!why)
        why = vxf_write(&o, file);
    vxf_out_free(&o);
    return fclose(file) ? "not closed" : why;
}

static void test_round_trip(const struct veh *v, const char *path)
{
    struct vxf f;
    struct veh r;
    const char *why = write_file(v, path);

    if (!ok(!why, "a vehicle is written: %s", why ? why : "done"))
        return;
    why = vxf_open(&f, path);
    if (!ok(!why, "opened: %s", why ? why : "done"))
        return;
    why = veh_read(&r, &f);
    if (ok(!why, "and read: %s", why ? why : "done")) {
        size_t n = (size_t)v->bodies, m = (size_t)v->couplings, w = (size_t)v->wheelsets, k = (size_t)v->knots;
        ok(r.bodies == 7 && r.couplings == 16 && r.wheelsets == 4 && r.knots == 18, "7 bodies, 16 couplings, 4 wheelsets, 18 knots");
        ok(!strcmp(r.name, v->name) && r.gravity == v->gravity, "name and gravity are as put");
        ok(!memcmp(r.body_name, v->body_name, n*sizeof *r.body_name) && !memcmp(r.cg, v->cg, 3*n*sizeof(double)) &&
           !memcmp(r.mass, v->mass, n*sizeof(double)) && !memcmp(r.inertia, v->inertia, 3*n*sizeof(double)), "so are the bodies");
        ok(!memcmp(r.ends, v->ends, 2*m*sizeof(int64_t)) && !memcmp(r.bearing, v->bearing, m*sizeof(int64_t)) &&
           !memcmp(r.stiffness, v->stiffness, 6*m*sizeof(double)) && !memcmp(r.preload, v->preload, 3*m*sizeof(double)) &&
           !memcmp(r.knot_first, v->knot_first, (m + 1)*sizeof(int64_t)) && !memcmp(r.knot_force, v->knot_force, k*sizeof(double)),
           "the couplings");
        ok(!memcmp(r.wheel_load, v->wheel_load, 2*w*sizeof(double)) && !memcmp(r.K, v->K, 36*n*n*sizeof(double)), "loads and stiffness");
    }
    veh_free(&r);
    vxf_close(&f);
}

static void test_refusals(const struct veh *good)
{
    int64_t ends[32], bearing[16], knot_first[17], wheelset[4];
    double mass[7], knot_at[18];
    struct veh v;

#define SPOIL(member, array, at, value, what) do { \
        v = *good; \
        memcpy(array, good->member, sizeof array); \
        array[at] = value; \
        v.member = array; \
        const char *why = veh_check(&v); \
        ok(why != NULL, "refused: %s (%s)", what, why ? why : "accepted"); \
    } while (0)

    SPOIL(ends, ends, 3, 7, "a coupling of body 7 of 0 to 6");
    SPOIL(ends, ends, 3, -1, "a coupling of body -1");
    SPOIL(bearing, bearing, 0, -1, "an axlebox that is none");
    SPOIL(knot_first, knot_first, 15, 19, "more knots than there are");
    SPOIL(knot_first, knot_first, 3, 2, "knots of a spring");
    SPOIL(knot_at, knot_at, 1, 0.025, "two knots at one deflection");
    SPOIL(wheelset, wheelset, 1, 8, "a wheelset that is no body");
    SPOIL(wheelset, wheelset, 0, 4, "wheelsets out of order");
    SPOIL(mass, mass, 2, 0, "a body without mass");
#undef SPOIL
}

int main(void)
{
    char path[] = "/tmp/veh.XXXXXX";
    int fd = mkstemp(path);
    struct veh v;
    const char *why = build(&v);

    if (fd < 0 || !ok(!why, "the Manchester coach: %s", why ? why : "built"))
        return done();
    close(fd);
    test_round_trip(&v, path);
    test_refusals(&v);
    unlink(path);
    veh_free(&v);
    return done();
}
