/* Repeatable numbers for tests. */
#ifndef VX_RANDOM_H
#define VX_RANDOM_H

#include <stdint.h>

/* Within 0..1, the same sequence in every program (xorshift, Marsaglia 2003). */
static inline double random_number(void)
{
    static uint64_t state = 88172645463325252u;

    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

#endif
