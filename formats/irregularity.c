#include "formats/irregularity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "formats/lines.h"
#include "formats/points.h"
#include "formats/reason.h"

const char *const irregularity_name[IRREGULARITY_QUANTITIES] = {"longitudinal_level", "alignment", "cross_level", "gauge"};

enum { STATION = IRREGULARITY_QUANTITIES, COLUMNS_MOST };
enum { WORD = 32 };

struct scan {
    struct irregularity *table;
    int64_t room;
    int columns;                   /* 0 until the heading is read */
    int what[COLUMNS_MOST];        /* [columns] a quantity, or STATION */
    double unit[COLUMNS_MOST];     /* m */
};

static double *column(const struct irregularity *t, int what)
{
    return what == STATION ? t->x : t->value[what];
}

static const char *find_column(const char *name, int *what)
{
    if (strcmp(name, "station") == 0) {
        *what = STATION;
        return NULL;
    }
    for (*what = 0; *what < IRREGULARITY_QUANTITIES; ++*what)
        if (strcmp(name, irregularity_name[*what]) == 0)
            return NULL;
    return reason("column '%s' is none of station, longitudinal_level, alignment, cross_level, gauge", name);
}

/* "name (unit)" into column k; *end is what follows it. */
static const char *heading_column(struct scan *s, int k, const char *text, const char **end)
{
    char name[WORD] = "", unit[WORD] = "";
    int read = 0;
    const char *why;

    if (sscanf(text, " %31[a-z_] (%31[^)]) %n", name, unit, &read) != 2 || !read)
        return "a heading must name each column with its unit: station (m), longitudinal_level (mm), ...";
    if ((why = find_column(name, &s->what[k])))
        return why;
    for (int i = 0; i < k; i++)
        if (s->what[i] == s->what[k])
            return reason("column '%s' is there twice", name);
    s->unit[k] = strcmp(unit, "m") == 0 ? 1 : strcmp(unit, "mm") == 0 ? 1e-3 : 0;
    if (!(s->unit[k] > 0))
        return reason("unit of column '%s' must be m or mm, is '%s'", name, unit);
    *end = text + read;
    return NULL;
}

static const char *heading_read(struct scan *s, const char *text)
{
    const char *why;
    int stations = 0;

    for (;;) {
        if (s->columns == COLUMNS_MOST)
            return "more columns than there are quantities";
        if ((why = heading_column(s, s->columns, text, &text)))
            return why;
        stations += s->what[s->columns++] == STATION;
        if (*text == '\0')
            break;
        if (*text++ != ',')
            return "columns of the heading must stand between commas";
    }
    if (!stations)
        return "column 'station' is missing";
    return s->columns > 1 ? NULL : "no column beside the station";
}

static const char *grow(struct scan *s)
{
    const int64_t room = s->room ? 2 * s->room : 1024;

    for (int k = 0; k < s->columns; k++) {
        double **to = s->what[k] == STATION ? &s->table->x : &s->table->value[s->what[k]];
        double *larger = realloc(*to, (size_t)room * sizeof *larger);
        if (!larger)
            return REASON_MEMORY;
        *to = larger;
    }
    s->room = room;
    return NULL;
}

static const char *row_read(struct scan *s, const char *text)
{
    struct irregularity *t = s->table;
    const char *why = t->n == s->room ? grow(s) : NULL;

    for (int k = 0; k < s->columns && !why; k++) {
        double x = 0;
        const char *rest = points_number(text += strspn(text, " \t"), &x);
        if (!rest)
            return reason("'%.*s' is not a number", (int)strcspn(text, ",\r\n"), text);
        rest += strspn(rest, " \t\r\n");
        if (*rest != (k + 1 < s->columns ? ',' : '\0'))
            return reason("should be %d numbers between commas", s->columns);
        column(t, s->what[k])[t->n] = x * s->unit[k];
        text = rest + 1;
    }
    if (!why && t->n && t->x[t->n] <= t->x[t->n - 1])
        why = reason("station %g m must lie beyond that of the line before", t->x[t->n]);
    t->n += !why;
    return why;
}

static const char *line_read(void *to, long number, char *text)
{
    struct scan *s = to;

    (void)number;
    text += strspn(text, " \t\r\n");
    if (*text == '\0' || *text == '#')
        return NULL;
    return s->columns ? row_read(s, text) : heading_read(s, text);
}

static uint64_t hash(const struct irregularity *t)
{
    uint64_t h = XXH64(t->x, (size_t)t->n * sizeof *t->x, 0);

    for (int k = 0; k < IRREGULARITY_QUANTITIES; k++)
        if (t->value[k])
            h = XXH64(t->value[k], (size_t)t->n * sizeof *t->x, h + (uint64_t)k);
    return h;
}

const char *irregularity_read(struct irregularity *t, const char *path)
{
    struct scan s = {.table = t};
    const char *why;

    *t = (struct irregularity){0};
    why = lines_read(path, line_read, &s);
    if (!why && t->n < 2)
        why = "fewer than two lines of numbers";
    if (why)
        irregularity_free(t);
    else
        t->hash = hash(t);
    return why;
}

void irregularity_free(struct irregularity *t)
{
    free(t->x);
    for (int k = 0; k < IRREGULARITY_QUANTITIES; k++)
        free(t->value[k]);
    *t = (struct irregularity){0};
}
