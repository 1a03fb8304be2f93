/* lookup TABLE.ctab: nanoseconds of one contact_lookup, CPU, best of seven rounds, a line each:
 *
 *   random N     stations, yaws, displacements and rolls all over the table: every call misses the processor's caches
 *   along N      those of one wheel over the table's length at 80 km/h, 1e-4 s a step, with a motion of a flange's play: cells repeat */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tests/kernel/random.h"
#include "tools/contact/lookup.h"

#define STEP (80 / 3.6 * 1e-4)      /* m */

enum { QUERIES = 100000, ROUNDS = 7 };

struct query { double s, yaw, u, roll; };

static double between(const double *axis, int64_t n)
{
    return axis[0] + random_number() * (axis[n - 1] - axis[0]);
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* s of one call; *sum keeps the compiler from leaving the calls out. */
static double time_calls(const struct ctab *t, const struct query *q, double *sum)
{
    struct contact c[CONTACT_MAX];
    double best = HUGE_VAL;

    for (int round = 0; round < ROUNDS; round++) {
        double start = seconds();
        for (int i = 0; i < QUERIES; i++)
            if (contact_lookup(t, q[i].s, q[i].yaw, q[i].u, q[i].roll, c) > 0)
                *sum += c[0].height;
        best = fmin(best, (seconds() - start) / QUERIES);
    }
    return best;
}

/* s of one read of a row at random, the next place known by what is read. */
static double time_chain(const struct ctab *t, double *sum)
{
    uint32_t at = 0, state = 1;
    double start = seconds();

    for (int i = 0; i < QUERIES; i++) {
        const float *row = t->row + (int64_t)at * CTAB_N;
        state = state * 1664525 + 1013904223 + (row[CTAB_HEIGHT] > 1);
        at = (uint32_t)((uint64_t)state * (uint64_t)t->rows >> 32);
    }
    *sum += at;
    return (seconds() - start) / QUERIES;
}

int main(int argc, char **argv)
{
    static struct query scattered[QUERIES], along[QUERIES];
    double sum = 0;
    struct vxf f;
    struct ctab t;
    const char *why = argc != 2 ? "usage: lookup TABLE.ctab" : vxf_open(&f, argv[1]);

    if (why || (why = ctab_read(&t, &f))) {
        fprintf(stderr, "lookup: %s\n", why);
        return 1;
    }
    for (int i = 0; i < QUERIES; i++) {
        double way = fmod(i * STEP, t.station[t.stations - 1] - t.station[0]), turn = 2 * acos(-1) * way / 9;
        scattered[i] = (struct query){
            between(t.station, t.stations), between(t.yaw, t.yaws), between(t.u, t.us), 2e-3 * (2 * random_number() - 1)
        };
        along[i] = (struct query){t.station[0] + way, 2e-3 * cos(turn), 5e-3 * sin(turn), 5e-4 * sin(turn)};
    }
    printf("random %.1f\n", 1e9 * time_calls(&t, scattered, &sum));
    printf("chain %.1f\n", 1e9 * time_chain(&t, &sum));
    printf("along %.1f\n", 1e9 * time_calls(&t, along, &sum));
    vxf_close(&f);
    return !isfinite(sum);
}
