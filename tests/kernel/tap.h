/* TAP for kernel tests: ok(), near(), done().  Each line says what should hold. */
#ifndef VX_TAP_H
#define VX_TAP_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "formats/reason.h"

static int tap_run, tap_failed;

static inline int ok(int holds, const char *format, ...) VX_PRINTF(2, 3);

static inline int ok(int holds, const char *format, ...)
{
    va_list ap;
    printf("%sok %d - ", holds ? "" : "not ", ++tap_run);
    va_start(ap, format);
    vprintf(format, ap);
    va_end(ap);
    putchar('\n');
    tap_failed += !holds;
    return holds;
}

/* |got - want| <= tolerance; a NaN fails. */
static inline int near(double got, double want, double tolerance, const char *what)
{
    int holds = fabs(got - want) <= tolerance;
    ok(holds, "%s (%.6g)", what, got);
    if (!holds)
        printf("# %s: got %.12g, should be %.12g within %.3g\n", what, got, want, tolerance);
    return holds;
}

static inline int done(void)
{
    printf("1..%d\n", tap_run);
    return tap_failed != 0;
}

#endif
