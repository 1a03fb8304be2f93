/* Edges rounded by discs, against the circle that touches both surfaces: between steep and flat ones, wherever columns meet them. */
#include "tests/kernel/tap.h"

#include "tools/profile/opening.h"

#define STEP 2.5e-5          /* m */
#define RADIUS 3.5e-3        /* m */

enum { COLUMNS = 800 };

/* A face that falls to the left with `steep` and a top that falls to the right with `flat`, meeting at y = corner. */
static double rounded(double y, double corner, double steep, double flat)
{
    double a = sqrt(1 + steep * steep), b = sqrt(1 + flat * flat), y0 = RADIUS * (a - b) / (steep + flat), z0 = RADIUS * b + flat * y0;
    double x = y - corner;

    if (x <= y0 - RADIUS * steep / a)
        return -steep * x;
    if (x >= y0 + RADIUS * flat / b)
        return flat * x;
    return z0 - sqrt(RADIUS * RADIUS - (x - y0) * (x - y0));
}

static void test_edge(double steep, double flat)
{
    double z[COLUMNS], work[2 * COLUMNS], worst = 0;

    for (int k = 0; k < 10; k++) {
        double corner = COLUMNS / 2 * STEP + 0.1 * k * STEP;
        for (int i = 0; i < COLUMNS; i++)
            z[i] = fmax(-steep * (i * STEP - corner), flat * (i * STEP - corner));
        opening_round(COLUMNS, STEP, INFINITY, RADIUS, z, work);
        for (int i = 200; i < COLUMNS - 200; i++)
            worst = fmax(worst, fabs(z[i] - rounded(i * STEP, corner, steep, flat)));
    }
    ok(worst < 1e-10, "face %g:1, top %g:1: beside the circle by %.2g m", steep, flat, worst);
}

int main(void)
{
    test_edge(20, 0.3);
    test_edge(60, 0.05);
    test_edge(5, 1);
    test_edge(1, 0.3);
    return done();
}
