/* Nanoseconds of one creep force, over a thousand contacts: "fastsim NS" on 10 x 10 cells, "table NS" from FILE.creep. */
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "formats/creep.h"
#include "tools/creep/fastsim.h"
#include "tools/creep/table.h"

enum { CONTACTS = 1000, ROUNDS = 200, TIMES = 5 };

static const double G = 82e9, NU = 0.28, MU = 0.3, N = 60e3;

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9*(double)t.tv_sec + (double)t.tv_nsec;
}

/* By FASTSIM where there is no table. */
static double measure(const struct fastsim *f, const struct creep *t)
{
    double best = HUGE_VAL, sum = 0, F[3];

    for (int k = 0; k < TIMES; k++) {
        double begun = now();
        for (int i = 0; i < ROUNDS*CONTACTS; i++) {
            double a = 4e-3 + 1e-6*(i*389 % CONTACTS), b = 4e-3 + 1e-6*(i*577 % CONTACTS);
            double xi = 6e-6*(i*37 % CONTACTS) - 3e-3, eta = 6e-6*(i*613 % CONTACTS) - 3e-3, phi = 1e-3*(i*211 % CONTACTS) - 0.5;
            if (t)
                creep_table(t, a, b, N, MU, G, NU, xi, eta, phi, F);
            else
                fastsim(f, a, b, N, MU, G, NU, xi, eta, phi, F);
            sum += F[0];
        }
        best = fmin(best, (now() - begun)/(ROUNDS*CONTACTS));
    }
    return isfinite(sum) ? best : NAN;
}

int main(int argc, char **argv)
{
    static struct fastsim f;
    struct vxf file;
    struct creep t;
    const char *why = argc == 2 ? vxf_open(&file, argv[1]) : "usage: creep FILE.creep";

    if (why || (why = creep_read(&t, &file))) {
        fprintf(stderr, "creep: %s\n", why);
        return 1;
    }
    fastsim_begin(&f, 10);
    printf("fastsim %.1f\ntable %.1f\n", measure(&f, NULL), measure(NULL, &t));
    vxf_close(&file);
    return 0;
}
