/* Asks for the line of memory at p, which will be read some hundred cycles on; where the compiler knows how. */
#ifndef VX_CONTACT_PREFETCH_H
#define VX_CONTACT_PREFETCH_H

#ifdef __GNUC__
#define PREFETCH(p) __builtin_prefetch(p)
#else
#define PREFETCH(p) ((void)(p))
#endif

#endif
