/* splitmix64 (Steele, Lea and Flood 2014, OOPSLA), normal numbers after Box and Muller 1958. */
#include "formats/random.h"

#include <math.h>

void random_begin(struct random *r, uint64_t seed)
{
    r->state = seed;
}

static uint64_t next(struct random *r)
{
    uint64_t x = r->state += 0x9e3779b97f4a7c15u;

    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

double random_uniform(struct random *r)
{
    return (double)(next(r) >> 11) / 9007199254740992.0; /* 2^53 */
}

/* Neither end included: it has a logarithm. */
static double within(struct random *r)
{
    return ((double)(next(r) >> 12) + 0.5) / 4503599627370496.0; /* 2^52 */
}

void random_normal(struct random *r, double x[2])
{
    const double radius = sqrt(-2 * log(within(r))), angle = 2 * M_PI * within(r);

    x[0] = radius * cos(angle);
    x[1] = radius * sin(angle);
}
