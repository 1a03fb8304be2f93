/* Read line by line, so that a refusal can say which. */
#include "formats/columns.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/reason.h"

static const char between[] = " \t,\r\n";

/* One heading [length], "name[unit]" or "name (unit)", cut in two. */
static const char *heading_read(struct columns *t, const char *heading, size_t length)
{
    size_t open = strcspn(heading, "[("), name = open < length ? open : length;

    while (length > 0 && strchr(" \t]\r\n)", heading[length - 1]))
        length--;
    size_t unit = open < length ? length - open - 1 : 0;
    while (name > 0 && heading[name - 1] == ' ')
        name--;
    if (t->n == COLUMNS_MOST)
        return reason("more than %d columns", COLUMNS_MOST);
    if (name == 0 || name >= COLUMNS_NAME || unit >= COLUMNS_NAME)
        return reason("the name of column %d is empty or too long", t->n + 1);
    memcpy(t->name[t->n], heading, name);
    memcpy(t->unit[t->n++], heading + open + 1, unit);
    return NULL;
}

/* Commas part the headings where there is one, else blanks. */
static const char *header_read(struct columns *t, const char *line)
{
    const char *part = strchr(line, ',') ? ",\r\n" : between, *why = NULL;

    if (strspn(line, "0123456789+-.eE \t,;\r\n") == strlen(line))
        return "a header must name the columns before the first numbers";
    for (const char *p = line + strspn(line, between); *p && !why; p += strspn(p, between)) {
        size_t length = strcspn(p, part);
        why = heading_read(t, p, length);
        p += length;
    }
    return why ? why : t->n < 2 ? "the header must name two columns or more, between blanks, tabs or commas" : NULL;
}

static const char *rows_grow(struct columns *t, int64_t *room)
{
    const int64_t larger = *room ? 2 * *room : 1024;
    int64_t *lines = realloc(t->line, (size_t)larger * sizeof *lines);

    if (!lines)
        return REASON_MEMORY;
    t->line = lines;
    for (int k = 0; k < t->n; k++) {
        double *more = realloc(t->value[k], (size_t)larger * sizeof *more);
        if (!more)
            return REASON_MEMORY;
        t->value[k] = more;
    }
    *room = larger;
    return NULL;
}

static const char *row_read(struct columns *t, int64_t *room, const char *line, int64_t number)
{
    const char *why = t->rows == *room ? rows_grow(t, room) : NULL;

    if (why)
        return why;
    for (int k = 0; k < t->n; k++) {
        char *end;
        line += strspn(line, between);
        if (!*line)
            return reason("column %d, %s, is missing", k + 1, t->name[k]);
        double v = strtod(line, &end);
        if (end == line || !strchr(between, *end) || !isfinite(v))
            return reason("column %d: \"%.*s\" is not a number", k + 1, (int)strcspn(line, between), line);
        t->value[k][t->rows] = v;
        line = end;
    }
    if (line[strspn(line, between)])
        return reason("more than %d numbers", t->n);
    t->line[t->rows++] = number;
    return NULL;
}

static const char *file_read(struct columns *t, FILE *file)
{
    const char *why = NULL;
    char *line = NULL;
    size_t size = 0;
    int64_t room = 0;

    for (long number = 1; !why && getline(&line, &size, file) >= 0; number++) {
        if (line[0] == '#' || !line[strspn(line, between)])
            continue;
        why = t->n == 0 ? header_read(t, line) : row_read(t, &room, line, number);
        if (why)
            why = reason("line %ld: %s", number, why);
    }
    free(line);
    if (!why && ferror(file))
        why = reason("%s", strerror(errno));
    return why || t->rows ? why : "no numbers";
}

const char *columns_read(struct columns *t, const char *path)
{
    *t = (struct columns){0};
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
    if (!file)
        return reason("%s", strerror(errno));
    const char *why = file_read(t, file);
    if (file != stdin)
        fclose(file);
    if (why)
        columns_free(t);
    return why;
}

void columns_free(struct columns *t)
{
    for (int k = 0; k < t->n; k++)
        free(t->value[k]);
    free(t->line);
    *t = (struct columns){0};
}

int columns_find(const struct columns *t, const char *name)
{
    for (int k = 0; k < t->n; k++)
        if (strcmp(t->name[k], name) == 0)
            return k;
    return -1;
}
