/* The vehicle at rest: weights reach the wheels, every body is in balance, and what cannot stand is refused. */
#include "tools/vehicle/statics.h"

#include <stdlib.h>
#include <string.h>

#include "formats/veh_text.h"
#include "tests/kernel/tap.h"
#include "tools/vehicle/couplings.h"
#include "tools/vehicle/vehicle.h"

#define COACH "data/vehicles/manchester-passenger.yaml"

static const char *load(struct veh *v, const char *path, const char *one, const char *two)
{
    struct veh_text in;
    uint64_t hash;
    char a[64], b[64], *set[2] = {a, b};

    snprintf(a, sizeof a, "%s", one ? one : "");
    snprintf(b, sizeof b, "%s", two ? two : "");
    memset(v, 0, sizeof *v);
    const char *why = veh_text_read(&in, path, set, (one != NULL) + (two != NULL), &hash);
    if (why)
        return why;
    why = vehicle_build(v, &in);
    veh_text_free(&in);
    return why;
}

/* Largest force or moment left on a body other than a wheelset, with its weight, over the weight of all. */
static double imbalance(const struct veh *v)
{
    int64_t n = VEH_DOFS*v->bodies;
    double *zero = calloc((size_t)n, sizeof *zero), *f = calloc((size_t)n, sizeof *f), most = 0, all = 0;

    couplings_force(v, NULL, zero, zero, f);
    for (int64_t i = 0; i < v->bodies; i++) {
        f[VEH_DOFS*i + VEH_Z] += v->mass[i]*v->gravity;
        all += v->mass[i]*v->gravity;
    }
    for (int64_t i = 0; i < n - VEH_DOFS*v->wheelsets; i++)
        most = fmax(most, fabs(f[i]));
    free(zero);
    free(f);
    return most/all;
}

static void test_coach(void)
{
    struct veh v;
    const char *why = load(&v, COACH, NULL, NULL);

    if (!ok(!why, "the Manchester coach stands: %s", why ? why : "")) {
        veh_free(&v);
        return;
    }
    double total = 0, mass = 0;
    for (int64_t i = 0; i < v.bodies; i++)
        mass += v.mass[i];
    near(mass, 44482, 1e-9, "it weighs 44 482 kg");
    for (int w = 0; w < 8; w++) {
        total += v.wheel_load[w];
        near(v.wheel_load[w], 44482*9.81/8, 1e-6, "each wheel carries an eighth, 54.55 kN");
    }
    near(total, mass*v.gravity, 1e-6, "wheel loads sum to the weight");
    ok(imbalance(&v) < 1e-12, "every body is in balance: %.1e of the weight is left", imbalance(&v));
    veh_free(&v);
}

/* A carbody off its middle: y = 0.1 m to the right, x 1 m towards the front. */
static void test_off_centre(void)
{
    struct veh v;
    const char *why = load(&v, COACH, "body.1.y=0.1", "body.1.x=-9.78");
    double left = 0, right = 0, front = 0;

    if (!ok(!why, "a carbody off its middle stands: %s", why ? why : ""))
        return;
    for (int w = 0; w < 4; w++) {
        left += v.wheel_load[2*w];
        right += v.wheel_load[2*w + 1];
        front += w < 2 ? v.wheel_load[2*w] + v.wheel_load[2*w + 1] : 0;
    }
    near(right - left, 32000*9.81*0.1/STATICS_CONTACT_LEVER, 1e-6, "the right wheels carry its moment about the track");
    near(front, (44482.0/2 + 32000*1.0/19)*9.81, 1e-6, "the front bogie its share by the lever of 19 m");
    ok(imbalance(&v) < 1e-12, "every body is in balance: %.1e of the weight is left", imbalance(&v));
    veh_free(&v);
}

/* The trains of the study: 19 t and 22.5 t a wheelset. */
static void test_trains(void)
{
    static const struct { const char *path; double load; } train[] = {
        {"data/vehicles/passenger-19t.yaml", 93.2e3}, {"data/vehicles/freight-y25-22t5.yaml", 110.4e3},
        {"data/vehicles/freight-y25-22t5-linear.yaml", 110.4e3}, {"data/vehicles/freight-y25-tare.yaml", 24.525e3},
        {"data/vehicles/wheelset.yaml", 54.55e3}};

    for (size_t i = 0; i < sizeof train/sizeof *train; i++) {
        struct veh v;
        const char *why = load(&v, train[i].path, NULL, NULL);
        if (ok(!why, "%s: %s", train[i].path, why ? why : "stands")) {
            near(v.wheel_load[0], train[i].load, 0.001*train[i].load, "its first left wheel carries what it should");
            ok(imbalance(&v) < 1e-12, "every body is in balance");
        }
        veh_free(&v);
    }
}

static void test_refusals(void)
{
    static const struct { const char *one, *two, *what; } bad[] = {
        {"coupling.5.stiffness=[160e3,160e3,0]", "coupling.6.stiffness=[160e3,160e3,0]", "nothing carries it"},
        {"coupling.5.stiffness=[0,160e3,430e3]", "coupling.6.stiffness=[0,160e3,430e3]", "nothing holds it along x"},
        {"body.1.mass=0", NULL, "no mass"},
        {"body.1.inertia=[56800,0,1.97e6]", NULL, "no inertia"},
        {"body.2.name=carbody", NULL, "a name twice"},
        {"coupling.5.from=boogie1", NULL, "an unknown body"},
        {"coupling.5.from=carbody", NULL, "a coupling of a body with itself"},
        {"coupling.1.at=[0.1,1.0,0.46]", NULL, "an axlebox off its axle"},
        {"coupling.7.mirror=true", NULL, "a twin in the middle"},
        {"wheelset.2.x=0", NULL, "wheelsets out of order"},
        {"stop.1.table=[[0.025,1],[0.03,600]]", NULL, "a stop that starts with a force"},
        {"body.1.y=3", NULL, "a wheel that lifts"},
    };
    for (size_t i = 0; i < sizeof bad/sizeof *bad; i++) {
        struct veh v;
        const char *why = load(&v, COACH, bad[i].one, bad[i].two);
        ok(why != NULL, "refused: %s (%s)", bad[i].what, why ? why : "accepted");
        veh_free(&v);
    }
}

int main(void)
{
    test_coach();
    test_off_centre();
    test_trains();
    test_refusals();
    return done();
}
