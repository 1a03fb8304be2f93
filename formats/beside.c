#include "formats/beside.h"

#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

char *beside_path(const char *file, const char *input)
{
    const char *slash = *file == '/' ? NULL : strrchr(input, '/');
    size_t n = slash ? (size_t)(slash - input) + 1 : 0, m = strlen(file);
    char *path = calloc(n + m + 1, 1);

    if (path) {
        memcpy(path, input, n);
        memcpy(path + n, file, m);
    }
    return path;
}

const char *beside_place(char **file, const char *input)
{
    if (!*file)
        return NULL;
    char *path = beside_path(*file, input);
    if (!path)
        return REASON_MEMORY;
    free(*file);
    *file = path;
    return NULL;
}
