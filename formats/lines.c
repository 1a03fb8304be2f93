#include "formats/lines.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

const char *lines_read(const char *path, const char *(*line)(void *to, long number, char *text), void *to)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
    const char *why = NULL;
    char *text = NULL;
    size_t size = 0;
    ssize_t length;

    if (!file)
        return reason("%s", strerror(errno));
    for (long number = 1; !why && (length = getline(&text, &size, file)) >= 0; number++) {
        why = strlen(text) == (size_t)length ? line(to, number, text) : "not a text";
        if (why)
            why = reason("line %ld: %s", number, why);
    }
    if (!why && ferror(file))
        why = reason("%s", strerror(errno));
    free(text);
    if (file != stdin)
        fclose(file);
    return why;
}
