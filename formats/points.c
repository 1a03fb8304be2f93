#include "formats/points.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/lines.h"
#include "formats/reason.h"

const char *points_number(const char *text, double *x)
{
    text += strspn(text, " \t");
    size_t digits = strspn(text, "+-.0123456789eE");
    char *end;

    if (digits == 0)
        return NULL;
    *x = strtod(text, &end);
    return end == text + digits && isfinite(*x) ? end : NULL;
}

static int array_grow(double **a, int64_t room)
{
    double *larger = realloc(*a, (size_t)room * sizeof **a);
    if (larger)
        *a = larger;
    return larger != NULL;
}

const char *points_add(struct points *p, int64_t *room, double y, double z, double weight)
{
    if (p->n == *room) {
        int64_t larger = *room ? 2 * *room : 256;
        if (!array_grow(&p->y, larger) || !array_grow(&p->z, larger) || !array_grow(&p->weight, larger))
            return REASON_MEMORY;
        *room = larger;
    }
    p->y[p->n] = y;
    p->z[p->n] = z;
    p->weight[p->n++] = weight;
    return NULL;
}

/* y z [weight] of one line, all between blanks or all between commas; *columns is 0 for a line without data. */
static const char *line_read(const char *line, double row[3], int *columns)
{
    int commas = 0;

    row[2] = 1;
    for (*columns = 0;; ++*columns) {
        line += strspn(line, " \t\r\n");
        if (*columns && *line == ',') {
            commas++;
            line += 1 + strspn(line + 1, " \t\r\n");
        }
        if (*line == '\0' || *line == '#')
            return *columns == 1 ? "one number, should be y z" : commas && commas >= *columns ? "a comma at the end" : NULL;
        if (*columns == 3)
            return "more than three columns";
        const char *rest = points_number(line, &row[*columns]);
        if (!rest || (*rest && !strchr(" \t\r\n#,", *rest)))
            return reason("'%.*s' is not a number", (int)strcspn(line, " \t\r\n#,"), line);
        if (commas && commas != *columns)
            return "commas between some of the columns only";
        line = rest;
    }
}

/* "y (mm),z (mm)", also with brackets or behind a comment sign: the unit of both; 0 where the line is no heading. */
static const char *heading_read(const char *line, double *unit)
{
    char word[2][4] = {"", ""};
    int end = 0;

    *unit = 0;
    line += strspn(line, "# \t");
    if (*line != 'y' || sscanf(line, "y%*[ ([]%3[m]%*[])] %*[,] z%*[ ([]%3[m]%*[])] %n", word[0], word[1], &end) < 2 || line[end])
        return NULL;
    *unit = strcmp(word[0], "m") == 0 ? 1 : strcmp(word[0], "mm") == 0 ? 1e-3 : 0;
    return *unit > 0 && strcmp(word[0], word[1]) == 0 ? NULL : "y and z must be in m or in mm";
}

struct scan {
    struct points *p;
    int64_t room;
    double unit;             /* m; 0 not stated yet */
};

static const char *row_add(void *scan, long number, char *line)
{
    struct scan *s = scan;
    double row[3], said = 0;
    int columns;
    const char *why = s->p->n ? NULL : heading_read(line, &said);

    (void)number;
    if (why || said > 0) {
        if (!why && s->unit > 0 && s->unit != said)
            why = "the heading's unit is not the one stated";
        s->unit = said;
        return why;
    }
    if ((why = line_read(line, row, &columns)) || !columns)
        return why;
    if (row[2] <= 0)
        return reason("weight must be positive, is %g", row[2]);
    if (s->unit <= 0)
        return "unit: must be stated, m or mm";
    return points_add(s->p, &s->room, row[0] * s->unit, row[1] * s->unit, row[2]);
}

const char *points_read(struct points *p, const char *path, double unit)
{
    struct scan s = {.p = p, .unit = unit};
    *p = (struct points){0};
    const char *why = lines_read(path, row_add, &s);
    if (!why && p->n < 3)
        why = reason("%lld points, a profile needs at least 3", (long long)p->n);
    if (why)
        points_free(p);
    return why;
}

void points_free(struct points *p)
{
    free(p->y);
    free(p->z);
    free(p->weight);
    *p = (struct points){0};
}
