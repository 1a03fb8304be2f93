/* Two buffers in turn: an argument of the call may be the reason of the call before. */
#include "formats/reason.h"

#include <stdarg.h>
#include <stdio.h>

const char *reason(const char *format, ...)
{
    static _Thread_local char text[2][512];
    static _Thread_local int turn;
    va_list ap;

    turn = !turn;
    va_start(ap, format);
    vsnprintf(text[turn], sizeof text[turn], format, ap);
    va_end(ap);
    return text[turn];
}
