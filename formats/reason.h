/* Why something failed, as a sentence a user can read.
 *
 * A function that can fail for a reason a user must read returns const char *: NULL on success, else the
 * reason.  reason() formats one into a buffer of the calling thread that lasts until the next call, so
 * a reason may be wrapped: return reason("%s: %s", name, why). */
#ifndef VX_FORMATS_REASON_H
#define VX_FORMATS_REASON_H

#if defined __GNUC__
#define VX_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define VX_PRINTF(f, a)
#endif

const char *reason(const char *format, ...) VX_PRINTF(1, 2);

#define REASON_MEMORY "out of memory"

#endif
